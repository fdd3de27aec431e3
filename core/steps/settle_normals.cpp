// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/settle_normals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "core/steps/surface.h"

namespace core::steps {
namespace {

constexpr float kAgreement = 0.9f;        ///< cosine, about 26 degrees
constexpr float kSettledPart = 0.3f;      ///< of the neighbours that have to agree
constexpr int kWindow = 2;                ///< neighbours on each side, in samples of the depth map
constexpr std::array kReaches{3, 6, 12};  ///< in which settled ones are looked for, likewise
constexpr float kLeastWeight = 2;         ///< of settled ones in such a reach

}  // namespace

void settleNormals(Surface& surface, const LabelImage& labels, const Camera& camera, float step, const StepPart& part) {
    const int stride = std::max(1, static_cast<int>(std::lround(step)));
    const ImageV3 fitted = surface.normal;
    const auto known = [&](int x, int y, std::uint16_t label) {
        return fitted.contains(x, y) && labels(x, y) == label && surface.depth(x, y) > 0;
    };
    Image<std::uint8_t> settled(labels.width(), labels.height(), 0);
    const float middle = 0.5f * (part.from + part.to);
    parallelFor(
        part.context, part.step, labels.height(),
        [&](int y) {
            for (int x = 0; x < labels.width(); ++x) {
                const std::uint16_t label = labels(x, y);
                if (label == 0 || !known(x, y, label)) continue;
                int agreeing = -1, count = -1;  // not the pixel itself
                for (int j = -kWindow; j <= kWindow; ++j)
                    for (int i = -kWindow; i <= kWindow; ++i) {
                        const int u = x + i * stride;
                        const int v = y + j * stride;
                        if (!known(u, v, label)) continue;
                        ++count;
                        if (fitted(u, v).dot(fitted(x, y)) > kAgreement) ++agreeing;
                    }
                settled(x, y) = static_cast<float>(agreeing) >= kSettledPart * static_cast<float>(count) ? 1 : 0;
            }
        },
        part.from, middle);
    parallelFor(
        part.context, part.step, labels.height(),
        [&](int y) {
            for (int x = 0; x < labels.width(); ++x) {
                const std::uint16_t label = labels(x, y);
                if (label == 0 || settled(x, y) != 0 || !known(x, y, label)) continue;
                for (const int reach : kReaches) {
                    const float falloff = 2 / static_cast<float>(reach * reach);
                    Vector3f sum = Vector3f::Zero();
                    float weights = 0;
                    for (int j = -reach; j <= reach; ++j)
                        for (int i = -reach; i <= reach; ++i) {
                            const int u = x + i * stride;
                            const int v = y + j * stride;
                            if (!known(u, v, label) || settled(u, v) == 0) continue;
                            const float weight = std::exp(-falloff * static_cast<float>(i * i + j * j));
                            sum += weight * fitted(u, v);
                            weights += weight;
                        }
                    if (weights < kLeastWeight) continue;
                    const Vector3f normal = sum.normalized();
                    const Vector3f& position = surface.position(x, y);
                    if (normal.dot(position) < 0) {
                        surface.normal(x, y) = normal;
                        surface.area(x, y) = patchArea(camera, position, normal);
                    }
                    break;
                }
            }
        },
        middle, part.to);
}

}  // namespace core::steps
