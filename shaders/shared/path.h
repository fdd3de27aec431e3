// SPDX-License-Identifier: GPL-3.0-or-later
// Scattering of a path at a surface, shared by the re-shading kernels and the reference renderer
// (core/shading/reference_renderer.h states the whole loop).
#ifndef PATINA_PATH_H
#define PATINA_PATH_H

#include "shaders/brdf/brdf.h"
#include "shaders/shared/drive.h"
#include "shaders/shared/sampling.h"

KERNEL_BEGIN

/// How one segment is shaded; an array of these is indexed by label.
struct SegmentShading {
    BrdfParams brdf;
    vec4 diffuse;  // rgb = albedo of the translucent body as other surfaces see it; w = 1: edited, else 0
    vec4 blend;    // x = weight of the new radiance, y = of the photograph, z = probability of the diffuse part at a
                   // hit, w = 1: paths continue here, 0: they end with the photograph's colour
    uvec4 drives;  // x = first of the segment's drives that paths follow, y = how many;
                   // z, w: those of the composite
};
KERNEL_BLOCK(SegmentShading, 176)

/// Four scalar parameters of which number `i` is replaced.
KERNEL_FN vec4 drive_replace(vec4 values, uint i, float value) {
    if (i == 0u) values.x = value;
    if (i == 1u) values.y = value;
    if (i == 2u) values.z = value;
    if (i == 3u) values.w = value;
    return values;
}

/// The shading of a pixel in which the drive's parameter has this value.
KERNEL_FN SegmentShading drive_apply(SegmentShading s, uint slot, vec3 value) {
    if (slot < 4u)
        s.brdf.values = drive_replace(s.brdf.values, slot, value.x);
    else if (slot < 8u)
        s.brdf.values2 = drive_replace(s.brdf.values2, slot - 4u, value.x);
    else if (slot < 12u)
        s.brdf.values3 = drive_replace(s.brdf.values3, slot - 8u, value.x);
    else if (slot == kDriveAlbedo)
        s.brdf.albedo = vec4(value, s.brdf.albedo.w);
    else if (slot == kDriveSpecular)
        s.brdf.specular = vec4(value, s.brdf.specular.w);
    else if (slot == kDriveEta)
        s.brdf.eta = vec4(value, s.brdf.eta.w);
    else if (slot == kDriveK)
        s.brdf.k = vec4(value, s.brdf.k.w);
    else if (slot == kDriveBlendNew)
        s.blend.x = value.x;
    else if (slot == kDriveBlendOriginal)
        s.blend.y = value.x;
    else if (slot == kDriveDiffuse)
        s.diffuse = vec4(value, s.diffuse.w);
    return s;
}

/// Role of a surface on a path.
const uint kPathPrimary = 0u;  // surface seen by the camera; its translucency is added elsewhere
const uint kPathLater = 1u;    // surface hit later: a translucent body is a Lambert surface of the same albedo
const uint kPathEnter = 2u;    // entry into a translucent body: cosine times Fresnel transmission

/// Density of path_scatter at `wi` [1/sr]; the rest of its integral to one is absorbed. Directions are in the
/// shading frame.
KERNEL_FN float path_pdf(SegmentShading s, uint role, vec3 wo, vec3 wi) {
    if (role == kPathEnter) return max(wi.z, 0.0f) * kInvPi;
    float p = role == kPathLater ? s.blend.z : 0.0f;
    float pdf = 0.0f;
    if (p < 1.0f) pdf = (1.0f - p) * brdf_pdf(s.brdf, wo, wi);
    return pdf + p * max(wi.z, 0.0f) * kInvPi;
}

/// Factor on the radiance from `wi` per solid angle, cosine included [1/sr]. `eta`: the boundary's relative index, for
/// kPathEnter.
KERNEL_FN vec3 path_value(SegmentShading s, uint role, float eta, vec3 wo, vec3 wi) {
    if (wi.z <= 0.0f) return vec3(0.0f);
    if (role == kPathEnter) return vec3(fresnel_transmission(eta, wi.z) * wi.z * kInvPi);
    vec3 f = brdf_eval(s.brdf, wo, wi);
    if (role == kPathLater && s.blend.z > 0.0f) f += rgb(s.diffuse) * kInvPi;
    return f * wi.z;
}

/// Samples the direction in which a path continues from a surface, by the surface's own lobes. Returns wi (wi.z <= 0:
/// absorbed) and the factor on what arrives from there, path_value / path_pdf.
KERNEL_FN vec3 path_scatter(SegmentShading s, uint role, float eta, vec3 wo, vec2 u, KERNEL_OUT(vec3) weight) {
    weight = vec3(0.0f);
    if (role == kPathEnter) {
        vec3 entering = sample_cosine_hemisphere(u);
        weight = vec3(fresnel_transmission(eta, entering.z));
        return entering;
    }
    float p = role == kPathLater ? s.blend.z : 0.0f;
    vec2 v = u;
    vec3 wi;
    if (u.x < p) {
        wi = sample_cosine_hemisphere(vec2(u.x / p, u.y));
    } else {
        if (p > 0.0f) v.x = min((u.x - p) / (1.0f - p), 0.99999994f);
        wi = brdf_sample(s.brdf, wo, v);
    }
    if (wi.z <= 0.0f) return wi;
    if (p <= 0.0f)
        weight = brdf_weight(s.brdf, wo, wi);
    else if (p >= 1.0f)
        weight = rgb(s.diffuse);
    else
        weight = path_value(s, role, eta, wo, wi) / path_pdf(s, role, wo, wi);
    return wi;
}

/// A direction in which a path may continue: by the surface's own sampling, or by the environment's.
struct PathCandidate {
    vec3 weight;          // path_value over the density of the candidate's own sampling
    float pdf;            // that density [1/sr]
    float otherPdf;       // density of the other sampling at this direction [1/sr]
    float expectedLight;  // luminance that may come from there
};

/// Minimum probability of the surface's own candidate: objects that it hits may be brighter than expected, and the
/// environment's candidate may be occluded.
const float kMinSurfaceChance = 0.25f;

/// Number of candidates that the surface's counts as in the balance heuristic; with one, lobes narrower than the lights
/// get noisier.
const float kSurfaceCandidates = 2.0f;

/// Chooses one of two candidates by what it may be expected to contribute, and returns the factor on what arrives from
/// it: the balance heuristic [VG95] for the sum over both, of which one is estimated. Zero weight: the path ends.
KERNEL_FN vec3 path_choose(PathCandidate surface, PathCandidate light, float u, KERNEL_OUT(uint) chosen) {
    vec3 a = vec3(0.0f);
    vec3 b = vec3(0.0f);
    if (surface.pdf > 0.0f)
        a = surface.weight * (kSurfaceCandidates * surface.pdf / (kSurfaceCandidates * surface.pdf + surface.otherPdf));
    if (light.pdf > 0.0f) b = light.weight * (light.pdf / (light.pdf + kSurfaceCandidates * light.otherPdf));
    float expectedA = luminance(a) * surface.expectedLight;
    float expectedB = luminance(b) * light.expectedLight;
    chosen = 0u;
    if (expectedB <= 0.0f) return a;
    float chance = expectedA / (expectedA + expectedB);
    if (expectedA > 0.0f) chance = max(chance, kMinSurfaceChance);
    if (u < chance) return a / chance;
    chosen = 1u;
    return b / (1.0f - chance);
}

/// True for a finite, non-negative colour; anything else is dropped and counted.
KERNEL_FN bool path_valid(vec3 c) {
    return c.x >= 0.0f && c.y >= 0.0f && c.z >= 0.0f && c.x < 3.0e38f && c.y < 3.0e38f && c.z < 3.0e38f;
}

KERNEL_END

#endif
