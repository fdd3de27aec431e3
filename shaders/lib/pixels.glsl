// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of pixels, and the surface the camera sees in one.
#ifndef PATINA_PIXELS_GLSL
#define PATINA_PIXELS_GLSL

#include "shaders/lib/geometry.glsl"
#include "shaders/lib/list.glsl"

ivec2 unpackPixel(uint packed) { return ivec2(packed & 0xffffu, packed >> 16); }

// Point of the front layer at the pixel's centre [m].
vec3 frontPosition(ivec2 pixel) { return backProject(vec2(pixel) + 0.5, 1.0 / texelFetch(frontPatchMap, pixel, 0).x); }

#endif
