// SPDX-License-Identifier: GPL-3.0-or-later
// Counter-based random numbers: a pure function of (pixel, sample, dimension, seed), the same bits in GLSL and C++, so
// that a picture does not depend on the order in which its samples are drawn.
#ifndef PATINA_RNG_H
#define PATINA_RNG_H

#include "shaders/shared/interop.h"

KERNEL_BEGIN

/// Four-dimensional PCG hash [JO20]: four well-mixed words from four counters.
KERNEL_FN uvec4 rng_hash(uvec4 v) {
    uint x = v.x * 1664525u + 1013904223u;
    uint y = v.y * 1664525u + 1013904223u;
    uint z = v.z * 1664525u + 1013904223u;
    uint w = v.w * 1664525u + 1013904223u;
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
    x ^= x >> 16;
    y ^= y >> 16;
    z ^= z >> 16;
    w ^= w >> 16;
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
    return uvec4(x, y, z, w);
}

/// The upper 24 bits as a float in [0, 1), exact in both languages.
KERNEL_FN float rng_to_float(uint bits) { return float(bits >> 8) * (1.0f / 16777216.0f); }

/// Uniform in [0, 1). Dimension d is word d mod 4 of the hash at d / 4.
KERNEL_FN float rng_float(uint pixel, uint sampleIndex, uint dimension, uint seed) {
    uvec4 h = rng_hash(uvec4(pixel, sampleIndex, dimension >> 2, seed));
    uint word = dimension & 3u;
    return rng_to_float(word == 0u ? h.x : word == 1u ? h.y : word == 2u ? h.z : h.w);
}

/// Dimensions (dimension, dimension + 1) with one hash; `dimension` must be even.
KERNEL_FN vec2 rng_vec2(uint pixel, uint sampleIndex, uint dimension, uint seed) {
    uvec4 h = rng_hash(uvec4(pixel, sampleIndex, dimension >> 2, seed));
    bool low = (dimension & 2u) == 0u;
    return vec2(rng_to_float(low ? h.x : h.z), rng_to_float(low ? h.y : h.w));
}

/// The same for the first decision of a path, where even spread pays most: successive samples of one pixel step through
/// the plane by the lattice of [Rob18] (powers of the plastic number), from a random start. Each number alone is
/// uniform, so means are unchanged and only noise is reduced.
KERNEL_FN vec2 rng_lattice(uint pixel, uint sampleIndex, uint dimension, uint seed) {
    uvec4 h = rng_hash(uvec4(pixel, 0xffffffffu, dimension, seed));
    return vec2(rng_to_float(h.x + sampleIndex * 3242174889u), rng_to_float(h.y + sampleIndex * 2447445414u));
}

/// Position in its pixel at which a path starts, in a lattice of its own (the square roots of 2 and 3).
KERNEL_FN vec2 rng_pixel(uint pixel, uint sampleIndex, uint seed) {
    uvec4 h = rng_hash(uvec4(pixel, 0xffffffffu, 0x40000000u, seed));
    return vec2(rng_to_float(h.x + sampleIndex * 1779033703u), rng_to_float(h.y + sampleIndex * 3144134277u));
}

/// Numbers for the light sampled at surface b of a path: xy its direction, z which candidate is taken. Those of the
/// first surface step through a lattice of their own.
KERNEL_FN vec3 rng_light(uint pixel, uint sampleIndex, uint b, uint seed) {
    uvec4 h = rng_hash(uvec4(pixel, b == 0u ? 0xffffffffu : sampleIndex, 0x80000000u + b, seed));
    uint step = b == 0u ? sampleIndex : 0u;
    return vec3(rng_to_float(h.x + step * 3242174889u), rng_to_float(h.y + step * 2447445414u),
                rng_to_float(h.z + step * 2654435769u));
}

/// Chooses which of the four pixels around hit number b of a path represents it.
KERNEL_FN vec2 rng_hit(uint pixel, uint sampleIndex, uint b, uint seed) {
    uvec4 h = rng_hash(uvec4(pixel, sampleIndex, 0xc0000000u + b, seed));
    return vec2(rng_to_float(h.x), rng_to_float(h.y));
}

/// Seed of a separate sequence (a segment's surface samples), unrelated to that of other streams and of the picture.
KERNEL_FN uint rng_stream(uint seed, uint stream) { return rng_hash(uvec4(seed, stream, 0x5bd1e995u, 0x9e3779b9u)).x; }

KERNEL_END

#endif
