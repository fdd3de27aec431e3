// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of check_brdf.comp (immediates).
#ifndef PATINA_CHECK_BRDF_BLOCK_H
#define PATINA_CHECK_BRDF_BLOCK_H

#include "shaders/shared/brdf_params.h"

#define CHECK_BRDF_CASES 0    // CheckBrdfCase
#define CHECK_BRDF_CELLS 1    // vec4 per case and cell: z from, z to, azimuth from, azimuth to
#define CHECK_BRDF_SAMPLES 2  // CheckBrdfSample per case and sample
#define CHECK_BRDF_SUMS 3     // CheckBrdfSums per case and cell

#define CHECK_BRDF_SAMPLE 0
#define CHECK_BRDF_INTEGRATE 1

KERNEL_BEGIN

struct CheckBrdfBlock {
    uint mode;     // CHECK_BRDF_SAMPLE or CHECK_BRDF_INTEGRATE
    uint first;    // item: a sample or a cell of a case
    uint count;    // items
    uint perCase;  // items of a case
    uint side;     // a cell has side × side points
    uint pad0;
    uint pad1;
    uint pad2;
};
KERNEL_BLOCK(CheckBrdfBlock, 32)

/// A material seen from one direction.
struct CheckBrdfCase {
    BrdfParams brdf;
    vec4 wo;  // xyz
};
KERNEL_BLOCK(CheckBrdfCase, 144)

/// Number of first samples of a case whose random numbers are at the ends of their range.
const uint kCheckBrdfCorners = 16u;

const uint kCheckLoops = 1u;  // the values of shaders/brdf/user.h
const uint kCheckDirection = 2u;
const uint kCheckPdf = 4u;        // negative, infinite or not a number
const uint kCheckValue = 8u;      // infinite or not a number
const uint kCheckNegative = 16u;  // a negative value

struct CheckBrdfSample {
    vec4 wi;      // xyz; w = faults
    vec4 weight;  // rgb
};
KERNEL_BLOCK(CheckBrdfSample, 32)

/// Means over the points of a cell.
struct CheckBrdfSums {
    vec4 value;   // rgb: the BRDF times the cosine; w: the density
    vec4 square;  // squares of the same
    vec4 fault;   // xyz: the first direction at which something was wrong; w = faults
    vec4 other;   // x: |f(wo, wi) − f(wi, wo)| times the cosine
};
KERNEL_BLOCK(CheckBrdfSums, 64)

KERNEL_END

#endif
