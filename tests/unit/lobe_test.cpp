// SPDX-License-Identifier: GPL-3.0-or-later
// Lobe widths of glossy segments: estimated, and taken out of the light they show. The truth is brute force: half
// vectors drawn at random from the GGX distribution.
#include "core/analysis/light/lobe.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "core/analysis/light/deconvolve.h"

namespace {

using core::DirectionalMap;
using core::Vector3f;
using core::analysis::LobeObservations;
using core::analysis::LobeProbe;

constexpr float kPi = std::numbers::pi_v<float>;

/// Mean of `light` over a lobe of width `alpha` about the normal, seen along `view`; what lies below the surface is
/// dark.
template <class Light>
Vector3f throughLobe(const Light& light, const Vector3f& view, const Vector3f& n, float alpha, int count,
                     std::mt19937& random) {
    std::uniform_real_distribution<float> uniform(0, 1);
    const Vector3f tangent = n.unitOrthogonal();
    const Vector3f bitangent = n.cross(tangent);
    Vector3f sum = Vector3f::Zero();
    for (int i = 0; i < count; ++i) {
        const float u = uniform(random);
        const float t = alpha * std::sqrt(u / (1 - u));
        const float phi = 2 * kPi * uniform(random);
        const Vector3f h = (n + t * (std::cos(phi) * tangent + std::sin(phi) * bitangent)).normalized();
        const Vector3f d = view - 2 * view.dot(h) * h;
        if (d.dot(n) > 0) sum += light(d);
    }
    return sum / static_cast<float>(count);
}

TEST(Lobe, RingsAddUpToTheDistribution) {
    for (const float alpha : {0.01f, 0.05f, 0.3f}) {
        float sum = 0;
        for (int i = 0; i <= core::analysis::kLobeRings; ++i) {
            EXPECT_GE(core::analysis::ringWeight(i, alpha), 0);
            sum += core::analysis::ringWeight(i, alpha);
        }
        EXPECT_NEAR(sum, 1, 1e-5f);
    }
}

TEST(Lobe, OffsetsFollowTheDistribution) {
    const auto offsets = core::analysis::lobeOffsets(0.1f, 1000);
    int inside = 0;
    for (const auto& o : offsets) inside += o.norm() < 0.1f;  // half of a GGX lobe lies within tan θ = α
    EXPECT_NEAR(inside, 500, 2);
}

/// Stripes of very different brightness: what a glossy thing might stand before.
Vector3f stripes(const Vector3f& d) {
    const float angle = std::atan2(d.x(), d.z());
    const float s = std::sin(9 * angle) > 0 ? 1.0f : 0.1f;
    return {s, 0.5f + 0.5f * s, std::sin(14 * d.y()) > 0 ? 1.2f : 0.2f};
}

std::vector<LobeProbe> probesOf(float alpha, const Vector3f& rho, int count, float outliers) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<LobeProbe> probes;
    const Vector3f view(0, 0, 1);
    for (int i = 0; i < count; ++i) {
        const Vector3f n = Vector3f(uniform(random) - 0.5f, uniform(random) - 0.5f, -1).normalized();
        LobeProbe probe;
        probe.color = rho.cwiseProduct(throughLobe(stripes, view, n, alpha, 1500, random));
        if (uniform(random) < outliers) probe.color *= 8;
        const Vector3f tangent = n.unitOrthogonal();
        const Vector3f bitangent = n.cross(tangent);
        for (int ring = 0; ring <= core::analysis::kLobeRings; ++ring) {
            const auto k = static_cast<std::size_t>(ring);
            const int rays = ring == 0 ? 1 : core::analysis::kRaysPerRing;
            for (int j = 0; j < rays; ++j) {
                const float phi = 2 * kPi * (static_cast<float>(j) + uniform(random)) / static_cast<float>(rays);
                const Vector3f h =
                    (n + core::analysis::ringTangent(ring) * (std::cos(phi) * tangent + std::sin(phi) * bitangent))
                        .normalized();
                const Vector3f d = view - 2 * view.dot(h) * h;
                if (d.dot(n) > 0) probe.incident[k] += stripes(d) / static_cast<float>(rays);
            }
            probe.known[k] = 1;
        }
        probes.push_back(probe);
    }
    return probes;
}

TEST(Lobe, WidthAndReflectanceAreRecovered) {
    for (const float alpha : {0.02f, 0.05f, 0.12f}) {
        const Vector3f rho(0.8f, 0.5f, 0.3f);
        const auto fit = core::analysis::fitLobe(probesOf(alpha, rho, 300, 0));
        ASSERT_TRUE(fit);
        EXPECT_TRUE(fit->reliable);
        EXPECT_NEAR(fit->alpha / alpha, 1, 0.2f) << alpha;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(fit->rho[c] / rho[c], 1, 0.05f) << alpha;
    }
}

TEST(Lobe, OutliersDoNotPull) {
    const Vector3f rho(0.8f, 0.5f, 0.3f);
    const auto fit = core::analysis::fitLobe(probesOf(0.05f, rho, 300, 0.08f));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->alpha / 0.05f, 1, 0.25f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(fit->rho[c] / rho[c], 1, 0.08f);
}

TEST(Lobe, UniformSurroundingsTellNothing) {
    std::vector<LobeProbe> probes(200);
    for (LobeProbe& probe : probes) {
        probe.color = Vector3f(0.5f, 0.5f, 0.5f);
        probe.incident.fill(Vector3f(1, 1, 1));
        probe.known.fill(1);
    }
    const auto fit = core::analysis::fitLobe(probes);
    ASSERT_TRUE(fit);
    EXPECT_FALSE(fit->reliable);
    EXPECT_NEAR(fit->rho.x(), 0.5f, 1e-4f);
    EXPECT_FALSE(core::analysis::fitLobe(std::span(probes).first(20)));
}

struct Deconvolution : testing::Test {
    static constexpr int kHeight = 64;
    static constexpr float kAlpha = 0.08f;
    const Vector3f view{0, 0, 1};

    /// A dim sky with a window and, where `lamp` is not 0, a lamp of 4 texels of that radiance.
    [[nodiscard]] static DirectionalMap room(float lamp) {
        DirectionalMap map{core::ImageRgb(2 * kHeight, kHeight, Vector3f(0.2f, 0.25f, 0.3f)),
                           core::ImageF(2 * kHeight, kHeight, 1.0f)};
        for (int y = 20; y < 32; ++y)
            for (int x = 30; x < 50; ++x) map.radiance(x, y) = Vector3f(2, 1.8f, 1.6f);
        if (lamp > 0)
            for (int y = 28; y < 30; ++y)
                for (int x = 90; x < 92; ++x) map.radiance(x, y) = Vector3f(lamp, lamp, lamp);
        return map;
    }

    /// What a mirror ball of width `kAlpha` shows of `room(lamp)`, clipped at `level`: the room by random half vectors,
    /// the lamp, which they would hardly ever hit, by the density of its directions.
    [[nodiscard]] LobeObservations observe(float lamp, float level) const {
        const DirectionalMap truth = room(0);
        const std::vector<LampPart> parts = lampParts();
        std::mt19937 random(9);
        std::uniform_real_distribution<float> uniform(0, 1);
        LobeObservations result{truth, kAlpha, view, 1};
        result.map.clipped = core::Image<std::uint8_t>(2 * kHeight, kHeight, 0);
        const auto light = [&](const Vector3f& d) {
            const auto texel = DirectionalMap::texelFromDirection(d, 2 * kHeight, kHeight);
            return truth.radiance(std::min(static_cast<int>(texel.x()), 2 * kHeight - 1),
                                  std::min(static_cast<int>(texel.y()), kHeight - 1));
        };
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < 2 * kHeight; ++x) {
                Vector3f sum = Vector3f::Zero();
                constexpr int kPixels = 20;
                for (int k = 0; k < kPixels; ++k) {
                    const Vector3f mirrored = DirectionalMap::directionFromTexel(
                        {static_cast<float>(x) + uniform(random), static_cast<float>(y) + uniform(random)}, 2 * kHeight,
                        kHeight);
                    const Vector3f n = (mirrored - view).normalized();
                    sum += throughLobe(light, view, n, kAlpha, 16, random);
                    if (lamp > 0) sum += lampThroughLobe(lamp, parts, n);
                }
                Vector3f mean = sum / kPixels;
                for (int c = 0; c < 3; ++c)
                    if (mean[c] >= level) result.map.clipped(x, y) |= static_cast<std::uint8_t>(1u << c);
                result.map.radiance(x, y) = mean.cwiseMin(level);
                // Next to the direction of view the ball is seen at grazing angles.
                if (mirrored(x, y).dot(view) > 0.8f) result.map.coverage(x, y) = 0;
            }
        }
        return result;
    }
    /// Directions over the four texels of the lamp, with their parts of its solid angle.
    struct LampPart {
        Vector3f direction, half;
        float weight;  ///< solid angle / (4 (−v·h))
    };
    [[nodiscard]] std::vector<LampPart> lampParts() const {
        std::vector<LampPart> parts;
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 8; ++x) {
                const Vector3f d = DirectionalMap::directionFromTexel(
                    {90 + (static_cast<float>(x) + 0.5f) / 4, 28 + (static_cast<float>(y) + 0.5f) / 4}, 2 * kHeight,
                    kHeight);
                const Vector3f h = (d - view).normalized();
                parts.push_back(
                    {d, h,
                     DirectionalMap::texelSolidAngle(28 + y / 4, 2 * kHeight, kHeight) / 16 / (4 * -view.dot(h))});
            }
        }
        return parts;
    }
    /// Radiance × GGX density D(h) (n·h)/(4 (−v·h)) × solid angle, over the lamp.
    [[nodiscard]] static Vector3f lampThroughLobe(float lamp, const std::vector<LampPart>& parts, const Vector3f& n) {
        float sum = 0;
        for (const LampPart& part : parts) {
            const float cosine = n.dot(part.half);
            if (cosine <= 0 || n.dot(part.direction) <= 0) continue;
            const float a2 = kAlpha * kAlpha;
            const float base = cosine * cosine * (a2 - 1) + 1;
            sum += a2 / (kPi * base * base) * cosine * part.weight;
        }
        return Vector3f::Constant(lamp * sum);
    }
    [[nodiscard]] static Vector3f mirrored(int x, int y) {
        return DirectionalMap::directionFromTexel({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f},
                                                  2 * kHeight, kHeight);
    }
    [[nodiscard]] static double error(const DirectionalMap& map, const DirectionalMap& truth) {
        double sum = 0;
        for (int y = 15; y < 37; ++y)
            for (int x = 25; x < 55; ++x)
                sum += static_cast<double>((map.radiance(x, y) - truth.radiance(x, y)).lpNorm<1>());
        return sum;
    }
    /// Radiance summed about the lamp over what is there without it.
    [[nodiscard]] static double lampEnergy(const DirectionalMap& map) {
        double sum = 0;
        for (int y = 22; y < 36; ++y)
            for (int x = 84; x < 98; ++x)
                sum += DirectionalMap::texelSolidAngle(y, 2 * kHeight, kHeight) *
                       static_cast<double>(map.radiance(x, y).y() - 0.25f);
        return sum;
    }
};

TEST_F(Deconvolution, SharpensWhatTheLobeBlurred) {
    const DirectionalMap truth = room(0);
    const LobeObservations seen = observe(0, 1e9f);
    DirectionalMap light = seen.map;
    light.clipped = {};
    core::analysis::deconvolve(light, std::span(&seen, 1), {});
    EXPECT_LT(error(light, truth), 0.75 * error(seen.map, truth));
    for (const Vector3f& c : light.radiance.pixels()) EXPECT_GT(c.minCoeff(), 0);
}

TEST_F(Deconvolution, ClippedLampGetsEnergyThatItsSurroundingsShow) {
    const DirectionalMap truth = room(200);
    const double expected = lampEnergy(truth);
    const LobeObservations seen = observe(200, 2.5f);
    DirectionalMap light = seen.map;
    const double clipped = lampEnergy(light);
    ASSERT_LT(clipped, 0.5 * expected);
    core::analysis::deconvolve(light, std::span(&seen, 1), {});
    // About half of what is missing: the tails also lie in what the surroundings seem to be.
    EXPECT_GT(lampEnergy(light), clipped + 0.4 * (expected - clipped));
    EXPECT_LT(lampEnergy(light), 1.1 * expected);
}

TEST_F(Deconvolution, FulfilledBoundsChangeNothing) {
    // A clipped view of light that another source knows: the bound is no reason to darken it.
    const DirectionalMap truth = room(200);
    LobeObservations bound{truth, 0, view, 1};
    bound.map.clipped = core::Image<std::uint8_t>(2 * kHeight, kHeight, 7);
    for (Vector3f& c : bound.map.radiance.pixels()) c = c.cwiseMin(0.5f);
    LobeObservations blurred{truth, kAlpha, view, 1};
    for (float& c : blurred.map.coverage.pixels()) c = 0;
    const std::vector<LobeObservations> sources{bound, blurred};
    DirectionalMap light = truth;
    core::analysis::deconvolve(light, sources, {});
    for (std::size_t i = 0; i < light.radiance.size(); ++i)
        ASSERT_TRUE(light.radiance[i].isApprox(truth.radiance[i], 1e-4f));
}

}  // namespace
