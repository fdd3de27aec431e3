// SPDX-License-Identifier: GPL-3.0-or-later
// Normals in the band along outlines where a depth map goes to pieces.
#include "core/analysis/depth/repair_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using core::Vector3f;

constexpr int kFoldSize = 120;
constexpr float kRadius = 50;  // [px]

struct Shown {
    core::Camera camera;
    core::LabelImage labels{kFoldSize, kFoldSize, 0};
    core::Surface surface;
};

/// Of a pixel, from the middle of the picture [px].
float centred(int x) { return static_cast<float>(x) + 0.5f - 0.5f * kFoldSize; }

/// A picture whose labelled pixels have the given normals, on a plane 1 m away.
template <class Normal>
Shown shown(const Normal& normal) {
    Shown s;
    s.camera.fx = s.camera.fy = 10 * kFoldSize;  // as good as parallel rays
    s.camera.cx = s.camera.cy = 0.5f * kFoldSize;
    s.surface.depth = core::ImageF(kFoldSize, kFoldSize, 1.0f);
    s.surface.normal = core::ImageV3(kFoldSize, kFoldSize, Vector3f(0, 0, -1));
    s.surface.position = core::ImageV3(kFoldSize, kFoldSize, Vector3f(0, 0, 1));
    s.surface.area = core::ImageF(kFoldSize, kFoldSize, 1.0f);
    for (int y = 0; y < kFoldSize; ++y)
        for (int x = 0; x < kFoldSize; ++x) {
            s.surface.position(x, y) = s.camera.backProject(x, y, 1);
            const Vector3f n = normal(centred(x) / kRadius, centred(y) / kRadius);
            if (n.isZero(0)) continue;
            s.labels(x, y) = 3;
            s.surface.normal(x, y) = n;
        }
    return s;
}

Vector3f sphere(float u, float v) {
    const float inside = 1 - u * u - v * v;
    return inside > 0 ? Vector3f(u, v, -std::sqrt(inside)) : Vector3f(0, 0, 0);
}

/// Two faces that meet in a vertical edge.
Vector3f crease(float u, float v) {
    if (std::max(std::abs(u), std::abs(v)) > 1) return {0, 0, 0};
    return Vector3f(u < 0 ? -1.0f : 1.0f, 0, -1).normalized();
}

float degrees(const Vector3f& a, const Vector3f& b) { return std::acos(std::clamp(a.dot(b), -1.0f, 1.0f)) * 57.2958f; }

double median(std::vector<float> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return static_cast<double>(*middle);
}

/// Normals of the six pixels along the outline, and with `depthToo` their depth, go to pieces. Returns those pixels.
std::vector<std::size_t> breakRim(Shown& scene, unsigned seed, bool depthToo) {
    std::mt19937 random(seed);
    std::normal_distribution<float> spread(0, 1);
    std::vector<std::size_t> wrong;
    for (int y = 0; y < kFoldSize; ++y)
        for (int x = 0; x < kFoldSize; ++x) {
            const float r = std::hypot(centred(x), centred(y));
            if (r >= kRadius || r < kRadius - 6) continue;
            Vector3f n(spread(random), spread(random), spread(random));
            n.z() = -std::abs(n.z()) - 0.1f;
            scene.surface.normal(x, y) = n.normalized();
            wrong.push_back(scene.labels.index(x, y));
            if (!depthToo) continue;
            const float z = 1 + 0.01f * std::abs(spread(random));
            scene.surface.depth(x, y) = z;
            scene.surface.position(x, y) = scene.camera.backProject(x, y, z);
        }
    return wrong;
}

TEST(RepairNormals, ABrokenRimFollowsWhatIsBesideIt) {
    const Shown truth = shown(sphere);
    Shown broken = truth;
    const std::vector<std::size_t> wrong = breakRim(broken, 1, false);
    Shown settled = broken;
    core::analysis::repairNormals(settled.surface, settled.labels, settled.camera, 1, core::Progress());
    std::vector<float> before, after;
    for (const std::size_t i : wrong) {
        before.push_back(degrees(broken.surface.normal[i], truth.surface.normal[i]));
        after.push_back(degrees(settled.surface.normal[i], truth.surface.normal[i]));
    }
    EXPECT_GT(median(before), 40);
    EXPECT_LT(median(after), 25);
    for (int y = 0; y < kFoldSize; ++y)
        for (int x = 0; x < kFoldSize; ++x) {
            const float r = std::hypot(centred(x), centred(y));
            if (r > kRadius - 9) continue;
            ASSERT_EQ(settled.surface.normal(x, y), truth.surface.normal(x, y)) << x << " " << y;
        }
}

TEST(RepairNormals, DepthFollowsTheNormals) {
    const Shown truth = shown(
        [](float u, float v) -> Vector3f { return std::hypot(u, v) < 1 ? Vector3f(0, 0, -1) : Vector3f(0, 0, 0); });
    Shown broken = truth;
    const std::vector<std::size_t> wrong = breakRim(broken, 2, true);
    core::analysis::repairNormals(broken.surface, broken.labels, broken.camera, 1, core::Progress());
    std::vector<float> off;
    for (const std::size_t i : wrong) {
        off.push_back(std::abs(broken.surface.depth[i] - 1));
        EXPECT_EQ(broken.surface.position[i].z(), broken.surface.depth[i]);
    }
    EXPECT_LT(median(off), 2e-4) << "rays that start in a dent hit its walls";
}

TEST(RepairNormals, CreasesRimsAndWhatHasNoLabelStay) {
    for (const auto& normal : {sphere, crease}) {
        const Shown truth = shown(normal);
        Shown settled = truth;
        core::analysis::repairNormals(settled.surface, settled.labels, settled.camera, 1, core::Progress());
        int changed = 0, count = 0;
        for (std::size_t i = 0; i < truth.labels.size(); ++i) {
            if (truth.labels[i] != 0) ++count;
            if (settled.surface.normal[i] != truth.surface.normal[i]) ++changed;
        }
        EXPECT_LT(changed, count / 200);
        settled = truth;
        for (std::size_t i = 0; i < truth.labels.size(); ++i) settled.labels[i] = 0;
        settled.surface.normal(60, 60) = Vector3f(1, 0, 0);
        core::analysis::repairNormals(settled.surface, settled.labels, settled.camera, 1, core::Progress());
        EXPECT_EQ(settled.surface.normal(60, 60), Vector3f(1, 0, 0));
    }
}

}  // namespace
