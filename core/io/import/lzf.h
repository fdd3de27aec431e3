// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace core {

/// Decompresses one LZF block (LibLZF, as in binary_compressed point clouds) to exactly `size` bytes; nullopt when it
/// is damaged or of another size. LZF cannot expand beyond kLzfMaxRatio, so that a larger `size` is refused unread.
[[nodiscard]] std::optional<std::string> lzfDecompress(std::string_view block, std::size_t size);
/// Bytes out per byte in: a reference of 3 bytes copies at most 264.
inline constexpr std::size_t kLzfMaxRatio = 88;

}  // namespace core
