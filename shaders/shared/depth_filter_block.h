// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of analysis/depth_filter.comp (immediates).
#ifndef PATINA_DEPTH_FILTER_BLOCK_H
#define PATINA_DEPTH_FILTER_BLOCK_H

#include "shaders/shared/interop.h"

#define DEPTH_FILTER_DEPTH 0       // float per pixel: inverse depth [1/m], 0 = none
#define DEPTH_FILTER_COLOR 1       // uint per pixel: 8 bits a channel, red lowest
#define DEPTH_FILTER_LABELS 2      // 16 bits per pixel, two in a word
#define DEPTH_FILTER_PARAMETERS 3  // vec4: first the pairs (dx, dy, weight, 0), then the noise curve, four cells each
#define DEPTH_FILTER_RESULT 4      // float per pixel of the slice

#define DEPTH_FILTER_PAIRS 12
#define DEPTH_FILTER_CELLS 16

KERNEL_BEGIN

/// Squared residual, in units of its range, from which on a pair of pixels belongs to another surface; in both twins.
const float kMaxSquaredResidual = 64.0f;

struct DepthFilterBlock {
    uint width;          // [px]
    uint height;         // [px]
    uint first;          // pixel of the slice
    uint count;          // pixels of the slice
    float curveFirst;    // inverse depth of the curve's first cell [1/m]
    float cellsPerUnit;  // cells per 1/m
    float colorFactor;   // 1 / (limit of colour differences)^2
    uint pad0;
};
KERNEL_BLOCK(DepthFilterBlock, 32)

KERNEL_END

#endif
