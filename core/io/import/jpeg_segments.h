// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
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

/// Position behind the end (EOI) of the JPEG picture that `stream` begins with; nullopt when it has none.
[[nodiscard]] std::optional<std::size_t> jpegPictureEnd(std::string_view stream);

/// Pictures that lie behind the one that `stream` begins with, whatever is between them; no more than 64. The last one
/// may be cut off: it has no end (EOI).
[[nodiscard]] std::vector<std::string_view> jpegPicturesBehind(std::string_view stream);

/// XMP packets of a JPEG stream as XML texts: the standard packets first (some programs add a second one), then the
/// extended one they refer to (joined by GUID and offset; XMP specification part 3, section 1.1.3.1). Parts that are
/// missing, overlap, or do not add up are described in `damage`, and the extended packet is left out.
[[nodiscard]] std::vector<std::string> jpegXmpPackets(std::string_view stream, Message* damage = nullptr);

}  // namespace core
