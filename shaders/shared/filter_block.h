// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of filter.comp (immediates): one level of the edge-aware filter, over some pixels of one segment.
#ifndef PATINA_FILTER_BLOCK_H
#define PATINA_FILTER_BLOCK_H

#include "shaders/shared/interop.h"

#define FILTER_PIXELS 0        // the segment's pixels, x | y << 16
#define FILTER_ACCUMULATION 1  // rgba32float: sum of radiance, sum of squared luminance
#define FILTER_COUNT 2         // r32float: samples in the sum
#define FILTER_SOURCE 3        // rgba32float: colour, variance of its luminance
#define FILTER_TARGET 4        // the same

KERNEL_BEGIN

struct FilterBlock {
    uint firstPixel;
    uint pixelCount;       // pixels of this slice
    int level;             // -1: colour and variance from the accumulation; 0 ...: taps 2^level pixels apart
    float normalPower;     // core::ImageFilterParams
    float depthSigma;      // pixel footprints
    float luminanceSigma;  // standard deviations
    uint temporalSamples;  // from this many samples on the variance comes from the second moment
    uint pad0;
};
KERNEL_BLOCK(FilterBlock, 32)

KERNEL_END

#endif
