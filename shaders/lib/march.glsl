// SPDX-License-Identifier: GPL-3.0-or-later
// Ray marching in the two-layer depth image (docs/method.md#re-shading, core/geometry/depth_layers.h).
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

// Solid of one pixel against the piece [s0, s1] of a ray inside that pixel: the parameters where it enters and leaves,
// and whether it enters through the back patch. False when it does not touch the solid, or when not `asked`: where lanes
// run in lock step the patches are read for all of them, and those that need none read the same texels. A side wall
// belongs to the nearer layer.
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

// Greatest of `least` and the least of the others, none of which is negative if it matters: such floats order as
// integers, which takes a third of the instructions where NaN needs them.
float nextStop(float least, vec2 exits, float end) {
    int stop = min(min(floatBitsToInt(exits.x), floatBitsToInt(exits.y)), floatBitsToInt(end));
    return intBitsToFloat(max(floatBitsToInt(least), stop));
}

// What rays march through, read once: loads are not moved out of loops everywhere.
struct MarchScene {
    ivec2 lastPixel;
    int top;  // levels of the pyramid
    int finest;
    uint rows;  // where its cells are (pyramidIndex)
    uint blocks;
    float leastW;
    float scale;  // rangeScale
    int steps;    // no ray needs more; one with broken numbers stops here
};

MarchScene marchScene() {
    MarchScene scene;
    scene.lastPixel = ivec2(geometry.width, geometry.height) - 1;
    scene.top = int(geometry.pyramidTop);
    scene.finest = int(geometry.pyramidFinest);
    scene.rows = geometry.pyramidRows;
    scene.blocks = geometry.pyramidBlocks;
    scene.leastW = geometry.leastW;
    scene.scale = rangeScale(geometry.leastW, geometry.greatestW);
    scene.steps = int(sliceValue(8u * (geometry.width + geometry.height) + 64u));
    return scene;
}

// A ray on its way, which walks the pyramid until it may touch the solid of a pixel, looks at that pixel, and walks on
// (Aila and Laine 2009, "while-while"): where lanes run in lock step, all of them then do the same most of the time.
struct March {
    ImageRay ray;
    vec2 z;       // of origin [m] and direction
    float start;  // w of the ray's start and step, in the pyramid's unit
    float slope;
    float s;  // it came so far
    ivec2 pixel;
    ivec2 ahead;  // 1 where u, v grow
    int level;    // of the cell it looks at next, the one with `pixel` in it
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
    m.start = (m.ray.start.z - scene.leastW) * scene.scale + kRangeStart;
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

// What holds all solids of the next cell (packRange).
uint nextCell(MarchScene scene, March m) {
    int stored = max(m.level, scene.finest);
    uvec2 cell = uvec2(m.pixel >> stored);
    uint index = pyramidIndex(cell.x, cell.y, uint(stored - scene.finest), scene.rows, scene.blocks);
    return texelFetch(pyramidMap, ivec2(pyramidTexel(index)), 0).x;
}

// A step of a ray that walks: past the next cell or into it. What it does is counted in instructions.
void walk(MarchScene scene, inout March m, uint range) {
    ivec2 low = m.pixel & -(1 << m.level);
    ivec2 edge = low + (m.ahead << m.level);
    vec2 exits = (vec2(edge) - m.ray.start.xy) * m.ray.inverse;
    float next = nextStop(m.s, exits, m.ray.end);
    float before = m.start + m.slope * m.s;
    float after = m.start + m.slope * next;
    float least = float(range & 0xffffu);
    float greatest = float(range >> 16u);
    bool touches = (before >= least || after >= least) && (before <= greatest || after <= greatest);
    m.candidate = touches && m.level == 0;
    m.going = touches || next < m.ray.end;

    // Truncated is as good as floored: it stays in its cell.
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

// First solid the ray enters. `p` has z > 0, `d` is unit length. An origin inside a solid does not count until the ray
// has left it.
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
