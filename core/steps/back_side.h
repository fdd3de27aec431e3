// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/steps/step.h"

namespace core::steps {

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

/// Moves the plane along `axis`, from the farthest point towards the nearest, by bisection to where E = max(C, O) is
/// least: C = fraction of points behind the plane (falls with the offset), O = fraction of the mirror images of the
/// others that project outside the segment's silhouette (rises with it). An image that falls behind another thing, one
/// nearer than the original point and no support, is not seen and does not count as outside.
[[nodiscard]] MirrorPlane fitMirrorPlane(const Camera& camera, const LabelImage& labels, const ImageF& depth,
                                         const std::vector<bool>& supports, std::uint16_t label,
                                         std::span<const Vector3f> points, const Vector3f& axis);

/// For every label, whether the segment is what things stand on or in front of (a table, a wall) rather than a thing:
/// it runs out of the picture on opposite sides with at least a tenth of its outline, or with two fifths of it on any
/// side. Nothing is known of its far end, so a mirror plane means nothing; it becomes a slab as thick as its `offset`.
[[nodiscard]] std::vector<bool> findSupports(const LabelImage& labels);

/// Invents the back of everything with valid depth: z_back ≥ z_front + minThickness in every pixel.
/// - Offset: the front, moved back by `offset` along the ray of its pixel.
/// - ParallelMirror: the plane z = the 80th percentile of the depth along the segment's outline, where its visible half
///   ends: the farthest point would double the depth of a box, the median cuts a sphere short.
/// - PcaMirror: `mirrorAxis`, `fitMirrorPlane`.
/// Mirror images keep normals and colours of their originals; what the image does not cover is closed smoothly from
/// what it does. A mirror that cannot be made (few points, no axis, E > 0.6, an image covering less than a fifth) falls
/// back to Offset and says so. Pixels without a label are solids of a tenth of their distance. `userDepth`, where given
/// and positive, replaces all of this.
[[nodiscard]] BackLayer inventBackSide(const Camera& camera, const LabelImage& labels, const Surface& front,
                                       std::span<const Segment> segments, const ImageF* userDepth, float relativeNoise,
                                       const StepContext& context);

}  // namespace core::steps
