// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import/camera_raw.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/message.h"

namespace core {

namespace {

constexpr std::size_t kMaxRawDirectories = 32;
constexpr std::uint64_t kMaxRawEntries = 512;

/// The integers of a TIFF file that is not read as a whole.
class TiffFile {
  public:
    TiffFile(std::ifstream& file, bool bigEndian) : file_(file), bigEndian_(bigEndian) {}

    /// nullopt beyond the end.
    [[nodiscard]] std::optional<std::uint64_t> integer(std::uint64_t at, std::size_t size) const {
        unsigned char bytes[8] = {};
        file_.clear();
        file_.seekg(static_cast<std::streamoff>(at));
        file_.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(size));
        if (!file_) return std::nullopt;
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < size; ++i) value = value << 8U | bytes[bigEndian_ ? i : size - 1 - i];
        return value;
    }

  private:
    std::ifstream& file_;
    bool bigEndian_;
};

/// Whether a directory of the file, or one below it, holds a mosaic of a sensor (CFA) or its linear values: numbers of
/// PhotometricInterpretation in TIFF/EP and the DNG specification.
bool hasSensorData(const TiffFile& file) {
    constexpr std::uint64_t kPhotometric = 262, kSubDirectories = 330, kMosaic = 32803, kLinearRaw = 34892;
    std::vector<std::uint64_t> directories{file.integer(4, 4).value_or(0)};
    for (std::size_t k = 0; k < directories.size(); ++k) {
        const std::uint64_t directory = directories[k];
        const std::uint64_t entries = std::min(file.integer(directory, 2).value_or(0), kMaxRawEntries);
        const auto add = [&](std::optional<std::uint64_t> at) {
            if (at && *at != 0 && directories.size() < kMaxRawDirectories) directories.push_back(*at);
        };
        for (std::uint64_t i = 0; i < entries; ++i) {
            const std::uint64_t entry = directory + 2 + 12 * i;
            const auto tag = file.integer(entry, 2);
            if (tag == kPhotometric) {
                const auto value = file.integer(entry + 8, 2);
                if (value == kMosaic || value == kLinearRaw) return true;
            } else if (tag == kSubDirectories) {
                const std::uint64_t count = file.integer(entry + 4, 4).value_or(0);
                if (count == 1) add(file.integer(entry + 8, 4));
                const auto list = file.integer(entry + 8, 4);
                for (std::uint64_t d = 0; list && count > 1 && d < std::min<std::uint64_t>(count, 8); ++d)
                    add(file.integer(*list + 4 * d, 4));
            }
        }
        add(file.integer(directory + 2 + 12 * entries, 4));
    }
    return false;
}

bool isCameraRaw(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string head(16, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    for (const std::string_view magic :
         {std::string_view("IIU\0", 4), std::string_view("IIRO"), std::string_view("IIRS"), std::string_view("MMOR"),
          std::string_view("FUJIFILMCCD-RAW"), std::string_view("FOVb"), std::string_view("\0MRM", 4)})
        if (head.starts_with(magic)) return true;
    if (head.size() >= 12 && head.compare(4, 8, "ftypcrx ") == 0) return true;
    const bool little = head.starts_with(std::string_view("II*\0", 4));
    if (!little && !head.starts_with(std::string_view("MM\0*", 4))) return false;
    return (head.size() >= 10 && head.compare(8, 2, "CR") == 0) || hasSensorData(TiffFile(file, !little));
}

}  // namespace

void refuseCameraRaw(const std::string& path) {
    if (!isCameraRaw(path)) return;
    throw Error(
        ErrorKind::Input,
        Message("messages",
                "Cannot read \"%1\": it is a camera raw file, expected a developed picture. Develop it in a raw "
                "converter, and save a TIFF, PNG or JPEG.")
            .with(path));
}

}  // namespace core
