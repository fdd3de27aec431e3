// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/translucency.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/diffusion_profile.h"
#include "shaders/shared/param_info.h"
#include "shaders/shared/rng.h"

namespace core {

namespace {

constexpr TranslucencyPreset kPresets[] = {
    {"apple", PARAM_LABEL("presets", "Apple"), {2.29f, 2.39f, 1.97f}, {0.0030f, 0.0034f, 0.046f}, 1.3f},
    {"chicken1", PARAM_LABEL("presets", "Chicken 1"), {0.15f, 0.21f, 0.38f}, {0.015f, 0.077f, 0.19f}, 1.3f},
    {"chicken2", PARAM_LABEL("presets", "Chicken 2"), {0.19f, 0.25f, 0.32f}, {0.018f, 0.088f, 0.20f}, 1.3f},
    {"cream", PARAM_LABEL("presets", "Cream"), {7.38f, 5.47f, 3.15f}, {0.0002f, 0.0028f, 0.0163f}, 1.3f},
    {"ketchup", PARAM_LABEL("presets", "Ketchup"), {0.18f, 0.07f, 0.03f}, {0.061f, 0.97f, 1.45f}, 1.3f},
    {"marble", PARAM_LABEL("presets", "Marble"), {2.19f, 2.62f, 3.00f}, {0.0021f, 0.0041f, 0.0071f}, 1.5f},
    {"potato", PARAM_LABEL("presets", "Potato"), {0.68f, 0.70f, 0.55f}, {0.0024f, 0.0090f, 0.12f}, 1.3f},
    {"skimmilk", PARAM_LABEL("presets", "Skimmed milk"), {0.70f, 1.22f, 1.90f}, {0.0014f, 0.0025f, 0.0142f}, 1.3f},
    {"skin1", PARAM_LABEL("presets", "Skin 1"), {0.74f, 0.88f, 1.01f}, {0.032f, 0.17f, 0.48f}, 1.3f},
    {"skin2", PARAM_LABEL("presets", "Skin 2"), {1.09f, 1.59f, 1.79f}, {0.013f, 0.070f, 0.145f}, 1.3f},
    {"spectralon", PARAM_LABEL("presets", "Spectralon"), {11.6f, 20.4f, 14.9f}, {0, 0, 0}, 1.3f},
    {"wholemilk", PARAM_LABEL("presets", "Whole milk"), {2.55f, 3.21f, 3.77f}, {0.0011f, 0.0024f, 0.014f}, 1.3f},
};

double coefficient(float value) { return std::isfinite(value) && value > 0 ? static_cast<double>(value) : 0.0; }

/// ∫ F(μ) μⁿ dμ over [0, 1], n = 1 or 2, for light that meets the boundary of a medium of relative index `eta` from
/// inside.
double internalFresnelMoment(double eta, int n) {
    constexpr int kSteps = 4000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double c = (i + 0.5) / kSteps;
        const double g2 = 1 / (eta * eta) - 1 + c * c;
        double f = 1;
        if (g2 > 0) {
            const double g = std::sqrt(g2);
            const double s = (g - c) / (g + c);
            const double p = (c * (g + c) - 1) / (c * (g - c) + 1);
            f = 0.5 * s * s * (1 + p * p);
        }
        sum += f * (n == 1 ? c : c * c);
    }
    return sum / kSteps;
}

/// Reflectance of a half space of albedo `alphaPrime`.
double halfSpaceReflectance(double alphaPrime, ScatteringModel model, const DiffuseBoundary& boundary) {
    return halfSpaceProfile(alphaPrime, 1 - alphaPrime, model, boundary).integral(0);
}

/// Position on the Hilbert curve over 65536² pixels: neighbours on the curve are neighbours in the picture.
std::uint64_t hilbertIndex(std::uint32_t x, std::uint32_t y) {
    std::uint64_t index = 0;
    for (std::uint32_t side = 1U << 15; side > 0; side >>= 1) {
        const std::uint32_t right = (x & side) != 0 ? 1 : 0;
        const std::uint32_t low = (y & side) != 0 ? 1 : 0;
        index = index << 2 | ((3 * right) ^ low);
        if (low == 0) {
            if (right == 1) {
                x = ~x;
                y = ~y;
            }
            std::swap(x, y);
        }
    }
    return index;
}

/// Number i of the van der Corput sequence, Owen-scrambled by the hash of [LK11] (improved constants), in [0, 1).
double scrambledVanDerCorput(std::uint32_t i, std::uint32_t seed) {
    // Scrambling nested from the highest digit on is hashing from the lowest on of the bits in reverse, which is i.
    std::uint32_t v = i;
    v ^= v * 0x3d20adeaU;
    v += seed;
    v *= (seed >> 16) | 1U;
    v ^= v * 0x05526c56U;
    v ^= v * 0x53a22864U;
    v = ((v >> 1) & 0x55555555U) | ((v & 0x55555555U) << 1);
    v = ((v >> 2) & 0x33333333U) | ((v & 0x33333333U) << 2);
    v = ((v >> 4) & 0x0f0f0f0fU) | ((v & 0x0f0f0f0fU) << 4);
    v = ((v >> 8) & 0x00ff00ffU) | ((v & 0x00ff00ffU) << 8);
    v = (v >> 16) | (v << 16);
    return std::ldexp(static_cast<double>(v) + 0.5, -32);
}

}  // namespace

std::span<const TranslucencyPreset> translucencyPresets() { return kPresets; }

const TranslucencyPreset* findTranslucencyPreset(std::string_view key) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    for (const TranslucencyPreset& preset : kPresets) {
        const std::string_view name = preset.key;
        if (std::equal(name.begin(), name.end(), key.begin(), key.end(), same)) return &preset;
    }
    return nullptr;
}

Translucency toTranslucency(const TranslucencyPreset& preset) {
    Translucency t;
    t.preset = preset.key;
    t.sigmaSPrime = Vector3f(preset.sigmaSPrime[0], preset.sigmaSPrime[1], preset.sigmaSPrime[2]);
    t.sigmaA = Vector3f(preset.sigmaA[0], preset.sigmaA[1], preset.sigmaA[2]);
    t.eta = preset.eta;
    return t;
}

double internalDiffuseFresnel(double eta) { return eta == 1 ? 0 : 2 * internalFresnelMoment(eta, 1); }

DiffuseBoundary diffuseBoundary(ScatteringModel model, double eta) {
    eta = std::isfinite(eta) ? std::clamp(eta, 0.1, 10.0) : 1.0;
    if (model == ScatteringModel::Dipole) {
        const double fdr = internalDiffuseFresnel(eta);
        return {.a = (1 + fdr) / (1 - fdr), .fluence = 0, .flux = 1};
    }
    const double c1 = eta == 1 ? 0 : internalFresnelMoment(eta, 1);
    const double c2 = eta == 1 ? 0 : internalFresnelMoment(eta, 2);
    return {.a = (1 + 3 * c2) / (1 - 2 * c1), .fluence = 0.25 * (1 - 2 * c1), .flux = 0.5 * (1 - 3 * c2)};
}

Translucency translucencyFromDiffuse(const Vector3f& color, const Vector3f& meanFreePathMm, float eta,
                                     ScatteringModel model) {
    Translucency t;
    t.model = model;
    t.eta = eta;
    const DiffuseBoundary boundary = diffuseBoundary(model, static_cast<double>(eta));
    for (int c = 0; c < 3; ++c) {
        const double target = std::clamp(coefficient(color[c]), 0.0, 1.0);
        double low = 0;
        double high = 1;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (halfSpaceReflectance(middle, model, boundary) < target ? low : high) = middle;
        }
        // At α' = 1 nothing is absorbed and σtr is 0 whatever σt' is, so stop just short of it.
        const double alphaPrime = std::min(0.5 * (low + high), 0.99999);
        const double sigmaTr = 1 / std::max(coefficient(meanFreePathMm[c]), 1e-4);
        const double sigmaT = sigmaTr / transportCoefficient(alphaPrime, 1 - alphaPrime, model);
        t.sigmaSPrime[c] = static_cast<float>(alphaPrime * sigmaT);
        t.sigmaA[c] = static_cast<float>((1 - alphaPrime) * sigmaT);
    }
    return t;
}

Vector3f diffuseMeanFreePath(const Translucency& translucency) {
    Vector3f result;
    for (int c = 0; c < 3; ++c) {
        const double sigmaTr = transportCoefficient(coefficient(translucency.sigmaSPrime[c]),
                                                    coefficient(translucency.sigmaA[c]), translucency.model);
        result[c] = static_cast<float>(std::min(1 / std::max(sigmaTr, 1e-9), static_cast<double>(kLongestFreePath)));
    }
    return result;
}

Vector3f diffuseReflectance(const Translucency& translucency) {
    const DiffusionProfile profile = profileFromTranslucency(translucency);
    Vector3f result;
    for (int c = 0; c < 3; ++c) result[c] = static_cast<float>(profile.integral(c));
    return result;
}

SurfaceSamples sampleSurface(const Analysis& analysis, const LabelImage& labels, std::uint16_t label, int count,
                             std::uint32_t seed) {
    CORE_ASSERT(analysis.front && analysis.back, "surface sampling needs both layers");
    std::vector<std::uint32_t> pixels;
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (labels[i] == label) pixels.push_back(static_cast<std::uint32_t>(i));
    const auto width = static_cast<std::uint32_t>(labels.width());
    const auto code = [width](std::uint32_t i) { return hilbertIndex(i % width, i / width); };
    std::sort(pixels.begin(), pixels.end(), [&](std::uint32_t a, std::uint32_t b) { return code(a) < code(b); });

    SurfaceSamples result;
    std::vector<double> cumulative;  // over front, then back
    cumulative.reserve(2 * pixels.size());
    const Surface* const layers[] = {analysis.front.get(), analysis.back.get()};
    for (const Surface* layer : layers)
        for (const std::uint32_t i : pixels) {
            const float area = layer->area[i];
            if (std::isfinite(area) && area > 0) result.area += static_cast<double>(area);
            cumulative.push_back(result.area);
        }
    if (result.area <= 0 || count <= 0) return result;

    result.samples.reserve(static_cast<std::size_t>(count));
    const std::uint32_t stream = kernel::rng_stream(seed, 2u * label);
    for (int s = 0; s < count; ++s) {
        const double curve = scrambledVanDerCorput(static_cast<std::uint32_t>(s), stream);
        const double target = curve * result.area;
        const auto found = std::upper_bound(cumulative.begin(), cumulative.end(), target);
        const auto cursor = static_cast<std::size_t>(std::min(found, cumulative.end() - 1) - cumulative.begin());
        const bool back = cursor >= pixels.size();
        const std::uint32_t i = pixels[back ? cursor - pixels.size() : cursor];
        const Surface& layer = *layers[back ? 1 : 0];
        result.samples.push_back({.x = static_cast<int>(i % width),
                                  .y = static_cast<int>(i / width),
                                  .back = back,
                                  .position = layer.position[i],
                                  .normal = layer.normal[i],
                                  .curve = curve});
    }
    result.order.resize(result.samples.size());
    std::iota(result.order.begin(), result.order.end(), 0U);
    std::sort(result.order.begin(), result.order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return result.samples[a].curve < result.samples[b].curve; });
    return result;
}

std::vector<float> sampleAreas(const SurfaceSamples& samples, std::size_t count) {
    count = std::min(count, samples.samples.size());
    std::vector<std::uint32_t> along;
    for (const std::uint32_t i : samples.order)
        if (i < count) along.push_back(i);
    std::vector<float> areas(count, 0.0f);
    const auto border = [&](std::size_t k) {  // between number k-1 and number k along the curve
        if (k == 0) return 0.0;
        if (k == along.size()) return 1.0;
        return 0.5 * (samples.samples[along[k - 1]].curve + samples.samples[along[k]].curve);
    };
    for (std::size_t k = 0; k < along.size(); ++k)
        areas[along[k]] = static_cast<float>((border(k + 1) - border(k)) * samples.area);
    return areas;
}

}  // namespace core
