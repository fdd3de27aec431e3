// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/repair_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/analysis/depth/depth_noise.h"
#include "core/analysis/depth/fill_depth.h"
#include "core/analysis/depth/normals.h"
#include "core/base/parallel.h"
#include "core/base/pixel.h"
#include "core/base/staged_progress.h"

namespace core::analysis {
namespace {

/// Cosine from which two normals agree, about 26 degrees.
constexpr float kMinAgreement = 0.9f;
/// Half-width of the window [depth samples] in which a fraction of the neighbours must agree with a pixel.
constexpr int kWindow = 2;
constexpr float kMinAgreeingNeighbors = 0.3f;
/// Half-width of the window [depth samples] in which this fraction of the pixels must also agree with their neighbours.
/// In a band of wrong normals neighbours agree by chance here and there, but not many side by side.
constexpr int kReliableWindow = 3;
constexpr float kMinReliableFraction = 0.6f;
/// Half-widths of the windows [depth samples] that are searched for reliable normals, and their smallest total weight.
constexpr std::array kReaches{3, 6, 12};
constexpr float kMinWeight = 2;
/// Width of the strip of reliable pixels [depth samples] that repaired depth continues.
constexpr int kRepairMargin = 6;

/// A surface with its normals as they were fitted, seen through windows of one depth sample's spacing.
struct FittedNormals {
    const Surface& surface;
    const LabelImage& labels;
    const ImageV3& normals;
    int spacing;  ///< [px]

    [[nodiscard]] bool isKnown(int x, int y, std::uint16_t label) const {
        return normals.contains(x, y) && labels(x, y) == label && surface.depth(x, y) > 0;
    }

    /// Calls `visitor(u, v, i, j)` for every known pixel (u, v) of the centre's segment within `reach` samples of it.
    template <class Visitor>
    void forWindow(Pixel center, int reach, const Visitor& visitor) const {
        const std::uint16_t label = labels(center.x, center.y);
        for (int j = -reach; j <= reach; ++j)
            for (int i = -reach; i <= reach; ++i) {
                const int u = center.x + i * spacing;
                const int v = center.y + j * spacing;
                if (isKnown(u, v, label)) visitor(u, v, i, j);
            }
    }

    [[nodiscard]] bool agreesWithNeighbors(Pixel p) const {
        int agreeing = -1, count = -1;  // without the pixel itself
        forWindow(p, kWindow, [&](int u, int v, int, int) {
            ++count;
            if (normals(u, v).dot(normals(p.x, p.y)) > kMinAgreement) ++agreeing;
        });
        return static_cast<float>(agreeing) >= kMinAgreeingNeighbors * static_cast<float>(count);
    }

    [[nodiscard]] bool isReliable(Pixel p, const Image<std::uint8_t>& agrees) const {
        int agreeing = 0, count = 0;
        forWindow(p, kReliableWindow, [&](int u, int v, int, int) {
            ++count;
            agreeing += agrees(u, v);
        });
        return !(static_cast<float>(agreeing) < kMinReliableFraction * static_cast<float>(count));
    }

    /// Mean of the reliable normals in the smallest window with enough of them.
    [[nodiscard]] std::optional<Vector3f> meanAround(Pixel p, const Image<std::uint8_t>& reliable) const {
        for (const int reach : kReaches) {
            const float falloff = 2 / static_cast<float>(reach * reach);
            Vector3f sum = Vector3f::Zero();
            float weights = 0;
            forWindow(p, reach, [&](int u, int v, int i, int j) {
                if (reliable(u, v) == 0) return;
                const float weight = std::exp(-falloff * static_cast<float>(i * i + j * j));
                sum += weight * normals(u, v);
                weights += weight;
            });
            if (weights >= kMinWeight) return sum.normalized();
        }
        return std::nullopt;
    }
};

// Expected times [ns on two cores] of finding agreeing and reliable pixels, per pixel, and of the repair of one pixel:
// its mean normal and its depth.
constexpr double kAgreementTime = 200;
constexpr double kReliabilityTime = 330;
constexpr double kMeanTime = 5000;
constexpr double kDepthTime = 20000;
/// Fraction of the pixels that are repaired, before it is known.
constexpr double kExpectedRepairs = 0.005;

/// 1 for labelled pixels whose normals are reliable.
Image<std::uint8_t> findReliable(const FittedNormals& fitted, StagedProgress& stages) {
    const LabelImage& labels = fitted.labels;
    const auto pixels = static_cast<double>(labels.size());
    Image<std::uint8_t> agrees(labels.width(), labels.height(), 0);
    parallelFor(stages.next(kAgreementTime * pixels), labels.height(), [&](int y) {
        for (int x = 0; x < labels.width(); ++x) {
            const std::uint16_t label = labels(x, y);
            if (label != 0 && fitted.isKnown(x, y, label)) agrees(x, y) = fitted.agreesWithNeighbors({x, y}) ? 1 : 0;
        }
    });
    Image<std::uint8_t> reliable = agrees;
    parallelFor(stages.next(kReliabilityTime * pixels), labels.height(), [&](int y) {
        for (int x = 0; x < labels.width(); ++x)
            if (agrees(x, y) != 0 && !fitted.isReliable({x, y}, agrees)) reliable(x, y) = 0;
    });
    return reliable;
}

}  // namespace

void repairNormals(Surface& surface, const LabelImage& labels, const Camera& camera, float depthSampleSpacing,
                   const Progress& progress) {
    const int spacing = wholeSpacing(depthSampleSpacing);
    const ImageV3 normals = surface.normal;
    const FittedNormals fitted{surface, labels, normals, spacing};
    StagedProgress stages(progress, static_cast<double>(labels.size()) * (kAgreementTime + kReliabilityTime +
                                                                          kExpectedRepairs * (kMeanTime + kDepthTime)));
    const Image<std::uint8_t> reliable = findReliable(fitted, stages);
    stages.setRemaining(kMeanTime + kDepthTime);
    DepthGaps gaps{Image<std::uint8_t>(labels.width(), labels.height(), 0), kRepairMargin * spacing,
                   kReaches.back() * spacing};
    parallelFor(stages.next(kMeanTime), labels.height(), [&](int y) {
        for (int x = 0; x < labels.width(); ++x) {
            const std::uint16_t label = labels(x, y);
            if (label == 0 || reliable(x, y) != 0 || !fitted.isKnown(x, y, label)) continue;
            const auto normal = fitted.meanAround({x, y}, reliable);
            if (!normal || !(normal->dot(surface.position(x, y)) < 0)) continue;
            surface.normal(x, y) = *normal;
            gaps.isGap(x, y) = 1;
        }
    });
    const Image<std::uint8_t> repaired = gaps.isGap;
    fillWithPlanes(surface.depth, labels, camera, gaps, stages.next(kDepthTime));
    for (int y = 0; y < labels.height(); ++y) {
        for (int x = 0; x < labels.width(); ++x) {
            if (repaired(x, y) == 0) continue;
            const Vector3f position = camera.backProject(x, y, surface.depth(x, y));
            surface.position(x, y) = position;
            surface.area(x, y) = patchArea(camera, position, surface.normal(x, y));
        }
    }
}

}  // namespace core::analysis
