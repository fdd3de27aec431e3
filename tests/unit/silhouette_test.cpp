// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shading/silhouette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace core {
namespace {

constexpr int kPictureSize = 64;

/// A ball of `radius` pixels before a background, each pixel the mean of 16 x 16 samples; labels and depth, as cameras
/// and annotators give them, are those of the pixel's centre.
struct Photograph {
    ImageRgb color{kPictureSize, kPictureSize};
    LabelImage labels{kPictureSize, kPictureSize};
    ImageF depth{kPictureSize, kPictureSize};
    ImageF coverage{kPictureSize, kPictureSize};  ///< true
};
using Radiance = std::function<Vector3f(float x, float y)>;
Photograph photograph(float radius, const Radiance& ball, const Radiance& background) {
    constexpr int kGrid = 16;
    Photograph p;
    const auto covered = [&](float x, float y) { return std::hypot(x - 31.3f, y - 32.6f) < radius; };
    for (int y = 0; y < kPictureSize; ++y)
        for (int x = 0; x < kPictureSize; ++x) {
            Vector3f sum = Vector3f::Zero();
            float inside = 0;
            for (int j = 0; j < kGrid; ++j)
                for (int i = 0; i < kGrid; ++i) {
                    const float u = static_cast<float>(x) + (static_cast<float>(i) + 0.5f) / kGrid;
                    const float v = static_cast<float>(y) + (static_cast<float>(j) + 0.5f) / kGrid;
                    sum += covered(u, v) ? ball(u, v) : background(u, v);
                    inside += covered(u, v) ? 1.0f : 0.0f;
                }
            p.color(x, y) = sum / (kGrid * kGrid);
            p.coverage(x, y) = inside / (kGrid * kGrid);
            const bool center = covered(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            p.labels(x, y) = center ? 2 : 1;
            p.depth(x, y) = center ? 1.0f : 2.0f;
        }
    return p;
}

/// What stopping at the label does (`corrected` false), or what the list says.
ImageRgb edited(const Photograph& p, const Radiance& material, bool corrected) {
    ImageRgb result = p.color;
    for (int y = 0; y < kPictureSize; ++y)
        for (int x = 0; x < kPictureSize; ++x)
            if (p.labels(x, y) == 2)
                result(x, y) = material(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    if (!corrected) return result;
    for (const SilhouettePixel& s : findSilhouette(p.color, p.labels, p.depth, 2, {0, 0, 1}, CoverageFrom::Colors))
        result(s.x, s.y) = s.coverage * result(s.sourceX, s.sourceY) + s.kept;
    return result;
}

/// Root mean square error over the pixels the outline passes through.
double outlineError(const Photograph& p, const ImageRgb& image, const ImageRgb& truth) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (p.coverage[i] <= 0 || p.coverage[i] >= 1) continue;
        sum += static_cast<double>((image[i] - truth[i]).squaredNorm()) / 3;
        ++count;
    }
    EXPECT_GT(count, 100);
    return std::sqrt(sum / count);
}

const Radiance kGold = [](float x, float) -> Vector3f { return Vector3f(0.8f, 0.5f, 0.1f) * (0.7f + 0.005f * x); };
const Radiance kBlue = [](float, float y) -> Vector3f { return Vector3f(0.1f, 0.25f, 0.9f) * (0.6f + 0.005f * y); };
const Radiance kTable = [](float x, float y) -> Vector3f {
    return Vector3f(0.05f, 0.3f, 0.05f) * (1 + 0.01f * x + 0.005f * y);
};

TEST(Silhouette, NoFringeOfTheOldMaterialOrTheBackgroundRemains) {
    const Photograph before = photograph(20.4f, kGold, kTable);
    const Photograph truth = photograph(20.4f, kBlue, kTable);
    const double plain = outlineError(before, edited(before, kBlue, false), truth.color);
    const double corrected = outlineError(before, edited(before, kBlue, true), truth.color);
    EXPECT_GT(plain, 0.1) << "the test must be able to fail";
    EXPECT_LT(corrected, plain / 8);
}

TEST(Silhouette, FindsTheCoverage) {
    const Photograph p = photograph(20.4f, kGold, kTable);
    for (const SilhouettePixel& s : findSilhouette(p.color, p.labels, p.depth, 2, {0, 0, 1}, CoverageFrom::Colors))
        EXPECT_NEAR(s.coverage, p.coverage(s.x, s.y), 0.08f) << s.x << " " << s.y;
}

TEST(Silhouette, LabelsTellTheCoverageWhereColoursDoNot) {
    // A mirror: its rim shows the background.
    const auto mirror = [](float x, float y) -> Vector3f {
        const float r = std::hypot(x - 31.3f, y - 32.6f);
        return r > 17 ? kTable(x, y) : Vector3f(3, 2, 1) * (0.3f + 0.03f * y);
    };
    for (const float radius : {9.3f, 20.4f}) {
        const Photograph p = photograph(radius, mirror, kTable);
        double squares = 0;
        double ofTheLabel = 0;
        int mixed = 0;
        ImageF found(kPictureSize, kPictureSize);
        for (int y = 0; y < kPictureSize; ++y)
            for (int x = 0; x < kPictureSize; ++x) found(x, y) = p.labels(x, y) == 2 ? 1.0f : 0.0f;
        const ImageF label = found;
        for (const SilhouettePixel& s : findSilhouette(p.color, p.labels, p.depth, 2, {0, 0, 1}, CoverageFrom::Labels))
            found(s.x, s.y) = s.coverage;
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (p.coverage[i] <= 0 || p.coverage[i] >= 1) continue;
            squares += std::pow(found[i] - p.coverage[i], 2);
            ofTheLabel += std::pow(label[i] - p.coverage[i], 2);
            ++mixed;
        }
        EXPECT_LT(std::sqrt(squares / mixed), 0.12) << radius;
        EXPECT_GT(std::sqrt(ofTheLabel / mixed), 0.25) << "the test must be able to fail";
    }
}

TEST(Silhouette, BelievesTheLabelWhereColoursDoNotTell) {
    const Photograph p = photograph(20.4f, kGold, kGold);
    EXPECT_TRUE(findSilhouette(p.color, p.labels, p.depth, 2, {0, 0, 1}, CoverageFrom::Colors).empty());
}

TEST(Silhouette, KeepsEverythingElse) {
    const Photograph p = photograph(20.4f, kGold, kTable);
    const ImageRgb result = edited(p, kBlue, true);
    for (int y = 0; y < kPictureSize; ++y)
        for (int x = 0; x < kPictureSize; ++x) {
            if (p.coverage(x, y) > 0) continue;
            EXPECT_EQ(result(x, y), p.color(x, y)) << x << " " << y;
        }
    EXPECT_LT(outlineError(p, edited(p, kGold, true), p.color), outlineError(p, edited(p, kGold, false), p.color) / 8)
        << "the same material again";
}

TEST(Silhouette, AllOfThePhotographIsThePhotograph) {
    const Photograph p = photograph(20.4f, kGold, kTable);
    for (const SilhouettePixel& s : findSilhouette(p.color, p.labels, p.depth, 2, {0, 0, 1}, CoverageFrom::Colors)) {
        const Vector3f shown = p.color(s.sourceX, s.sourceY);  // new weight 0, old weight 1
        EXPECT_NEAR((s.coverage * shown + s.kept + s.keptOriginal - p.color(s.x, s.y)).norm(), 0, 0.01) << s.x;
    }
}

TEST(Silhouette, LeavesOtherEditedSegmentsAndThinOrEmptyOnesAlone) {
    const Photograph p = photograph(20.4f, kGold, kTable);
    for (const SilhouettePixel& s : findSilhouette(p.color, p.labels, p.depth, 2, {0, 1, 1}, CoverageFrom::Colors))
        EXPECT_EQ(p.labels(s.x, s.y), 2);
    const Photograph thin = photograph(1.2f, kGold, kTable);
    EXPECT_TRUE(findSilhouette(thin.color, thin.labels, thin.depth, 2, {0, 0, 1}, CoverageFrom::Colors).empty())
        << "no clean inside";
    EXPECT_TRUE(
        findSilhouette(p.color, p.labels, ImageF(kPictureSize, kPictureSize, 0.0f), 2, {0, 0, 1}, CoverageFrom::Colors)
            .empty());
    EXPECT_TRUE(findSilhouette(p.color, p.labels, p.depth, 7, {0, 0, 1}, CoverageFrom::Colors).empty());
}

}  // namespace
}  // namespace core
