// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of pixels, and the surface the camera sees in one.
#ifndef PATINA_PIXELS_GLSL
#define PATINA_PIXELS_GLSL

#include "shaders/lib/geometry.glsl"

// Index of this invocation in a list that a two-dimensional grid of workgroups covers (render::listGroups).
uint listIndex() { return gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x) + gl_GlobalInvocationID.x; }

// A value of the block that a branch or a loop depends on and that changes from slice to slice. Software drivers compile
// another variant of a kernel for every value of a constant that decides such a thing; min(v, v | id) is v, but no
// constant. (gl_GlobalInvocationID is only there to be unknown.)
uint sliceValue(uint value) { return min(value, value | gl_GlobalInvocationID.x); }
float sliceValue(float value) { return uintBitsToFloat(sliceValue(floatBitsToUint(value))); }

ivec2 unpackPixel(uint packed) { return ivec2(packed & 0xffffu, packed >> 16); }

// Point of the front layer at the pixel's centre [m].
vec3 frontPosition(ivec2 pixel) { return backProject(vec2(pixel) + 0.5, 1.0 / texelFetch(frontPatchMap, pixel, 0).x); }

#endif
