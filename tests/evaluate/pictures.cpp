// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/pictures.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/evaluate/metrics.h"

namespace evaluate {

using core::ImageF;
using core::ImageRgb;
using core::Vector3f;

namespace {

/// Red, yellow, green, cyan, blue for t from 0 to 1.
Vector3f rainbow(double t) {
    const auto channel = [&](double centre) {
        return static_cast<float>(std::clamp(1.5 - std::abs(4 * t - centre), 0.0, 1.0));
    };
    return {channel(0.5), channel(2), channel(3.5)};
}

}  // namespace

ImageRgb normalPicture(const core::ImageV3& normals) {
    ImageRgb picture(normals.width(), normals.height());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        if (normals[i].isZero()) continue;
        picture[i] = Vector3f::Constant(0.5f) + 0.5f * Vector3f(normals[i].x(), -normals[i].y(), -normals[i].z());
    }
    return picture;
}

std::pair<double, double> depthRange(const ImageF& depth) {
    std::vector<float> valid;
    for (const float z : depth.pixels())
        if (z > 0) valid.push_back(z);
    return {quantile(valid, 0.02), quantile(valid, 0.98)};
}

ImageRgb depthPicture(const ImageF& depth, std::pair<double, double> range) {
    ImageRgb picture(depth.width(), depth.height());
    const double span = std::max(range.second - range.first, 1e-9);
    for (std::size_t i = 0; i < depth.size(); ++i)
        if (depth[i] > 0) picture[i] = rainbow(std::clamp((depth[i] - range.first) / span, 0.0, 1.0));
    return picture;
}

ImageRgb heatPicture(const ImageF& values, double largest) {
    ImageRgb picture(values.width(), values.height());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto t = static_cast<float>(3 * values[i] / largest);
        picture[i] = Vector3f(std::clamp(t, 0.0f, 1.0f), std::clamp(t - 1, 0.0f, 1.0f), std::clamp(t - 2, 0.0f, 1.0f));
    }
    return picture;
}

ImageRgb differencePicture(const ImageRgb& a, const ImageRgb& b) {
    ImageRgb picture(a.width(), a.height());
    for (std::size_t i = 0; i < a.size(); ++i) picture[i] = (2 * (a[i] - b[i])).cwiseAbs().cwiseMin(1.0f);
    return picture;
}

Rect boundsOf(const core::Image<std::uint8_t>& mask, int margin) {
    Rect rect{mask.width(), mask.height(), 0, 0};
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            if (mask(x, y) == 0) continue;
            rect.x0 = std::min(rect.x0, x), rect.x1 = std::max(rect.x1, x + 1);
            rect.y0 = std::min(rect.y0, y), rect.y1 = std::max(rect.y1, y + 1);
        }
    }
    if (rect.x1 == 0) return {0, 0, mask.width(), mask.height()};
    return {std::max(rect.x0 - margin, 0), std::max(rect.y0 - margin, 0), std::min(rect.x1 + margin, mask.width()),
            std::min(rect.y1 + margin, mask.height())};
}

ImageRgb cropped(const ImageRgb& image, const Rect& rect) {
    ImageRgb result(rect.x1 - rect.x0, rect.y1 - rect.y0);
    for (int y = 0; y < result.height(); ++y)
        for (int x = 0; x < result.width(); ++x) result(x, y) = image(rect.x0 + x, rect.y0 + y);
    return result;
}

ImageRgb fitted(const ImageRgb& image, int width, int height) {
    const double scale =
        std::min(static_cast<double>(width) / image.width(), static_cast<double>(height) / image.height());
    const int w = std::clamp(static_cast<int>(std::lround(scale * image.width())), 1, width);
    const int h = std::clamp(static_cast<int>(std::lround(scale * image.height())), 1, height);
    // Tent filter as wide as a pixel of the coarser grid.
    const double radius = std::max(1.0, 1 / scale);
    const auto weights = [&](double centre, int size) {
        std::vector<std::pair<int, float>> list;
        double sum = 0;
        for (int i = static_cast<int>(std::floor(centre - radius)); i <= static_cast<int>(centre + radius); ++i) {
            const double weight = 1 - std::abs(i + 0.5 - centre) / radius;
            if (weight <= 0) continue;
            list.emplace_back(std::clamp(i, 0, size - 1), static_cast<float>(weight));
            sum += weight;
        }
        for (auto& entry : list) entry.second /= static_cast<float>(sum);
        return list;
    };
    ImageRgb rows(w, image.height());
    for (int x = 0; x < w; ++x)
        for (const auto& [i, weight] : weights((x + 0.5) * image.width() / w, image.width()))
            for (int y = 0; y < image.height(); ++y) rows(x, y) += weight * image(i, y);
    ImageRgb result(w, h);
    for (int y = 0; y < h; ++y)
        for (const auto& [i, weight] : weights((y + 0.5) * image.height() / h, image.height()))
            for (int x = 0; x < w; ++x) result(x, y) += weight * rows(x, i);
    return result;
}

void savePicture(const ImageRgb& picture, const std::string& path) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * picture.size());
    for (const Vector3f& pixel : picture.pixels())
        for (int c = 0; c < 3; ++c)
            bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(pixel[c], 0.0f, 1.0f))));
    OIIO::ImageSpec spec(picture.width(), picture.height(), 3, OIIO::TypeDesc::UINT8);
    spec["png:compressionLevel"] = 9;
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path);
    if (!output || !output->open(path, spec) || !output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) ||
        !output->close())
        throw core::Error(core::ErrorKind::Output, "\"" + path + "\" cannot be written.");
}

}  // namespace evaluate
