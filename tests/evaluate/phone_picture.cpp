// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/phone_picture.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/color.h"
#include "core/io/image_io.h"
#include "core/io/project.h"
#include "tests/evaluate/metrics.h"

namespace evaluate {

namespace fs = std::filesystem;
using core::ImageF;
using core::ImageRgb;

namespace {

constexpr double kReduction = 2.5;
constexpr float kShiftX = 0.6f;
constexpr float kShiftY = -0.4f;

float clampedAt(const ImageF& image, int x, int y) {
    return image(std::clamp(x, 0, image.width() - 1), std::clamp(y, 0, image.height() - 1));
}

/// Means over the area of each new pixel, along x.
ImageF reducedRows(const ImageF& image, int width) {
    ImageF result(width, image.height());
    const double scale = static_cast<double>(image.width()) / width;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < width; ++x) {
            const double from = x * scale;
            const double to = from + scale;
            double sum = 0;
            for (int u = static_cast<int>(from); u < std::min(to, static_cast<double>(image.width())); ++u)
                sum +=
                    (std::min(to, u + 1.0) - std::max(from, static_cast<double>(u))) * static_cast<double>(image(u, y));
            result(x, y) = static_cast<float>(sum / scale);
        }
    }
    return result;
}

ImageF transposed(const ImageF& image) {
    ImageF result(image.height(), image.width());
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) result(y, x) = image(x, y);
    return result;
}

ImageF median3(const ImageF& image) {
    ImageF result(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            std::array<float, 9> values{};
            for (int k = 0; k < 9; ++k)
                values[static_cast<std::size_t>(k)] = clampedAt(image, x + k % 3 - 1, y + k / 3 - 1);
            std::ranges::nth_element(values, values.begin() + 4);
            result(x, y) = values[4];
        }
    }
    return result;
}

ImageF blurredRows(const ImageF& image) {
    ImageF result(image.width(), image.height());
    const auto mirrored = [&](int x) {
        x = std::abs(x);
        return x < image.width() ? x : 2 * (image.width() - 1) - x;
    };
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            float sum = 0;
            float weights = 0;
            for (int d = -4; d <= 4; ++d) {
                const float w = std::exp(-0.5f * static_cast<float>(d * d));
                sum += w * image(mirrored(x + d), y);
                weights += w;
            }
            result(x, y) = sum / weights;
        }
    }
    return result;
}

ImageF shifted(const ImageF& image) {
    ImageF result(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const float u = static_cast<float>(x) - kShiftX;
            const float v = static_cast<float>(y) - kShiftY;
            const int x0 = static_cast<int>(std::floor(u));
            const int y0 = static_cast<int>(std::floor(v));
            const float fx = u - static_cast<float>(x0);
            const float fy = v - static_cast<float>(y0);
            result(x, y) = (1 - fy) * ((1 - fx) * clampedAt(image, x0, y0) + fx * clampedAt(image, x0 + 1, y0)) +
                           fy * ((1 - fx) * clampedAt(image, x0, y0 + 1) + fx * clampedAt(image, x0 + 1, y0 + 1));
        }
    }
    return result;
}

void roundTo8Bits(ImageF& image) {
    const auto [lowest, highest] = std::ranges::minmax_element(image.pixels());
    const float low = *lowest;
    const float range = *highest - low;
    if (!(range > 0)) return;
    for (float& value : image.pixels()) value = low + std::round((value - low) / range * 255) / 255 * range;
}

ImageF phoneDisparity(const ImageF& depth) {
    ImageF disparity(depth.width(), depth.height());
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (!(depth[i] > 0)) continue;
        disparity[i] = 1 / depth[i];
        least = std::min(least, disparity[i]);
    }
    // A phone measures everywhere: what is far becomes a wall.
    for (float& value : disparity.pixels())
        if (!(value > 0)) value = 0.8f * least;
    const auto size = [](int full) { return std::max(8, static_cast<int>(std::lround(full / kReduction))); };
    ImageF small =
        transposed(reducedRows(transposed(reducedRows(disparity, size(depth.width()))), size(depth.height())));
    small = median3(small);
    small = transposed(blurredRows(transposed(blurredRows(small))));
    small = shifted(small);
    roundTo8Bits(small);
    return small;
}

void saveJpeg(const ImageRgb& encoded, const fs::path& path) {
    std::vector<std::uint8_t> bytes;
    for (const core::Vector3f& color : encoded.pixels())
        for (int c = 0; c < 3; ++c) bytes.push_back(static_cast<std::uint8_t>(color[c] * 255 + 0.5f));
    OIIO::ImageSpec spec(encoded.width(), encoded.height(), 3, OIIO::TypeDesc::UINT8);
    spec.attribute("Compression", "jpeg:92");
    const auto output = OIIO::ImageOutput::create(path.string());
    if (!output || !output->open(path.string(), spec) || !output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) ||
        !output->close())
        throw core::Error(core::ErrorKind::Output, "Cannot write \"" + path.string() + "\".");
}

}  // namespace

float phoneWhite(const SceneFolder& folder) {
    std::vector<float> brightest;
    for (const core::Vector3f& color : folder.scene.photo->color.pixels()) brightest.push_back(color.maxCoeff());
    return std::max(static_cast<float>(quantile(std::move(brightest), 0.98)), 1e-6f);
}

core::Scene phoneScene(const SceneFolder& folder, PhoneDepth depth, const fs::path& temporary) {
    const core::Photo& photo = *folder.scene.photo;
    core::CreateOptions options;
    options.color = (temporary / "phone.jpg").string();
    options.segments = (folder.path / "segments.png").string();
    options.intrinsics = photo.camera;
    saveJpeg(displayEncoded(photo.color, 1 / phoneWhite(folder)), options.color);
    if (depth == PhoneDepth::Exact) {
        options.depth = (folder.path / "depth.exr").string();
    } else {
        options.depth = (temporary / "disparity.exr").string();
        options.depthKind = core::DepthKind::Disparity;
        options.depthUnit = 1;
        core::saveScalar(phoneDisparity(photo.depth), options.depth, "Y");
    }
    core::Scene scene = core::createScene(options);
    scene.segments = folder.scene.segments;
    scene.render = folder.scene.render;
    return scene;
}

}  // namespace evaluate
