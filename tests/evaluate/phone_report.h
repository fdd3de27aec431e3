// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include "tests/evaluate/contact_sheet.h"
#include "tests/evaluate/json.h"
#include "tests/evaluate/scene_folder.h"

namespace evaluate {

/// The folder's edits in the picture that a phone would have taken (`phoneScene`): with its depth map, without glossy
/// flags, with exact depth, and with its depth map under the true light, which tells what is lost to the shape. One
/// report per variant and edit. Adds a row of photograph, truth and variants to the sheet for each edit. `only`: name
/// of one edit, or empty.
///
/// Compared is the edited segment, eroded by one pixel: PSNR and SSIM of all three channels, display-encoded with the
/// 99th percentile of the truth there at 1 and the truth clipped as the photograph is; "contrast": standard deviation
/// of the logarithm of luminance over the truth's; "mean_ratio": mean over the true mean; "normals": their angles [°]
/// to the true ones in all segments but the largest.
[[nodiscard]] Json phoneReports(const SceneFolder& folder, const std::string& only, ContactSheet& sheet,
                                const std::filesystem::path& output);

void printPhone(std::ostream& out, const Json& reports);

}  // namespace evaluate
