#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Marches a list of rays for the analysis, the benchmark and the tests. A workgroup has a share of the list, from which
// each invocation takes the next ray when one of its two has ended (Aila and Laine 2009, "persistent threads"); see
// shaders/lib/march.glsl.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shaders/lib/list.glsl"
#include "shaders/shared/march_block.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { MarchBlock block; };
#define MARCH_WITHOUT block.without
#include "shaders/lib/march.glsl"

layout(set = 1, binding = MARCH_RAYS) readonly buffer Rays { vec4 rays[]; };
layout(set = 1, binding = MARCH_HITS) writeonly buffer Hits { vec4 hits[]; };

shared uint taken;  // first ray that no invocation has taken

// Rays march in rounds: a look at one pixel, then up to this many steps through the pyramid. With more steps a lane waits
// longer for its next look or ray; with fewer there are more looks.
const int kRoundSteps = 12;

// One of an invocation's rays.
struct Taken {
    uint index;  // where its hit belongs
    int rounds;  // left
    March m;
};

// Takes the next ray from the list, which stops at `end`, if there is none or it has ended; then looks at its pixel.
void beginRound(MarchScene scene, uint end, inout Taken ray) {
    if (ray.rounds == 0) ray.m.going = false;
    --ray.rounds;
    if (!ray.m.going) {
        if (ray.index < end) {
            MarchHit hit = marchHit(ray.m);
            hits[ray.index] =
                hit.found ? vec4(hit.pixel + ivec2(1, 0), hit.back ? 1.0 : 0.0, hit.distance) : vec4(0.0);
        }
        ray.index = atomicAdd(taken, 1u);
        if (ray.index < end) {
            vec3 direction = rays[2u * ray.index + 1u].xyz;
            ray.m = startMarch(scene, rays[2u * ray.index].xyz, direction);
            ray.m.going = ray.m.going && direction != vec3(0.0);
            ray.m.candidate = ray.m.going;
            ray.rounds = scene.steps / 4;
        }
    }
    lookAtPixel(scene, ray.m);
}

void main() {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint first = (group % block.groupsPerWorker * block.workers + group / block.groupsPerWorker) * block.share;
    uint end = min(first + block.share, sliceValue(block.rayCount));
    if (gl_LocalInvocationIndex == 0u) taken = first;
    barrier();
    MarchScene scene = marchScene();
    Taken a = Taken(~0u, 0, noMarch());
    Taken b = a;
    do {
        beginRound(scene, end, a);
        beginRound(scene, end, b);
        for (int i = 0; i < kRoundSteps && (walks(a.m) || walks(b.m)); ++i) {
            uint cellA = nextCell(scene, a.m);
            uint cellB = nextCell(scene, b.m);
            if (walks(a.m)) walk(scene, a.m, cellA);
            if (walks(b.m)) walk(scene, b.m, cellB);
        }
    } while (a.index < end || b.index < end);
}
