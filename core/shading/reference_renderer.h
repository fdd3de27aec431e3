// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/base/progress.h"
#include "core/geometry/depth_layers.h"
#include "core/geometry/march.h"
#include "core/material/diffusion_profile.h"
#include "core/scene/scene.h"
#include "core/shading/drive_table.h"
#include "core/shading/environment_sampler.h"
#include "core/shading/image_filter.h"
#include "core/shading/surface_samples.h"
#include "shaders/shared/path.h"

namespace core {

// The path loop, in words; kernels follow it step by step and draw the same random numbers.
//
// Inputs: layers (marched), colour and normal of both layers, environment, SegmentShading per label, N = bounces, seed.
// radiance(pixel id, sample s, stream seed; start: point p, unit normal n, direction to the viewer wo, shading S):
//
//   T = 1, L = 0
//   for b = 0 .. N-1:
//     n  = shading_normal(n, wo)                                   (tilts normals that face away from wo)
//     u  = b == 0 ? rng_lattice(pixel id, s, 0, seed) : rng_vec2(pixel id, s, 2b, seed)
//     wi = path_scatter(S, role, to_local(n, wo), u, weight);  d = normalize(from_local(n, wi))
//     where the environment is sampled (EnvironmentSampler not empty):
//       w = rng_light(pixel id, s, b, seed);  d' = EnvironmentSampler::sample(w.x, w.y)
//       (d, weight) = path_choose of d and d' by w.z; one ray is marched, so that a surface met by either counts
//     T *= weight;                                                 if T == 0: end
//     o  = p + n · marchBias(camera, p.z)
//     march(o, d);  miss: L += T · environment(d), end             (no environment: black)
//     q  = shownPixel of the hit by rng_hit(pixel id, s, b, seed): one of the four pixels around it
//     c  = colour of q, of the layer that was entered;  S = shading[label of q], with that pixel's values of driven
//          parameters (shaders/shared/drive.h)
//     if S.blend.w == 0 or b == N-1 or the layer's normal there is zero: L += T · c, end
//     L += T · S.blend.y · c;  T *= S.blend.x
//     p  = o + d · distance;  n = the layer's normal at q;  wo = -d
//
// The picture: pixel id = y · width + x, seed = RenderParams::seed, start at the pixel's front position and normal with
// wo = -p/|p|, in every pixel of an edited segment with valid depth; the mean over s is the re-shaded radiance. Pixels
// whose sample is not finite (path_valid) drop it: a sum of zero counted as dropped.
//
// Surface samples: sampleSurface(seed) draws its positions with rng_stream(seed, 2l).
//
// Irradiance of surface sample i of label l: pixel id = i, seed = rng_stream(seed, 2l+1), ray j is s = j; the same
// loop with the role kPathEnter at b = 0: cosine-weighted directions, weight F_t(wi.z). Ê = (π/N_rays) Σ radiance.
//
// Translucent radiance before the outgoing Fresnel factor: B(p) = (1/π) Σ_i A_i Ê_i R_d(|p − s_i|²) / max(1, Σ_i A_i
// R_d) with A_i of sampleAreas (Ã/|S| on average) and the profile blurred to Ã/|S| (kernels sum by grids,
// core/shading/diffusion_grid.h). R_d is a half space's: summed over a thin or folded body it would reflect more than
// it receives, and the quotient takes that away. L_t = F_t(max(n·wo, 0)) · B with n = shading_normal(n, wo).
//
// Composite, edited segments only, driven weights of the pixel: blendNew · (reshaded + weight · L_t) + blendOriginal ·
// photo. Then the pixels that show a segment in part, at its outline and up to two pixels outside
// (core/shading/silhouette.h). All other pixels are the photograph's, bit for bit.

/// CPU twin and oracle of the GPU renderer: slow, exact marching, plain sums in double. Works on its own copy of the
/// scene's values; the analysis must hold front and back (layers are built from them when it has none).
class ReferenceRenderer {
  public:
    ReferenceRenderer(const Scene& scene, std::shared_ptr<const Analysis> analysis,
                      LightSampling lightSampling = LightSampling::Both);

    /// One path through pixel (x, y); zero where nothing is re-shaded.
    [[nodiscard]] Vector3f pathRadiance(int x, int y, std::uint32_t sample) const;

    /// `samples` paths per re-shaded pixel, numbered from `first`.
    [[nodiscard]] Accumulation reshade(int samples, std::uint32_t first = 0, const Progress& progress = {}) const;

    /// Ê of every surface sample of `label` [radiance · sr], `rays` rays each.
    [[nodiscard]] std::vector<Vector3f> irradiance(const SurfaceSamples& samples, std::uint16_t label, float eta,
                                                   int rays, const Progress& progress = {}) const;

    /// B of every pixel of `label` (see above), zero elsewhere; brute force.
    [[nodiscard]] ImageRgb translucentRadiosity(const SurfaceSamples& samples, const std::vector<Vector3f>& irradiance,
                                                std::uint16_t label, const DiffusionProfile& profile,
                                                const Progress& progress = {}) const;

    /// L_t of every translucent segment, with the scene's sample counts; the material's weight is not applied.
    [[nodiscard]] ImageRgb translucency(const Progress& progress = {}) const;

    /// The edited photograph from mean re-shaded and translucent radiance.
    [[nodiscard]] ImageRgb composite(const ImageRgb& reshaded, const ImageRgb& translucent) const;

    [[nodiscard]] const std::vector<kernel::SegmentShading>& shading() const { return shading_; }

  private:
    struct Vertex;
    struct Path;
    [[nodiscard]] Vector3f follow(Vertex vertex, const Path& path) const;
    [[nodiscard]] kernel::vec3 leave(const Vertex& vertex, const Path& path, std::uint32_t b,
                                     kernel::vec3& direction) const;
    [[nodiscard]] Vector3f environment(kernel::vec3 direction) const;
    /// The pixel whose colour and normal stand for a hit at `p`: one of the four around it, by chance as often as
    /// bilinear interpolation would weigh it, where the surface goes on there.
    [[nodiscard]] Eigen::Vector2i shownPixel(const MarchHit& hit, kernel::vec3 p, kernel::vec2 u) const;
    /// Of the front layer at `offset` [px] from a pixel's centre, not of unit length.
    [[nodiscard]] kernel::vec3 normalAt(int x, int y, kernel::vec2 offset) const;
    [[nodiscard]] const kernel::SegmentShading& shadingOf(std::uint16_t label) const;
    /// With the values of driven parameters in that pixel.
    [[nodiscard]] kernel::SegmentShading shadingAt(int x, int y) const;
    [[nodiscard]] kernel::vec3 driven(kernel::uint drive, int x, int y) const;
    /// A weight of the composite in that pixel.
    [[nodiscard]] float weightAt(float weight, kernel::uint slot, int x, int y) const;

    Scene scene_;
    std::shared_ptr<const Analysis> analysis_;
    std::shared_ptr<const DepthLayers> layers_;
    std::vector<kernel::SegmentShading> shading_;
    DriveTable drives_;
    std::vector<float> driveValues_;
    EnvironmentSampler sampler_;
};

/// Everything: re-shades, scatters, filters (when the scene asks for it) and composites.
[[nodiscard]] ImageRgb renderReference(const Scene& scene, const std::shared_ptr<const Analysis>& analysis,
                                       const Progress& progress = {});

}  // namespace core
