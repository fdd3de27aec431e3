// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of analysis/relax_membrane.comp (immediates).
#ifndef PATINA_RELAX_MEMBRANE_BLOCK_H
#define PATINA_RELAX_MEMBRANE_BLOCK_H

#include "shaders/shared/interop.h"

#define RELAX_MEMBRANE_ROWS 0    // vec4 per row: up, down, side, scale
#define RELAX_MEMBRANE_VALUES 1  // vec4 per texel: the three values; w = 1 where they are given

KERNEL_BEGIN

struct RelaxMembraneBlock {
    uint width;            // [texel], even
    uint height;           // [texel]
    uint parity;           // colour of the board that is relaxed: x + y is even (0) or odd (1)
    float overRelaxation;  // 1 = none
};
KERNEL_BLOCK(RelaxMembraneBlock, 16)

KERNEL_END

#endif
