// SPDX-License-Identifier: GPL-3.0-or-later
// Organised point clouds (Point Cloud Library, PCD 0.7): a raster of points with colours. Intrinsics follow from the
// points themselves.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <sstream>

#include "core/io/color_decode.h"
#include "core/io/image_io.h"
#include "core/io/import/import_format.h"
#include "core/io/import/lzf.h"

namespace core {

namespace {

constexpr std::size_t kMaxHeaderBytes = 64 * 1024;
constexpr std::size_t kMaxFields = 256;
constexpr std::size_t kMaxValues = 4096;     // of one field
constexpr double kMaxResidual = 2;           // of the pin-hole fit [px]
constexpr std::size_t kMinimalPoints = 100;  // that a fit can be trusted with

struct Field {
    std::string name;
    char type = 'F';         ///< F, I or U
    std::size_t size = 4;    ///< bytes of a value
    std::size_t count = 1;   ///< values
    std::size_t offset = 0;  ///< bytes before this field, in a point
    [[nodiscard]] std::size_t bytes() const { return size * count; }
};

struct Header {
    std::vector<Field> fields;
    int width = 0;
    int height = 0;
    std::string data;       ///< ascii, binary, binary_compressed
    std::size_t begin = 0;  ///< of the data, in the file
    std::size_t pointBytes = 0;
    [[nodiscard]] std::size_t points() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    [[nodiscard]] const Field* find(std::string_view name) const {
        const auto found = std::ranges::find(fields, name, &Field::name);
        return found == fields.end() ? nullptr : &*found;
    }
};

bool recognises(const ImportFile& file) {
    return file.head().starts_with("# .PCD") ||
           (file.head().starts_with("VERSION") && file.head().find("\nFIELDS ") != std::string::npos);
}

/// Reads the words of header lines as numbers, with messages that name the line.
class HeaderReader {
  public:
    explicit HeaderReader(const ImportFile& file) : file_(file) {}

    [[nodiscard]] Header read() {
        const std::string& bytes = file_.bytes();
        Header header;
        long points = -1;
        std::vector<long> sizes;
        std::vector<long> counts;
        std::string types;
        while (header.data.empty()) {
            const std::size_t end = bytes.find('\n', header.begin);
            if (end == std::string::npos || end > kMaxHeaderBytes)
                file_.fail("the PCD header has no end, expected a line \"DATA ...\"");
            std::istringstream line(bytes.substr(header.begin, end - header.begin));
            header.begin = end + 1;
            std::string key;
            if (!(line >> key) || key.starts_with("#")) continue;
            std::vector<std::string> words;
            for (std::string word; line >> word;) words.push_back(word);
            if (words.size() > kMaxFields) fail(key, "has " + std::to_string(words.size()) + " values");
            if (words.empty()) fail(key, "has no value");
            if (key == "FIELDS")
                for (const std::string& word : words) header.fields.emplace_back().name = word;
            else if (key == "SIZE")
                sizes = numbers(key, words);
            else if (key == "TYPE")
                for (const std::string& word : words) types += word.size() == 1 ? word[0] : '?';
            else if (key == "COUNT")
                counts = numbers(key, words);
            else if (key == "WIDTH")
                header.width = side(key, words);
            else if (key == "HEIGHT")
                header.height = side(key, words);
            else if (key == "POINTS")
                points = numbers(key, words)[0];
            else if (key == "DATA")
                header.data = words[0];
        }
        if (counts.empty()) counts.assign(header.fields.size(), 1);
        completeFields(header, sizes, types, counts);
        if (header.height < 2)
            file_.fail("the point cloud has WIDTH " + std::to_string(header.width) + " and HEIGHT " +
                       std::to_string(header.height) + ", expected a raster of points (HEIGHT of 2 or more)");
        if (static_cast<long>(header.points()) > kMaxImagePixels)
            file_.fail("the point cloud has " + std::to_string(header.width) + "x" + std::to_string(header.height) +
                       " points, expected at most " + std::to_string(kMaxImagePixels));
        if (points != -1 && points != static_cast<long>(header.points()))
            fail("POINTS",
                 "is " + std::to_string(points) + ", expected WIDTH times HEIGHT, " + std::to_string(header.points()));
        return header;
    }

  private:
    [[noreturn]] void fail(const std::string& key, const std::string& reason) const {
        file_.fail("the PCD header's " + key + " " + reason);
    }

    [[nodiscard]] std::vector<long> numbers(const std::string& key, const std::vector<std::string>& words) const {
        std::vector<long> result;
        for (const std::string& word : words) {
            long value = 0;
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
            if (error != std::errc() || end != word.data() + word.size())
                fail(key, "is \"" + word + "\", expected a whole number");
            result.push_back(value);
        }
        return result;
    }

    [[nodiscard]] int side(const std::string& key, const std::vector<std::string>& words) const {
        const long value = numbers(key, words)[0];
        if (value < 1 || value > kMaxImageSide)
            fail(key, "is " + std::to_string(value) + ", expected 1 to " + std::to_string(kMaxImageSide));
        return static_cast<int>(value);
    }

    void completeFields(Header& header, const std::vector<long>& sizes, const std::string& types,
                        const std::vector<long>& counts) const {
        const std::size_t n = header.fields.size();
        if (n == 0 || sizes.size() != n || types.size() != n || counts.size() != n)
            file_.fail("the PCD header's FIELDS, SIZE, TYPE and COUNT have " + std::to_string(n) + ", " +
                       std::to_string(sizes.size()) + ", " + std::to_string(types.size()) + " and " +
                       std::to_string(counts.size()) + " values, expected the same number");
        for (std::size_t i = 0; i < n; ++i) {
            if (sizes[i] != 1 && sizes[i] != 2 && sizes[i] != 4 && sizes[i] != 8)
                fail("SIZE", "has the value " + std::to_string(sizes[i]) + ", expected 1, 2, 4 or 8");
            if (counts[i] < 1 || counts[i] > static_cast<long>(kMaxValues))
                fail("COUNT",
                     "has the value " + std::to_string(counts[i]) + ", expected 1 to " + std::to_string(kMaxValues));
            if (types[i] != 'F' && types[i] != 'I' && types[i] != 'U')
                fail("TYPE", "has the value \"" + types.substr(i, 1) + "\", expected F, I or U");
            Field& field = header.fields[i];
            field.type = types[i];
            field.size = static_cast<std::size_t>(sizes[i]);
            field.count = static_cast<std::size_t>(counts[i]);
            field.offset = header.pointBytes;
            header.pointBytes += field.bytes();
        }
    }

    const ImportFile& file_;
};

/// The points as raw bytes, whatever the layout in the file.
class Points {
  public:
    Points(const ImportFile& file, Header header) : file_(file), header_(std::move(header)) {
        if (header_.data == "ascii")
            parseText();
        else if (header_.data == "binary")
            bytes_ = std::string(payload(header_.begin, header_.points() * header_.pointBytes));
        else if (header_.data == "binary_compressed")
            decompress();
        else
            file.fail("the PCD header's DATA is \"" + header_.data + "\", expected ascii, binary or binary_compressed");
    }

    [[nodiscard]] const Header& header() const { return header_; }

    /// First value of a field of point `i`, which is a float of 4 or 8 bytes.
    [[nodiscard]] double real(const Field& field, std::size_t i) const {
        if (field.size == 8) return load<double>(field, i);
        return static_cast<double>(load<float>(field, i));
    }
    /// The same of a field of 4 bytes, as stored.
    [[nodiscard]] std::uint32_t word(const Field& field, std::size_t i) const { return load<std::uint32_t>(field, i); }

  private:
    template <class T>
    [[nodiscard]] T load(const Field& field, std::size_t i) const {
        T value;
        std::memcpy(&value, bytes_.data() + position(field, i), sizeof value);
        return value;
    }

    [[nodiscard]] std::size_t position(const Field& field, std::size_t i) const {
        if (byField_) return header_.points() * field.offset + i * field.bytes();
        return i * header_.pointBytes + field.offset;
    }

    [[nodiscard]] std::string_view payload(std::size_t begin, std::size_t size) const {
        const std::string& bytes = file_.bytes();
        if (begin > bytes.size() || size > bytes.size() - begin)
            file_.fail("the file is truncated: its points take " + std::to_string(size) + " bytes, " +
                       std::to_string(bytes.size() - std::min(begin, bytes.size())) + " are there");
        return std::string_view(bytes).substr(begin, size);
    }

    void decompress() {
        std::uint32_t sizes[2];
        std::memcpy(sizes, payload(header_.begin, sizeof sizes).data(), sizeof sizes);
        const std::size_t expected = header_.points() * header_.pointBytes;
        if (sizes[1] != expected)
            file_.fail("its points unpack to " + std::to_string(sizes[1]) + " bytes, expected " +
                       std::to_string(expected));
        auto unpacked = lzfDecompress(payload(header_.begin + sizeof sizes, sizes[0]), expected);
        if (!unpacked) file_.fail("its compressed points (LZF) are damaged");
        bytes_ = std::move(*unpacked);
        byField_ = true;
    }

    void parseText() {
        const std::string& text = file_.bytes();
        // A value takes a digit and a space at least.
        std::size_t values = 0;
        for (const Field& field : header_.fields) values += field.count;
        if (header_.points() > (text.size() - header_.begin + 1) / 2 / values)
            file_.fail("the file is truncated: expected " + std::to_string(header_.points()) + " lines of points");
        bytes_.resize(header_.points() * header_.pointBytes);
        const char* at = text.data() + header_.begin;
        const char* const end = text.data() + text.size();
        for (std::size_t i = 0; i < header_.points(); ++i)
            for (const Field& field : header_.fields)
                for (std::size_t k = 0; k < field.count; ++k) {
                    while (at != end && std::isspace(static_cast<unsigned char>(*at)) != 0) ++at;
                    at = parseValue(at, end, field,
                                    bytes_.data() + i * header_.pointBytes + field.offset + k * field.size);
                    if (at == nullptr)
                        file_.fail("point " + std::to_string(i) + " has no value for the field \"" + field.name + "\"");
                }
    }

    /// One number to its stored form; nullptr when there is none. Fields that are not needed are skipped.
    static const char* parseValue(const char* at, const char* end, const Field& field, char* target) {
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

    const ImportFile& file_;
    Header header_;
    std::string bytes_;
    bool byField_ = false;
};

const Field& requireReal(const ImportFile& file, const Header& header, const char* name) {
    const Field* field = header.find(name);
    if (field == nullptr || field->type != 'F' || field->size < 4)
        file.fail("the point cloud has no field \"" + std::string(name) + "\" of type F and size 4 or 8");
    return *field;
}

/// Least squares line through (slope of the ray, image coordinate): focal length and principal point.
class AxisFit {
  public:
    void add(double slope, double coordinate) {
        ++n_;
        sx_ += slope;
        sy_ += coordinate;
        sxx_ += slope * slope;
        sxy_ += slope * coordinate;
        syy_ += coordinate * coordinate;
    }
    [[nodiscard]] double focal() const { return (n_ * sxy_ - sx_ * sy_) / (n_ * sxx_ - sx_ * sx_); }
    [[nodiscard]] double center() const { return (sy_ - focal() * sx_) / n_; }
    /// Root mean square distance from the line.
    [[nodiscard]] double residual() const {
        const double f = focal();
        const double c = center();
        const double sum = syy_ + f * f * sxx_ + n_ * c * c - 2 * f * sxy_ - 2 * c * sy_ + 2 * f * c * sx_;
        return std::sqrt(std::max(sum, 0.0) / n_);
    }

  private:
    double n_ = 0, sx_ = 0, sy_ = 0, sxx_ = 0, sxy_ = 0, syy_ = 0;
};

Camera fitCamera(const ImportFile& file, const Points& points, const Field& x, const Field& y, const ImageF& depth) {
    AxisFit horizontal;
    AxisFit vertical;
    std::size_t valid = 0;
    for (int v = 0; v < depth.height(); ++v)
        for (int u = 0; u < depth.width(); ++u) {
            const std::size_t i = depth.index(u, v);
            const auto z = static_cast<double>(depth[i]);
            const double slopeX = points.real(x, i) / z;
            const double slopeY = points.real(y, i) / z;
            if (!(z > 0) || !std::isfinite(slopeX) || !std::isfinite(slopeY)) continue;
            horizontal.add(slopeX, u + 0.5);
            vertical.add(slopeY, v + 0.5);
            ++valid;
        }
    if (valid < kMinimalPoints)
        file.fail("only " + std::to_string(valid) + " points have x, y and z > 0, expected " +
                  std::to_string(kMinimalPoints) + " or more");
    const Camera camera{depth.width(),
                        depth.height(),
                        static_cast<float>(horizontal.focal()),
                        static_cast<float>(vertical.focal()),
                        static_cast<float>(horizontal.center()),
                        static_cast<float>(vertical.center())};
    const double residual = std::max(horizontal.residual(), vertical.residual());
    if (!(camera.fx > 0) || !(camera.fy > 0) || !(residual <= kMaxResidual)) {
        std::ostringstream text;
        text << "its raster is not what a pin-hole camera sees (fx=" << camera.fx << ", fy=" << camera.fy << ", off by "
             << residual << " pixels), expected x to the right, y downwards, z forward";
        file.fail(text.str());
    }
    return camera;
}

ImportedPhoto read(const ImportFile& file) {
    const Points points(file, HeaderReader(file).read());
    const Header& header = points.header();
    const Field& x = requireReal(file, header, "x");
    const Field& y = requireReal(file, header, "y");
    const Field& z = requireReal(file, header, "z");
    const Field* color = header.find("rgba");
    if (color == nullptr) color = header.find("rgb");
    if (color == nullptr || color->size != 4)
        file.fail("the point cloud has no colours, expected a field \"rgb\" or \"rgba\" of size 4");

    ImportedPhoto photo;
    photo.kind = DepthKind::Z;
    photo.color = ImageRgb(header.width, header.height);
    photo.depth = ImageF(header.width, header.height);
    for (std::size_t i = 0; i < photo.depth.size(); ++i) {
        photo.depth[i] = static_cast<float>(points.real(z, i));
        const std::uint32_t argb = points.word(*color, i);
        photo.color[i] = Vector3f(static_cast<float>(argb >> 16U & 255U), static_cast<float>(argb >> 8U & 255U),
                                  static_cast<float>(argb & 255U)) /
                         255.0f;
    }
    decodeSrgb(photo.color.pixels());
    photo.camera = fitCamera(file, points, x, y, photo.depth);
    return photo;
}

}  // namespace

const ImportFormat pcdFormat{"an organised point cloud (PCD)", recognises, read};

}  // namespace core
