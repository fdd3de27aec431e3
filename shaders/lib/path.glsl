// SPDX-License-Identifier: GPL-3.0-or-later
// The path loop, twin of core/shading/reference_renderer.h. The includer declares `SegmentShading shading[]`,
// `Drive drives[]` and `float driveValues[]`.
#ifndef PATINA_PATH_GLSL
#define PATINA_PATH_GLSL

#include "shaders/lib/drives.glsl"
#include "shaders/lib/list.glsl"
#include "shaders/lib/march.glsl"
#include "shaders/shared/path.h"
#include "shaders/shared/rng.h"
#include "shaders/shared/shading_point.h"

// 1 if any segment has drives; otherwise their code is not compiled.
layout(constant_id = 1) const uint kDriven = 1u;

// A surface point on a path.
struct PathVertex {
    vec3 p;       // [m]
    vec3 n;       // shading normal, dot(n, wo) > 0
    vec3 wo;
    uint label;
    ivec2 pixel;  // pixel that shows it; unused for kPathEnter
    uint role;    // kPath... of shaders/shared/path.h
    float eta;    // relative index of the boundary, for kPathEnter
};

// Counters that a path's random numbers are a function of.
struct PathId {
    uint pixel;
    uint sampleIndex;
    uint seed;
};

// Distance a ray's origin is lifted off the surface, core::marchBias.
float marchBias(float z) { return z / (geometry.camera.x + geometry.camera.y); }

// How a segment is shaded in one pixel.
SegmentShading shadingAt(uint label, ivec2 pixel) {
    SegmentShading s = shading[label];
    if (kDriven != 0u)
        for (uint i = 0u; i < s.drives.y; ++i)
            s = drive_apply(s, drives[s.drives.x + i].slot, driveAt(s.drives.x + i, pixel));
    return s;
}

// Samples the direction in which the path continues from surface b; returns the factor on the radiance from there.
// light: rgb = the environment in that direction, w < 0 = not looked up.
vec3 leave(PathVertex v, PathId id, uint b, out vec3 direction, out vec4 light) {
    vec3 wo = to_local(v.n, v.wo);
    vec2 u = b == 0u ? rng_lattice(id.pixel, id.sampleIndex, 0u, id.seed)
                     : rng_vec2(id.pixel, id.sampleIndex, 2u * b, id.seed);
    SegmentShading s = shading[v.label];
    if (kDriven != 0u && v.role != kPathEnter) s = shadingAt(v.label, v.pixel);
    vec3 weight;
    vec3 wi = path_scatter(s, v.role, v.eta, wo, u, weight);
    direction = normalize(from_local(v.n, wi));
    light = vec4(0.0, 0.0, 0.0, -1.0);
    if (sliceValue(geometry.environmentSampled) == 0u) return weight;

    vec3 w = rng_light(id.pixel, id.sampleIndex, b, id.seed);
    vec4 found = sampleEnvironment(w.xy);
    vec3 towards = to_local(v.n, found.xyz);
    vec4 seen = environmentLight(found.xyz);
    light = environmentLight(direction);
    PathCandidate own = PathCandidate(weight, 0.0, light.w, luminance(light.rgb) + geometry.meanLuminance);
    if (wi.z > 0.0) own.pdf = path_pdf(s, v.role, wo, wi);
    PathCandidate bright = PathCandidate(vec3(0.0), 0.0, 0.0, luminance(seen.rgb) + geometry.meanLuminance);
    if (towards.z > 0.0 && found.w > 0.0) {
        bright.weight = path_value(s, v.role, v.eta, wo, towards) / found.w;
        bright.pdf = found.w;
        bright.otherPdf = path_pdf(s, v.role, wo, towards);
    }
    uint chosen;
    weight = path_choose(own, bright, w.z, chosen);
    if (chosen == 1u) {
        direction = found.xyz;
        light = seen;
    }
    light.w = 1.0;
    return weight;
}

// The pixel whose colour and normal represent a hit at p: one of the four around it where the surface continues, chosen
// with the probability that bilinear interpolation would weight it by.
ivec2 shownPixel(MarchHit hit, vec3 p, vec2 u) {
    vec2 uv = geometry.camera.xy * p.xy / p.z + geometry.camera.zw;
    ivec2 q = clamp(ivec2(floor(uv + u - 0.5)), ivec2(0), ivec2(geometry.width, geometry.height) - 1);
    q = clamp(q, hit.pixel - 1, hit.pixel + 1);
    vec4 own = texelFetch(frontPatchMap, hit.pixel, 0);
    vec4 next = texelFetch(frontPatchMap, q, 0);
    bool same = next.w == own.w;
    if (hit.back) {
        own = texelFetch(backPatchMap, hit.pixel, 0);
        next = texelFetch(backPatchMap, q, 0);
    }
    return same && surface_goes_on(own.xyz, next.xyz, vec2(q - hit.pixel)) ? q : hit.pixel;
}

// Radiance leaving `v` towards v.wo along one path of up to `bounces` surfaces.
vec3 pathRadiance(PathVertex v, PathId id, uint bounces) {
    vec3 radiance = vec3(0.0);
    vec3 throughput = vec3(1.0);
    for (uint b = 0u; b < bounces; ++b) {
        vec3 direction;
        vec4 light;
        throughput *= leave(v, id, b, direction, light);
        if (max(throughput.x, max(throughput.y, throughput.z)) == 0.0) break;
        vec3 origin = v.p + v.n * marchBias(v.p.z);
        MarchHit hit = march(origin, direction);
        if (!hit.found) {
            if (light.w < 0.0) light.rgb = environmentRadiance(direction);
            radiance += throughput * light.rgb;
            break;
        }
        v.p = origin + direction * hit.distance;
        v.pixel = shownPixel(hit, v.p, rng_hit(id.pixel, id.sampleIndex, b, id.seed));
        vec3 color = hit.back ? texelFetch(backColorMap, v.pixel, 0).rgb : texelFetch(frontColorMap, v.pixel, 0).rgb;
        vec3 normal = hit.back ? texelFetch(backNormalMap, v.pixel, 0).xyz : texelFetch(frontNormalMap, v.pixel, 0).xyz;
        v.label = uint(texelFetch(frontPatchMap, v.pixel, 0).w);
        vec4 blend = shading[v.label].blend;
        if (kDriven != 0u && blend.w != 0.0) blend = shadingAt(v.label, v.pixel).blend;
        if (blend.w == 0.0 || b + 1u >= bounces || dot(normal, normal) == 0.0) {
            radiance += throughput * color;
            break;
        }
        radiance += throughput * color * blend.y;
        throughput *= blend.x;
        v.wo = -direction;
        v.n = shading_normal(normal, v.wo);
        v.role = kPathLater;
    }
    return radiance;
}

#endif
