// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import/pcd_points.h"

#include <cctype>
#include <charconv>
#include <sstream>

#include "core/io/image_io.h"
#include "core/io/import/lzf.h"

namespace core {

namespace {

constexpr std::size_t kMaxHeaderBytes = 64 * 1024;
constexpr std::size_t kMaxFields = 256;
/// Values of one field.
constexpr std::size_t kMaxValues = 4096;

/// Reads the words of header lines as numbers, with messages that name the line.
class HeaderReader {
  public:
    explicit HeaderReader(const ImportFile& file) : file_(file) {}

    [[nodiscard]] PcdHeader read() {
        const std::string& bytes = file_.bytes();
        PcdHeader header;
        Lists lists;
        while (header.data.empty()) {
            const std::size_t end = bytes.find('\n', header.begin);
            if (end == std::string::npos || end > kMaxHeaderBytes)
                file_.fail(Message("messages", "the PCD header has no end, expected a line \"DATA ...\""));
            std::istringstream line(bytes.substr(header.begin, end - header.begin));
            header.begin = end + 1;
            std::string key;
            if (!(line >> key) || key.starts_with("#")) continue;
            std::vector<std::string> words;
            for (std::string word; line >> word;) words.push_back(word);
            if (words.size() > kMaxFields) fail(key, Message("messages", "has %1 values").with(words.size()));
            if (words.empty()) fail(key, Message("messages", "has no value"));
            readLine(key, words, header, lists);
        }
        if (lists.counts.empty()) lists.counts.assign(header.fields.size(), 1);
        completeFields(header, lists.sizes, lists.types, lists.counts);
        checkSize(header, lists.points);
        return header;
    }

  private:
    /// Values of lines that complete the fields or repeat what other lines say.
    struct Lists {
        std::vector<long> sizes;
        std::string types;
        std::vector<long> counts;
        long points = -1;  ///< -1 = not stated
    };

    void readLine(const std::string& key, const std::vector<std::string>& words, PcdHeader& header,
                  Lists& lists) const {
        if (key == "FIELDS")
            for (const std::string& word : words) header.fields.emplace_back().name = word;
        else if (key == "SIZE")
            lists.sizes = numbers(key, words);
        else if (key == "TYPE")
            for (const std::string& word : words) lists.types += word.size() == 1 ? word[0] : '?';
        else if (key == "COUNT")
            lists.counts = numbers(key, words);
        else if (key == "WIDTH")
            header.width = side(key, words);
        else if (key == "HEIGHT")
            header.height = side(key, words);
        else if (key == "POINTS")
            lists.points = numbers(key, words)[0];
        else if (key == "DATA")
            header.data = words[0];
    }

    void checkSize(const PcdHeader& header, long points) const {
        if (header.height < 2)
            file_.fail(
                Message("messages",
                        "the point cloud has WIDTH %1 and HEIGHT %2, expected a raster of points (HEIGHT of 2 or more)")
                    .with(header.width, header.height));
        if (static_cast<long>(header.points()) > kMaxImagePixels)
            file_.fail(Message("messages", "the point cloud has %1x%2 points, expected at most %3")
                           .with(header.width, header.height, kMaxImagePixels));
        if (points != -1 && points != static_cast<long>(header.points()))
            fail("POINTS", Message("messages", "is %1, expected WIDTH times HEIGHT, %2").with(points, header.points()));
    }

    [[noreturn]] void fail(const std::string& key, const Message& reason) const {
        file_.fail(Message("messages", "the PCD header's %1 %2").with(key, reason));
    }

    [[nodiscard]] std::vector<long> numbers(const std::string& key, const std::vector<std::string>& words) const {
        std::vector<long> result;
        for (const std::string& word : words) {
            long value = 0;
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
            if (error != std::errc() || end != word.data() + word.size())
                fail(key, Message("messages", "is \"%1\", expected a whole number").with(word));
            result.push_back(value);
        }
        return result;
    }

    [[nodiscard]] int side(const std::string& key, const std::vector<std::string>& words) const {
        const long value = numbers(key, words)[0];
        if (value < 1 || value > kMaxImageSide)
            fail(key, Message("messages", "is %1, expected 1 to %2").with(value, kMaxImageSide));
        return static_cast<int>(value);
    }

    void completeFields(PcdHeader& header, const std::vector<long>& sizes, const std::string& types,
                        const std::vector<long>& counts) const {
        const std::size_t n = header.fields.size();
        if (n == 0 || sizes.size() != n || types.size() != n || counts.size() != n)
            file_.fail(Message("messages",
                               "the PCD header's FIELDS, SIZE, TYPE and COUNT have %1, %2, %3 and %4 values, expected "
                               "the same number")
                           .with(n, sizes.size(), types.size(), counts.size()));
        for (std::size_t i = 0; i < n; ++i) {
            if (sizes[i] != 1 && sizes[i] != 2 && sizes[i] != 4 && sizes[i] != 8)
                fail("SIZE", Message("messages", "has the value %1, expected 1, 2, 4 or 8").with(sizes[i]));
            if (counts[i] < 1 || counts[i] > static_cast<long>(kMaxValues))
                fail("COUNT", Message("messages", "has the value %1, expected 1 to %2").with(counts[i], kMaxValues));
            if (types[i] != 'F' && types[i] != 'I' && types[i] != 'U')
                fail("TYPE", Message("messages", "has the value \"%1\", expected F, I or U").with(types.substr(i, 1)));
            PcdField& field = header.fields[i];
            field.type = types[i];
            field.size = static_cast<std::size_t>(sizes[i]);
            field.count = static_cast<std::size_t>(counts[i]);
            field.offset = header.pointBytes;
            header.pointBytes += field.bytes();
        }
    }

    const ImportFile& file_;
};

/// One number to its stored form; nullptr when there is none. Fields that are not needed are skipped.
const char* parseValue(const char* at, const char* end, const PcdField& field, char* target) {
    const char* stop = std::find_if(at, end, [](unsigned char c) { return std::isspace(c) != 0; });
    if (stop == at) return nullptr;
    std::from_chars_result result{at, {}};
    if (field.type == 'F' && field.size == 8) {
        double value = 0;
        result = std::from_chars(at, stop, value);
        std::memcpy(target, &value, sizeof value);
    } else if (field.type == 'F' && field.size == 4) {
        float value = 0;
        result = std::from_chars(at, stop, value);
        std::memcpy(target, &value, sizeof value);
    } else if (field.size == 4) {
        std::int64_t value = 0;
        result = std::from_chars(at, stop, value);
        const auto low = static_cast<std::uint32_t>(value);
        std::memcpy(target, &low, sizeof low);
    } else {
        return stop;
    }
    return result.ec == std::errc() ? stop : nullptr;
}

}  // namespace

PcdPoints::PcdPoints(const ImportFile& file) : file_(file), header_(HeaderReader(file).read()) {
    if (header_.data == "ascii")
        parseText();
    else if (header_.data == "binary")
        bytes_ = std::string(payload(header_.begin, header_.points() * header_.pointBytes));
    else if (header_.data == "binary_compressed")
        decompress();
    else
        file.fail(Message("messages", "the PCD header's DATA is \"%1\", expected ascii, binary or binary_compressed")
                      .with(header_.data));
}

std::string_view PcdPoints::payload(std::size_t begin, std::size_t size) const {
    const std::string& bytes = file_.bytes();
    if (begin > bytes.size() || size > bytes.size() - begin)
        file_.fail(Message("messages", "the file is truncated: its points take %1 bytes, %2 are there")
                       .with(size, bytes.size() - std::min(begin, bytes.size())));
    return std::string_view(bytes).substr(begin, size);
}

void PcdPoints::decompress() {
    std::uint32_t sizes[2];
    std::memcpy(sizes, payload(header_.begin, sizeof sizes).data(), sizeof sizes);
    const std::size_t expected = header_.points() * header_.pointBytes;
    if (sizes[1] != expected)
        file_.fail(Message("messages", "its points unpack to %1 bytes, expected %2").with(sizes[1], expected));
    auto unpacked = lzfDecompress(payload(header_.begin + sizeof sizes, sizes[0]), expected);
    if (!unpacked) file_.fail(Message("messages", "its compressed points (LZF) are damaged"));
    bytes_ = std::move(*unpacked);
    byField_ = true;
}

void PcdPoints::parseText() {
    const std::string& text = file_.bytes();
    // A value takes at least a digit and a space.
    std::size_t values = 0;
    for (const PcdField& field : header_.fields) values += field.count;
    if (header_.points() > (text.size() - header_.begin + 1) / 2 / values)
        file_.fail(Message("messages", "the file is truncated: expected %1 lines of points").with(header_.points()));
    bytes_.resize(header_.points() * header_.pointBytes);
    const char* at = text.data() + header_.begin;
    const char* const end = text.data() + text.size();
    for (std::size_t i = 0; i < header_.points(); ++i)
        for (const PcdField& field : header_.fields)
            for (std::size_t k = 0; k < field.count; ++k) {
                while (at != end && std::isspace(static_cast<unsigned char>(*at)) != 0) ++at;
                at = parseValue(at, end, field, bytes_.data() + i * header_.pointBytes + field.offset + k * field.size);
                if (at == nullptr)
                    file_.fail(Message("messages", "point %1 has no value for the field \"%2\"").with(i, field.name));
            }
}

}  // namespace core
