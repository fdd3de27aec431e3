// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/analysis/analysis.h"
#include "tests/evaluate/contact_sheet.h"
#include "tests/evaluate/edit_report.h"
#include "tests/evaluate/scene_folder.h"

namespace evaluate {

/// One row per edit: unedited, ours, with true light, with true light and back side, truth, our error; cropped to
/// the edited segment, exposed as for the metrics.
[[nodiscard]] std::vector<ContactSheet::Cell> editRow(const SceneFolder& folder, const Edit& edit,
                                                      const EditPictures& pictures, const Json& report);

/// The same pictures except the last, at full size side by side, without captions.
void saveStrip(const SceneFolder& folder, const Edit& edit, const EditPictures& pictures,
               const std::filesystem::path& path);

/// Recovered and true normals, back sides and light of a scene.
void saveSceneSheet(const SceneFolder& folder, const core::Analysis& analysis, const std::filesystem::path& path);

}  // namespace evaluate
