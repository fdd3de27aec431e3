// SPDX-License-Identifier: GPL-3.0-or-later
// Immediates and bindings of canvas.frag, which draws what the window shows.
#ifndef PATINA_CANVAS_BLOCK_H
#define PATINA_CANVAS_BLOCK_H

#include "shaders/shared/interop.h"

#define CANVAS_PICTURE 0
#define CANVAS_LABELS 1
#define CANVAS_MASK 2
#define CANVAS_RULER_IMAGE 3
#define CANVAS_SELECTION_CODES 4

// Specialization constants, because a software device executes both sides of every branch.
#define CANVAS_FILTER 0  // 0 = nearest, 1 = bilinear, n > 1 = box of n x n taps
#define CANVAS_FLAGS 1

#define CANVAS_PICTURE_ENCODED 1u  // the picture is display-encoded: no exposure, no transfer function
#define CANVAS_OUTLINE 2u          // draw the outline of `selected`
#define CANVAS_OVERLAY 4u          // draw the mask
#define CANVAS_RULER 8u            // draw the ruler
#define CANVAS_BRUSH 16u           // draw the brush
#define CANVAS_SELECTION 32u       // draw what is selected and what would change

// Codes of a pixel in CANVAS_SELECTION_CODES.
#define SELECTION_IS 1u      // it is selected
#define SELECTION_JOINS 2u   // it would be selected
#define SELECTION_LEAVES 4u  // it would not be any longer

KERNEL_BEGIN

const float kCanvasSurround = 0.033f;  // linear; a neutral dark grey around the picture

struct CanvasBlock {
    vec2 origin;        // picture position at the view's top-left corner [px]
    float step;         // picture pixels per view pixel
    float gain;         // radiance factor, 2^stops
    uint selected;      // label that is outlined
    float brushRadius;  // [px]
    vec2 brushCenter;   // picture position [px]
    vec2 ruler;         // top-left corner of its image in the view [px]
    vec2 pad0;
};
KERNEL_BLOCK(CanvasBlock, 48)

KERNEL_END

#endif
