// SPDX-License-Identifier: GPL-3.0-or-later
// The depth filter on noisy depth: analytic scenes, and the path-traced photographs of PATINA_REFERENCE_DATA.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "core/analysis/depth/depth_noise.h"
#include "core/analysis/depth/normals.h"
#include "core/analysis/depth/upsample_depth.h"
#include "core/analysis/step.h"
#include "core/io/image_io.h"
#include "core/io/image_reader.h"
#include "tests/support/ray_scene.h"
#include "tests/support/sensor_noise.h"

namespace {

using core::ImageF;
using core::ImageV3;
using core::Vector3f;

/// White noise blurred by a Gaussian of `sigma` [px], with a standard deviation of 1.
ImageF correlatedNoise(int width, int height, float sigma) {
    std::mt19937 random(7);
    std::normal_distribution<float> normal;
    ImageF noise(width, height);
    for (float& v : noise.pixels()) v = normal(random);
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    for (const bool horizontal : {true, false}) {
        ImageF blurred(width, height);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                float sum = 0, squares = 0;
                for (int i = -radius; i <= radius; ++i) {
                    const int u = std::clamp(x + (horizontal ? i : 0), 0, width - 1);
                    const int v = std::clamp(y + (horizontal ? 0 : i), 0, height - 1);
                    const float k = std::exp(-static_cast<float>(i * i) / (2 * sigma * sigma));
                    sum += k * noise(u, v);
                    squares += k * k;
                }
                blurred(x, y) = sum / std::sqrt(squares);
            }
        }
        noise = std::move(blurred);
    }
    return noise;
}

/// Adds noise of inverse depth [1/m]: that of a triangulating sensor, z² times this in depth.
ImageF withInverseNoise(ImageF depth, const ImageF& noise, float sigma) {
    for (std::size_t i = 0; i < depth.size(); ++i)
        if (depth[i] > 0) depth[i] = 1 / (1 / depth[i] + sigma * noise[i]);
    return depth;
}

float medianAngle(const ImageV3& normals, const ImageV3& truth, const std::vector<bool>& counts) {
    std::vector<float> angles;
    for (std::size_t i = 0; i < normals.size(); ++i)
        if (counts[i] && !truth[i].isZero())
            angles.push_back(std::acos(std::clamp(truth[i].normalized().dot(normals[i]), -1.0f, 1.0f)) * 180 /
                             std::numbers::pi_v<float>);
    const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
    std::ranges::nth_element(angles, middle);
    return *middle;
}

/// Normals as the analysis computes them from a photograph, with the depth filter or without.
ImageV3 analysedNormals(const core::Photo& photo, bool filter) {
    core::Scene scene;
    scene.photo = std::make_shared<core::Photo>(photo);
    scene.depthFilter.enabled = filter;
    core::analysis::Board board;
    board.scene = &scene;
    core::analysis::recoverDepthStep().run(board, {});
    core::analysis::computeNormalsStep().run(board, {});
    return board.front->normal;
}

TEST(DepthNoise, CorrelationLengthAndDeviationAreFound) {
    core::ImageF inverse(480, 360);
    for (int y = 0; y < 360; ++y)
        for (int x = 0; x < 480; ++x)
            inverse(x, y) = 1 + 0.001f * static_cast<float>(x) + 0.0005f * static_cast<float>(y);
    const core::LabelImage labels(480, 360);
    const auto estimate = [&](float sigma) {
        core::ImageF noisy = inverse;
        const core::ImageF noise = correlatedNoise(480, 360, sigma);
        for (std::size_t i = 0; i < noisy.size(); ++i) noisy[i] += 0.002f * noise[i];
        return core::analysis::estimateDepthNoise(noisy, labels, 1, {});
    };
    const auto white = estimate(0.1f);
    EXPECT_EQ(white.correlationLength, 1);
    EXPECT_NEAR(white.deviation.at(1.3f), 0.002f, 0.0003f);
    const auto correlated = estimate(2.5f);
    EXPECT_GE(correlated.correlationLength, 4);
    EXPECT_LE(correlated.correlationLength, 8);
    EXPECT_NEAR(correlated.deviation.at(1.3f), 0.002f, 0.0006f);
    EXPECT_EQ(core::analysis::estimateDepthNoise(inverse, labels, 1, {}).relative, 0);
}

TEST(DepthNoise, FilterHelpsOnAStillLife) {
    const test::RayScene scene = test::stillLife(test::testCamera(480, 360));
    core::Photo photo = scene.photograph();
    const ImageV3 truth = scene.frontSurface().normal;
    const ImageF exact = photo.depth;
    std::vector<bool> things(exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) things[i] = photo.labels[i] > 1;
    const auto check = [&](const char* what, const ImageF& noisy, float factor) {
        photo.depth = noisy;
        const float before = medianAngle(analysedNormals(photo, false), truth, things);
        const float after = medianAngle(analysedNormals(photo, true), truth, things);
        std::printf("still life, %s: normals %.2f deg before, %.2f after\n", what, before, after);
        EXPECT_LT(after, 5) << what;
        EXPECT_LT(after, factor * before) << what;
    };
    check("sensor noise", test::withSensorNoise(exact), 0.5f);
    check("correlated noise", withInverseNoise(exact, correlatedNoise(480, 360, 2.5f), 0.001f), 0.7f);
    photo.depth = exact;
    EXPECT_EQ(analysedNormals(photo, true), analysedNormals(photo, false)) << "exact depth is left alone";
}

/// The still life with depth in steps of disparity, as telephones store it: from a map `factor` times smaller.
core::Photo withEnlargedTerraces(int width, int height, float factor) {
    core::Photo photo = test::stillLife(test::testCamera(width, height)).photograph();
    ImageF map = test::stillLife(test::testCamera(static_cast<int>(std::lround(static_cast<float>(width) / factor)),
                                                  static_cast<int>(std::lround(static_cast<float>(height) / factor))))
                     .photograph()
                     .depth;
    constexpr float kStep = 0.006f;  // [1/m], 256 of them from 0.65 m to infinity
    for (float& z : map.pixels())
        if (z > 0) z = 1 / (kStep * std::round(1 / (kStep * z)));
    photo.depth = core::upsampleDepth(map, width, height, &photo.color.image());
    for (std::size_t i = 0; i < photo.labels.size(); ++i)
        if (photo.labels[i] == 0) photo.depth[i] = 0;
    photo.depthSampleSpacing = factor;
    return photo;
}

TEST(DepthNoise, TerracesOfAnEnlargedMapAreSmoothed) {
    for (const float factor : {1.05f, 2.0f}) {
        const core::Photo photo = withEnlargedTerraces(480, 360, factor);
        const auto noise =
            core::analysis::estimateDepthNoise(core::analysis::inverseOf(photo.depth), photo.labels, factor, {});
        EXPECT_TRUE(noise.quantised) << factor;
        // The floor's rows are level, so that rows between two steps look like steps of their own.
        EXPECT_GT(noise.deviation.at(1), 0.4f * 0.006f / std::sqrt(12.0f)) << factor;
        EXPECT_LT(noise.deviation.at(1), 1.1f * 0.006f / std::sqrt(12.0f)) << factor;
        const ImageV3 truth = test::stillLife(test::testCamera(480, 360)).frontSurface().normal;
        std::vector<bool> things(photo.depth.size());
        for (std::size_t i = 0; i < things.size(); ++i) things[i] = photo.labels[i] > 1;
        const float before = medianAngle(analysedNormals(photo, false), truth, things);
        const float after = medianAngle(analysedNormals(photo, true), truth, things);
        std::printf("still life, map enlarged by %.2f: normals %.2f deg before, %.2f after\n",
                    static_cast<double>(factor), static_cast<double>(before), static_cast<double>(after));
        EXPECT_LT(after, 0.5f * before) << factor;
    }
}

/// Depth in 8 bits of disparity over its own range, as telephones store it.
ImageF inEightBits(ImageF depth) {
    float low = 1e9f, high = 0;
    for (const float z : depth.pixels())
        if (z > 0) low = std::min(low, 1 / z), high = std::max(high, 1 / z);
    const float step = (high - low) / 255;
    for (float& z : depth.pixels())
        if (z > 0) z = 1 / (low + step * std::round((1 / z - low) / step));
    return depth;
}

TEST(DepthNoise, RoundingIsFoundWhereDepthIsSteepToo) {
    // A floor that falls by four steps of rounding and a bit from row to row, and exactly so.
    constexpr float kStep = 0.001f;
    ImageF rounded(480, 360), exact(480, 360);
    for (int y = 0; y < 360; ++y) {
        for (int x = 0; x < 480; ++x) {
            rounded(x, y) = 1 + kStep * std::round(4.1f * static_cast<float>(y) + 0.13f * static_cast<float>(x));
            exact(x, y) = 1 + kStep * 4.1f * static_cast<float>(y);
        }
    }
    const core::LabelImage labels(480, 360);
    const auto noise = core::analysis::estimateDepthNoise(rounded, labels, 1, {});
    EXPECT_TRUE(noise.quantised);
    EXPECT_NEAR(noise.deviation.at(1.7f), kStep / std::sqrt(12.0f), 0.1f * kStep);
    EXPECT_EQ(core::analysis::estimateDepthNoise(exact, labels, 1, {}).relative, 0);
}

TEST(DepthNoise, RoundingBeforeTheLastResamplingIsFound) {
    // A slope in steps of four codes of a byte whose edges a resampling has smeared over three pixels.
    constexpr float kCode = 0.001f;
    const auto slope = [](int x, int y) {
        return 4 * std::round(0.02f * static_cast<float>(x) + 0.031f * static_cast<float>(y));
    };
    ImageF smeared(480, 360), fine(480, 360);
    for (int y = 0; y < 360; ++y) {
        for (int x = 0; x < 480; ++x) {
            const float code = std::round((slope(x - 1, y) + 2 * slope(x, y) + slope(x + 1, y)) / 4);
            smeared(x, y) = 0.1f + kCode * code;
            fine(x, y) = 0.1f + kCode * std::round(0.08f * static_cast<float>(x) + 0.124f * static_cast<float>(y));
        }
    }
    const core::LabelImage labels(480, 360);
    const auto coarse = core::analysis::estimateDepthNoise(smeared, labels, 1, {});
    EXPECT_TRUE(coarse.quantised);
    EXPECT_NEAR(coarse.deviation.at(0.15f), 4 * kCode / std::sqrt(12.0f), 0.4f * kCode);
    const auto byte = core::analysis::estimateDepthNoise(fine, labels, 1, {});
    EXPECT_NEAR(byte.deviation.at(0.15f), kCode / std::sqrt(12.0f), 0.1f * kCode);
}

TEST(DepthNoise, AreasOfANoisySquareAddUp) {
    test::RayScene scene;
    scene.camera = test::testCamera(480, 360);
    scene.objects.push_back(
        {1,
         std::make_shared<test::Box>(Eigen::Vector3d(0.02, -0.01, 1), Eigen::Vector3d(0.2, 0.2, 1e-6),
                                     test::rotation(0.6, {0.3, 1, 0})),
         {}});
    core::Scene input;
    core::Photo photo = scene.photograph();
    photo.depth = withInverseNoise(photo.depth, correlatedNoise(480, 360, 2.5f), 0.001f);
    input.photo = std::make_shared<core::Photo>(photo);
    core::analysis::Board board;
    board.scene = &input;
    core::analysis::recoverDepthStep().run(board, {});
    core::analysis::computeNormalsStep().run(board, {});
    double sum = 0;
    for (const float a : board.front->area.pixels()) sum += static_cast<double>(a);
    EXPECT_NEAR(sum, 0.16, 0.02 * 0.16);
}

class DepthReferenceData : public testing::TestWithParam<const char*> {};

TEST_P(DepthReferenceData, FilterHelps) {
    const char* root = std::getenv("PATINA_REFERENCE_DATA");
    if (root == nullptr || *root == '\0')
        GTEST_SKIP() << "PATINA_REFERENCE_DATA is not set: no path-traced photographs to compare with.";
    const std::filesystem::path folder = std::filesystem::path(root) / GetParam();
    nlohmann::json json;
    std::ifstream(folder / "scene.json") >> json;
    core::Photo photo;
    photo.color = core::loadColor((folder / "color.exr").string());
    photo.labels = core::loadLabels((folder / "segments.png").string());
    photo.camera = {photo.color.width(), photo.color.height(), json["fx"], json["fy"], json["cx"], json["cy"]};
    const ImageF exact = core::loadScalar((folder / "depth.exr").string());
    const ImageV3 truth = core::ImageReader((folder / "normal.exr").string()).readRgb(0, 1, 2);
    std::uint16_t table = 0;
    for (const auto& segment : json["segments"])
        if (segment["name"] == "table") table = segment["label"];
    std::vector<bool> things(exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i)
        things[i] = exact[i] > 0 && photo.labels[i] != 0 && photo.labels[i] != table;

    photo.depth = exact;
    EXPECT_LT(medianAngle(analysedNormals(photo, true), truth, things), 2) << "exact depth";
    const auto check = [&](const char* what, const ImageF& noisy) {
        photo.depth = noisy;
        const float before = medianAngle(analysedNormals(photo, false), truth, things);
        const float after = medianAngle(analysedNormals(photo, true), truth, things);
        std::printf("%s, %s: normals %.2f deg before, %.2f after\n", GetParam(), what, before, after);
        EXPECT_LT(after, before) << what;
        return after;
    };
    EXPECT_LT(check("sensor noise", test::withSensorNoise(exact)), 5);
    const int width = exact.width();
    const int height = exact.height();
    (void)check("8 bits of disparity", inEightBits(exact));
    (void)check("correlated noise", withInverseNoise(exact, correlatedNoise(width, height, 2.5f), 0.0012f));
}

INSTANTIATE_TEST_SUITE_P(Scenes, DepthReferenceData,
                         testing::Values("synthetic/dragon", "synthetic/sphere_bag", "synthetic/buddha", "studio"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::ranges::replace(name, '/', '_');
                             return name;
                         });

}  // namespace
