// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <optional>
#include <random>

#include "core/selection/selector.h"

namespace {

using core::BinaryMask;
using core::Camera;
using core::ImageF;
using core::ImageRgb;
using core::Pixel;
using core::SelectionSeeds;
using core::Selector;
using core::Vector3f;

/// A photograph with known objects.
struct KnownPicture {
    ImageRgb color;
    ImageF depth;
    Camera camera;
    core::LabelImage truth;

    [[nodiscard]] Selector selector() const { return Selector({color, depth, camera, 1}); }
    [[nodiscard]] BinaryMask object(std::uint16_t label) const {
        BinaryMask mask(truth.width(), truth.height());
        for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = truth[i] == label ? 1 : 0;
        return mask;
    }
    /// Mean of the pixels of an object.
    [[nodiscard]] Pixel middle(std::uint16_t label) const {
        long sumX = 0, sumY = 0, count = 0;
        for (int y = 0; y < truth.height(); ++y)
            for (int x = 0; x < truth.width(); ++x)
                if (truth(x, y) == label) sumX += x, sumY += y, ++count;
        EXPECT_GT(count, 500) << "the scene shows object " << label;
        return {static_cast<int>(sumX / count), static_cast<int>(sumY / count)};
    }
};

double overlap(const BinaryMask& a, const BinaryMask& b) {
    std::size_t both = 0, any = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += a[i] != 0 && b[i] != 0 ? 1 : 0;
        any += a[i] != 0 || b[i] != 0 ? 1 : 0;
    }
    return any == 0 ? 1 : static_cast<double>(both) / static_cast<double>(any);
}

struct Sphere {
    Vector3f center;
    float radius;
};

/// Distance along `ray` (z = 1) to a sphere, 0 = missed.
float meet(const Sphere& sphere, const Vector3f& ray) {
    const float a = ray.squaredNorm(), b = ray.dot(sphere.center);
    const float d = b * b - a * (sphere.center.squaredNorm() - sphere.radius * sphere.radius);
    return d > 0 ? (b - std::sqrt(d)) / a : 0.0f;
}

/// Two spheres, labels 1 and 2, on a table seen from above. All have the same colour but for texture, so only depth
/// tells them apart. `noise`: relative, of depth.
KnownPicture spheresOnTable(float noise = 0) {
    constexpr int kWidth = 240, kHeight = 180;
    KnownPicture picture{ImageRgb(kWidth, kHeight), ImageF(kWidth, kHeight),
                         Camera::fromHorizontalFov(kWidth, kHeight, 0.9f), core::LabelImage(kWidth, kHeight)};
    const Vector3f up = Vector3f(0, -0.8f, -0.6f);
    const float height = -0.5f;  // of the table along `up`
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    const auto resting = [&](float x, float along, float radius) {
        const Vector3f forward(0, -0.6f, 0.8f);
        return Sphere{Vector3f(x, 0, 0) + along * forward + (height + radius) * up, radius};
    };
    const Sphere spheres[] = {resting(-0.12f, 0.65f, 0.08f), resting(0.14f, 0.75f, 0.06f)};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Vector3f ray = picture.camera.pixelRay(x, y);
            float z = height / up.dot(ray);
            for (std::uint16_t k = 0; k < 2; ++k)
                if (const float hit = meet(spheres[k], ray); hit > 0)
                    z = hit, picture.truth(x, y) = static_cast<std::uint16_t>(k + 1);
            picture.depth(x, y) = z * (1 + noise * normal(random));
            picture.color(x, y) = Vector3f::Constant(0.3f + 0.01f * normal(random));
        }
    return picture;
}

/// A red disc, label 1, on grey; its depth, nearer, lies `shift` pixels to the right. Without depth when nullopt.
KnownPicture discWithDepth(std::optional<int> shift) {
    constexpr int kWidth = 300, kHeight = 220;
    KnownPicture picture{ImageRgb(kWidth, kHeight), shift ? ImageF(kWidth, kHeight) : ImageF(),
                         Camera::fromHorizontalFov(kWidth, kHeight, 1), core::LabelImage(kWidth, kHeight)};
    std::mt19937 random(2);
    std::normal_distribution<float> normal;
    const auto inDisc = [](int x, int y) { return (x - 140) * (x - 140) + (y - 110) * (y - 110) < 60 * 60; };
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            picture.color(x, y) = (inDisc(x, y) ? Vector3f(0.5f, 0.12f, 0.1f) : Vector3f(0.3f, 0.32f, 0.35f)) *
                                  (1 + 0.03f * normal(random));
            picture.truth(x, y) = inDisc(x, y) ? 1 : 0;
            if (shift) picture.depth(x, y) = inDisc(x - *shift, y) ? 1.0f : 1.5f;
        }
    return picture;
}

TEST(Selector, OneClickTakesWhatStandsOnATable) {
    const KnownPicture picture = spheresOnTable();
    const Selector selector = picture.selector();
    for (const std::uint16_t label : {std::uint16_t{1}, std::uint16_t{2}})
        EXPECT_GT(overlap(selector.select({{picture.middle(label)}, {}}), picture.object(label)), 0.95) << label;
}

TEST(Selector, NoisyDepthIsEnough) {
    const KnownPicture picture = spheresOnTable(0.002f);
    EXPECT_GT(overlap(picture.selector().select({{picture.middle(1)}, {}}), picture.object(1)), 0.8);
}

TEST(Selector, WorksWithoutDepth) {
    const KnownPicture picture = discWithDepth({});
    EXPECT_GT(overlap(picture.selector().select({{{130, 100}}, {}}), picture.object(1)), 0.98);
    KnownPicture empty = picture;
    empty.depth = ImageF(picture.color.width(), picture.color.height());
    EXPECT_EQ(empty.selector().select({{{130, 100}}, {}}), picture.selector().select({{{130, 100}}, {}}));
}

TEST(Selector, TheOutlineFollowsThePhotographNotTheDepthMap) {
    const KnownPicture picture = discWithDepth(10);
    KnownPicture shifted = picture;
    for (int y = 0; y < picture.truth.height(); ++y)
        for (int x = 0; x < picture.truth.width(); ++x) shifted.truth(x, y) = picture.depth(x, y) < 1.2f ? 1 : 0;
    const BinaryMask mask = picture.selector().select({{{140, 110}}, {}});
    EXPECT_GT(overlap(mask, picture.object(1)), 0.97);
    EXPECT_LT(overlap(mask, shifted.object(1)), 0.9);
}

TEST(Selector, PixelsWithoutDepthCanBeClicked) {
    KnownPicture picture = discWithDepth(0);
    for (int y = 95; y < 125; ++y)
        for (int x = 125; x < 155; ++x) picture.depth(x, y) = 0;
    const BinaryMask mask = picture.selector().select({{{140, 110}}, {}});
    EXPECT_EQ(mask(140, 110), 1);
    EXPECT_EQ(mask(20, 20), 0);
}

TEST(Selector, HolesOfASensorAreNoOutline) {
    // A pale disc. Depth lies beside its edges, and is missing across its outline.
    KnownPicture picture = discWithDepth(6);
    for (int y = 0; y < picture.truth.height(); ++y)
        for (int x = 0; x < picture.truth.width(); ++x) {
            Vector3f& color = picture.color(x, y);
            if (picture.truth(x, y) != 0) color = 0.35f * color + 0.65f * Vector3f(0.3f, 0.32f, 0.35f);
            if ((x - 120) * (x - 120) + (y - 112) * (y - 112) < 18 * 18) color *= 1.5f;
            if (x >= 30 && x < 170 && y >= 60 && y < 160) picture.depth(x, y) = 0;
        }
    EXPECT_GT(overlap(picture.selector().select({{{175, 110}}, {}}), picture.object(1)), 0.95);
}

TEST(Selector, SeedsAreObeyed) {
    const KnownPicture picture = spheresOnTable();
    const Pixel a = picture.middle(1), b = picture.middle(2);
    const SelectionSeeds seeds{{a, b}, {{a.x + 3, a.y + 2}, {a.x + 1, a.y}, {120, 20}}};
    const BinaryMask mask = picture.selector().select(seeds);
    for (const Pixel& p : seeds.add) EXPECT_EQ(mask(p.x, p.y), 1) << p.x << ", " << p.y;
    for (const Pixel& p : seeds.remove) EXPECT_EQ(mask(p.x, p.y), 0) << p.x << ", " << p.y;
}

TEST(Selector, FurtherClicksAddAndRemove) {
    const KnownPicture picture = spheresOnTable();
    const Pixel a = picture.middle(1), b = picture.middle(2);
    const Selector selector = picture.selector();
    BinaryMask truth = picture.object(1);
    for (std::size_t i = 0; i < truth.size(); ++i) truth[i] = picture.truth[i] != 0 ? 1 : 0;
    EXPECT_GT(overlap(selector.select({{a, b}, {}}), truth), 0.95);
    EXPECT_GT(overlap(selector.select({{a}, {b}}), picture.object(1)), 0.95);
}

TEST(Selector, RemovingAPartKeepsTheRest) {
    // A disc of two shades, and a bar beside it in the shade of its other half: a fifth of what one click takes.
    KnownPicture picture = discWithDepth({});
    std::mt19937 random(3);
    std::normal_distribution<float> normal;
    for (int y = 0; y < picture.truth.height(); ++y)
        for (int x = 0; x < picture.truth.width(); ++x) {
            const bool bar = picture.truth(x, y) == 0 && x >= 190 && x < 214 && y >= 60 && y < 160;
            if (picture.truth(x, y) == 0 && !bar) continue;
            if (bar) picture.truth(x, y) = 2;
            const float green = 0.12f + (x >= 140 && !bar ? 0.05f : 0.0f);
            picture.color(x, y) = Vector3f(0.5f, green, 0.1f) * (1 + 0.03f * normal(random));
        }
    const Selector selector = picture.selector();
    EXPECT_EQ(selector.select({{{110, 110}}, {}})(206, 110), 1) << "control: one click takes both";
    const BinaryMask mask = selector.select({{{110, 110}}, {{206, 110}}});
    EXPECT_EQ(mask(206, 110), 0);
    EXPECT_GT(overlap(mask, picture.object(1)), 0.8) << "the half beyond the first click stays";
}

std::size_t pixelsOf(const BinaryMask& mask) {
    return static_cast<std::size_t>(std::ranges::count(mask.pixels(), std::uint8_t{1}));
}

TEST(Selector, AClickBesideTheOutlineChangesOnlyDetails) {
    const KnownPicture picture = discWithDepth({});
    const Selector selector = picture.selector();
    const BinaryMask before = selector.select({{{140, 110}}, {}});
    // 4 px outside and inside of the outline, where the photograph shows nothing.
    const BinaryMask more = selector.select({{{140, 110}, {204, 110}}, {}});
    const BinaryMask less = selector.select({{{140, 110}}, {{196, 110}}});
    for (const BinaryMask* after : {&more, &less}) {
        std::size_t changed = 0;
        for (std::size_t i = 0; i < before.size(); ++i) changed += (*after)[i] != before[i] ? 1 : 0;
        EXPECT_GT(changed, 10);
        EXPECT_LT(changed, 250);
    }
    for (int x = 202; x <= 206; ++x) EXPECT_EQ(more(x, 110), 1) << x;
    for (int x = 194; x <= 198; ++x) EXPECT_EQ(less(x, 110), 0) << x;
}

TEST(Selector, TakesWhatAnObjectEncloses) {
    // A highlight that the depth camera did not see, on an object whose depth lies beside it.
    KnownPicture picture = discWithDepth(6);
    for (int y = 100; y < 112; ++y)
        for (int x = 150; x < 166; ++x) picture.color(x, y) = Vector3f(1, 1, 1), picture.depth(x, y) = 0;
    const Selector selector = picture.selector();
    const BinaryMask mask = selector.select({{{115, 120}}, {}});
    EXPECT_EQ(mask(158, 106), 1);
    const BinaryMask without = selector.select({{{115, 120}}, {{158, 106}}});
    EXPECT_EQ(without(158, 106), 0);
    EXPECT_EQ(without(154, 104), 0) << "the highlight goes as a whole";
    EXPECT_GT(pixelsOf(without), pixelsOf(mask) * 9 / 10) << "and takes nothing else along";
}

TEST(Selector, ARealHoleStaysOne) {
    // Through the hole the camera sees something farther.
    KnownPicture picture = discWithDepth(0);
    for (int y = 100; y < 112; ++y)
        for (int x = 150; x < 166; ++x) picture.color(x, y) = Vector3f(0.3f, 0.32f, 0.35f), picture.depth(x, y) = 1.5f;
    EXPECT_EQ(picture.selector().select({{{115, 120}}, {}})(158, 106), 0);
}

TEST(Selector, RefusesSeedsThatMakeNoSense) {
    const KnownPicture picture = discWithDepth({});
    const Selector selector = picture.selector();
    for (const Pixel outside : {Pixel{-1, 5}, Pixel{300, 5}, Pixel{5, 220}, Pixel{1000000, -1000000}}) {
        EXPECT_THROW((void)selector.select({{outside}, {}}), core::Error);
        EXPECT_THROW((void)selector.select({{{5, 5}}, {outside}}), core::Error);
    }
    EXPECT_THROW((void)selector.select({{{5, 5}}, {{5, 5}}}), core::Error);
    EXPECT_EQ(selector.select({{}, {{5, 5}}}), BinaryMask(300, 220));
    for (const Pixel corner : {Pixel{0, 0}, Pixel{299, 0}, Pixel{0, 219}, Pixel{299, 219}})
        EXPECT_EQ(selector.select({{corner}, {}})(corner.x, corner.y), 1);
}

TEST(Selector, APhotographOfOneColourIsOneObject) {
    const ImageRgb color(90, 70, Vector3f(0.2f, 0.4f, 0.6f));
    const Selector selector({color, ImageF(), Camera::fromHorizontalFov(90, 70, 1), 1});
    EXPECT_EQ(selector.select({{{40, 30}}, {}}), BinaryMask(90, 70, 1));
    const Selector black({ImageRgb(90, 70), ImageF(), Camera::fromHorizontalFov(90, 70, 1), 1});
    EXPECT_EQ(black.select({{{0, 0}}, {}}), BinaryMask(90, 70, 1));
}

TEST(Selector, TakesPicturesOfAnySize) {
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {1, 7}, {3, 3}, {500, 2}}) {
        const ImageRgb color(width, height, Vector3f(0.2f, 0.4f, 0.6f));
        const ImageF depth(width, height, 1.0f);
        const Selector selector({color, depth, Camera::fromHorizontalFov(width, height, 1), 1});
        const BinaryMask mask = selector.select({{{width - 1, height - 1}}, {}});
        EXPECT_EQ(mask(width - 1, height - 1), 1);
        EXPECT_TRUE(selector.propose().sameSize(mask));
    }
}

TEST(Selector, LargePicturesAreSelectedAtTheirOwnResolution) {
    // Above the working resolution; the edge lies on no multiple of the factor.
    constexpr int kWidth = 2001, kHeight = 1603;
    ImageRgb color(kWidth, kHeight, Vector3f(0.3f, 0.3f, 0.3f));
    BinaryMask truth(kWidth, kHeight);
    for (int y = 401; y < 1203; ++y)
        for (int x = 503; x < 1504; ++x) color(x, y) = Vector3f(0.1f, 0.3f, 0.5f), truth(x, y) = 1;
    const Selector selector({color, ImageF(), Camera::fromHorizontalFov(kWidth, kHeight, 1), 1});
    EXPECT_GT(overlap(selector.select({{{1000, 800}}, {}}), truth), 0.998);
}

TEST(Selector, DoesNotDependOnTheNumberOfThreads) {
    const KnownPicture picture = spheresOnTable(0.001f);
    const SelectionSeeds seeds{{picture.middle(1)}, {{120, 20}}};
    std::optional<BinaryMask> first;
    for (const std::size_t threads : {1U, 2U, 5U}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const Selector selector = picture.selector();
        const BinaryMask mask = selector.select(seeds);
        if (!first) first = mask;
        EXPECT_EQ(mask, *first) << threads;
    }
}

TEST(Selector, CanBeCancelled) {
    const KnownPicture picture = discWithDepth(0);
    std::atomic<bool> cancel{true};
    const core::Progress progress({}, &cancel);
    EXPECT_THROW(Selector({picture.color, picture.depth, picture.camera, 1}, progress), core::Error);
    const Selector selector = picture.selector();
    EXPECT_THROW((void)selector.select({{{5, 5}}, {}}, progress), core::Error);
    EXPECT_THROW((void)selector.propose(progress), core::Error);
}

TEST(Selector, ProposesTheObjectsOnTheTable) {
    const KnownPicture picture = spheresOnTable();
    const core::LabelImage found = picture.selector().propose();
    EXPECT_EQ(*std::ranges::max_element(found.pixels()), 2);
    for (const std::uint16_t label : {std::uint16_t{1}, std::uint16_t{2}}) {
        BinaryMask mask(found.width(), found.height());
        const BinaryMask truth = picture.object(label);
        const Pixel inside = picture.middle(label);
        for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = found[i] == found(inside.x, inside.y) ? 1 : 0;
        EXPECT_GT(overlap(mask, truth), 0.95) << label;
    }
    EXPECT_EQ(discWithDepth({}).selector().propose(), core::LabelImage(300, 220));
}

}  // namespace
