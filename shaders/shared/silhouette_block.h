// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of silhouette.comp (immediates): the partly covered pixels at one segment's outline.
#ifndef PATINA_SILHOUETTE_BLOCK_H
#define PATINA_SILHOUETTE_BLOCK_H

#include "shaders/shared/interop.h"

#define SILHOUETTE_PIXELS 0        // MixedPixel
#define SILHOUETTE_RESULT 1        // rgba32float
#define SILHOUETTE_DRIVES 2        // Drive
#define SILHOUETTE_DRIVE_VALUES 3  // float

KERNEL_BEGIN

/// core::SilhouettePixel as the kernel reads it.
struct MixedPixel {
    uint pixel;   // x | y << 16
    uint source;  // x | y << 16
    float coverage;
    float pad0;
    vec4 kept;          // rgb
    vec4 keptOriginal;  // rgb
};
KERNEL_BLOCK(MixedPixel, 48)

struct SilhouetteBlock {
    uint pixelCount;
    float blendOriginal;
    uint firstDrive;  // first of the drives of the weights
    uint driveCount;
};
KERNEL_BLOCK(SilhouetteBlock, 16)

KERNEL_END

#endif
