// SPDX-License-Identifier: GPL-3.0-or-later
// The grids on which light below a surface is summed (core/shading/diffusion_grid.h states the method), as far as
// kernels and core share them.
#ifndef PATINA_DIFFUSION_H
#define PATINA_DIFFUSION_H

#include "shaders/shared/interop.h"

// A brick is 4x4x4 cells of one level. Brick 0 is empty and its own neighbour everywhere. As words (uint):
#define DIFFUSION_BRICK_NEIGHBOURS 0  // 27 bricks around, x + 3y + 9z, itself in the middle; 0 = none
#define DIFFUSION_BRICK_PARENT 27     // the brick of the next coarser level that covers it; 0 = none
#define DIFFUSION_BRICK_CHILDREN 28   // 8 bricks of the next finer level that it covers, x + 2y + 4z; 0 = none
#define DIFFUSION_BRICK_ORIGIN 36     // x, y, z in bricks of its level
#define DIFFUSION_BRICK_WORDS 40
#define DIFFUSION_BRICK_CELLS 64

KERNEL_BEGIN

/// Quadratic B-spline (centred) with cells of width 1.
KERNEL_FN float diffusion_spline(float t) {
    float a = max(1.5f - abs(t), 0.0f);
    float b = max(0.5f - abs(t), 0.0f);
    return 0.5f * a * a - 1.5f * b * b;
}

/// Exitance for an irradiance of 1 everywhere, from its estimate by samples (`whole`). The uneven density of samples
/// would show as blotches, so an estimate within `tolerance` (a few standard deviations) of that of a flat surface is
/// replaced by it; larger deviations, as at thin parts and edges, are kept (a non-negative garrote [Bre95]).
KERNEL_FN float diffusion_whole(float whole, float flatSurface, float tolerance) {
    float d = whole - flatSurface;
    return d * d > tolerance * tolerance ? flatSurface + d * (1.0f - tolerance * tolerance / (d * d)) : flatSurface;
}

/// Exitance from the samples' sum, relative to their sum for an irradiance of 1 (`whole`), so that their uneven density
/// cancels; never more than was received.
KERNEL_FN float diffusion_exitance(float sum, float whole, float flatSurface, float tolerance) {
    float known = max(whole, max(0.01f * flatSurface, 1e-20f));
    return max(sum, 0.0f) / known * min(max(diffusion_whole(whole, flatSurface, tolerance), 0.0f), 1.0f);
}

/// A point of the camera's frame in the grids' axes, which are turned so that no plane of a room lies along them: on
/// such a plane the place relative to cells, which the sum depends on a little, would be the same everywhere.
KERNEL_FN vec3 diffusion_axes(vec3 p) {
    return vec3(dot(p, vec3(0.460000000f, -0.290659966f, 0.838997487f)),
                dot(p, vec3(0.770659966f, 0.600000000f, -0.214670017f)),
                dot(p, vec3(-0.441002513f, 0.745329983f, 0.500000000f)));
}

KERNEL_END

#endif
