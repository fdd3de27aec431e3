// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "core/analysis/segment/segment_pixels.h"

namespace core::analysis {

/// For every label, whether the segment is a support: something that objects stand on or in front of (a table, a wall).
/// It leaves the picture on opposite sides with at least a tenth of its outline, or with two fifths of it on any side.
/// Its far end is unknown, so that a mirror plane is meaningless; it becomes a slab as thick as its `offset`.
[[nodiscard]] std::vector<bool> findSupports(const LabelImage& labels);

/// Plane n·p = offset of a support; the normal points into it, away from what stands on it.
struct SupportPlane {
    Vector3f normal{0, 0, 1};
    float offset = 0;  ///< [m]

    /// Depth [m] at which the ray of a pixel meets the plane from above; infinite when it does not.
    [[nodiscard]] float depthAlong(const Vector3f& pixelRay) const {
        const float slope = normal.dot(pixelRay);
        return slope > 1e-6f ? offset / slope : std::numeric_limits<float>::infinity();
    }
};

/// Plane through points, fitted robustly (RANSAC, then least squares over the inliers: points within three pixel widths
/// of it). `pixelWidth` [m] at a depth of one metre. nullopt for fewer than a dozen points, or when fewer than half
/// of them are inliers.
[[nodiscard]] std::optional<SupportPlane> fitPlane(std::span<const Vector3f> points, float pixelWidth);

/// The plane a segment stands on or leans against (`fitPlane`), from the support pixels around the segment's outline.
/// nullopt when no support touches it, when these pixels are not on a plane, or when more than a tenth of the segment
/// lies beyond that plane and so does not stand on it.
[[nodiscard]] std::optional<SupportPlane> fitSupportPlane(const SegmentPixels& segment);

}  // namespace core::analysis
