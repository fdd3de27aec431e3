// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace core {

// Decoders fill in what a cut file lacks (libjpeg with grey, OpenImageIO's TIFF reader with whatever it finds); these
// look whether the data is there at all. Damaged structures count as incomplete. `bytes` is the whole file.

/// A JPEG whose first image has its end marker.
[[nodiscard]] bool jpegIsComplete(std::string_view bytes);

/// A TIFF or BigTIFF whose first directory's strips and tiles lie inside the file.
[[nodiscard]] bool tiffIsComplete(std::string_view bytes);

}  // namespace core
