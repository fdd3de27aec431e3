// SPDX-License-Identifier: GPL-3.0-or-later
// BRDFs that the user wrote: messages of the compiler and the check, and their pictures.
#include <gtest/gtest.h>

#include "core/material/brdf_file.h"
#include "core/shading/reference_renderer.h"
#include "render/kernels/brdf_check.h"
#include "render/kernels/user_kernels.h"
#include "render/renderer.h"
#include "tests/gpu/render_support.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"
#include "tests/support/user_brdf_text.h"

namespace {

using namespace test;
using test::evaluating;
using test::expectError;
using test::kMattBrdf;

/// The built-in ggx as a file.
const std::string kGgx = R"(uniform vec3 specular;
uniform float alpha = 0.2;  // 0.01 to 1, log
vec3 evaluate(vec3 wo, vec3 wi) { return fresnel(dot(wo, normalize(wo + wi))) * ggx_lobe(vec2(alpha), wo, wi); }
float pdf(vec3 wo, vec3 wi) { return ggx_lobe_pdf(vec2(alpha), wo, wi); }
vec3 sample(vec3 wo, vec2 u) { return ggx_lobe_sample(vec2(alpha), wo, u); }
)";

class UserBrdf : public testing::Test {
  protected:
    std::shared_ptr<const core::BrdfFile> load(const std::string& text, const std::string& name = "a") const {
        const std::string path = folder_ / (name + ".brdf.glsl");
        test::writeBytes(path, text);
        return core::loadBrdfFile(path);
    }
    void refused(const std::string& text, const std::vector<std::string>& parts) const {
        SCOPED_TRACE(text);
        expectError(core::ErrorKind::Input, parts, [&] { render::requireSound(device(), load(text)); });
    }
    test::TempFolder folder_;
};

/// Share of the segment's pixels that agree within 0.2 % + 1e-3.
double equalShare(const core::ImageRgb& actual, const core::ImageRgb& expected, const core::LabelImage& labels,
                  std::uint16_t label) {
    double equal = 0;
    double count = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i] != label) continue;
        ++count;
        equal += (actual[i] - expected[i]).cwiseAbs().maxCoeff() <= 0.002f * expected[i].cwiseAbs().maxCoeff() + 1e-3f;
    }
    EXPECT_GT(count, 500);
    return equal / count;
}

TEST_F(UserBrdf, ThatDoesNotCompileIsRefusedWithItsLine) {
    refused(evaluating("return albedo\n * oops;"), {"a.brdf.glsl:3: ", "'oops'", "undeclared"});
    refused(evaluating("return albedo *;"), {"a.brdf.glsl:2: ", "syntax error"});
    refused(evaluating("return albedo * driveValues[0];"), {"a.brdf.glsl:2: ", "'driveValues'", "undeclared"});
    refused(evaluating("imageStore(accumulationMap, ivec2(0), vec4(1)); return albedo;"), {"a.brdf.glsl:2: "});
    refused(evaluating("return albedo * float(gl_GlobalInvocationID.x);"), {"a.brdf.glsl:2: ", "undeclared"});
    // -2^31 / -1 stops the process on software devices.
    refused(evaluating("ivec2 a = ivec2(5); a /= int(wi.x); return albedo;"), {"a.brdf.glsl:2: ", "integers"});
}

TEST_F(UserBrdf, OfTheProgramIsSound) {
    for (const char* name : {"velvet", "thin_film"}) {
        const auto file = core::loadBrdfFile(std::string(PATINA_SOURCE_DIR "/resources/brdf/") + name + ".brdf.glsl");
        for (const render::BrdfFinding& f : render::checkBrdf(device(), file->info, file)) {
            EXPECT_EQ(f.problem, "") << name;
            EXPECT_LT(f.asymmetry, 1e-4) << name << " " << f.parameters;
        }
    }
}

TEST_F(UserBrdf, OfTheManualIsSound) {
    const std::string page = test::readBytes(PATINA_SOURCE_DIR "/docs/user-brdfs.md");
    const std::size_t begin = page.find("```glsl\n") + 8;
    const auto file = load(page.substr(begin, page.find("```", begin) - begin));
    EXPECT_STREQ(file->info.params[0].label, "Darker edge");
    render::requireSound(device(), file);
}

TEST_F(UserBrdf, WhoseValuesAreWrongIsRefused) {
    refused(evaluating("return vec3(0.2 / (wi.z - wi.z));"), {"a.brdf.glsl:2: ", "infinite or not a number"});
    refused(evaluating("return albedo * (0.3 - wi.z);"), {"a.brdf.glsl:2: ", "negative"});
    refused(evaluating("return albedo * 0.4;"), {"a.brdf.glsl:2: ", "1.257 times what it receives"});
    // Wrong only at the end of a parameter's range.
    refused("uniform float gain = 0.3;  // 0 to 0.6\n" + evaluating("return albedo * gain;"),
            {"a.brdf.glsl:3: ", "1.885 times", "gain = 0.6"});
}

TEST_F(UserBrdf, WhoseSamplesAreWrongIsRefused) {
    const std::string half = "vec3 w = sample_cosine_hemisphere(u); return vec3(abs(w.x), w.yz);";
    refused(test::sampling(half), {"a.brdf.glsl:4: ", "does not follow pdf()"});
    refused(
        test::replaced(test::sampling(half), "return wi.z * kInvPi", "return wi.x > 0.0 ? 2.0 * wi.z * kInvPi : 0.0"),
        {"a.brdf.glsl:4: ", "leaves out directions", "0.5 of the light by samples"});
    // A lobe that is a tenth wider than its density.
    refused(test::replaced(kGgx, "ggx_lobe_pdf(vec2(alpha)", "ggx_lobe_pdf(vec2(1.1 * alpha)"),
            {"a.brdf.glsl:5: ", "does not follow pdf()"});
    refused(test::sampling("return 1.1 * sample_cosine_hemisphere(u);"), {"a.brdf.glsl:4: ", "unit length"});
    refused(test::withPdf("return 0.5;"), {"a.brdf.glsl:3: ", "pdf() integrates to 3.14"});
}

TEST_F(UserBrdf, ThatWouldNotEndIsRefused) {
    refused(evaluating("for (;;) {} return albedo;"), {"a.brdf.glsl:2: ", "256 steps"});
}

TEST_F(UserBrdf, RendersAsTheSameBrdfOfTheProgram) {
    const AnalyticScene source = stillLife();
    core::Scene own = source.scene;
    own.render.samples = 4;
    own.render.filter = false;
    own.findSegment(2)->edit = material("ggx");
    own.findSegment(2)->edit->specular = Vector3f(0.9f, 0.8f, 0.6f);
    own.findSegment(2)->edit->values[0] = 0.3f;
    own.findSegment(3)->edit = material("lambert");
    own.findSegment(3)->edit->translucency = core::Translucency();
    own.render.surfaceSamples = 500;
    const core::ImageRgb expected = core::renderReference(own, source.analysis);

    core::Scene user = own;
    for (core::Segment& segment : user.segments) {
        if (!segment.edit) continue;
        const bool ggx = segment.edit->brdf == "ggx";
        core::Material m = core::fileMaterial(load(ggx ? kGgx : kMattBrdf, ggx ? "ggx" : "matt"));
        m.albedo = segment.edit->albedo;
        m.specular = segment.edit->specular;
        m.values = segment.edit->values;
        m.translucency = segment.edit->translucency;
        EXPECT_EQ(m.fresnel, segment.edit->fresnel);
        segment.edit = m;
    }
    const core::ImageRgb actual = render::renderImage(device(), user, source.analysis);
    EXPECT_GE(equalShare(actual, expected, source.photo->labels, 2), 0.97);
    // The sum below the surface differs from that of the reference, but not from the device's own.
    const core::ImageRgb same = render::renderImage(device(), own, source.analysis);
    EXPECT_GE(equalShare(actual, same, source.photo->labels, 3), 0.97);
}

TEST_F(UserBrdf, KeepsThePictureUntilAnotherIsCompiled) {
    const AnalyticScene source = stillLife();
    core::Scene scene = source.scene;
    scene.render.samples = 2;
    const auto edit = [&](const std::string& text) { scene.findSegment(2)->edit = core::fileMaterial(load(text)); };
    render::Renderer renderer(device());
    const auto record = [&](double seconds) {
        gpu::CommandEncoder encoder = device().createCommandEncoder({.label = "test"});
        const bool worked = renderer.record(encoder, seconds);
        device().queue().submit(encoder.finish());
        device().waitIdle();
        return worked;
    };
    const auto finish = [&] {
        for (int i = 0; i < 10000 && record(0.1); ++i) continue;
        return render::readResult(device(), renderer);
    };
    const auto differ = [&](const core::ImageRgb& a, const core::ImageRgb& b) {
        return !std::equal(a.pixels().begin(), a.pixels().end(), b.pixels().begin());
    };
    renderer.setScene(scene, source.analysis);
    EXPECT_FALSE(differ(finish(), source.photo->color));
    edit(kMattBrdf);
    renderer.setScene(scene, source.analysis);
    ASSERT_TRUE(record(0));
    EXPECT_FALSE(differ(render::readResult(device(), renderer), source.photo->color));
    const core::ImageRgb matt = finish();
    EXPECT_TRUE(differ(matt, source.photo->color));

    edit(evaluating("return albedo * 0.01;"));
    renderer.setScene(scene, source.analysis);
    ASSERT_TRUE(record(0));
    EXPECT_FALSE(renderer.progress().finished);
    EXPECT_FALSE(differ(render::readResult(device(), renderer), matt));
    EXPECT_TRUE(differ(finish(), matt));
    EXPECT_TRUE(renderer.progress().finished);
}

TEST_F(UserBrdf, OfTooManyFilesIsRefused) {
    core::Scene scene = stillLife().scene;
    scene.segments.resize(9);
    for (std::size_t i = 0; i < 9; ++i) {
        scene.segments[i].label = static_cast<std::uint16_t>(i + 1);
        scene.segments[i].edit = core::fileMaterial(load(kMattBrdf, std::to_string(i)));
    }
    std::vector<kernel::SegmentShading> shading(10);
    expectError(core::ErrorKind::Input, {"9 BRDFs", "at most 8"},
                [&] { static_cast<void>(render::placeUserBrdfs(scene, shading)); });
}

}  // namespace
