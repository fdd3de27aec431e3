// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "core/analysis/pipeline.h"
#include "core/analysis/step.h"
#include "core/io/project.h"
#include "tests/support/analytic_scene.h"

namespace {

using core::Vector3f;

constexpr int kWallSize = 200;
constexpr std::uint16_t kRelief = 1;
const Vector3f kWallNormal = Vector3f(0.3f, 0.2f, -1).normalized();

/// Exact depth of a tilted wall; what is left of its middle is another segment, with bumps 3 px wide.
core::Scene bumpyWall() {
    const core::Camera camera = test::squareCamera(kWallSize, kWallSize);
    return test::AnalyticScene(camera,
                               [&](const Vector3f& ray) {
                                   const float x = ray.x() * camera.fx;
                                   const float y = ray.y() * camera.fy;
                                   const bool relief = std::abs(x + 40) < 30 && std::abs(y) < 30;
                                   const auto wave = [](float v) {
                                       return std::cos(2 * std::numbers::pi_v<float> * v / 3);
                                   };
                                   return test::AnalyticHit{
                                       .front = -1 / kWallNormal.dot(ray) + (relief ? 4e-3f * wave(x) * wave(y) : 0.0f),
                                       .back = 3,
                                       .label = static_cast<std::uint16_t>(relief ? kRelief : 2)};
                               })
        .scene;
}

core::ImageF depthOf(const core::Scene& scene) {
    core::analysis::Board board;
    board.scene = &scene;
    core::analysis::recoverDepthStep().run(board, {});
    return board.depth->depth;
}

core::ImageV3 normalsOf(const core::Scene& scene) {
    core::analysis::Board board;
    board.scene = &scene;
    core::analysis::recoverDepthStep().run(board, {});
    core::analysis::computeNormalsStep().run(board, {});
    return board.front->normal;
}

/// Largest sine of the angle between the wall and the normals of the relief, its rim of `margin` pixels left out.
float reliefTilt(const core::Scene& scene, int margin) {
    const core::ImageV3 normals = normalsOf(scene);
    const core::LabelImage& labels = scene.photo->labels;
    float largest = 0;
    for (int y = margin; y < kWallSize - margin; ++y)
        for (int x = margin; x < kWallSize - margin; ++x)
            if (labels(x - margin, y) == kRelief && labels(x + margin, y) == kRelief &&
                labels(x, y - margin) == kRelief && labels(x, y + margin) == kRelief)
                largest = std::max(largest, normals(x, y).cross(kWallNormal).norm());
    return largest;
}

TEST(SegmentSmoothing, RemovesNarrowBumpsOfThatSegmentOnly) {
    core::Scene scene = bumpyWall();
    const float before = reliefTilt(scene, 6);
    EXPECT_GT(before, 0.1f);
    scene.findSegment(kRelief)->smoothing = 12;
    const float after = reliefTilt(scene, 6);
    EXPECT_LT(after, 0.02f * before) << before;
    const core::ImageF depth = depthOf(scene);
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (scene.photo->labels[i] == kRelief) continue;
        ASSERT_EQ(depth[i], scene.photo->depth[i]);
    }
}

TEST(SegmentSmoothing, ExactDepthIsKeptUnlessTheUserAsks) {
    core::Scene scene = bumpyWall();
    EXPECT_EQ(depthOf(scene), scene.photo->depth) << "automatic";
    scene.findSegment(kRelief)->smoothing = 0;
    EXPECT_EQ(depthOf(scene), scene.photo->depth) << "none";
    scene.findSegment(kRelief)->smoothing = 12;
    EXPECT_NE(depthOf(scene), scene.photo->depth);
    scene.depthFilter.enabled = false;
    EXPECT_EQ(depthOf(scene), scene.photo->depth) << "smoothing is part of the depth filter";
}

TEST(SegmentSmoothing, ReachesHalfOfTheSegmentAtMost) {
    core::Scene scene = bumpyWall();
    scene.findSegment(kRelief)->smoothing = 200;
    core::AnalysisPipeline pipeline;
    const auto analysis = pipeline.run(scene);
    EXPECT_NEAR(analysis->smoothing.at(kRelief), 0.5f * 60, 1);
    EXPECT_EQ(analysis->smoothing.at(2), 0);
}

TEST(SegmentSmoothing, AChangeRecomputesTheDepth) {
    core::Scene scene = bumpyWall();
    core::AnalysisPipeline pipeline;
    const auto front = [&](std::optional<float> smoothing) {
        scene.findSegment(kRelief)->smoothing = smoothing;
        return pipeline.run(scene)->front;
    };
    const auto automatic = front(std::nullopt);
    EXPECT_EQ(front(std::nullopt), automatic);
    const auto smooth = front(12.0f);
    EXPECT_NE(smooth->depth, automatic->depth);
    EXPECT_NE(front(0.0f), smooth);
}

TEST(SegmentSmoothing, ReliefOfDepthInMillimetresIsKept) {
    core::Scene scene = core::loadProject(PATINA_SAMPLES "/studio/studio.patina");
    const core::ImageV3 truth = normalsOf(scene);
    auto photo = std::make_shared<core::Photo>(*scene.photo);
    for (float& z : photo->depth.pixels()) z = std::round(1000 * z) / 1000;
    scene.photo = photo;
    struct Errors {
        float median, most;
    };
    // Median and 95 % of all segments but the table.
    const auto errors = [&] {
        const core::ImageV3 normals = normalsOf(scene);
        std::vector<float> angles;
        for (std::size_t i = 0; i < normals.size(); ++i)
            if (photo->labels[i] > 1 && !truth[i].isZero(0))
                angles.push_back(std::acos(std::clamp(truth[i].dot(normals[i]), -1.0f, 1.0f)) * 57.2958f);
        std::ranges::sort(angles);
        return Errors{angles[angles.size() / 2], angles[angles.size() * 95 / 100]};
    };
    const Errors smoothed = errors();
    for (core::Segment& segment : scene.segments) segment.smoothing = 0;
    const Errors unsmoothed = errors();
    std::printf("studio in millimetres: normals %.2f / %.1f deg, without smoothing %.2f / %.1f\n", smoothed.median,
                smoothed.most, unsmoothed.median, unsmoothed.most);
    EXPECT_LT(smoothed.median, 1.02f * unsmoothed.median);
    EXPECT_LT(smoothed.most, 1.02f * unsmoothed.most);
}

}  // namespace
