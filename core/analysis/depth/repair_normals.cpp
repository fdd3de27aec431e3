// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/repair_normals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/analysis/depth/continue_depth.h"
#include "core/analysis/depth/normals.h"
#include "core/base/parallel.h"

namespace core::analysis {
namespace {

/// Cosine from which two normals agree, about 26 degrees.
constexpr float kAgreement = 0.9f;
/// Minimum share of neighbours whose normals agree with a consistent one.
constexpr float kSettledPart = 0.3f;
/// Half-width of the window of those neighbours [depth samples].
constexpr int kWindow = 2;
/// Half-width of the second window [depth samples].
constexpr int kAround = 3;
/// Minimum share of consistent pixels in the second window.
constexpr float kAgreeingPart = 0.6f;
/// Half-widths of the windows in which a replacement is sought, in turn [depth samples].
constexpr std::array kReaches{3, 6, 12};
/// Width of the consistent margin from which depth is continued [depth samples].
constexpr int kMargin = 6;
/// Minimum weight of consistent pixels in a window of `kReaches`.
constexpr float kLeastWeight = 2;

}  // namespace

void settleNormals(Surface& surface, const LabelImage& labels, const Camera& camera, float step,
                   const Progress& progress) {
    const int stride = std::max(1, static_cast<int>(std::lround(step)));
    const ImageV3 fitted = surface.normal;
    const auto known = [&](int x, int y, std::uint16_t label) {
        return fitted.contains(x, y) && labels(x, y) == label && surface.depth(x, y) > 0;
    };
    Image<std::uint8_t> agrees(labels.width(), labels.height(), 0);
    constexpr float kMiddle = 0.4f;
    constexpr float kLate = 0.7f;
    parallelFor(progress.part(0, kMiddle), labels.height(), [&](int y) {
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
            agrees(x, y) = static_cast<float>(agreeing) >= kSettledPart * static_cast<float>(count) ? 1 : 0;
        }
    });
    // In the band neighbours agree by chance here and there: what is settled has settled ones around it.
    Image<std::uint8_t> settled = agrees;
    parallelFor(progress.part(kMiddle, kMiddle), labels.height(), [&](int y) {
        for (int x = 0; x < labels.width(); ++x) {
            const std::uint16_t label = labels(x, y);
            if (agrees(x, y) == 0) continue;
            int agreeing = 0, count = 0;
            for (int j = -kAround; j <= kAround; ++j)
                for (int i = -kAround; i <= kAround; ++i) {
                    const int u = x + i * stride;
                    const int v = y + j * stride;
                    if (!known(u, v, label)) continue;
                    ++count;
                    agreeing += agrees(u, v);
                }
            if (static_cast<float>(agreeing) < kAgreeingPart * static_cast<float>(count)) settled(x, y) = 0;
        }
    });
    DepthGaps gaps{Image<std::uint8_t>(labels.width(), labels.height(), 0), kMargin * stride, kReaches.back() * stride};
    parallelFor(progress.part(kMiddle, kLate), labels.height(), [&](int y) {
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
                if (normal.dot(surface.position(x, y)) < 0) {
                    surface.normal(x, y) = normal;
                    gaps.isGap(x, y) = 1;
                }
                break;
            }
        }
    });
    const Image<std::uint8_t> moved = gaps.isGap;
    continueDepth(surface.depth, labels, camera, gaps, progress.part(kLate, 1));
    for (int y = 0; y < labels.height(); ++y) {
        for (int x = 0; x < labels.width(); ++x) {
            if (moved(x, y) == 0) continue;
            const Vector3f position = camera.backProject(x, y, surface.depth(x, y));
            surface.position(x, y) = position;
            surface.area(x, y) = patchArea(camera, position, surface.normal(x, y));
        }
    }
}

}  // namespace core::analysis
