// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "core/base/binary_mask.h"
#include "core/base/camera.h"
#include "core/base/image.h"
#include "core/base/progress.h"

namespace core {

/// A photograph to select in. Only referred to while a Selector is being built.
struct SelectionInput {
    const ImageRgb& color;         ///< scene-linear
    const ImageF& depth;           ///< planar z [m], 0 = none; empty or all 0 = the photograph has no depth
    Camera camera;                 ///< of the size of `color`
    float depthSampleSpacing = 1;  ///< photograph pixels per pixel of the stored depth map, ≥ 1
};

/// OKLab in 8 bits per channel: L in [0, 1], a and b in [-0.4, 0.4] mapped to [0, 255] ([Ott20]).
using PackedLab = std::array<std::uint8_t, 3>;

/// How far the depth map can be trusted.
struct DepthQuality {
    bool present = false;  ///< some pixel has depth
    float noise = 0;       ///< typical relative deviation of 1/z from a plane over a few pixels
    int span = 1;        ///< [working px] distance over which slopes are measured; grows with noise and sample spacing
    int edgeOffset = 0;  ///< [working px] how far its edges lie from those of the photograph; 0 = on them
};

/// Photograph at the resolution at which regions are found, at most about kMaxWorkingPixels. All images share a size.
struct SelectionPicture {
    int factor = 1;       ///< photograph pixels per working pixel
    Camera camera;        ///< of the working resolution
    ImageV3 lab;          ///< OKLab, exposed so that the 99th percentile of the photograph is white
    ImageF inverseDepth;  ///< 1/z [1/m]; 0 = none
    ImageV3 normal;       ///< unit length, facing the camera; zero where there is no depth
    DepthQuality quality;
};

inline constexpr int kMaxWorkingPixels = 1'500'000;

/// `packed` receives the colour of every pixel of the photograph. Throws Error(Cancelled).
[[nodiscard]] SelectionPicture makeSelectionPicture(const SelectionInput& input, Image<PackedLab>& packed,
                                                    const Progress& progress);

/// Strength of the boundary between neighbouring pixels in [0, 255]: how likely an object ends there.
struct BoundaryStrength {
    Image<std::uint8_t> right;  ///< between (x, y) and (x+1, y); the last column is 0
    Image<std::uint8_t> down;   ///< between (x, y) and (x, y+1); the last row is 0
};

/// Combines the evidence of colour, depth steps and creases (docs/method.md#selection), at each pixel mostly that of
/// the strongest cue ([FPCC16]). May set `picture.quality.edgeOffset`. Throws Error(Cancelled).
[[nodiscard]] BoundaryStrength findBoundaries(SelectionPicture& picture, const Progress& progress);

/// OKLab of scene-linear Rec.709.
[[nodiscard]] Vector3f okLab(const Vector3f& color);
[[nodiscard]] PackedLab packLab(const Vector3f& lab);
[[nodiscard]] Vector3f unpackLab(const PackedLab& packed);

}  // namespace core
