// SPDX-License-Identifier: GPL-3.0-or-later
// Image files made without the code under test: PFM, PGM/PPM and PNG byte by byte, the rest by OpenImageIO.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/temp_folder.h"

namespace test {

/// The four bytes of a number, little endian.
inline std::string little32(std::uint32_t v) {
    return {static_cast<char>(v), static_cast<char>(v >> 8U), static_cast<char>(v >> 16U), static_cast<char>(v >> 24U)};
}

/// PFM, rows given top-down (the file stores them bottom-up), little endian.
inline void writePfm(const std::string& path, int width, int height, int channels, const std::vector<float>& values) {
    std::string bytes =
        (channels == 3 ? "PF\n" : "Pf\n") + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
    const auto row = static_cast<std::size_t>(width * channels);
    for (int y = height - 1; y >= 0; --y)
        for (std::size_t i = 0; i < row; ++i) {
            char raw[4];
            std::memcpy(raw, &values.at(static_cast<std::size_t>(y) * row + i), 4);
            bytes.append(raw, 4);
        }
    writeBytes(path, bytes);
}

/// Binary PGM or PPM with 8 bit.
inline void writePnm8(const std::string& path, int width, int height, int channels,
                      const std::vector<std::uint8_t>& values) {
    std::string bytes =
        (channels == 3 ? "P6\n" : "P5\n") + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
    bytes.append(values.begin(), values.end());
    writeBytes(path, bytes);
}

/// Any format by OpenImageIO, from interleaved pixels of `type`.
inline void writeWith(const std::string& plugin, const std::string& path, const OIIO::ImageSpec& spec,
                      OIIO::TypeDesc type, const void* pixels) {
    const auto output = OIIO::ImageOutput::create(plugin);
    if (!output || !output->open(path, spec) || !output->write_image(type, pixels) || !output->close())
        throw std::runtime_error("cannot write " + path + ": " + (output ? output->geterror() : ""));
}

inline std::uint32_t pngCrc(const std::string& bytes) {
    std::uint32_t crc = 0xffffffffU;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int i = 0; i < 8; ++i) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
    }
    return ~crc;
}

inline std::string bigEndian32(std::uint32_t value) {
    return {static_cast<char>(value >> 24U), static_cast<char>(value >> 16U), static_cast<char>(value >> 8U),
            static_cast<char>(value)};
}

inline std::string pngChunk(const std::string& type, const std::string& data) {
    return bigEndian32(static_cast<std::uint32_t>(data.size())) + type + data + bigEndian32(pngCrc(type + data));
}

/// PNG from rows that are already packed (without filter byte), stored uncompressed; `palette` may be empty.
inline std::string pngBytes(std::uint32_t width, std::uint32_t height, int bits, int colorType,
                            const std::vector<std::string>& rows, const std::string& palette = {}) {
    std::string raw;
    for (const std::string& row : rows) raw += std::string(1, '\0') + row;
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const char c : raw) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    const auto length = static_cast<std::uint16_t>(raw.size());
    std::string stream("\x78\x01\x01", 3);
    for (const unsigned value : {unsigned{length}, ~unsigned{length}}) {
        stream += static_cast<char>(value & 255U);
        stream += static_cast<char>(value >> 8U & 255U);
    }
    stream += raw + bigEndian32(b << 16U | a);
    std::string header = bigEndian32(width) + bigEndian32(height);
    header += {static_cast<char>(bits), static_cast<char>(colorType), 0, 0, 0};
    return std::string("\x89PNG\r\n\x1a\n") + pngChunk("IHDR", header) +
           (palette.empty() ? "" : pngChunk("PLTE", palette)) + pngChunk("IDAT", stream) + pngChunk("IEND", "");
}

}  // namespace test
