// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shading/image_filter.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/color.h"

namespace core {

namespace {

constexpr float kEpsilon = 1e-6f;
constexpr std::array<float, 5> kB3Spline{1.0f / 16, 4.0f / 16, 6.0f / 16, 4.0f / 16, 1.0f / 16};

class Filter {
  public:
    Filter(const Accumulation& accumulation, const Camera& camera, const Surface& front, const LabelImage& labels,
           const std::vector<std::uint8_t>& edited, const ImageFilterParams& params)
        : camera_(camera), front_(front), params_(params), color_(meanRadiance(accumulation)) {
        group_ = labels;
        for (std::size_t i = 0; i < group_.size(); ++i) {
            const bool takesPart = group_[i] < edited.size() && edited[group_[i]] != 0 && front.depth[i] > 0;
            if (!takesPart) group_[i] = 0;
        }
        variance_ = ImageF(color_.width(), color_.height());
        forEachPixel([&](int x, int y) { variance_(x, y) = initialVariance(accumulation, x, y); });
    }

    void level(int level) {
        ImageF smooth(variance_.width(), variance_.height());
        forEachPixel([&](int x, int y) { smooth(x, y) = smoothVariance(x, y); });
        ImageRgb color = color_;
        ImageF variance = variance_;
        forEachPixel([&](int x, int y) { filterPixel(x, y, 1 << level, smooth(x, y), color(x, y), variance(x, y)); });
        color_ = std::move(color);
        variance_ = std::move(variance);
    }

    ImageRgb take() { return std::move(color_); }

  private:
    template <class Body>
    void forEachPixel(const Body& body) const {
        tbb::parallel_for(tbb::blocked_range<int>(0, group_.height()), [&](const tbb::blocked_range<int>& rows) {
            for (int y = rows.begin(); y < rows.end(); ++y)
                for (int x = 0; x < group_.width(); ++x)
                    if (group_(x, y) != 0) body(x, y);
        });
    }

    [[nodiscard]] bool together(int x, int y, int qx, int qy) const {
        return group_.contains(qx, qy) && group_(qx, qy) == group_(x, y);
    }

    [[nodiscard]] float initialVariance(const Accumulation& accumulation, int x, int y) const {
        const auto n = static_cast<float>(accumulation.samples);
        if (accumulation.samples >= kTemporalSamples) {
            const float mean = luminance(color_(x, y));
            return std::max((accumulation.sumSquaredLuminance(x, y) / n - mean * mean) / (n - 1), 0.0f);
        }
        float sum = 0;
        float squared = 0;
        float count = 0;
        for (int dy = -3; dy <= 3; ++dy)
            for (int dx = -3; dx <= 3; ++dx) {
                if (!together(x, y, x + dx, y + dy)) continue;
                const float l = luminance(color_(x + dx, y + dy));
                sum += l;
                squared += l * l;
                count += 1;
            }
        return std::max(squared / count - (sum / count) * (sum / count), 0.0f);
    }

    [[nodiscard]] float smoothVariance(int x, int y) const {
        float sum = 0;
        float weights = 0;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                if (!together(x, y, x + dx, y + dy)) continue;
                const auto w = static_cast<float>((2 - std::abs(dx)) * (2 - std::abs(dy)));
                sum += w * variance_(x + dx, y + dy);
                weights += w;
            }
        return sum / weights;
    }

    void filterPixel(int x, int y, int step, float variance, Vector3f& colorOut, float& varianceOut) const {
        const Vector3f position = front_.position(x, y);
        const Vector3f normal = front_.normal(x, y);
        const float footprint = front_.depth(x, y) / camera_.fx;
        const float here = luminance(color_(x, y));
        const float luminanceScale = 1 / (params_.luminanceSigma * std::sqrt(variance) + kEpsilon);
        const float depthScale = 1 / (params_.depthSigma * footprint * static_cast<float>(step));
        Vector3f color = Vector3f::Zero();
        float weights = 0;
        float squared = 0;
        for (int dy = -2; dy <= 2; ++dy)
            for (int dx = -2; dx <= 2; ++dx) {
                const int qx = x + dx * step;
                const int qy = y + dy * step;
                if (!together(x, y, qx, qy)) continue;
                float w = kB3Spline[static_cast<unsigned>(dx + 2)] * kB3Spline[static_cast<unsigned>(dy + 2)];
                if (dx != 0 || dy != 0) {
                    const float cosine = std::max(normal.dot(front_.normal(qx, qy)), 0.0f);
                    const float plane = std::abs(normal.dot(front_.position(qx, qy) - position));
                    const auto distance = static_cast<float>(std::max(std::abs(dx), std::abs(dy)));
                    w *= std::pow(cosine, params_.normalPower) *
                         std::exp(-plane * depthScale / distance -
                                  std::abs(luminance(color_(qx, qy)) - here) * luminanceScale);
                }
                color += w * color_(qx, qy);
                weights += w;
                squared += w * w * variance_(qx, qy);
            }
        colorOut = color / weights;
        varianceOut = squared / (weights * weights);
    }

    Camera camera_;
    const Surface& front_;
    ImageFilterParams params_;
    LabelImage group_;  ///< label of the pixels that take part, otherwise 0
    ImageRgb color_;
    ImageF variance_;
};

}  // namespace

ImageRgb meanRadiance(const Accumulation& accumulation) {
    ImageRgb mean = accumulation.sum;
    if (accumulation.samples > 0)
        for (Vector3f& c : mean.pixels()) c /= static_cast<float>(accumulation.samples);
    return mean;
}

ImageRgb filterReshaded(const Accumulation& accumulation, const Camera& camera, const Surface& front,
                        const LabelImage& labels, const std::vector<std::uint8_t>& edited,
                        const ImageFilterParams& params, const Progress& progress) {
    if (accumulation.samples <= 0) return accumulation.sum;
    Filter filter(accumulation, camera, front, labels, edited, params);
    for (int i = 0; i < params.levels; ++i) {
        progress.checkpoint(static_cast<float>(i) / static_cast<float>(params.levels));
        filter.level(i);
    }
    return filter.take();
}

}  // namespace core
