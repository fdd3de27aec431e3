// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/light/surface_color.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/analysis/light/irradiance.h"
#include "core/base/color.h"
#include "core/base/statistics.h"

namespace core {

namespace {

constexpr float kMeterReflectance = 0.18f;
constexpr float kMaxAlbedo = 0.9f;
constexpr std::size_t kMaxPixels = 40000;
constexpr int kPickRadius = 2;
/// E(n)/π of a light.
class Shading {
  public:
    Shading(const Photo& photo, const Analysis* analysis) {
        if (analysis != nullptr && analysis->environment != nullptr && !analysis->environment->empty() &&
            analysis->front != nullptr && analysis->front->normal.sameSize(photo.color)) {
            front_ = analysis->front.get();
            light_.emplace(analysis->environment->radiance);
            return;
        }
        double sum = 0;
        for (const Vector3f& c : photo.color.pixels()) sum += static_cast<double>(luminance(c));
        const auto count = static_cast<double>(std::max<std::size_t>(photo.color.size(), 1));
        uniform_ = static_cast<float>(sum / count) / kMeterReflectance;
    }

    /// 0 = unknown.
    [[nodiscard]] Vector3f at(std::size_t pixel) const {
        if (front_ == nullptr) return Vector3f::Constant(uniform_);
        if (!(front_->depth[pixel] > 0)) return Vector3f::Zero();
        return light_->at(front_->normal[pixel]);
    }

  private:
    const Surface* front_ = nullptr;
    float uniform_ = 0;
    std::optional<analysis::Irradiance> light_;
};

Vector3f albedoOf(const Photo& photo, const Shading& shading, const std::vector<std::size_t>& pixels) {
    std::array<std::vector<float>, 3> ratios;
    for (const std::size_t i : pixels) {
        const Vector3f light = shading.at(i);
        if (!(light.minCoeff() > 1e-6f) || !photo.color[i].allFinite()) continue;
        for (int c = 0; c < 3; ++c) ratios[static_cast<std::size_t>(c)].push_back(photo.color[i][c] / light[c]);
    }
    if (ratios[0].empty()) return Vector3f::Constant(0.5f);
    Vector3f albedo;
    for (int c = 0; c < 3; ++c) albedo[c] = median(ratios[static_cast<std::size_t>(c)]);
    const float most = albedo.maxCoeff();
    return most > kMaxAlbedo ? Vector3f(kMaxAlbedo / most * albedo) : albedo;
}

}  // namespace

Vector3f segmentAlbedo(const Photo& photo, const Analysis* analysis, std::uint16_t label) {
    std::vector<std::size_t> pixels;
    for (std::size_t i = 0; i < photo.labels.size(); ++i)
        if (photo.labels[i] == label) pixels.push_back(i);
    const std::size_t stride = pixels.size() / kMaxPixels + 1;
    std::vector<std::size_t> some;
    for (std::size_t i = 0; i < pixels.size(); i += stride) some.push_back(pixels[i]);
    return albedoOf(photo, Shading(photo, analysis), some);
}

Vector3f albedoAt(const Photo& photo, const Analysis* analysis, int x, int y) {
    std::vector<std::size_t> pixels;
    if (photo.color.contains(x, y))
        for (int v = y - kPickRadius; v <= y + kPickRadius; ++v)
            for (int u = x - kPickRadius; u <= x + kPickRadius; ++u)
                if (photo.labels.contains(u, v) && photo.labels(u, v) == photo.labels(x, y))
                    pixels.push_back(photo.color.index(u, v));
    return albedoOf(photo, Shading(photo, analysis), pixels);
}

}  // namespace core
