// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <ostream>

#include "tests/evaluate/contact_sheet.h"
#include "tests/evaluate/json.h"

namespace evaluate {

/// A real photograph with hand-drawn segments and their new materials: one entry of tests/evaluate/photos.json.
/// Reduced by a whole number to at most `longerSide` pixels; 0 = full size. Throws core::Error if a file cannot be
/// read.
[[nodiscard]] core::Scene loadPhotoScene(const std::filesystem::path& folder, const Json& entry, int longerSide);

struct PhotoOptions {
    int samples = 16;       ///< paths per pixel of the edit
    int longerSide = 1300;  ///< as in `loadPhotoScene`
};

/// Analyses and edits one photograph, adds input, depth, normals, light and edit to the sheet, saves the edit large as
/// photo_NAME.png in `output`. An unreadable photograph is reported as skipped, with the reason.
[[nodiscard]] Json photoReport(const std::filesystem::path& folder, const Json& entry, const PhotoOptions& options,
                               ContactSheet& sheet, const std::filesystem::path& output);

/// Table of all photographs, as Markdown.
void printPhotos(std::ostream& out, const Json& reports);

}  // namespace evaluate
