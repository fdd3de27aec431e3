// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/diffusion_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core {
namespace {

/// Extinction coefficients below this [1/mm] are outside the validity of diffusion.
constexpr double kMinExtinction = 1e-6;

double nonNegative(float value) { return std::isfinite(value) && value > 0 ? static_cast<double>(value) : 0.0; }

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

}  // namespace

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

double transportCoefficient(double sigmaSPrime, double sigmaA, ScatteringModel model) {
    const double sigmaT = std::max(sigmaSPrime + sigmaA, 1e-300);
    const double d =
        model == ScatteringModel::Dipole ? 1 / (3 * sigmaT) : (2 * sigmaA + sigmaSPrime) / (3 * sigmaT * sigmaT);
    return std::sqrt(sigmaA / d);
}

DiffusionProfile halfSpaceProfile(double sigmaSPrime, double sigmaA, ScatteringModel model,
                                  const DiffuseBoundary& boundary) {
    const double sigmaT = sigmaSPrime + sigmaA;
    const double alpha = sigmaSPrime / sigmaT;
    const double zr = 1 / sigmaT;
    const bool better = model == ScatteringModel::BetterDipole;
    const double d = better ? (2 * sigmaA + sigmaSPrime) / (3 * sigmaT * sigmaT) : 1 / (3 * sigmaT);
    const double zv = zr + 4 * boundary.a * d;
    const double strength = (better ? alpha * alpha : alpha) / (4 * std::numbers::pi);
    // Almost without absorption each of the two fluences diverges, but not their difference.
    const double sigma = std::max(transportCoefficient(sigmaSPrime, sigmaA, model), better ? 1e-5 * sigmaT : 0.0);
    const double flux = strength * boundary.flux;
    const double fluence = strength * boundary.fluence / d;
    DiffusionProfile profile;
    for (std::vector<DiffusionProfile::Term>& terms : profile.terms)
        terms = {{.z = zr, .sigma = sigma, .flux = flux, .fluence = fluence},
                 {.z = zv, .sigma = sigma, .flux = flux, .fluence = -fluence}};
    return profile;
}

DiffusionProfile profileFromTranslucency(const Translucency& translucency) {
    DiffusionProfile profile;
    profile.eta = std::isfinite(translucency.eta) ? std::clamp(translucency.eta, 0.1f, 10.0f) : 1.0f;
    const DiffuseBoundary boundary = diffuseBoundary(translucency.model, static_cast<double>(profile.eta));
    const double perMetre = 1000 * std::max(nonNegative(translucency.scale), 1e-6);
    for (int c = 0; c < 3; ++c) {
        const double sigmaS = nonNegative(translucency.sigmaSPrime[c]);
        const double sigmaT = std::max(sigmaS + nonNegative(translucency.sigmaA[c]), kMinExtinction);
        const auto channel = static_cast<std::size_t>(c);
        profile.terms[channel] =
            halfSpaceProfile(sigmaS * perMetre, (sigmaT - sigmaS) * perMetre, translucency.model, boundary)
                .terms[channel];
    }
    return profile;
}

double DiffusionProfile::evaluate(int channel, double r2) const {
    double sum = 0;
    for (const Term& t : terms[static_cast<std::size_t>(channel)]) {
        const double d2 = r2 + t.z * t.z;
        const double d = std::sqrt(d2);
        sum += (t.flux * t.z * (1 + t.sigma * d) / d2 + t.fluence) * std::exp(-t.sigma * (d - t.shift)) / d;
    }
    return sum;
}

double DiffusionProfile::integral(int channel) const {
    double sum = 0;
    for (const Term& t : terms[static_cast<std::size_t>(channel)]) {
        const double decay = 2 * std::numbers::pi * std::exp(-t.sigma * (t.z - t.shift));
        sum += t.flux * decay;
        if (t.fluence != 0) sum += t.fluence * decay / t.sigma;
    }
    return sum;
}

double DiffusionProfile::tolerance(int channel) const {
    const double whole = integral(channel);
    if (!(sampleArea > 0) || !(whole > 0)) return 0;
    constexpr int kRings = 240;
    constexpr double kDeviation = 1.5;
    const double low = std::log(1e-2 * std::sqrt(sampleArea));
    double depth = std::sqrt(sampleArea);
    for (const Term& t : terms[static_cast<std::size_t>(channel)]) depth = std::max(depth, t.z);
    const double step = (std::log(30 * depth) - low) / kRings;
    double squared = 0;
    for (int ring = 0; ring < kRings; ++ring) {
        const double r = std::exp(low + step * (ring + 0.5));
        const double value = evaluate(channel, r * r);
        squared += value * value * 2 * std::numbers::pi * r * r * step;
    }
    return 3 * kDeviation * sampleArea * squared / whole;
}

DiffusionProfile blurred(DiffusionProfile profile, double area) {
    profile.sampleArea = area;
    for (std::vector<DiffusionProfile::Term>& terms : profile.terms)
        for (DiffusionProfile::Term& t : terms) {
            if (t.sigma * t.sigma * area > 1) {
                const double sigma = 1 / std::sqrt(area);
                const double decay = std::exp((sigma - t.sigma) * (t.z - t.shift));
                t.flux *= decay;
                t.fluence *= decay * sigma / t.sigma;
                t.sigma = sigma;
            }
            const double b = 0.5 * t.sigma * area;
            t.shift += b + std::sqrt(b * b + area);
            t.z += b + std::sqrt(b * b + area);
        }
    return profile;
}

}  // namespace core
