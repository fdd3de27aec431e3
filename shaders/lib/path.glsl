// SPDX-License-Identifier: GPL-3.0-or-later
// The path loop, twin of core/reference_renderer.h. The includer declares `SegmentShading shading[]`.
#ifndef PATINA_PATH_GLSL
#define PATINA_PATH_GLSL

#include "shaders/lib/march.glsl"
#include "shaders/shared/path.h"
#include "shaders/shared/rng.h"

// Distance a ray's origin is lifted off the surface, core::marchBias.
float marchBias(float z) { return z / (geometry.camera.x + geometry.camera.y); }

// Radiance that arrives at (p, n) from `direction`, times `throughput`; the path goes on up to `bounces` surfaces.
vec3 followPath(vec3 p, vec3 n, vec3 throughput, vec3 direction, uint pixel, uint sampleIndex, uint seed, uint bounces) {
    vec3 radiance = vec3(0.0);
    for (uint b = 1u;; ++b) {
        if (max(throughput.x, max(throughput.y, throughput.z)) == 0.0) return radiance;
        vec3 origin = p + n * marchBias(p.z);
        MarchHit hit = march(origin, direction);
        if (!hit.found) return radiance + throughput * environmentRadiance(direction);

        vec3 color = hit.back ? texelFetch(backColorMap, hit.pixel, 0).rgb : texelFetch(frontColorMap, hit.pixel, 0).rgb;
        vec3 normal = hit.back ? texelFetch(backNormalMap, hit.pixel, 0).xyz : texelFetch(frontNormalMap, hit.pixel, 0).xyz;
        uint label = uint(texelFetch(frontPatchMap, hit.pixel, 0).w);
        vec4 blend = shading[label].blend;
        if (blend.w == 0.0 || b >= bounces || dot(normal, normal) == 0.0) return radiance + throughput * color;
        radiance += throughput * color * blend.y;
        throughput *= blend.x;
        p = origin + direction * hit.distance;
        vec3 wo = -direction;
        n = shading_normal(normal, wo);

        vec3 weight;
        vec3 wi = path_scatter(shading[label], false, to_local(n, wo), rng_vec2(pixel, sampleIndex, 2u * b, seed), weight);
        if (wi.z <= 0.0) return radiance;
        throughput *= weight;
        direction = normalize(from_local(n, wi));
    }
}

#endif
