// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/translucency.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/material/diffusion_profile.h"
#include "shaders/shared/param_info.h"

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

/// Reflectance of a half space of albedo `alphaPrime`.
double halfSpaceReflectance(double alphaPrime, ScatteringModel model, const DiffuseBoundary& boundary) {
    return halfSpaceProfile(alphaPrime, 1 - alphaPrime, model, boundary).integral(0);
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
        // At α' = 1 there is no absorption and σtr is 0 for any σt', so stop just short of it.
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
        result[c] = static_cast<float>(std::min(1 / std::max(sigmaTr, 1e-9), static_cast<double>(kMaxMeanFreePath)));
    }
    return result;
}

Vector3f diffuseReflectance(const Translucency& translucency) {
    const DiffusionProfile profile = profileFromTranslucency(translucency);
    Vector3f result;
    for (int c = 0; c < 3; ++c) result[c] = static_cast<float>(profile.integral(c));
    return result;
}

}  // namespace core
