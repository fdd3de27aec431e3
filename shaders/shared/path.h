// SPDX-License-Identifier: GPL-3.0-or-later
// What a path does at a surface, shared by the re-shading kernels and the reference renderer
// (core/reference_renderer.h states the whole loop).
#ifndef PATINA_PATH_H
#define PATINA_PATH_H

#include "shaders/brdf/brdf.h"
#include "shaders/shared/sampling.h"

KERNEL_BEGIN

/// How one segment is shaded; an array of these is indexed by label.
struct SegmentShading {
    BrdfParams brdf;
    vec4 diffuse;  // rgb = albedo of the translucent body as other surfaces see it; w = 1: edited, else 0
    vec4 blend;    // x = weight of the new radiance, y = of the photograph, z = probability of the diffuse part at a
                   // hit, w = 1: paths go on here, else they end with the photograph's colour
};
KERNEL_BLOCK(SegmentShading, 128)

/// Samples where a path goes on from a surface, in its shading frame. `primary`: the surface the camera sees, whose
/// translucency is added elsewhere; at later surfaces a translucent body is a Lambert one of the same albedo, chosen
/// with probability blend.z. Returns wi (wi.z <= 0: absorbed) and the factor on what arrives from there.
KERNEL_FN vec3 path_scatter(SegmentShading s, bool primary, vec3 wo, vec2 u, KERNEL_OUT(vec3) weight) {
    float p = primary ? 0.0f : s.blend.z;
    if (u.x < p) {
        weight = rgb(s.diffuse) / p;
        return sample_cosine_hemisphere(vec2(u.x / p, u.y));
    }
    vec2 v = u;
    if (p > 0.0f) v.x = min((u.x - p) / (1.0f - p), 0.99999994f);
    vec3 wi = brdf_sample(s.brdf, wo, v);
    weight = vec3(0.0f);
    if (wi.z > 0.0f) weight = brdf_weight(s.brdf, wo, wi) / (1.0f - p);
    return wi;
}

/// True for a finite, non-negative colour; anything else is dropped and counted.
KERNEL_FN bool path_valid(vec3 c) {
    return c.x >= 0.0f && c.y >= 0.0f && c.z >= 0.0f && c.x < 3.0e38f && c.y < 3.0e38f && c.z < 3.0e38f;
}

KERNEL_END

#endif
