// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/translucency.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>

#include "shaders/shared/param_info.h"
#include "shaders/shared/rng.h"

namespace core {

namespace {

constexpr TranslucencyPreset kPresets[] = {
    {"apple", PARAM_LABEL("presets", "Apple"), {2.29f, 2.39f, 1.97f}, {0.0030f, 0.0034f, 0.046f}},
    {"chicken1", PARAM_LABEL("presets", "Chicken 1"), {0.15f, 0.21f, 0.38f}, {0.015f, 0.077f, 0.19f}},
    {"chicken2", PARAM_LABEL("presets", "Chicken 2"), {0.19f, 0.25f, 0.32f}, {0.018f, 0.088f, 0.20f}},
    {"cream", PARAM_LABEL("presets", "Cream"), {7.38f, 5.47f, 3.15f}, {0.0002f, 0.0028f, 0.0163f}},
    {"ketchup", PARAM_LABEL("presets", "Ketchup"), {0.18f, 0.07f, 0.03f}, {0.061f, 0.97f, 1.45f}},
    {"marble", PARAM_LABEL("presets", "Marble"), {2.19f, 2.62f, 3.00f}, {0.0021f, 0.0041f, 0.0071f}},
    {"potato", PARAM_LABEL("presets", "Potato"), {0.68f, 0.70f, 0.55f}, {0.0024f, 0.0090f, 0.12f}},
    {"skimmilk", PARAM_LABEL("presets", "Skimmed milk"), {0.70f, 1.22f, 1.90f}, {0.0014f, 0.0025f, 0.0142f}},
    {"skin1", PARAM_LABEL("presets", "Skin 1"), {0.74f, 0.88f, 1.01f}, {0.032f, 0.17f, 0.48f}},
    {"skin2", PARAM_LABEL("presets", "Skin 2"), {1.09f, 1.59f, 1.79f}, {0.013f, 0.070f, 0.145f}},
    {"spectralon", PARAM_LABEL("presets", "Spectralon"), {11.6f, 20.4f, 14.9f}, {0, 0, 0}},
    {"wholemilk", PARAM_LABEL("presets", "Whole milk"), {2.55f, 3.21f, 3.77f}, {0.0011f, 0.0024f, 0.014f}},
};

/// Scattering coefficients below this [1/mm] are no medium that diffusion describes.
constexpr double kMinExtinction = 1e-6;

double coefficient(float value) { return std::isfinite(value) && value > 0 ? static_cast<double>(value) : 0.0; }

double relativeIndex(float eta) { return std::isfinite(eta) ? std::clamp(static_cast<double>(eta), 0.1, 10.0) : 1.0; }

/// Mean Fresnel reflectance for diffuse light entering a denser medium: 2 ∫ F(μ) μ dμ.
double externalDiffuseFresnel(double eta) {
    constexpr int kSteps = 2000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double c = (i + 0.5) / kSteps;
        const double g = std::sqrt(eta * eta - 1 + c * c);
        const double s = (g - c) / (g + c);
        const double p = (c * (g + c) - 1) / (c * (g - c) + 1);
        sum += 0.5 * s * s * (1 + p * p) * c;
    }
    return 2 * sum / kSteps;
}

double boundaryTerm(double eta) {
    const double fdr = internalDiffuseFresnel(eta);
    return (1 + fdr) / (1 - fdr);
}

double halfSpaceReflectance(double alphaPrime, double a) {
    const double s = std::sqrt(3 * (1 - alphaPrime));
    return 0.5 * alphaPrime * (1 + std::exp(-4.0 / 3.0 * a * s)) * std::exp(-s);
}

float& channel(kernel::vec4& v, int c) { return c == 0 ? v.x : c == 1 ? v.y : v.z; }

/// Position on the Z-order curve, so that neighbours in the list are neighbours in the picture.
std::uint64_t mortonCode(int x, int y) {
    const auto spread = [](std::uint64_t v) {
        v = (v | (v << 16)) & 0x0000ffff0000ffffULL;
        v = (v | (v << 8)) & 0x00ff00ff00ff00ffULL;
        v = (v | (v << 4)) & 0x0f0f0f0f0f0f0f0fULL;
        v = (v | (v << 2)) & 0x3333333333333333ULL;
        return (v | (v << 1)) & 0x5555555555555555ULL;
    };
    return spread(static_cast<std::uint64_t>(x)) | (spread(static_cast<std::uint64_t>(y)) << 1);
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
    return t;
}

double internalDiffuseFresnel(double eta) {
    if (eta == 1) return 0;
    // Entering and leaving are tied by reciprocity: (1 − F_in) η⁻² = 1 − F_out for a denser inside.
    if (eta > 1) return 1 - (1 - externalDiffuseFresnel(eta)) / (eta * eta);
    return externalDiffuseFresnel(1 / eta);
}

Translucency translucencyFromDiffuse(const Vector3f& color, const Vector3f& meanFreePathMm, float eta) {
    Translucency t;
    t.eta = eta;
    const double a = boundaryTerm(relativeIndex(eta));
    for (int c = 0; c < 3; ++c) {
        const double target = std::clamp(coefficient(color[c]), 0.0, 1.0);
        double low = 0;
        double high = 1;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (halfSpaceReflectance(middle, a) < target ? low : high) = middle;
        }
        // σtr = sqrt(3 σa σt') = σt' sqrt(3 (1 − α')); at α' = 1 nothing is absorbed and σtr is 0 whatever σt' is, so
        // stop just short of it.
        const double alphaPrime = std::min(0.5 * (low + high), 0.99999);
        const double sigmaTr = 1 / std::max(coefficient(meanFreePathMm[c]), 1e-4);
        const double sigmaT = sigmaTr / std::sqrt(3 * (1 - alphaPrime));
        t.sigmaSPrime[c] = static_cast<float>(alphaPrime * sigmaT);
        t.sigmaA[c] = static_cast<float>((1 - alphaPrime) * sigmaT);
    }
    return t;
}

kernel::DipoleParams dipoleFromTranslucency(const Translucency& translucency) {
    kernel::DipoleParams p;
    const double eta = relativeIndex(translucency.eta);
    const double a = boundaryTerm(eta);
    const double scale = std::max(coefficient(translucency.scale), 1e-6);
    for (int c = 0; c < 3; ++c) {
        const double sigmaS = coefficient(translucency.sigmaSPrime[c]);
        const double sigmaA = coefficient(translucency.sigmaA[c]);
        const double sigmaT = std::max(sigmaS + sigmaA, kMinExtinction);
        const double perMetre = 1000 * scale;
        const double zr = 1 / (sigmaT * perMetre);
        channel(p.zr, c) = static_cast<float>(zr);
        channel(p.zv, c) = static_cast<float>(zr * (1 + 4.0 / 3.0 * a));
        channel(p.sigmaTr, c) = static_cast<float>(std::sqrt(3 * sigmaA * sigmaT) * perMetre);
        channel(p.alphaPrime, c) = static_cast<float>(sigmaS / sigmaT);
    }
    p.alphaPrime.w = static_cast<float>(eta);
    return p;
}

Vector3f diffuseReflectance(const Translucency& translucency) {
    const double a = boundaryTerm(relativeIndex(translucency.eta));
    Vector3f result;
    for (int c = 0; c < 3; ++c) {
        const double sigmaS = coefficient(translucency.sigmaSPrime[c]);
        const double sigmaT = std::max(sigmaS + coefficient(translucency.sigmaA[c]), kMinExtinction);
        result[c] = static_cast<float>(halfSpaceReflectance(sigmaS / sigmaT, a));
    }
    return result;
}

SurfaceSamples sampleSurface(const Analysis& analysis, const LabelImage& labels, std::uint16_t label, int count,
                             std::uint32_t seed) {
    CORE_ASSERT(analysis.front && analysis.back, "surface sampling needs both layers");
    std::vector<std::uint32_t> pixels;
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (labels[i] == label) pixels.push_back(static_cast<std::uint32_t>(i));
    const auto width = static_cast<std::uint32_t>(labels.width());
    const auto code = [width](std::uint32_t i) {
        return mortonCode(static_cast<int>(i % width), static_cast<int>(i / width));
    };
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
    std::size_t cursor = 0;
    for (int s = 0; s < count; ++s) {
        const double u = static_cast<double>(kernel::rng_float(static_cast<kernel::uint>(s), 0, 0, stream));
        const double target = (s + u) / count * result.area;
        while (cursor + 1 < cumulative.size() && cumulative[cursor] <= target) ++cursor;
        const bool back = cursor >= pixels.size();
        const std::uint32_t i = pixels[back ? cursor - pixels.size() : cursor];
        const Surface& layer = *layers[back ? 1 : 0];
        result.samples.push_back({.x = static_cast<int>(i % width),
                                  .y = static_cast<int>(i / width),
                                  .back = back,
                                  .position = layer.position[i],
                                  .normal = layer.normal[i]});
    }
    return result;
}

kernel::DipoleParams smoothedFor(const SurfaceSamples& samples, kernel::DipoleParams dipole) {
    const auto count = static_cast<double>(samples.samples.size());
    dipole.zr.w = count > 0 ? static_cast<float>(samples.area / count) : 0.0f;
    return dipole;
}

}  // namespace core
