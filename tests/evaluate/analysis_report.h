// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

#include "core/analysis/pipeline.h"
#include "tests/evaluate/scene_folder.h"

namespace evaluate {

/// The segment of the reference scenes that all objects stand on. It is a plane and covers half of the picture, so it
/// would dominate an overall figure.
inline constexpr const char* kTable = "table";
inline constexpr const char* kAllButTable = "all but the table";
inline constexpr const char* kAll = "all";

/// Errors of the analysis of one scene against ground truth: normals from exact and from noisy depth, with and without
/// the filter; patch areas; back sides by method; reflectances; lobe widths; the light by filling method. The keys are
/// those of docs/evaluation.md.
[[nodiscard]] Json analysisReport(const SceneFolder& folder, core::AnalysisPipeline& pipeline);

/// Tables of the reports of all scenes, as Markdown.
void printAnalysis(std::ostream& out, const Json& reports);

}  // namespace evaluate
