// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/shading/image_filter.h"
#include "shaders/shared/rng.h"
#include "tests/support/analytic_scene.h"

namespace core {
namespace {

using test::AnalyticHit;
using test::AnalyticScene;
using test::squareCamera;

constexpr int kSize = 64;

struct FilterScene {
    AnalyticScene scene{squareCamera(kSize, kSize), [](const Vector3f& ray) {
                            return AnalyticHit{
                                .front = 1, .back = 2, .label = static_cast<std::uint16_t>(ray.x() < 0 ? 1 : 2)};
                        }};

    [[nodiscard]] ImageRgb filter(const Accumulation& a, const std::vector<std::uint8_t>& edited = {0, 1, 1}) const {
        return filterReshaded(a, scene.scene.photo->camera, *scene.analysis->front, scene.scene.photo->labels, edited);
    }

    /// `samples` of mean `level(x)` with uniform noise of full width `noise` in every pixel.
    template <class F>
    [[nodiscard]] static Accumulation sums(int samples, const F& level, float noise) {
        Accumulation a{.sum = ImageRgb(kSize, kSize, Vector3f::Zero()),
                       .sumSquaredLuminance = ImageF(kSize, kSize),
                       .samples = samples};
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x)
                for (int s = 0; s < samples; ++s) {
                    const float v = level(x) + noise * (kernel::rng_float(static_cast<kernel::uint>(y * kSize + x),
                                                                          static_cast<kernel::uint>(s), 0, 1) -
                                                        0.5f);
                    a.sum(x, y) += Vector3f(v, v, v);
                    a.sumSquaredLuminance(x, y) += v * v;
                }
        return a;
    }
};

double deviation(const ImageRgb& image, float level, int x0, int x1) {
    double sum = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = x0; x < x1; ++x) sum += std::pow(static_cast<double>(image(x, y).x() - level), 2);
    return std::sqrt(sum / (kSize * (x1 - x0)));
}

TEST(ImageFilter, KeepsAConstant) {
    const FilterScene scene;
    const ImageRgb result = scene.filter(FilterScene::sums(
        8, [](int) { return 0.7f; }, 0));
    for (const Vector3f& c : result.pixels()) ASSERT_NEAR((c - Vector3f(0.7f, 0.7f, 0.7f)).norm(), 0, 1e-5);
}

TEST(ImageFilter, RemovesNoiseAndKeepsTheMean) {
    const FilterScene scene;
    for (const int samples : {1, 2, 4, 16}) {
        const Accumulation a = FilterScene::sums(
            samples, [](int) { return 1.0f; }, 1);
        const ImageRgb result = scene.filter(a);
        const double before = deviation(meanRadiance(a), 1, 0, 32);
        EXPECT_LT(deviation(result, 1, 0, 32), 0.15 * before) << samples;
        double mean = 0;
        for (const Vector3f& c : result.pixels()) mean += static_cast<double>(c.x()) / (kSize * kSize);
        EXPECT_NEAR(mean, 1, 0.01) << samples;
    }
}

TEST(ImageFilter, NeverMixesSegmentsNorTouchesUneditedOnes) {
    const FilterScene scene;
    const auto level = [](int x) { return x < kSize / 2 ? 1.0f : 1.2f; };
    const Accumulation a = FilterScene::sums(1, level, 1);
    const ImageRgb both = scene.filter(a);
    const ImageRgb left = scene.filter(a, {0, 1, 0});
    Accumulation other = a;
    for (int y = 0; y < kSize; ++y)
        for (int x = kSize / 2; x < kSize; ++x) other.sum(x, y) = Vector3f(1e6f, 0, 0);
    const ImageRgb shielded = scene.filter(other);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            if (x < kSize / 2) {
                ASSERT_EQ(both(x, y), left(x, y));
                ASSERT_EQ(both(x, y), shielded(x, y)) << "no light from the other segment";
            } else {
                ASSERT_EQ(left(x, y), a.sum(x, y)) << "not edited: as it was";
            }
        }
}

TEST(ImageFilter, FadesOutAsTheNoiseDoes) {
    // A pattern of fixed contrast inside a segment: the less noise, the less of it is smoothed away.
    const FilterScene scene;
    const auto level = [](int x) { return x % 8 < 4 ? 1.0f : 1.2f; };
    double last = 1;
    for (const int samples : {4, 64, 1024}) {
        const Accumulation a = FilterScene::sums(samples, level, 1);
        const ImageRgb result = scene.filter(a);
        const ImageRgb mean = meanRadiance(a);
        double change = 0;
        for (std::size_t i = 0; i < mean.size(); ++i)
            change = std::max(change, static_cast<double>((result[i] - mean[i]).norm()));
        EXPECT_LT(change, last);
        last = change;
    }
    EXPECT_LT(last, 0.06);
    Accumulation exact = FilterScene::sums(4, level, 0);
    const ImageRgb result = scene.filter(exact);
    for (std::size_t i = 0; i < result.size(); ++i)
        ASSERT_NEAR((result[i] - exact.sum[i] / 4).norm(), 0, 1e-4) << "without noise nothing changes";
}

TEST(ImageFilter, NoSamplesNoResult) {
    const FilterScene scene;
    Accumulation a = FilterScene::sums(
        0, [](int) { return 1.0f; }, 0);
    const ImageRgb result = scene.filter(a);
    for (const Vector3f& c : result.pixels()) ASSERT_EQ(c, Vector3f::Zero());
}

}  // namespace
}  // namespace core
