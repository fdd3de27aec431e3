// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/import/import_format.h"

namespace core {

/// One field of the points of a PCD file.
struct PcdField {
    std::string name;
    char type = 'F';         ///< F, I or U
    std::size_t size = 4;    ///< bytes of a value
    std::size_t count = 1;   ///< values
    std::size_t offset = 0;  ///< bytes before this field, in a point
    [[nodiscard]] std::size_t bytes() const { return size * count; }
};

/// Header of a PCD file, checked: an organised cloud of a size that can be a photograph.
struct PcdHeader {
    std::vector<PcdField> fields;
    int width = 0;
    int height = 0;
    std::string data;       ///< ascii, binary, binary_compressed
    std::size_t begin = 0;  ///< position of the data in the file
    std::size_t pointBytes = 0;
    [[nodiscard]] std::size_t points() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    [[nodiscard]] const PcdField* find(std::string_view name) const {
        const auto found = std::ranges::find(fields, name, &PcdField::name);
        return found == fields.end() ? nullptr : &*found;
    }
};

/// The points of a PCD file (version 0.7: ascii, binary, binary_compressed), as raw bytes. Throws Error(Input).
class PcdPoints {
  public:
    explicit PcdPoints(const ImportFile& file);

    [[nodiscard]] const PcdHeader& header() const { return header_; }

    /// First value of a field of point `i`, which is a float of 4 or 8 bytes.
    [[nodiscard]] double real(const PcdField& field, std::size_t i) const {
        if (field.size == 8) return load<double>(field, i);
        return static_cast<double>(load<float>(field, i));
    }
    /// The same of a field of 4 bytes, as stored.
    [[nodiscard]] std::uint32_t word(const PcdField& field, std::size_t i) const {
        return load<std::uint32_t>(field, i);
    }

  private:
    template <class T>
    [[nodiscard]] T load(const PcdField& field, std::size_t i) const {
        T value;
        std::memcpy(&value, bytes_.data() + position(field, i), sizeof value);
        return value;
    }

    [[nodiscard]] std::size_t position(const PcdField& field, std::size_t i) const {
        if (byField_) return header_.points() * field.offset + i * field.bytes();
        return i * header_.pointBytes + field.offset;
    }

    [[nodiscard]] std::string_view payload(std::size_t begin, std::size_t size) const;
    void decompress();
    void parseText();

    const ImportFile& file_;
    PcdHeader header_;
    std::string bytes_;
    bool byField_ = false;  ///< true: all values of a field together; false: all fields of a point
};

}  // namespace core
