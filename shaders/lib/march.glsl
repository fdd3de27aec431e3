// SPDX-License-Identifier: GPL-3.0-or-later
// Ray marching in the two-layer depth image (DESIGN 3.5, core/depth_layers.h).
//
// Everything happens in (u, v, w) with w = 1/z, where rays stay straight lines and surface patches stay planes. With
// s = t / (p.z + t d.z) the ray p + t d becomes start + s step: linear in s. Each pixel is a solid between its back and
// its front patch, and the crossing inside a pixel is a linear equation, so there is no step size. A pyramid cell whose
// range of w the ray does not touch is skipped as a whole (Tevs et al. 2008, "Maximum mipmaps").
//
// A kernel may define MARCH_WITHOUT before it includes this: pixels with that label count as empty.
#ifndef PATINA_MARCH_GLSL
#define PATINA_MARCH_GLSL

#include "shaders/lib/geometry.glsl"

struct MarchHit {
    bool found;
    bool back;       // entered through the back layer
    ivec2 pixel;
    float distance;  // along the ray [m]
};

const float kFar = 1.0e30;

struct ImageRay {
    vec3 start;   // (u [px], v [px], w [1/m])
    vec3 step;    // per unit of s
    float begin;  // s where the ray enters the image; 0 when it starts over it
    float end;    // s where it leaves the image, the depths that occur, or space
};

// The part of the ray that can meet anything; empty (end < begin, or NaN) when there is none.
ImageRay imageRay(vec3 p, vec3 d) {
    ImageRay ray;
    float w = 1.0 / p.z;
    vec2 focal = geometry.camera.xy;
    ray.start = vec3(focal * p.xy * w + geometry.camera.zw, w);
    ray.step = vec3(focal * (d.xy - d.z * p.xy * w), -d.z * w);
    ray.begin = 0.0;
    ray.end = d.z > 0.0 ? 1.0 / d.z : kFar;

    uint rootIndex = 0u;
    for (uint level = 1u; level < geometry.levelCount; ++level)
        rootIndex += ((geometry.width + (1u << level) - 1u) >> level) * ((geometry.height + (1u << level) - 1u) >> level);
    vec2 root = pyramid[rootIndex];
    if (ray.step.z > 0.0) ray.end = min(ray.end, (root.y - w) / ray.step.z);
    if (ray.step.z < 0.0) ray.end = min(ray.end, (root.x - w) / ray.step.z);
    if (ray.step.z == 0.0 && (w > root.y || w < root.x)) ray.end = -1.0;

    vec2 size = vec2(geometry.width, geometry.height);
    for (int axis = 0; axis < 2; ++axis) {
        if (ray.step[axis] == 0.0) {
            if (!(ray.start[axis] >= 0.0 && ray.start[axis] < size[axis])) ray.end = -1.0;
        } else {
            float a = -ray.start[axis] / ray.step[axis];
            float b = (size[axis] - ray.start[axis]) / ray.step[axis];
            ray.begin = max(ray.begin, min(a, b));
            ray.end = min(ray.end, max(a, b));
        }
    }
    return ray;
}

// Distance [m] along the ray of parameter s.
float rayDistance(vec3 p, vec3 d, float s) { return s * p.z / max(1.0 - s * d.z, 1.0e-20); }

// Solid of one pixel against the piece [s0, s1] of a ray inside that pixel: the parameters where it enters and leaves,
// and whether it enters through the back patch. False when it does not touch the solid. A side wall belongs to the
// nearer layer.
bool crossPixel(ImageRay ray, ivec2 pixel, float s0, float s1, out float enter, out float leave, out bool back) {
    enter = s0;
    leave = s1;
    back = false;
    vec4 frontPatch = texelFetch(frontPatchMap, pixel, 0);
    if (!(frontPatch.x > 0.0)) return false;
#ifdef MARCH_WITHOUT
    if (frontPatch.w == MARCH_WITHOUT) return false;
#endif
    vec4 backPatch = texelFetch(backPatchMap, pixel, 0);
    vec3 a = ray.start + ray.step * s0;
    vec3 b = ray.start + ray.step * s1;
    vec2 center = vec2(pixel) + 0.5;
    // Signed room below the front patch and above the back patch; the solid is where both are >= 0.
    float front0 = (frontPatch.x + dot(frontPatch.yz, a.xy - center)) - a.z;
    float front1 = (frontPatch.x + dot(frontPatch.yz, b.xy - center)) - b.z;
    float back0 = a.z - (backPatch.x + dot(backPatch.yz, a.xy - center));
    float back1 = b.z - (backPatch.x + dot(backPatch.yz, b.xy - center));
    if ((front0 < 0.0 && front1 < 0.0) || (back0 < 0.0 && back1 < 0.0)) return false;
    float lo = 0.0;
    float hi = 1.0;
    if (front0 < 0.0) lo = front0 / (front0 - front1);
    if (front1 < 0.0) hi = front0 / (front0 - front1);
    if (back0 < 0.0) {
        float root = back0 / (back0 - back1);
        if (root > lo) {
            lo = root;
            back = true;
        }
    }
    if (back1 < 0.0) hi = min(hi, back0 / (back0 - back1));
    if (!(lo <= hi)) return false;
    if (lo <= 0.0) back = front0 > back0;
    enter = lo > 0.0 ? s0 + (s1 - s0) * lo : s0;
    leave = hi < 1.0 ? s0 + (s1 - s0) * hi : s1;
    return true;
}

// First solid the ray enters. `p` has z > 0, `d` is unit length. An origin inside a solid does not count until the ray
// has left it.
MarchHit march(vec3 p, vec3 d) {
    MarchHit hit = MarchHit(false, false, ivec2(0), 0.0);
    if (!(p.z > 0.0)) return hit;
    ImageRay ray = imageRay(p, d);
    if (!(ray.begin <= ray.end)) return hit;

    uvec2 size = uvec2(geometry.width, geometry.height);
    int level = 0;
    uint offset = 0u;  // of the level in the pyramid, for level > 0
    ivec2 cell = clamp(ivec2(floor(ray.start.xy + ray.step.xy * ray.begin)), ivec2(0), ivec2(size) - 1);
    ivec2 direction = ivec2(ray.step.x > 0.0 ? 1 : -1, ray.step.y > 0.0 ? 1 : -1);
    vec2 inverse = vec2(ray.step.x != 0.0 ? 1.0 / ray.step.x : 0.0, ray.step.y != 0.0 ? 1.0 / ray.step.y : 0.0);
    float s = ray.begin;
    bool inside = ray.begin <= 0.0;  // escaping from the solid of the origin; the first pixel decides whether there is one

    int budget = 8 * int(size.x + size.y) + 64;  // no ray needs more; one with broken numbers stops here
    for (int i = 0; i < budget; ++i) {
        float cellSize = float(1 << level);
        vec2 edge = (vec2(cell) + vec2(max(direction, ivec2(0)))) * cellSize;
        vec2 exits = vec2(ray.step.x != 0.0 ? (edge.x - ray.start.x) * inverse.x : kFar,
                          ray.step.y != 0.0 ? (edge.y - ray.start.y) * inverse.y : kFar);
        float next = max(s, min(min(exits.x, exits.y), ray.end));

        if (level > 0) {
            uint levelWidth = (size.x + (1u << level) - 1u) >> level;
            vec2 range = pyramid[offset + uint(cell.y) * levelWidth + uint(cell.x)];
            float w0 = ray.start.z + ray.step.z * s;
            float w1 = ray.start.z + ray.step.z * next;
            if (max(w0, w1) >= range.x && min(w0, w1) <= range.y) {
                --level;
                vec2 middle = (vec2(cell) + 0.5) * cellSize;
                vec2 position = ray.start.xy + ray.step.xy * s;
                ivec2 levelSize = ivec2((size + (1u << level) - 1u) >> level);
                if (level > 0) offset -= uint(levelSize.x * levelSize.y);
                cell = min(2 * cell + ivec2(greaterThanEqual(position, middle)), levelSize - 1);
                continue;
            }
            inside = false;
        } else {
            float enter, leave;
            bool back;
            if (crossPixel(ray, cell, s, next, enter, leave, back)) {
                if (inside && enter > s) inside = false;
                if (!inside) {
                    hit.found = true;
                    hit.back = back;
                    hit.pixel = cell;
                    hit.distance = rayDistance(p, d, enter);
                    return hit;
                }
                inside = leave >= next;
            } else {
                inside = false;
            }
        }

        if (next >= ray.end) return hit;
        s = next;
        ivec2 before = cell;
        if (exits.x <= exits.y) cell.x += direction.x;
        if (exits.y <= exits.x) cell.y += direction.y;
        ivec2 levelSize = ivec2((size + (1u << level) - 1u) >> level);
        if (any(lessThan(cell, ivec2(0))) || any(greaterThanEqual(cell, levelSize))) return hit;
        if (level < int(geometry.levelCount) && (before >> 1) != (cell >> 1)) {
            if (level > 0) offset += uint(levelSize.x * levelSize.y);
            ++level;
            cell >>= 1;
        }
    }
    return hit;
}

// The baseline of [BRD14] Sec. 3.5: constant steps of `stepSize` [m]; steps over what is thinner.
MarchHit marchConstant(vec3 p, vec3 d, float stepSize, float maxDistance) {
    MarchHit hit = MarchHit(false, false, ivec2(0), 0.0);
    bool inside = true;
    for (float t = 0.0; t <= maxDistance; t += stepSize) {
        vec3 q = p + d * t;
        if (!(q.z > 0.0)) return hit;
        vec2 uv = geometry.camera.xy * q.xy / q.z + geometry.camera.zw;
        if (any(lessThan(uv, vec2(0.0))) || any(greaterThanEqual(uv, vec2(geometry.width, geometry.height)))) return hit;
        ivec2 pixel = ivec2(uv);
        vec4 frontPatch = texelFetch(frontPatchMap, pixel, 0);
        float w = 1.0 / q.z;
        bool solid = false;
        if (frontPatch.x > 0.0) {
            vec4 backPatch = texelFetch(backPatchMap, pixel, 0);
            vec2 offset = uv - vec2(pixel) - 0.5;
            float room = frontPatch.x + dot(frontPatch.yz, offset) - w;
            float depth = w - backPatch.x - dot(backPatch.yz, offset);
            solid = room >= 0.0 && depth >= 0.0;
            if (solid && !inside) return MarchHit(true, depth < room, pixel, t);
        }
        inside = inside && solid;
    }
    return hit;
}

#endif
