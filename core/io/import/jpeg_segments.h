// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"

namespace core {

/// One marker segment before the entropy-coded data of a JPEG stream.
struct JpegSegment {
    unsigned marker = 0;       ///< 0xE1 for APP1
    std::size_t offset = 0;    ///< position of `payload` in the stream
    std::string_view payload;  ///< without marker and length
};

/// Segments up to the start of the first scan. `complete` becomes false when the stream ends or breaks before that.
/// Empty when `stream` does not begin with a JPEG marker.
[[nodiscard]] std::vector<JpegSegment> jpegSegments(std::string_view stream, bool* complete = nullptr);

/// XMP packets of a JPEG stream as XML texts: the standard packet first, then the extended one it refers to (joined by
/// GUID and offset; XMP specification part 3, section 1.1.3.1). Parts that are missing, overlap, or do not add up are
/// described in `damage`, and the extended packet is left out.
[[nodiscard]] std::vector<std::string> jpegXmpPackets(std::string_view stream, Message* damage = nullptr);

}  // namespace core
