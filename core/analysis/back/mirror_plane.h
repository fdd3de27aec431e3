// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "core/analysis/segment/segment_pixels.h"

namespace core::analysis {

/// Symmetry plane assumed for one segment ([BRD14] section 3.2): n·p = offset.
struct MirrorPlane {
    Vector3f normal{0, 0, 1};  ///< unit, facing away from the camera (z ≥ 0)
    float offset = 0;          ///< [m]
    float error = 0;           ///< E = max(C, O) of the plane, [0, 1]

    [[nodiscard]] Vector3f mirrored(const Vector3f& p) const { return p - 2 * (normal.dot(p) - offset) * normal; }
    [[nodiscard]] Vector3f mirroredDirection(const Vector3f& d) const { return d - 2 * normal.dot(d) * normal; }
};

/// Principal axis of the points most parallel to the image-plane normal (0, 0, 1), facing away from the camera. The
/// paper prints argmin |eᵢ·n|, which contradicts its words "most similar"; this is argmax. nullopt for fewer than 3
/// points or points on one line.
[[nodiscard]] std::optional<Vector3f> mirrorAxis(std::span<const Vector3f> points);

/// The two parts of E = max(C, O) of a plane.
struct MirrorErrors {
    float behind = 0;  ///< C: share of the points behind the plane, [0, 1]
    /// O: share of the points whose mirror images project outside the segment's silhouette, [0, 1]. Images behind
    /// another object (nearer than the original point, and no support) are invisible and do not count as outside.
    float outside = 0;
};
[[nodiscard]] MirrorErrors mirrorErrors(const SegmentPixels& segment, const MirrorPlane& plane);

/// Moves the plane along `axis` to where E = max(C, O) is minimal, by bisection between the nearest and the farthest
/// point: C falls with the offset, O rises with it.
[[nodiscard]] MirrorPlane fitMirrorPlane(const SegmentPixels& segment, const Vector3f& axis);

/// The plane z = the 80th percentile of the depth along the segment's outline, where its visible half ends. The
/// farthest point would double the depth of a box, the median would cut a sphere short.
[[nodiscard]] MirrorPlane parallelMirrorPlane(const SegmentPixels& segment);

}  // namespace core::analysis
