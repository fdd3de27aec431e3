// SPDX-License-Identifier: GPL-3.0-or-later
// Measured BRDFs read from files that were written from analytic ones.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/material/brdf_file.h"
#include "tests/support/brdf_properties.h"
#include "tests/support/merl_file.h"
#include "tests/support/temp_folder.h"

namespace {

using core::Vector3f;
using kernel::vec3;
using std::numbers::pi;
using test::BrdfCase;
using test::direction;

const Vector3f kLambert = Vector3f(0.9f, 0.6f, 0.3f) / static_cast<float>(pi);

struct Example {
    const char* name;
    std::function<Vector3f(double, double, double)> brdf;
};
const Example kExamples[] = {{"lambert", [](double, double, double) { return kLambert; }},
                             {"rough", [](double h, double d, double p) { return test::ggxInHalfDiff(0.5, h, d, p); }},
                             {"both", [](double h, double d, double p) -> Vector3f {
                                  return 0.5f * kLambert + 0.4f * test::ggxInHalfDiff(0.05, h, d, p);
                              }}};

class MeasuredBrdf : public testing::TestWithParam<Example> {
  protected:
    MeasuredBrdf() {
        test::writeMerl(folder_ / "a.binary", GetParam().brdf);
        material_ = core::fileMaterial(core::loadBrdfFile(folder_ / "a.binary"));
        brdf_ = core::toKernel(material_, Vector3f(1, 1, 1));
    }
    [[nodiscard]] std::vector<BrdfCase> cases() const {
        std::vector<BrdfCase> result;
        for (const double angle : {0.0, 50.0, 85.0})
            result.push_back({brdf_, direction(angle * pi / 180, 0.7), GetParam().name});
        return result;
    }
    test::TempFolder folder_;
    core::Material material_;
    kernel::BrdfParams brdf_{};
};

TEST_P(MeasuredBrdf, SamplesFollowThePdf) {
    for (const BrdfCase& c : cases()) {
        SCOPED_TRACE(c.wo.z);
        test::expectSamplesFollowThePdf(c, test::sidak(0.01, 9));
    }
}

TEST_P(MeasuredBrdf, KeepsTheRulesOfEveryBrdf) {
    for (const BrdfCase& c : cases()) {
        SCOPED_TRACE(c.wo.z);
        test::expectReflectsNoMoreThanItReceives(c);
        test::expectWeightIsEvalTimesCosineOverPdf(c);
        test::expectIsReciprocal(c);
        test::expectIsZeroBelowTheHorizon(c);
    }
}

TEST_P(MeasuredBrdf, ReturnsTheFunctionItWasMadeFrom) {
    for (const BrdfCase& c : cases()) {
        double worst = 0;
        double sum = 0;
        constexpr int kDirections = 2000;
        for (kernel::uint s = 0; s < kDirections; ++s) {
            const vec3 wi = kernel::sample_cosine_hemisphere(kernel::rng_vec2(4, s, 0, 7));
            if (wi.z < 0.1f || c.wo.z < 0.1f) continue;
            const vec3 h = kernel::normalize(c.wo + wi);
            // The difference vector's azimuth by its definition: in the frame of h whose x axis points away from n.
            const Eigen::Vector3d n(0, 0, 1);
            const Eigen::Vector3d hd(h.x, h.y, h.z);
            const Eigen::Vector3d id(wi.x, wi.y, wi.z);
            const Eigen::Vector3d y = n.cross(hd).normalized();
            const Eigen::Vector3d x = y.cross(hd);
            double phi = std::atan2(id.dot(y), id.dot(x));
            if (phi < 0) phi += pi;
            const Vector3f expected =
                GetParam().brdf(std::acos(std::min(hd.z(), 1.0)), std::acos(std::min(id.dot(hd), 1.0)), phi);
            const vec3 actual = kernel::brdf_eval(c.brdf, c.wo, wi);
            const double error =
                static_cast<double>((Vector3f(actual.x, actual.y, actual.z) - expected).norm() / expected.norm());
            worst = std::max(worst, error);
            sum += error;
        }
        EXPECT_LT(worst, 0.1) << c.wo.z;
        EXPECT_LT(sum / kDirections, 0.01) << c.wo.z;
    }
}

TEST_P(MeasuredBrdf, SamplesWeighLittle) {
    for (const BrdfCase& c : cases())
        for (kernel::uint s = 0; s < 5000; ++s) {
            const vec3 wi = kernel::brdf_sample(c.brdf, c.wo, kernel::rng_vec2(9, s, 0, 7));
            if (wi.z <= 0) continue;
            const vec3 w = kernel::brdf_weight(c.brdf, c.wo, wi);
            ASSERT_TRUE(std::isfinite(w.x) && w.x >= 0 && w.x < 12) << w.x << " at " << c.wo.z;
        }
}

INSTANTIATE_TEST_SUITE_P(Analytic, MeasuredBrdf, testing::ValuesIn(kExamples),
                         [](const auto& test) { return test.param.name; });

TEST(MeasuredFurnace, WhiteLambertReturnsExactlyOne) {
    const test::TempFolder folder;
    test::writeMerl(folder / "white.binary",
                    [](double, double, double) { return Vector3f::Constant(static_cast<float>(1 / pi)); });
    const core::Material m = core::fileMaterial(core::loadBrdfFile(folder / "white.binary"));
    const kernel::BrdfParams b = core::toKernel(m, Vector3f(1, 1, 1));
    for (kernel::uint s = 0; s < 10000; ++s) {
        const vec3 wi = kernel::brdf_sample(b, vec3(0.6f, 0, 0.8f), kernel::rng_vec2(6, s, 0, 3));
        ASSERT_NEAR(kernel::brdf_weight(b, vec3(0.6f, 0, 0.8f), wi).y, 1, 1e-5);
    }
}

}  // namespace
