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
#include "shaders/lib/list.glsl"

struct MarchHit {
    bool found;
    bool back;       // entered through the back layer
    ivec2 pixel;
    float distance;  // along the ray [m]
};

const float kFar = 1.0e30;
const float kLeastStep = 1.0e-12;  // [px] per unit of s; across the view, or none

struct ImageRay {
    vec3 start;    // (u [px], v [px], w [1/m])
    vec3 step;     // per unit of s
    vec2 inverse;  // 1/step.xy, finite
    float begin;   // s where the ray enters the image; 0 when it starts over it
    float end;     // s where it leaves the image, the depths that occur, or space
};

// The part of the ray that can meet anything; empty (end < begin, or NaN) when there is none.
ImageRay imageRay(vec3 p, vec3 d) {
    ImageRay ray;
    float w = 1.0 / p.z;
    vec2 focal = geometry.camera.xy;
    ray.start = vec3(focal * p.xy * w + geometry.camera.zw, w);
    ray.step = vec3(focal * (d.xy - d.z * p.xy * w), -d.z * w);
    if (abs(ray.step.x) < kLeastStep) ray.step.x = kLeastStep;
    if (abs(ray.step.y) < kLeastStep) ray.step.y = kLeastStep;
    ray.inverse = 1.0 / ray.step.xy;
    ray.end = d.z > 0.0 ? 1.0 / d.z : kFar;
    if (ray.step.z > 0.0) ray.end = min(ray.end, (geometry.greatestW - w) / ray.step.z);
    if (ray.step.z < 0.0) ray.end = min(ray.end, (geometry.leastW - w) / ray.step.z);
    if (ray.step.z == 0.0 && (w > geometry.greatestW || w < geometry.leastW)) ray.end = -1.0;

    vec2 size = vec2(geometry.width, geometry.height);
    vec2 ahead = vec2(ray.step.x > 0.0 ? size.x : 0.0, ray.step.y > 0.0 ? size.y : 0.0);
    vec2 first = (size - ahead - ray.start.xy) * ray.inverse;
    vec2 last = (ahead - ray.start.xy) * ray.inverse;  // as `march` finds the edge of a cell
    ray.begin = max(0.0, max(first.x, first.y));
    ray.end = min(ray.end, min(last.x, last.y));
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

// Greatest of `least` and the least of the others, none of which is negative if it matters: such floats order as
// integers, which takes a third of the instructions where NaN needs them.
float nextStop(float least, vec2 exits, float end) {
    int stop = min(min(floatBitsToInt(exits.x), floatBitsToInt(exits.y)), floatBitsToInt(end));
    return intBitsToFloat(max(floatBitsToInt(least), stop));
}

// First solid the ray enters. `p` has z > 0, `d` is unit length. An origin inside a solid does not count until the ray
// has left it.
//
// The inner loop walks the hierarchy until the ray may touch the solid of a pixel, the outer one looks at that pixel
// (Aila and Laine 2009, "while-while"): where lanes run in lock step, all of them then do the same most of the time. What
// the inner loop does is counted in instructions; it reads one word of the pyramid and nothing else.
MarchHit march(vec3 p, vec3 d) {
    MarchHit hit = MarchHit(false, false, ivec2(0), 0.0);
    ImageRay ray = imageRay(p, d);
    bool going = p.z > 0.0 && ray.begin <= ray.end;

    // Read once; loads are not moved out of loops everywhere.
    ivec2 lastPixel = ivec2(geometry.width, geometry.height) - 1;
    int top = int(geometry.pyramidTop);
    int finest = int(geometry.pyramidFinest);
    uint rows = geometry.pyramidRows;
    uint blocks = geometry.pyramidBlocks;
    float scale = rangeScale(geometry.leastW, geometry.greatestW);
    float start = (ray.start.z - geometry.leastW) * scale + kRangeStart;  // in the pyramid's unit
    float slope = ray.step.z * scale;

    ivec2 pixel = clamp(ivec2(floor(ray.start.xy + ray.step.xy * ray.begin)), ivec2(0), lastPixel);
    ivec2 ahead = ivec2(ray.step.x > 0.0 ? 1 : 0, ray.step.y > 0.0 ? 1 : 0);
    int level = 0;
    float s = ray.begin;
    bool inside = ray.begin <= 0.0;  // escaping from the solid of the origin; the first pixel decides whether there is one

    // No ray needs more steps; one with broken numbers stops here.
    int budget = int(sliceValue(8u * (geometry.width + geometry.height) + 64u));
    while (going && budget > 0) {
        bool candidate = false;
        while (budget > 0) {
            --budget;
            ivec2 low = pixel & -(1 << level);
            ivec2 edge = low + (ahead << level);
            vec2 exits = (vec2(edge) - ray.start.xy) * ray.inverse;
            float next = nextStop(s, exits, ray.end);
            float before = start + slope * s;
            float after = start + slope * next;
            int stored = max(level, finest);
            uvec2 cell = uvec2(pixel >> stored);
            uint range = pyramid[pyramidIndex(cell.x, cell.y, uint(stored - finest), rows, blocks)];
            float least = float(range & 0xffffu);
            float greatest = float(range >> 16u);
            bool touches = (before >= least || after >= least) && (before <= greatest || after <= greatest);
            candidate = touches && level == 0;
            going = touches || next < ray.end;
            if (candidate || !going) break;

            // Truncated is as good as floored: it stays in its cell.
            ivec2 over = clamp(ivec2(ray.start.xy + ray.step.xy * next), low, min(low + ((1 << level) - 1), lastPixel));
            if (exits.x <= exits.y) over.x = edge.x + ahead.x - 1;
            if (exits.y <= exits.x) over.y = edge.y + ahead.y - 1;
            ivec2 moved = (pixel ^ over) >> level;
            int up = (moved.x | moved.y) > 1 && level < top ? 1 : 0;
            inside = inside && touches;
            level += touches ? -1 : up;
            pixel = touches ? pixel : over;
            s = touches ? s : next;
        }
        if (candidate) {
            ivec2 edge = pixel + ahead;
            vec2 exits = (vec2(edge) - ray.start.xy) * ray.inverse;
            float next = nextStop(s, exits, ray.end);
            float enter, leave;
            bool back;
            if (crossPixel(ray, pixel, s, next, enter, leave, back)) {
                if (!inside || enter > s) {
                    hit = MarchHit(true, back, pixel, rayDistance(p, d, enter));
                    going = false;
                }
                inside = leave >= next;
            } else {
                inside = false;
            }
            if (next >= ray.end) going = false;
            s = next;
            ivec2 over = pixel;
            if (exits.x <= exits.y) over.x = edge.x + ahead.x - 1;
            if (exits.y <= exits.x) over.y = edge.y + ahead.y - 1;
            ivec2 moved = pixel ^ over;
            if ((moved.x | moved.y) > 1 && top > 0) level = 1;
            pixel = over;
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
