// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shading/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "shaders/shared/rng.h"

namespace core {
namespace {

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
    // Nested scrambling from the highest digit equals hashing the reversed bits from the lowest; reversed, they are i.
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
    std::vector<double> cumulative;  // areas of front, then back
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
    // Border between samples k-1 and k along the curve.
    const auto border = [&](std::size_t k) {
        if (k == 0) return 0.0;
        if (k == along.size()) return 1.0;
        return 0.5 * (samples.samples[along[k - 1]].curve + samples.samples[along[k]].curve);
    };
    for (std::size_t k = 0; k < along.size(); ++k)
        areas[along[k]] = static_cast<float>((border(k + 1) - border(k)) * samples.area);
    return areas;
}

}  // namespace core
