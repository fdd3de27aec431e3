// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace core {

/// Integers of a TIFF structure (a TIFF file, EXIF data, an MPF index), in its byte order. Offsets count from its
/// start.
class TiffBytes {
  public:
    explicit TiffBytes(std::string_view bytes) : bytes_(bytes), bigEndian_(bytes.starts_with("MM")) {}

    /// nullopt beyond the end.
    [[nodiscard]] std::optional<std::uint64_t> integer(std::uint64_t at, std::uint64_t size) const {
        if (at > bytes_.size() || size > bytes_.size() - at) return std::nullopt;
        std::uint64_t value = 0;
        for (std::uint64_t i = 0; i < size; ++i) {
            const std::uint64_t position = bigEndian_ ? at + i : at + size - 1 - i;
            value = value << 8U | static_cast<unsigned char>(bytes_[position]);
        }
        return value;
    }

    /// Offset of the entry `tag` of a (32-bit) directory; nullopt when there is none.
    [[nodiscard]] std::optional<std::uint64_t> findEntry(std::optional<std::uint64_t> directory,
                                                         std::uint64_t tag) const {
        const auto entries = directory ? integer(*directory, 2) : std::nullopt;
        for (std::uint64_t i = 0; entries && i < *entries; ++i) {
            const std::uint64_t at = *directory + 2 + 12 * i;
            const auto found = integer(at, 2);
            if (!found) return std::nullopt;
            if (*found == tag) return at;
        }
        return std::nullopt;
    }

  private:
    std::string_view bytes_;
    bool bigEndian_;
};

}  // namespace core
