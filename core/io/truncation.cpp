// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/truncation.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "core/io/tiff_bytes.h"

namespace core {

namespace {

/// Values of one directory entry.
struct TiffArray {
    std::uint64_t begin = 0;
    std::uint64_t size = 0;  ///< bytes of one value
    std::uint64_t count = 0;
};

std::uint64_t valueSize(std::uint64_t type) {
    switch (type) {
        case 3:
            return 2;  // SHORT
        case 4:
            return 4;  // LONG
        case 13:
            return 4;  // IFD
        case 16:
        case 18:
            return 8;  // LONG8, IFD8
        default:
            return 0;
    }
}

/// Places and sizes of the strips or tiles.
struct TiffDirectory {
    TiffArray offsets;
    TiffArray sizes;
};

struct TiffEntry {
    std::uint64_t tag = 0;
    std::uint64_t type = 0;
    std::uint64_t count = 0;
    std::uint64_t inside = 0;   ///< place of the values if they fit into the entry
    std::uint64_t pointer = 0;  ///< place of the values if they do not
};

/// The entry at `at`, with counts and offsets of `word` bytes; nullopt behind the end of the file.
std::optional<TiffEntry> readEntry(const TiffBytes& file, std::uint64_t at, std::uint64_t word) {
    const auto tag = file.integer(at, 2);
    const auto type = file.integer(at + 2, 2);
    const auto count = file.integer(at + 4, word);
    const auto pointer = file.integer(at + 4 + word, word);
    if (!tag || !type || !count || !pointer) return std::nullopt;
    return TiffEntry{*tag, *type, *count, at + 4 + word, *pointer};
}

/// The first directory; nullopt if it is damaged. `fileSize` in bytes.
std::optional<TiffDirectory> readDirectory(const TiffBytes& file, std::size_t fileSize) {
    const bool big = file.integer(2, 2) == 43U;
    const std::uint64_t word = big ? 8 : 4;  // bytes of an offset
    const std::uint64_t entryBytes = big ? 20 : 12;
    const auto directory = file.integer(big ? 8 : 4, word);
    if (!directory) return std::nullopt;
    const auto entries = file.integer(*directory, big ? 8 : 2);
    if (!entries || *entries > 65535) return std::nullopt;
    TiffDirectory result;
    for (std::uint64_t i = 0; i < *entries; ++i) {
        const auto entry = readEntry(file, *directory + (big ? 8 : 2) + entryBytes * i, word);
        if (!entry) return std::nullopt;
        const bool isOffsets = entry->tag == 273 || entry->tag == 324;  // StripOffsets, TileOffsets
        const bool isSizes = entry->tag == 279 || entry->tag == 325;    // StripByteCounts, TileByteCounts
        if (!isOffsets && !isSizes) continue;
        const std::uint64_t size = valueSize(entry->type);
        if (size == 0 || entry->count > fileSize) return std::nullopt;
        const bool fits = entry->count * size <= word;
        (isOffsets ? result.offsets : result.sizes) = {fits ? entry->inside : entry->pointer, size, entry->count};
    }
    return result;
}

}  // namespace

bool jpegIsComplete(std::string_view bytes) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    std::size_t i = 2;
    while (i + 1 < bytes.size()) {
        if (byte(i) != 0xff) {  // entropy-coded data
            ++i;
            continue;
        }
        const unsigned marker = byte(i + 1);
        if (marker == 0xd9) return true;
        if (marker == 0xff) {  // fill byte
            ++i;
            continue;
        }
        const bool standalone = marker == 0x00 || marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
        if (standalone) {
            i += 2;
            continue;
        }
        if (i + 3 >= bytes.size()) return false;
        i += 2 + (std::size_t{byte(i + 2)} << 8U) + byte(i + 3);
    }
    return false;
}

bool tiffIsComplete(std::string_view bytes) {
    const TiffBytes file(bytes);
    const auto directory = readDirectory(file, bytes.size());
    if (!directory || directory->offsets.count == 0) return false;
    const auto& [offsets, sizes] = *directory;
    for (std::uint64_t i = 0; i < std::min(offsets.count, sizes.count); ++i) {
        const auto begin = file.integer(offsets.begin + i * offsets.size, offsets.size);
        const auto length = file.integer(sizes.begin + i * sizes.size, sizes.size);
        if (!begin || !length || *begin > bytes.size() || *length > bytes.size() - *begin) return false;
    }
    return true;
}

}  // namespace core
