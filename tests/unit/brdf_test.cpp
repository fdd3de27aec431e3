// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/brdf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>
#include <string>

#include "core/io/material_json.h"
#include "core/material/metals.h"
#include "shaders/brdf/brdf.h"

namespace core {
namespace {

TEST(BrdfList, IdsAreTheFileFormat) {
    EXPECT_EQ(findBrdf("none")->id, 0);
    EXPECT_EQ(findBrdf("lambert")->id, 1);
    EXPECT_EQ(findBrdf("phong")->id, 2);
    EXPECT_EQ(findBrdf("ggx")->id, 3);
    EXPECT_EQ(findBrdf("GGX"), nullptr);
    EXPECT_EQ(findBrdf(""), nullptr);
}

TEST(BrdfList, TablesAreConsistent) {
    std::set<int> ids;
    for (const BrdfInfo& info : brdfs()) {
        EXPECT_TRUE(ids.insert(info.id).second) << info.key;
        EXPECT_NE(std::string(info.label), "") << info.key;
        EXPECT_LE(info.params.size(), static_cast<std::size_t>(kBrdfValueCount)) << info.key;
        std::set<std::string> keys;
        for (const ParamInfo& p : info.params) {
            EXPECT_TRUE(keys.insert(p.key).second) << p.key;
            EXPECT_LT(p.min, p.max) << p.key;
            EXPECT_LE(p.min, p.initial) << p.key;
            EXPECT_LE(p.initial, p.max) << p.key;
            EXPECT_TRUE(!p.logScale || p.min > 0) << p.key;
        }
    }
    EXPECT_STREQ(findBrdf("phong")->params[0].key, "exponent");
    EXPECT_STREQ(findBrdf("ggx")->params[0].key, "alpha");
    EXPECT_EQ(findBrdf("phong")->defaultFresnel, Fresnel::None);
    EXPECT_EQ(findBrdf("ggx")->defaultFresnel, Fresnel::Schlick);
}

TEST(BrdfToKernel, TakesEveryField) {
    Material m = defaultMaterial(*findBrdf("ggx"));
    m.albedo = Vector3f(0.1f, 0.2f, 0.3f);
    m.eta = Vector3f(1.1f, 1.2f, 1.3f);
    m.k = Vector3f(2, 3, 4);
    m.values = {0.25f, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    const kernel::BrdfParams estimated = toKernel(m, Vector3f(0.7f, 0.8f, 0.9f));
    EXPECT_EQ(estimated.specular.y, 0.8f);
    EXPECT_EQ(estimated.specular.w, static_cast<float>(Fresnel::Schlick));
    EXPECT_EQ(estimated.albedo.z, 0.3f);
    EXPECT_EQ(estimated.eta.x, 1.1f);
    EXPECT_EQ(estimated.k.z, 4);
    EXPECT_EQ(estimated.values.x, 0.25f);
    EXPECT_EQ(estimated.values.w, 3);
    EXPECT_EQ(estimated.values2.x, 4);
    EXPECT_EQ(estimated.values3.w, 11);
    EXPECT_EQ(estimated.type, 3u);
    m.specular = Vector3f(0, 0.5f, 1);
    EXPECT_EQ(toKernel(m, Vector3f(0.7f, 0.8f, 0.9f)).specular.y, 0.5f);
}

TEST(BrdfToKernel, NamesAnUnknownBrdf) {
    Material m;
    m.brdf = "wrad";
    try {
        static_cast<void>(toKernel(m, Vector3f(1, 1, 1)));
        FAIL() << "an unknown key must be refused";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Usage);
        EXPECT_THAT(error.what(), testing::HasSubstr("\"wrad\""));
        EXPECT_THAT(error.what(), testing::HasSubstr("lambert"));
    }
}

TEST(BrdfDocs, CommandLinePageHasTheTableOfBrdfs) {
    std::ifstream file(PATINA_SOURCE_DIR "/docs/command-line.md");
    std::stringstream page;
    page << file.rdbuf();
    EXPECT_NE(page.str().find(brdfTableMarkdown()), std::string::npos) << "docs/command-line.md should have:\n\n"
                                                                       << brdfTableMarkdown();
}

TEST(Metals, ReflectWhatTheirColoursAreKnownFor) {
    const auto reflectance = [](const char* key) {
        Material m = defaultMaterial(*findBrdf("ggx"));
        setMetal(m, *findMetal(key));
        EXPECT_EQ(metalOf(m), findMetal(key));
        const kernel::vec3 f = kernel::fresnel_specular(toKernel(m, Vector3f(0.1f, 0.1f, 0.1f)), 1);
        return Vector3f(f.x, f.y, f.z);
    };
    // Normal reflectance from other sources: gold 0.95 red to 0.4 blue, copper pink, silver and aluminium above 0.9.
    const Vector3f gold = reflectance("gold");
    EXPECT_NEAR(gold.x(), 0.95f, 0.03f);
    EXPECT_NEAR(gold.y(), 0.75f, 0.06f);
    EXPECT_NEAR(gold.z(), 0.39f, 0.06f);
    const Vector3f copper = reflectance("copper");
    EXPECT_GT(copper.x(), 0.9f);
    EXPECT_GT(copper.y(), copper.z());
    EXPECT_GT(reflectance("silver").minCoeff(), 0.95f);
    EXPECT_NEAR(reflectance("aluminium").mean(), 0.91f, 0.02f);
    EXPECT_NEAR(reflectance("iron").mean(), 0.53f, 0.04f);
    EXPECT_NEAR(reflectance("chromium").mean(), 0.55f, 0.04f);
    EXPECT_EQ(findMetal("unobtainium"), nullptr);
}

TEST(Metals, AreWordsOfTheEdit) {
    const Material m = materialFromJson(R"({"brdf": "ward", "metal": "gold", "alpha_x": 0.2})");
    EXPECT_EQ(metalOf(m), findMetal("gold"));
    EXPECT_EQ(m.specular, Vector3f(1, 1, 1));
    EXPECT_EQ(materialFromJson(materialToJson(m)), m);
    EXPECT_THAT(materialToJson(m), testing::HasSubstr("\"metal\":\"gold\""));
    for (const char* wrong :
         {R"({"brdf": "lambert", "metal": "gold"})", R"({"brdf": "ggx", "metal": "gold", "eta": 2})",
          R"({"brdf": "ggx", "metal": "tin"})", R"({"brdf": "ggx", "metal": 3})"})
        EXPECT_THROW(static_cast<void>(materialFromJson(wrong)), Error) << wrong;
}

TEST(BrdfFresnel, DielectricMatchesTheFresnelEquations) {
    for (const double eta : {1.0, 1.3, 1.5, 2.4, 0.7}) {
        for (double c = 0.02; c <= 1; c += 0.07) {
            const double sinT = std::sqrt(1 - c * c) / eta;
            double expected = 1;
            if (sinT < 1) {
                const double t = std::sqrt(1 - sinT * sinT);
                const double s = (c - eta * t) / (c + eta * t);
                const double p = (eta * c - t) / (eta * c + t);
                expected = 0.5 * (s * s + p * p);
            }
            EXPECT_NEAR(kernel::fresnel_dielectric(static_cast<float>(c), static_cast<float>(eta)), expected, 2e-6)
                << eta << " " << c;
        }
    }
    EXPECT_NEAR(kernel::fresnel_dielectric(1, 1.5f), 0.04f, 1e-6f);
    EXPECT_EQ(kernel::fresnel_dielectric(0, 1.5f), 1);
}

TEST(BrdfFresnel, ConductorMatchesTheComplexFresnelEquations) {
    using Complex = std::complex<double>;
    for (const Complex eta : {Complex(0.2, 3.9), Complex(1.5, 0), Complex(2.9, 3.0), Complex(0.14, 11.0)})
        for (double c = 0.02; c <= 1; c += 0.07) {
            const Complex t = std::sqrt(1.0 - (1 - c * c) / (eta * eta));
            const Complex s = (c - eta * t) / (c + eta * t);
            const Complex p = (eta * c - t) / (eta * c + t);
            EXPECT_NEAR(kernel::fresnel_conductor(static_cast<float>(c), static_cast<float>(eta.real()),
                                                  static_cast<float>(eta.imag())),
                        0.5 * (std::norm(s) + std::norm(p)), 1e-4)
                << eta << " " << c;
        }
}

TEST(BrdfFresnel, ModesScaleTheSpecularColour) {
    kernel::BrdfParams b;
    b.specular = {0.5f, 0.25f, 1, static_cast<float>(kernel::kFresnelNone)};
    b.eta = kernel::vec4(1.5f);
    b.k = kernel::vec4(0.0f);
    EXPECT_EQ(kernel::fresnel_specular(b, 0.1f).y, 0.25f);
    b.specular.w = static_cast<float>(kernel::kFresnelSchlick);
    EXPECT_EQ(kernel::fresnel_specular(b, 1).y, 0.25f);
    EXPECT_EQ(kernel::fresnel_specular(b, 0).y, 1);
    b.specular.w = static_cast<float>(kernel::kFresnelDielectric);
    EXPECT_NEAR(kernel::fresnel_specular(b, 1).x, 0.02f, 1e-6f);
    b.specular.w = static_cast<float>(kernel::kFresnelConductor);
    EXPECT_NEAR(kernel::fresnel_specular(b, 1).x, 0.02f, 1e-6f);
}

TEST(BrdfGgx, PeakIsTheTextbookValue) {
    kernel::BrdfParams b;
    b.specular = kernel::vec4(kernel::vec3(0.8f), 0);
    b.values.x = 0.1f;
    b.type = 3;
    const kernel::vec3 up(0, 0, 1);
    // F D(0) G / 4 with D(0) = 1/(π α²), G = 1.
    EXPECT_NEAR(kernel::brdf_eval(b, up, up).x, 0.8 / (4 * std::numbers::pi * 0.01), 1e-4);
}

TEST(BrdfPhong, PeakIsTheNormalisedLobe) {
    kernel::BrdfParams b;
    b.specular = kernel::vec4(kernel::vec3(1.0f), 0);
    b.values.x = 30;
    b.type = 2;
    const kernel::vec3 wo(0.6f, 0, 0.8f);
    const kernel::vec3 mirror(-0.6f, 0, 0.8f);
    EXPECT_NEAR(kernel::brdf_eval(b, wo, mirror).x, 31 / (2 * std::numbers::pi) / 0.8, 1e-3);
}

TEST(ShadingFrame, IsOrthonormalAndInvertible) {
    for (const kernel::vec3 n :
         {kernel::vec3(0, 0, 1), kernel::vec3(0, 0, -1), kernel::vec3(0.6f, 0, -0.8f),
          kernel::normalize(kernel::vec3(1e-4f, 1e-4f, -1)), kernel::vec3(0, 1, 0), kernel::vec3(1, 0, 0),
          kernel::vec3(-1, 0, 0), kernel::normalize(kernel::vec3(1, 1e-5f, 1e-4f))}) {
        const kernel::vec3 u = kernel::frame_u(n);
        const kernel::vec3 v = kernel::frame_v(n);
        EXPECT_NEAR(kernel::dot(u, v), 0, 1e-5);
        EXPECT_NEAR(kernel::dot(u, n), 0, 1e-5);
        EXPECT_NEAR(kernel::length(u), 1, 1e-5);
        EXPECT_NEAR(kernel::dot(kernel::cross(u, v), n), 1, 1e-5);
        const kernel::vec3 d(0.36f, 0.48f, 0.8f);
        EXPECT_NEAR(kernel::length(kernel::to_local(n, kernel::from_local(n, d)) - d), 0, 1e-5);
        EXPECT_GE(u.x, 0) << "the first tangent follows the camera's x axis";
        EXPECT_NEAR(v.x, 0, 1e-6) << "and the second has no part of it";
    }
}

TEST(ShadingFrame, TiltsNormalsThatFaceAway) {
    const kernel::vec3 wo(0, 0, 1);
    const kernel::vec3 good(0.6f, 0, 0.8f);
    EXPECT_EQ(kernel::shading_normal(good, wo).x, 0.6f);
    for (const kernel::vec3 bad : {kernel::vec3(1, 0, 0), kernel::vec3(0.8f, 0, -0.6f)}) {
        const kernel::vec3 n = kernel::shading_normal(bad, wo);
        EXPECT_NEAR(kernel::dot(n, wo), kernel::kMinShadingCosine, 1e-6);
        EXPECT_NEAR(kernel::length(n), 1, 1e-5);
        EXPECT_GT(n.x, 0.99f);
    }
    EXPECT_EQ(kernel::shading_normal(kernel::vec3(0, 0, -1), wo).z, 1);
}

}  // namespace
}  // namespace core
