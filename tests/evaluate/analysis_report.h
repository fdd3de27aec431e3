// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

#include "core/analysis/pipeline.h"
#include "tests/evaluate/scene_folder.h"

namespace evaluate {

/// The segment of the reference scenes that everything stands on: half of the picture and a plane, so that it would
/// hide everything else in an overall figure.
inline constexpr const char* kTable = "table";
inline constexpr const char* kAllButTable = "all but the table";
inline constexpr const char* kAll = "all";

/// What the analysis recovers of one scene against the truth: normals from exact and from noisy depth without and with
/// the filter, patch areas, back sides by method, reflectances, lobe widths, the light by way of filling. Keys are
/// those of docs/evaluation.md.
[[nodiscard]] Json analysisReport(const SceneFolder& folder, core::AnalysisPipeline& pipeline);

/// Tables of the reports of all scenes, as Markdown.
void printAnalysis(std::ostream& out, const Json& reports);

}  // namespace evaluate
