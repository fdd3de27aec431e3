// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <vector>

#include "core/analysis/pipeline.h"
#include "tests/evaluate/scene_folder.h"

namespace evaluate {

/// One edit in five pictures: the photograph; Patina's rendering from recovered data, with the true light, with the
/// true light and back side; and ground truth. Scene-linear.
struct EditPictures {
    core::ImageRgb unedited, ours, trueLight, trueBoth, truth;
};

/// Renders one edit of a scene with the scene's number of samples.
[[nodiscard]] EditPictures renderEdit(const SceneFolder& folder, const Edit& edit, core::AnalysisPipeline& pipeline);

/// PSNR, SSIM, relative MSE and mean of each picture inside the edited segment eroded by one pixel.
[[nodiscard]] Json editReport(const SceneFolder& folder, const Edit& edit, const EditPictures& pictures);

/// Table of all edits and their averages, as Markdown.
void printEdits(std::ostream& out, const Json& reports);

/// Mean over the edits of `key`'s metric ("psnr", "ssim", "rel_mse"); infinite values are left out.
[[nodiscard]] double meanOverEdits(const Json& reports, const std::string& variant, const std::string& metric);

}  // namespace evaluate
