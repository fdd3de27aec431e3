// SPDX-License-Identifier: GPL-3.0-or-later
// Light below surfaces against the reference renderer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/shading/reference_renderer.h"
#include "render/renderer.h"
#include "tests/gpu/render_support.h"

namespace {

using core::Vector3f;
using test::AnalyticScene;
using test::compare;
using test::device;
using test::edited;
using test::marble;
using test::material;
using test::stillLife;

TEST(Translucency, MatchesBruteForceInDouble) {
    const AnalyticScene source = stillLife();
    for (const float eta : {1.0f, 1.3f}) {
        core::Material m = marble();
        m.translucency->eta = eta;
        m.translucency->weight = 0.8f;
        core::Scene scene = edited(source, 2, m, 1);
        scene.render.surfaceSamples = 700;
        scene.render.irradianceSamples = 16;
        const core::ImageRgb actual = render::renderImage(device(), scene, source.analysis);
        const core::ImageRgb expected = core::renderReference(scene, source.analysis);
        EXPECT_LE(compare(actual, expected, source.photo->labels, 2).meanDifference, 0.002) << eta;
        // The grids' own error, within its bounds.
        double squares = 0;
        double total = 0;
        double largest = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            if (source.photo->labels[i] != 2) continue;
            squares += static_cast<double>((actual[i] - expected[i]).squaredNorm());
            total += static_cast<double>(expected[i].squaredNorm());
            largest = std::max(
                largest, static_cast<double>((actual[i] - expected[i]).cwiseAbs().maxCoeff() / expected[i].maxCoeff()));
        }
        EXPECT_LE(std::sqrt(squares / total), 0.01) << eta;
        EXPECT_LE(largest, 0.03) << eta;
    }
}

TEST(Translucency, NeverBrighterThanAWhiteSurface) {
    // Spheres that form one body with gaps and necks, in white light among white objects.
    const Vector3f one(1, 1, 1);
    const AnalyticScene source = test::spheresOnFloor(80, 60,
                                                                    {{Vector3f(-0.12f, 0, 0.9f), 0.1f, 2, one},
                                                                     {Vector3f(0.1f, 0, 0.9f), 0.1f, 2, one},
                                                                     {Vector3f(-0.01f, 0.13f, 0.95f), 0.1f, 2, one},
                                                                     {Vector3f(-0.01f, -0.1f, 0.85f), 0.03f, 2, one}},
                                                                    0, [&](const Vector3f&) { return one; });
    core::Material lambert = material("lambert");
    lambert.albedo = one;
    const core::ImageRgb white = render::renderImage(device(), edited(source, 2, lambert, 4), source.analysis);
    for (const bool matched : {true, false}) {
        core::Material m = marble();
        m.translucency->sigmaA = Vector3f(0, 0, 0.002f);
        m.translucency->sigmaSPrime = Vector3f(0.4f, 0.05f, 0.05f);
        m.translucency->eta = matched ? 1.0f : 1.3f;
        m.translucency->model = matched ? core::ScatteringModel::Dipole : core::ScatteringModel::BetterDipole;
        core::Scene scene = edited(source, 2, m, 1);
        scene.render.surfaceSamples = 1500;
        scene.render.irradianceSamples = 8;
        const core::ImageRgb actual = render::renderImage(device(), scene, source.analysis);
        float largest = 0;
        for (std::size_t i = 0; i < actual.size(); ++i)
            if (source.photo->labels[i] == 2) largest = std::max(largest, actual[i].cwiseQuotient(white[i]).maxCoeff());
        EXPECT_LE(largest, 1 + 1e-4f) << m.translucency->eta;
        if (matched) {
            EXPECT_GE(largest, 1 - 1e-4f) << "as bright as white";
        }
    }
}

}  // namespace
