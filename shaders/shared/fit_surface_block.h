// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of analysis/fit_surface.comp (immediates).
#ifndef PATINA_FIT_SURFACE_BLOCK_H
#define PATINA_FIT_SURFACE_BLOCK_H

#include "shaders/shared/interop.h"

#define FIT_SURFACE_DEPTH 0   // float per pixel: inverse depth [1/m], 0 = none
#define FIT_SURFACE_LABELS 1  // 16 bits per pixel, two in a word
#define FIT_SURFACE_TAPS 2    // vec4 per tap: dx, dy, weight, 1 / limit of the residual
#define FIT_SURFACE_KNOWN 3   // 3 floats per pixel: normals that are taken as they are where not zero
#define FIT_SURFACE_RESULT 4  // 7 floats per pixel of the slice: normal, position [m], area [m^2]

#define FIT_SURFACE_MAX_TAPS 25

KERNEL_BEGIN

// Constants of both twins (core/analysis/depth/normals.cpp, which explains the fit).

/// Smallest cosine of view taken for a patch's area, so that one grazing pixel cannot outweigh a segment.
const float kMinViewCosine = 0.02f;
/// Inverse depth that is on no plane [1/m].
const float kNothing = 1.0e9f;
/// Two sides of a pixel disagree when one deviates from a line this many times as much as the other.
const float kMaxSideRatio = 6.0f;
/// Smallest step over an occluding contour, relative to the step before it.
const float kContourJump = 6.0f;
/// Distances of a pixel to the contour that are searched [px]; the slope is infinite on the contour itself.
const float kMinContourDistance = 0.02f;
const float kMaxContourDistance = 100.0f;
const int kContourBisections = 16;
/// Ratio of neighbouring steps from which on they do not end like a square root.
const float kMaxContourRatio = 0.95f;
/// Tolerance of the third step, relative to the first.
const float kContourTolerance = 0.05f;
/// Weight of the guessed slope, relative to that of the pixels.
const float kSlopeStiffness = 1.0e-4f;

struct FitSurfaceBlock {
    vec4 camera;          // fx, fy, cx, cy [px]
    uint width;           // [px]
    uint height;          // [px]
    uint first;           // pixel of the slice
    uint count;           // pixels of the slice
    uint tapCount;        // 9 or 25
    uint hasKnown;        // 1: FIT_SURFACE_KNOWN is there
    float relativeNoise;  // of the depth
    float sign;           // -1: front, towards the camera; 1: back
};
KERNEL_BLOCK(FitSurfaceBlock, 48)

KERNEL_END

#endif
