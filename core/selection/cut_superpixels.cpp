// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/cut_superpixels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/selection/min_cut.h"

namespace core {

namespace {

/// Costs are multiples of this, so that they can be integers.
constexpr float kUnit = 100;
/// Bins of a colour model along each axis.
constexpr int kBins = 16;
/// Chroma that falls into the last bin (OKLab).
constexpr float kModelChroma = 0.2f;
/// Density that is added to every colour, so that unseen ones tell little.
constexpr float kLeastDensity = 1e-4f;
/// Largest log-likelihood ratio that a colour can contribute.
constexpr float kMaxRatio = 2;
/// How fast the cost of a cut falls with the strength of the boundary.
constexpr float kSharpness = 4;

/// Weights of what is known of a superpixel, against a cut of one pixel through nothing.
struct Weights {
    float color;  ///< of the log-likelihood ratio of its colour
    float guess;  ///< of the first guess
};
constexpr Weights kWithExactDepth{0.1f, 1.0f};
constexpr Weights kOtherwise{0.25f, 0.5f};

MinCut::Capacity capacity(float cost) { return static_cast<MinCut::Capacity>(kUnit * cost); }

/// Histogram of colours (OKLab), each spread over the eight nearest bins.
class ColorModel {
  public:
    void add(const Vector3f& lab, float weight) {
        visit(lab, [&](std::size_t bin, float share) { bins_[bin] += weight * share; });
        total_ += weight;
    }
    [[nodiscard]] float density(const Vector3f& lab) const {
        float sum = 0;
        visit(lab, [&](std::size_t bin, float share) { sum += share * bins_[bin]; });
        return sum / std::max(1.0f, total_) + kLeastDensity;
    }

  private:
    template <class Visit>
    static void visit(const Vector3f& lab, const Visit& use) {
        const auto scaled = [](float value) { return std::clamp(value, 0.0f, 1.0f) * (kBins - 1); };
        const std::array<float, 3> at{scaled(lab.x()), scaled(0.5f + 0.5f * lab.y() / kModelChroma),
                                      scaled(0.5f + 0.5f * lab.z() / kModelChroma)};
        for (unsigned corner = 0; corner < 8; ++corner) {
            float share = 1;
            std::size_t bin = 0;
            for (unsigned k = 0; k < 3; ++k) {
                const int low = static_cast<int>(at[k]);
                const float fraction = at[k] - static_cast<float>(low);
                const bool upper = ((corner >> k) & 1U) != 0;
                share *= upper ? fraction : 1 - fraction;
                bin = bin * kBins + static_cast<std::size_t>(std::min(low + (upper ? 1 : 0), kBins - 1));
            }
            use(bin, share);
        }
    }
    std::vector<float> bins_ = std::vector<float>(std::size_t{kBins} * kBins * kBins);
    float total_ = 0;
};

}  // namespace

std::vector<std::uint8_t> cutSuperpixels(const Selector::State& state, const SuperpixelPrior& prior,
                                         const Progress& progress) {
    const std::vector<Superpixel>& superpixels = state.superpixels.superpixels;
    const DepthQuality& quality = state.picture.quality;
    const Weights weights = quality.present && quality.edgeOffset == 0 ? kWithExactDepth : kOtherwise;
    ColorModel object, rest;
    for (std::size_t i = 0; i < superpixels.size(); ++i)
        (prior.object[i] != 0 ? object : rest).add(superpixels[i].lab, superpixels[i].area);
    MinCut cut(superpixels.size());
    for (std::uint32_t i = 0; i < superpixels.size(); ++i) {
        const bool inside = prior.object[i] != 0;
        const Vector3f& lab = superpixels[i].lab;
        const float ratio = std::clamp(std::log(object.density(lab) / rest.density(lab)), -kMaxRatio, kMaxRatio);
        const float vote = weights.color * ratio + (inside ? weights.guess : -weights.guess);
        const MinCut::Capacity cost = capacity(std::sqrt(superpixels[i].area) * std::abs(vote));
        cut.addNode(i, vote > 0 ? cost : 0, vote > 0 ? 0 : cost);
        if (prior.fixed[i] != 0) cut.addNode(i, inside ? MinCut::kMaxCapacity : 0, inside ? 0 : MinCut::kMaxCapacity);
    }
    for (const SuperpixelBorder& border : state.superpixels.borders) {
        const float strength = 0.5f * (border.strength + border.firmness);
        cut.addEdge(border.a, border.b, capacity(border.length * std::exp(-kSharpness * strength)));
    }
    return cut.solve(progress);
}

}  // namespace core
