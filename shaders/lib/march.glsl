// SPDX-License-Identifier: GPL-3.0-or-later
// Ray marching in the two-layer depth image (docs/method.md#re-shading, core/geometry/depth_layers.h).
//
// Everything happens in (u, v, w) with w = 1/z, where rays stay straight lines and surface patches stay planes. With
// s = t / (p.z + t d.z) the ray p + t d becomes start + s step: linear in s. Each pixel is a solid between its back and
// its front patch, and the crossing inside a pixel is a linear equation, so there is no step size. A pyramid cell whose
// range of w the ray does not touch is skipped as a whole (Tevs et al. 2008, "Maximum mipmaps").
//
// The pyramid has cells of 1 (level 0) to 256 pixels that hold the range of inverse depth of the solids in them. Software
// devices pay for each iteration with all lanes and gain nothing from branches; what counts is how many words are read,
// and from how many cache lines. Therefore:
// - A cell is one word, two 16-bit numbers rounded outwards. All levels are in one map, which lies in blocks of 4x4 cells
//   (pyramidIndex). It is a texture, because drivers read one for eight lanes at once and a buffer lane by lane.
// - The inner loop only walks the pyramid. The outer loop looks at the two patches of a pixel, once a lane has found one
//   that its ray may touch; lanes without one all read the same texel, so that they fetch nothing from far away.
// - A list of rays (march_rays.comp: the analysis, the benchmark) is marched in the same steps, with lanes that never
//   wait for the longest ray among them. A workgroup has a share of the list, and each lane takes the next ray from it
//   when one of its two has ended. Two, because on large pictures most of the time is spent waiting for memory: one ray's
//   cell arrives while the other's is examined. Software drivers give each thread one part of the workgroups, so
//   neighbouring shares go to different parts.
// - Kernels that follow paths (lib/path.glsl) march one ray per lane at a time.
// Pictures whose pyramid exceeds the device's largest texture do without the finest levels. core::MarchPyramid is the
// twin on the CPU, core::march the oracle of both.
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
const float kMinStep = 1.0e-12;  // [px] per unit of s; avoids division by zero

struct ImageRay {
    vec3 start;    // (u [px], v [px], w [1/m])
    vec3 step;     // per unit of s
    vec2 inverse;  // 1/step.xy, finite
    float begin;   // s where the ray enters the image; 0 when it starts over it
    float end;     // s where it leaves the image, the range of depths, or the half space before the camera
};

// The part of the ray that can meet anything; empty (end < begin, or NaN) when there is none.
ImageRay imageRay(vec3 p, vec3 d) {
    ImageRay ray;
    float w = 1.0 / p.z;
    vec2 focal = geometry.camera.xy;
    ray.start = vec3(focal * p.xy * w + geometry.camera.zw, w);
    ray.step = vec3(focal * (d.xy - d.z * p.xy * w), -d.z * w);
    if (abs(ray.step.x) < kMinStep) ray.step.x = kMinStep;
    if (abs(ray.step.y) < kMinStep) ray.step.y = kMinStep;
    ray.inverse = 1.0 / ray.step.xy;
    ray.end = d.z > 0.0 ? 1.0 / d.z : kFar;
    if (ray.step.z > 0.0) ray.end = min(ray.end, (geometry.maxW - w) / ray.step.z);
    if (ray.step.z < 0.0) ray.end = min(ray.end, (geometry.minW - w) / ray.step.z);
    if (ray.step.z == 0.0 && (w > geometry.maxW || w < geometry.minW)) ray.end = -1.0;

    vec2 size = vec2(geometry.width, geometry.height);
    vec2 ahead = vec2(ray.step.x > 0.0 ? size.x : 0.0, ray.step.y > 0.0 ? size.y : 0.0);
    vec2 first = (size - ahead - ray.start.xy) * ray.inverse;
    vec2 last = (ahead - ray.start.xy) * ray.inverse;  // as `march` finds the edge of a cell
    ray.begin = max(0.0, max(first.x, first.y));
    ray.end = min(ray.end, min(last.x, last.y));
    return ray;
}

// Intersects the piece [s0, s1] of a ray inside a pixel with the pixel's solid: where it enters and leaves, and whether
// it enters through the back patch; a side wall belongs to the nearer layer. False when it does not touch the solid, or
// when not `asked`. Lanes run in lock step, so the patches are read in any case; lanes that need none read the same
// texels.
bool crossPixel(ImageRay ray, ivec2 pixel, float s0, float s1, bool asked, out float enter, out float leave,
                out bool back) {
    ivec2 texel = asked ? pixel : ivec2(0);
    vec4 frontPatch = texelFetch(frontPatchMap, texel, 0);
    vec4 backPatch = texelFetch(backPatchMap, texel, 0);
    bool touches = asked && frontPatch.x > 0.0;
#ifdef MARCH_WITHOUT
    touches = touches && frontPatch.w != MARCH_WITHOUT;
#endif
    vec3 a = ray.start + ray.step * s0;
    vec3 b = ray.start + ray.step * s1;
    vec2 center = vec2(pixel) + 0.5;
    // Signed room below the front patch and above the back patch; the solid is where both are >= 0.
    float front0 = (frontPatch.x + dot(frontPatch.yz, a.xy - center)) - a.z;
    float front1 = (frontPatch.x + dot(frontPatch.yz, b.xy - center)) - b.z;
    float back0 = a.z - (backPatch.x + dot(backPatch.yz, a.xy - center));
    float back1 = b.z - (backPatch.x + dot(backPatch.yz, b.xy - center));
    touches = touches && (front0 >= 0.0 || front1 >= 0.0) && (back0 >= 0.0 || back1 >= 0.0);
    float frontRoot = front0 / (front0 - front1);
    float backRoot = back0 / (back0 - back1);
    float lo = front0 < 0.0 ? frontRoot : 0.0;
    float hi = front1 < 0.0 ? frontRoot : 1.0;
    back = back0 < 0.0 && backRoot > lo;
    lo = back ? backRoot : lo;
    hi = back1 < 0.0 ? min(hi, backRoot) : hi;
    back = lo <= 0.0 ? front0 > back0 : back;
    enter = lo > 0.0 ? s0 + (s1 - s0) * lo : s0;
    leave = hi < 1.0 ? s0 + (s1 - s0) * hi : s1;
    return touches && lo <= hi;
}

// Smallest of exits and end, at least `start`. Non-negative floats compare like integers, which takes a third of the
// instructions, because NaN needs no care; results for negative ones do not matter.
float nextStop(float start, vec2 exits, float end) {
    int stop = min(min(floatBitsToInt(exits.x), floatBitsToInt(exits.y)), floatBitsToInt(end));
    return intBitsToFloat(max(floatBitsToInt(start), stop));
}

// What rays march through. Read once, because not every compiler moves loads out of loops.
struct MarchScene {
    ivec2 lastPixel;
    int top;  // levels of the pyramid
    int finest;
    uint rows;  // where its cells are (pyramidIndex)
    uint blocks;
    float minW;
    float scale;  // rangeScale
    int steps;    // upper bound for any ray; stops those with NaN
};

MarchScene marchScene() {
    MarchScene scene;
    scene.lastPixel = ivec2(geometry.width, geometry.height) - 1;
    scene.top = int(geometry.pyramidTop);
    scene.finest = int(geometry.pyramidFinest);
    scene.rows = geometry.pyramidRows;
    scene.blocks = geometry.pyramidBlocks;
    scene.minW = geometry.minW;
    scene.scale = rangeScale(geometry.minW, geometry.maxW);
    scene.steps = int(sliceValue(8u * (geometry.width + geometry.height) + 64u));
    return scene;
}

// State of a ray. It walks the pyramid until it may touch the solid of a pixel, looks at that pixel, and walks on (Aila
// and Laine 2009, "while-while"), so that lanes in lock step do the same most of the time.
struct March {
    ImageRay ray;
    vec2 z;       // of origin [m] and direction
    float start;  // w of the ray's start and step, in the pyramid's unit
    float slope;
    float s;  // current position
    ivec2 pixel;
    ivec2 ahead;  // 1 where u, v grow
    int level;    // level of the next cell, which contains `pixel`
    bool going;
    bool candidate;  // it may touch the solid of `pixel`
    bool inside;     // escaping from the solid of the origin; the first pixel decides whether there is one
    bool found;      // hit: `pixel`, at `s`
    bool back;
};

// Before the first ray.
March noMarch() {
    ImageRay ray = ImageRay(vec3(0.0), vec3(0.0), vec2(0.0), 0.0, 0.0);
    return March(ray, vec2(0.0), 0.0, 0.0, 0.0, ivec2(0), ivec2(0), 0, false, false, false, false, false);
}

// `p` has z > 0, `d` is unit length.
March startMarch(MarchScene scene, vec3 p, vec3 d) {
    March m;
    m.ray = imageRay(p, d);
    m.z = vec2(p.z, d.z);
    m.start = (m.ray.start.z - scene.minW) * scene.scale + kRangeStart;
    m.slope = m.ray.step.z * scene.scale;
    m.s = m.ray.begin;
    m.pixel = clamp(ivec2(floor(m.ray.start.xy + m.ray.step.xy * m.ray.begin)), ivec2(0), scene.lastPixel);
    m.ahead = ivec2(m.ray.step.x > 0.0 ? 1 : 0, m.ray.step.y > 0.0 ? 1 : 0);
    m.level = 0;
    m.going = p.z > 0.0 && m.ray.begin <= m.ray.end;
    m.candidate = m.going;  // most rays start on a surface
    m.inside = m.ray.begin <= 0.0;
    m.found = false;
    m.back = false;
    return m;
}

// Looks at the pixel of a candidate; leaves others as they are.
void lookAtPixel(MarchScene scene, inout March m) {
    ivec2 edge = m.pixel + m.ahead;
    vec2 exits = (vec2(edge) - m.ray.start.xy) * m.ray.inverse;
    float next = nextStop(m.s, exits, m.ray.end);
    float enter, leave;
    bool back;
    bool touches = crossPixel(m.ray, m.pixel, m.s, next, m.candidate, enter, leave, back);
    if (m.candidate) {
        m.candidate = false;
        m.found = touches && (!m.inside || enter > m.s);
        m.back = back;
        m.inside = touches && leave >= next;
        m.going = !m.found && next < m.ray.end;
        ivec2 over = m.pixel;
        if (exits.x <= exits.y) over.x = edge.x + m.ahead.x - 1;
        if (exits.y <= exits.x) over.y = edge.y + m.ahead.y - 1;
        ivec2 moved = m.pixel ^ over;
        if ((moved.x | moved.y) > 1 && scene.top > 0) m.level = 1;
        m.s = m.found ? enter : next;
        m.pixel = m.found ? m.pixel : over;
    }
}

MarchHit marchHit(March m) {
    return MarchHit(m.found, m.back, m.pixel, m.s * m.z.x / max(1.0 - m.s * m.z.y, 1.0e-20));
}

bool walks(March m) { return m.going && !m.candidate; }

// Range of all solids in the next cell (packRange).
uint nextCell(MarchScene scene, March m) {
    int stored = max(m.level, scene.finest);
    uvec2 cell = uvec2(m.pixel >> stored);
    uint index = pyramidIndex(cell.x, cell.y, uint(stored - scene.finest), scene.rows, scene.blocks);
    return texelFetch(pyramidMap, ivec2(pyramidTexel(index)), 0).x;
}

// One step of a walking ray: past the next cell or into it. The innermost code; every instruction counts.
void walk(MarchScene scene, inout March m, uint range) {
    ivec2 low = m.pixel & -(1 << m.level);
    ivec2 edge = low + (m.ahead << m.level);
    vec2 exits = (vec2(edge) - m.ray.start.xy) * m.ray.inverse;
    float next = nextStop(m.s, exits, m.ray.end);
    float before = m.start + m.slope * m.s;
    float after = m.start + m.slope * next;
    float rangeMin = float(range & 0xffffu);
    float rangeMax = float(range >> 16u);
    bool touches = (before >= rangeMin || after >= rangeMin) && (before <= rangeMax || after <= rangeMax);
    m.candidate = touches && m.level == 0;
    m.going = touches || next < m.ray.end;

    // Truncation instead of floor: the clamp keeps it in its cell.
    ivec2 over = clamp(ivec2(m.ray.start.xy + m.ray.step.xy * next), low,
                       min(low + ((1 << m.level) - 1), scene.lastPixel));
    if (exits.x <= exits.y) over.x = edge.x + m.ahead.x - 1;
    if (exits.y <= exits.x) over.y = edge.y + m.ahead.y - 1;
    ivec2 moved = (m.pixel ^ over) >> m.level;
    int up = (moved.x | moved.y) > 1 && m.level < scene.top ? 1 : 0;
    int down = m.level > 0 ? -1 : 0;
    m.inside = m.inside && touches;
    m.level += touches ? down : up;
    m.pixel = touches ? m.pixel : over;
    m.s = touches ? m.s : next;
}

// First solid that the ray enters. `p` has z > 0, `d` is unit length. The solid that contains the origin does not count
// until the ray has left it.
MarchHit march(vec3 p, vec3 d) {
    MarchScene scene = marchScene();
    March m = startMarch(scene, p, d);
    int steps = scene.steps;
    while (m.going && steps > 0) {
        --steps;
        lookAtPixel(scene, m);
        while (walks(m) && steps > 0) {
            --steps;
            walk(scene, m, nextCell(scene, m));
        }
    }
    return marchHit(m);
}

#endif
