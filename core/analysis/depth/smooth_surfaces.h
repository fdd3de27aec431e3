// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <numbers>
#include <span>
#include <vector>

#include "core/analysis/depth/depth_noise.h"
#include "core/base/camera.h"
#include "core/base/image.h"
#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace core::analysis {

/// How far the surface of one segment is smoothed.
struct SurfaceSmoothing {
    std::uint16_t label = 0;
    float length = 0;       ///< [px] plate length: halves bumps and dents π times as wide, removes narrower ones
    float noise = 0;        ///< [1/m] σ of inverse depth; 0 = unknown, then `length` applies to the whole segment
    float correlation = 1;  ///< [px] pixels farther apart than this err independently
    float depthSampleSpacing = 1;  ///< [px] as in Photo
    bool rounded = false;          ///< the noise is rounding: errors can have one sign over any distance

    /// Width of the bump, half a wave, that a weak plate halves, over the plate's length L: 1 / (1 + (2πL/λ)⁴) is left.
    static constexpr float kBumpOverLength = std::numbers::pi_v<float>;
};

/// The smoothing of every segment with depth: the user's bump width, at most half of the segment's width, or what the
/// noise requires, at most an eighth of it.
[[nodiscard]] std::vector<SurfaceSmoothing> chooseSmoothing(const ImageF& depth, const Scene& scene,
                                                            const DepthNoise& noise);

/// Width of the bumps [px] that are smoothed away, by label.
[[nodiscard]] std::map<std::uint16_t, float> bumpWidths(std::span<const SurfaceSmoothing> segments);

/// Expected time of `smoothSurfaces` [ns on two cores].
[[nodiscard]] double expectedSmoothingTime(const ImageF& depth, const LabelImage& labels,
                                           std::span<const SurfaceSmoothing> segments);

/// Replaces the depth of segments, which `filterDepth` has freed of noise from pixel to pixel, by weak plates [BZ87]:
/// the inverse depth that bends least while following the measured one. A mirror shows every error of slope; the plate
/// has none that is narrower than `length`. Where measurements are off to one side by more than their noise allows,
/// there is relief, and the length shrinks to what shows it, but not below the correlation of the noise. In rounded
/// maps distant outliers lose their weight. The plate may fold where the surface turns by more than about twenty
/// degrees within the length, and break where depth jumps (weights of Geman and McClure, updated six times). Planes
/// and slopes at the outline are preserved; segments do not influence each other. The plate spans what is not
/// `measured` (0). Solved from coarse to fine; time per pixel does not grow with the length. The result is the same on
/// any number of threads. Cancellable.
void smoothSurfaces(ImageF& depth, const Image<std::uint8_t>& measured, const LabelImage& labels, const Camera& camera,
                    std::span<const SurfaceSmoothing> segments, const Progress& progress);

}  // namespace core::analysis
