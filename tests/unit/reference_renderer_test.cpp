// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shading/reference_renderer.h"
#include "core/material/translucency.h"
#include "core/shading/image_filter.h"
#include "core/shading/segment_shading.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>

#include "tests/support/analytic_scene.h"

namespace core {
namespace {

using test::AnalyticHit;
using test::AnalyticScene;
using test::squareCamera;

/// Left half segment 1, right half segment 2, top rows without depth.
AnalyticScene twoHalves() {
    AnalyticScene s(squareCamera(8, 8), [](const Vector3f& ray) {
        AnalyticHit hit{.front = 1, .back = 2, .label = static_cast<std::uint16_t>(ray.x() < 0 ? 1 : 2)};
        if (ray.y() < -0.3f) hit.front = 0;
        hit.color = Vector3f(0.1f, 0.2f, 0.3f);
        return hit;
    });
    s.setEnvironment([](const Vector3f&) { return Vector3f(1, 1, 1); });
    return s;
}

TEST(SegmentShading, FollowsEditsAndGlossyFlags) {
    AnalyticScene s = twoHalves();
    auto shading = buildSegmentShading(s.scene, *s.analysis);
    ASSERT_EQ(shading.size(), 3u);
    for (const auto& entry : shading) {
        EXPECT_EQ(entry.blend.w, 0) << "nothing edited: every path ends with the photograph";
        EXPECT_EQ(entry.diffuse.w, 0);
    }
    s.edit(1, "phong").blendOriginal = 0.25f;
    s.scene.findSegment(2)->glossy = true;
    auto rho = std::make_shared<Reflectance>();
    rho->label = 2;
    rho->rho = Vector3f(0.9f, 0.6f, 0.3f);
    s.analysis->reflectances.push_back(rho);
    shading = buildSegmentShading(s.scene, *s.analysis);
    EXPECT_EQ(shading[1].brdf.type, 2u);
    EXPECT_EQ(shading[1].blend.y, 0.25f);
    EXPECT_EQ(shading[1].blend.w, 1);
    EXPECT_EQ(shading[1].diffuse.w, 1);
    EXPECT_EQ(shading[2].brdf.type, 3u) << "glossy: GGX";
    EXPECT_EQ(shading[2].brdf.values.x, 0.05f);
    EXPECT_EQ(shading[2].brdf.specular.y, 0.6f);
    EXPECT_EQ(shading[2].blend.w, 1);
    EXPECT_EQ(shading[2].diffuse.w, 0) << "glossy is not edited";
}

TEST(SegmentShading, SpecularComesFromTheUserThenTheEstimateThenWhite) {
    AnalyticScene s = twoHalves();
    Segment& segment = *s.scene.findSegment(2);
    EXPECT_EQ(specularOf(segment, *s.analysis), Vector3f(1, 1, 1));
    auto rho = std::make_shared<Reflectance>();
    rho->label = 2;
    rho->rho = Vector3f(0.9f, 0.6f, 0.3f);
    s.analysis->reflectances.push_back(rho);
    EXPECT_EQ(specularOf(segment, *s.analysis), rho->rho);
    segment.reflectance = Vector3f(0.2f, 0.2f, 0.2f);
    EXPECT_EQ(specularOf(segment, *s.analysis), *segment.reflectance);
}

TEST(SegmentShading, TranslucentBodyIsALambertOneForOtherSurfaces) {
    AnalyticScene s = twoHalves();
    Material& m = s.edit(1, "none");
    m.translucency.emplace().eta = 1;
    const kernel::SegmentShading shading = buildSegmentShading(s.scene, *s.analysis)[1];
    EXPECT_EQ(shading.blend.z, 1);
    EXPECT_NEAR(shading.diffuse.x, diffuseReflectance(*m.translucency).x(), 1e-6);
    kernel::vec3 weight;
    const kernel::vec3 up(0, 0, 1);
    EXPECT_LE(kernel::path_scatter(shading, kernel::kPathPrimary, 1, up, kernel::vec2(0.5f, 0.5f), weight).z, 0)
        << "the camera sees its translucent light, computed elsewhere, and no reflection";
    EXPECT_GT(kernel::path_scatter(shading, kernel::kPathLater, 1, up, kernel::vec2(0.5f, 0.5f), weight).z, 0);
    EXPECT_EQ(weight.x, shading.diffuse.x);
}

TEST(ReferenceComposite, LeavesEverythingElseBitForBit) {
    AnalyticScene s = twoHalves();
    Material& m = s.edit(2, "lambert");
    m.blendNew = 0.5f;
    m.blendOriginal = 0.25f;
    m.translucency.emplace().weight = 3;
    const ReferenceRenderer renderer(s.scene, s.analysis);
    const ImageRgb reshaded(8, 8, Vector3f(1, 1, 1));
    const ImageRgb translucent(8, 8, Vector3f(0.5f, 0, 0));
    const ImageRgb result = renderer.composite(reshaded, translucent);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            if (s.scene.photo->labels(x, y) == 2) {
                EXPECT_NEAR(result(x, y).x(), 0.5f * (1 + 3 * 0.5f) + 0.25f * 0.1f, 1e-6);
                EXPECT_NEAR(result(x, y).y(), 0.5f + 0.25f * 0.2f, 1e-6);
            } else {
                EXPECT_EQ(result(x, y), s.scene.photo->color(x, y)) << x << " " << y;
            }
        }
}

TEST(ReferenceRender, WithoutEditsIsThePhotograph) {
    AnalyticScene s = twoHalves();
    s.scene.render.filter = true;
    EXPECT_EQ(renderReference(s.scene, s.analysis), s.scene.photo->color);
}

TEST(ReferenceRender, RepeatsAndSumsInAnyOrder) {
    AnalyticScene s = twoHalves();
    s.setEnvironment([](const Vector3f& d) { return Vector3f(1 + d.x(), 1 + d.y(), 1); });
    s.edit(1, "lambert");
    const ReferenceRenderer renderer(s.scene, s.analysis);
    const Accumulation all = renderer.reshade(8);
    const Accumulation again = renderer.reshade(8);
    const Accumulation first = renderer.reshade(5);
    const Accumulation rest = renderer.reshade(3, 5);
    EXPECT_EQ(all.sum, again.sum);
    for (std::size_t i = 0; i < all.sum.size(); ++i)
        EXPECT_NEAR((first.sum[i] + rest.sum[i] - all.sum[i]).cwiseAbs().maxCoeff(), 0, 1e-5);
}

TEST(ReferenceRender, StopsWhenAsked) {
    AnalyticScene s = twoHalves();
    s.edit(1, "lambert");
    const std::atomic<bool> cancel{true};
    const core::Progress progress({}, &cancel);
    try {
        static_cast<void>(renderReference(s.scene, s.analysis, progress));
        FAIL() << "a cancelled render must not return";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Cancelled);
    }
}

}  // namespace
}  // namespace core
