// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse grids in bricks of 4x4x4 cells (shaders/shared/diffusion.h). The includer declares `words`, the bricks.
#ifndef PATINA_BRICKS_GLSL
#define PATINA_BRICKS_GLSL

#include "shaders/shared/diffusion.h"

uint brickWord(uint brick, uint word) { return words[brick * DIFFUSION_BRICK_WORDS + word]; }

ivec3 brickOrigin(uint brick) {
    return ivec3(brickWord(brick, DIFFUSION_BRICK_ORIGIN), brickWord(brick, DIFFUSION_BRICK_ORIGIN + 1u),
                 brickWord(brick, DIFFUSION_BRICK_ORIGIN + 2u));
}

uint cellIn(uint brick, ivec3 cell) {
    ivec3 c = cell & 3;
    return brick * DIFFUSION_BRICK_CELLS + uint(c.x + 4 * c.y + 16 * c.z);
}

// Cell `cell` relative to a brick's first one, -4 to 7 in each direction; it may belong to a neighbour.
uint cellAround(uint brick, ivec3 cell) {
    ivec3 n = (cell >> 2) + 1;
    return cellIn(brickWord(brick, DIFFUSION_BRICK_NEIGHBOURS + uint(n.x + 3 * n.y + 9 * n.z)), cell);
}

ivec3 cellOfLane(uint lane) { return ivec3(lane & 3u, (lane >> 2) & 3u, lane >> 4); }

#endif
