// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/directional_map.h"
#include "core/base/image.h"
#include "core/geometry/surface.h"
#include "core/scene/scene.h"

namespace core {

struct DepthLayers;

/// What was found out about one glossy segment (docs/method.md#reflectance).
struct Reflectance {
    std::uint16_t label = 0;
    Vector3f rho{1, 1, 1};       ///< reflected over incident, per channel; the value in use (the user's, when given)
    bool reliable = false;       ///< false: too few directions known by both maps, rho is clamped or a default
    float commonSolidAngle = 0;  ///< solid angle known by both maps [sr]
    float alpha = 0.05f;         ///< GGX width of the lobe, (0, 1]; the value in use (the user's, when given)
    bool alphaReliable = false;  ///< false: nothing sharp enough was reflected to tell, alpha is a default
    DirectionalMap reflected;    ///< L_S
    DirectionalMap incident;     ///< L_G
};

/// How the back of one segment was made (docs/method.md#back-side).
struct BackSideInfo {
    std::uint16_t label = 0;
    BackSideMethod used = BackSideMethod::Offset;  ///< Automatic's choice, or what replaced a method that failed
    Message note;  ///< why another method was used than the segment asks for; empty when none was
    /// The method's own penalty, [0, 1]. Mirrors: E = max(C, O); C = fraction of points behind the mirror, O = fraction
    /// mirrored outside the silhouette. FlatFaces: what of outline and front the faces do not explain. 0 for Offset.
    float mirrorError = 0;
    bool onSupport = false;  ///< a support's plane was found, through which the back does not reach
};

/// Result of the analysis: stages 3.1 to 3.4. Parts are shared, so that a change recomputes only what it invalidates.
struct Analysis {
    /// Width of the bumps that were smoothed away [px], by the segment's label: the user's, or what the noise asks for.
    /// Empty without the depth filter.
    std::map<std::uint16_t, float> smoothing;
    std::shared_ptr<const Surface> front;
    std::shared_ptr<const Surface> back;
    std::shared_ptr<const DepthLayers> layers;  ///< front and back as rays see them (core/geometry/depth_layers.h)
    std::vector<BackSideInfo> backSides;        ///< one per segment that has pixels, in label order
    std::vector<std::shared_ptr<const Reflectance>> reflectances;  ///< one per glossy segment, in label order
    std::shared_ptr<const DirectionalMap> environment;
    /// Texture of the segments with a drive by luminance: the photograph's luminance over that of the shading, mean 1
    /// per segment, 1 elsewhere; nullptr when no segment has such a drive.
    std::shared_ptr<const ImageF> textureDetail;

    [[nodiscard]] const Reflectance* findReflectance(std::uint16_t label) const;
};

}  // namespace core
