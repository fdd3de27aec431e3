// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "core/material/brdf.h"
#include "core/shading/reference_renderer.h"
#include "render/renderer.h"
#include "tests/gpu/render_support.h"

namespace {

using core::Vector3f;
using test::AnalyticScene;
using test::device;

constexpr int kPictureWidth = 96;
constexpr int kPictureHeight = 72;

/// Two balls on a floor under a coloured sky.
AnalyticScene smallStillLife() {
    return test::spheresOnFloor(
        kPictureWidth, kPictureHeight,
        {{Vector3f(-0.12f, 0.13f, 0.9f), 0.16f, 2, Vector3f(0.6f, 0.2f, 0.1f)},
         {Vector3f(0.2f, 0.16f, 1.05f), 0.13f, 3, Vector3f(0.1f, 0.3f, 0.7f)}},
        2.0f, [](const Vector3f& d) -> Vector3f { return Vector3f(0.6f, 0.8f, 1.2f) * (1 - 0.8f * d.y()); });
}

std::shared_ptr<const core::Mask> makeMask(const std::function<float(int, int)>& value) {
    core::ImageF values(kPictureWidth, kPictureHeight);
    for (int y = 0; y < kPictureHeight; ++y)
        for (int x = 0; x < kPictureWidth; ++x) values(x, y) = value(x, y);
    return std::make_shared<core::Mask>(values);
}

core::Drive drive(const char* parameter, std::shared_ptr<const core::Mask> mask, float from, float to) {
    core::Drive d;
    d.parameter = parameter;
    d.mask = std::move(mask);
    d.from = core::DriveEnd{.value = Vector3f::Constant(from), .factor = false};
    d.to = core::DriveEnd{.value = Vector3f::Constant(to), .factor = false};
    return d;
}

core::Scene edited(const AnalyticScene& source, const char* brdf, int samples) {
    core::Scene scene = source.scene;
    scene.findSegment(2)->edit = core::defaultMaterial(*core::findBrdf(brdf));
    scene.findSegment(2)->edit->specular = Vector3f(0.9f, 0.8f, 0.6f);
    scene.render.samples = samples;
    scene.render.filter = false;
    return scene;
}

std::shared_ptr<const core::Mask> ramp() {
    return makeMask([](int x, int y) { return static_cast<float>((x * 3 + y) % 40) / 39; });
}

/// Share of the segment's pixels that agree within `tolerance` (relative) + 1e-3.
double agreement(const core::ImageRgb& actual, const core::ImageRgb& expected, const core::LabelImage& labels,
                 std::uint16_t label, float tolerance = 0.002f) {
    double same = 0;
    double count = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i] != label) continue;
        ++count;
        same +=
            (actual[i] - expected[i]).cwiseAbs().maxCoeff() <= tolerance * expected[i].cwiseAbs().maxCoeff() + 1e-3f;
    }
    return same / count;
}

/// Renders all samples.
core::ImageRgb finish(render::Renderer& renderer, const core::Scene& scene, const AnalyticScene& source) {
    renderer.setScene(scene, source.analysis);
    for (int i = 0; i < 10000; ++i) {
        gpu::CommandEncoder encoder = device().createCommandEncoder({.label = "test"});
        const bool worked = renderer.record(encoder, 0.1);
        device().queue().submit(encoder.finish());
        device().waitIdle();
        if (!worked) break;
    }
    return render::readResult(device(), renderer);
}

TEST(Drives, FollowTheReferenceRendererPathByPath) {
    const AnalyticScene source = smallStillLife();
    const auto detail = std::make_shared<core::ImageF>(kPictureWidth, kPictureHeight);
    for (int y = 0; y < kPictureHeight; ++y)
        for (int x = 0; x < kPictureWidth; ++x) (*detail)(x, y) = 1 + 0.5f * std::sin(static_cast<float>(x + 2 * y));
    std::shared_ptr<core::Analysis> analysis = source.analysis;
    analysis->textureDetail = detail;

    core::Scene scene = edited(source, "artist", 4);
    core::Material& artist = *scene.findSegment(2)->edit;
    const auto mask = ramp();
    for (const core::ParamInfo& param : core::findBrdf("artist")->params)
        artist.drives.push_back(drive(param.key, mask, param.min, 0.5f * (param.min + param.max)));
    core::Drive texture;
    texture.parameter = "albedo";
    texture.source = core::DriveSource::Luminance;
    artist.drives.push_back(texture);
    artist.drives.push_back(drive("blend.new", mask, 0.6f, 1));
    artist.drives.push_back(drive("blend.original", mask, 0.3f, 0));

    core::Material& marble = scene.findSegment(3)->edit.emplace(core::defaultMaterial(*core::findBrdf("ggx")));
    marble.translucency = core::Translucency();
    marble.translucency->sigmaA = Vector3f(0.02f, 0.04f, 0.07f);
    marble.translucency->sigmaSPrime = Vector3f(0.3f, 0.35f, 0.4f);
    const auto halves = makeMask([](int x, int) { return x < 66 ? 0.25f : 1.0f; });
    marble.drives = {drive("translucency.weight", halves, 0, 2), drive("eta", halves, 1.2f, 2.4f),
                     drive("specular", mask, 0, 1), drive("alpha", halves, 0.05f, 0.6f)};
    marble.fresnel = core::Fresnel::Dielectric;
    marble.specular = Vector3f(1, 1, 1);
    scene.findSegment(1)->glossy = true;
    scene.render.surfaceSamples = 300;
    scene.render.irradianceSamples = 8;

    const core::ImageRgb actual = render::renderImage(device(), scene, analysis);
    const core::ImageRgb expected = core::renderReference(scene, analysis);
    EXPECT_GE(agreement(actual, expected, source.photo->labels, 2), 0.97);
    // Every pixel of a translucent body sums all samples, including the few whose rays differ.
    EXPECT_GE(agreement(actual, expected, source.photo->labels, 3, 0.01f), 0.97);
    // The drives have a visible effect.
    core::Scene plain = scene;
    plain.findSegment(2)->edit->drives.clear();
    EXPECT_LE(agreement(actual, core::renderReference(plain, analysis), source.photo->labels, 2), 0.1);
}

TEST(Drives, ConstantMaskIsTheConstantParameterBitForBit) {
    const AnalyticScene source = smallStillLife();
    core::Scene driven = edited(source, "ggx", 3);
    driven.findSegment(2)->edit->drives = {drive("alpha", makeMask([](int, int) { return 1.0f; }), 0.9f, 0.3f)};
    core::Scene constant = edited(source, "ggx", 3);
    constant.findSegment(2)->edit->values[0] = 0.3f;
    render::Renderer renderer(device());
    EXPECT_EQ(finish(renderer, driven, source), finish(renderer, constant, source));
}

TEST(Drives, HalvesAreTheTwoConstantEdits) {
    const AnalyticScene source = smallStillLife();
    render::Renderer renderer(device());
    const auto constant = [&](float albedo) {
        core::Scene scene = edited(source, "lambert", 8);
        scene.render.bounces = 1;
        scene.findSegment(2)->edit->albedo = Vector3f::Constant(albedo);
        return finish(renderer, scene, source);
    };
    const core::ImageRgb low = constant(0.2f);
    const core::ImageRgb high = constant(0.7f);
    core::Scene scene = edited(source, "lambert", 8);
    scene.render.bounces = 1;
    scene.findSegment(2)->edit->drives = {
        drive("albedo", makeMask([](int x, int) { return x < 35 ? 0.0f : 1.0f; }), 0.2f, 0.7f)};
    const core::ImageRgb halves = finish(renderer, scene, source);
    int count = 0;
    for (int y = 0; y < kPictureHeight; ++y)
        for (int x = 0; x < kPictureWidth; ++x) {
            if (source.photo->labels(x, y) != 2) continue;
            const Vector3f expected = x < 35 ? low(x, y) : high(x, y);
            EXPECT_LE((halves(x, y) - expected).norm(), 1e-4f * expected.norm()) << x << ' ' << y;
            ++count;
        }
    EXPECT_GT(count, 300);
}

TEST(Drives, PaintingUpdatesWhatIsOnTheDevice) {
    const AnalyticScene source = smallStillLife();
    core::Scene scene = edited(source, "lambert", 2);
    const auto first = makeMask([](int, int) { return 0.0f; });
    scene.findSegment(2)->edit->drives = {drive("albedo", first, 0.1f, 0.9f)};
    render::Renderer renderer(device());
    const core::ImageRgb before = finish(renderer, scene, source);
    auto stroke = std::make_shared<core::Mask>(*first);
    stroke->change(20, 30, 50, 50, [](int x, int y, float) { return (x - 35) * (x - 35) + (y - 40) * (y - 40) < 60; });
    scene.findSegment(2)->edit->drives[0].mask = stroke;
    renderer.setScene(scene, source.analysis);
    EXPECT_EQ(renderer.progress().samples, 0);
    const core::ImageRgb after = finish(renderer, scene, source);
    render::Renderer fresh(device());
    EXPECT_EQ(after, finish(fresh, scene, source));
    EXPECT_NE(after, before);
    // The same mask again restarts nothing.
    renderer.setScene(scene, source.analysis);
    EXPECT_EQ(renderer.progress().samples, 2);
    // A second driven parameter leaves the planes in place and has a visible effect.
    scene.findSegment(2)->edit->drives.push_back(drive("blend.original", stroke, 0, 1));
    scene.findSegment(3)->edit = core::defaultMaterial(*core::findBrdf("ggx"));
    scene.findSegment(3)->edit->drives = {drive("alpha", ramp(), 0.1f, 0.9f)};
    render::Renderer another(device());
    EXPECT_EQ(finish(renderer, scene, source), finish(another, scene, source));
}

}  // namespace
