// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/color.h"

namespace core::analysis {
namespace {

constexpr int kWidthCount = 33;
constexpr float kMinKnown = 0.75f;  // of a lobe, for a probe to count
constexpr std::size_t kMinProbes = 50;
/// The best width has to explain the probes this much better than the widest lobe does, which must leave at least
/// `kMinError` of their radiance unexplained.
constexpr double kDistinct = 0.93;
constexpr double kMinError = 0.005;

/// Outer edge of ring `i`.
float ringEdge(int i) {
    return kInnerRing * std::pow(kOuterRing / kInnerRing, static_cast<float>(i) / static_cast<float>(kLobeRings));
}

float widthAt(int i) {
    return kMinLobeWidth *
           std::pow(kMaxLobeWidth / kMinLobeWidth, static_cast<float>(i) / static_cast<float>(kWidthCount - 1));
}

struct Prediction {
    Vector3f incident{0, 0, 0};
    float known = 0;
};

Prediction predict(const LobeProbe& probe, float alpha) {
    Prediction result;
    for (int i = 0; i <= kLobeRings; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const float weight = ringWeight(i, alpha) * probe.known[k];
        result.incident += weight * probe.incident[k];
        result.known += weight;
    }
    if (result.known > 0) result.incident /= result.known;
    return result;
}

/// Sum of colours over sum of predictions, without the lowest and the highest tenth of the ratios of luminance.
Vector3f trimmedRatio(std::span<const LobeProbe> probes, std::span<const Vector3f> predictions) {
    std::vector<std::pair<float, std::size_t>> order;
    for (std::size_t i = 0; i < probes.size(); ++i)
        if (const float below = luminance(predictions[i]); below > 0)
            order.emplace_back(luminance(probes[i].color) / below, i);
    std::ranges::sort(order);
    Eigen::Vector3d above = Eigen::Vector3d::Zero();
    Eigen::Vector3d below = Eigen::Vector3d::Zero();
    const std::size_t trim = order.size() / 10;
    for (std::size_t k = trim; k + trim < order.size(); ++k) {
        above += probes[order[k].second].color.cast<double>();
        below += predictions[order[k].second].cast<double>();
    }
    Vector3f rho(1, 1, 1);
    for (int c = 0; c < 3; ++c)
        if (below[c] > 0) rho[c] = static_cast<float>(above[c] / below[c]);
    return rho;
}

}  // namespace

float ringWeight(int i, float alpha) {
    const auto inside = [&](int ring) {
        if (ring < 0) return 0.0f;
        if (ring >= kLobeRings) return 1.0f;
        const float t = ringEdge(ring);
        return t * t / (t * t + alpha * alpha);
    };
    return inside(i) - inside(i - 1);
}

float ringTangent(int i) { return i == 0 ? 0.0f : std::sqrt(ringEdge(i - 1) * ringEdge(i)); }

std::optional<LobeFit> fitLobe(std::span<const LobeProbe> all) {
    // One set of probes for all widths: those that know most of a wide lobe, or failing that of a narrow one.
    std::vector<LobeProbe> probes;
    for (const float judged : {0.1f, 0.03f}) {
        probes.clear();
        for (const LobeProbe& probe : all)
            if (predict(probe, judged).known >= kMinKnown && luminance(probe.color) > 0) probes.push_back(probe);
        if (probes.size() >= 4 * kMinProbes) break;
    }
    if (probes.size() < kMinProbes) return std::nullopt;

    std::vector<Vector3f> predictions(probes.size());
    std::array<double, kWidthCount> errors{};
    for (int w = 0; w < kWidthCount; ++w) {
        for (std::size_t i = 0; i < probes.size(); ++i) predictions[i] = predict(probes[i], widthAt(w)).incident;
        const Vector3f rho = trimmedRatio(probes, predictions);
        double error = 0;
        double sum = 0;
        for (std::size_t i = 0; i < probes.size(); ++i) {
            error += static_cast<double>((probes[i].color - rho.cwiseProduct(predictions[i])).lpNorm<1>());
            sum += static_cast<double>(probes[i].color.lpNorm<1>());
        }
        errors[static_cast<std::size_t>(w)] = error / sum;
    }
    const auto best = static_cast<int>(std::ranges::min_element(errors) - errors.begin());
    const double least = errors[static_cast<std::size_t>(best)];

    LobeFit fit;
    fit.probes = probes.size();
    // The minimum of a parabola through the best width and its neighbours, in log α.
    double shift = 0;
    if (best > 0 && best + 1 < kWidthCount) {
        const double a = errors[static_cast<std::size_t>(best) - 1] - least;
        const double b = errors[static_cast<std::size_t>(best) + 1] - least;
        if (a + b > 0) shift = 0.5 * (a - b) / (a + b);
    }
    fit.alpha = widthAt(best) * std::pow(widthAt(1) / widthAt(0), static_cast<float>(shift));
    fit.reliable = errors.back() >= kMinError && least <= kDistinct * errors.back();
    for (std::size_t i = 0; i < probes.size(); ++i) predictions[i] = predict(probes[i], fit.alpha).incident;
    fit.rho = trimmedRatio(probes, predictions);
    return fit;
}

std::vector<Vector2f> lobeOffsets(float alpha, int count) {
    std::vector<Vector2f> offsets;
    for (int i = 0; i < count; ++i) {
        const double u = (i + 0.5) / count;
        const double tangent = static_cast<double>(alpha) * std::sqrt(u / (1 - u));
        const double phi = 2 * std::numbers::pi * std::fmod(i * (std::numbers::phi - 1), 1.0);
        offsets.emplace_back(static_cast<float>(tangent * std::cos(phi)), static_cast<float>(tangent * std::sin(phi)));
    }
    return offsets;
}

}  // namespace core::analysis
