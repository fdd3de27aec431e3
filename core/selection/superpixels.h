// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/image.h"
#include "core/base/progress.h"
#include "core/selection/selection_picture.h"

namespace core {

/// Border shared by two superpixels, or a short gap between them.
struct SuperpixelBorder {
    std::uint32_t a = 0, b = 0;  ///< indices, a < b
    float length = 0;            ///< [px]
    float strength = 0;          ///< mean boundary strength, [0, 1]
    float firmness = 0;  ///< mean of a saturating function of the strength: the share that is clearly a boundary
    bool operator==(const SuperpixelBorder&) const = default;
};

struct Superpixel {
    float area = 0;                      ///< [px]
    float border = 0;                    ///< length of its outline on the picture's edge [px]
    float depthArea = 0;                 ///< pixels with depth [px]
    Vector3f lab = Vector3f::Zero();     ///< mean colour
    float inverseDepth = 0;              ///< mean of the pixels with depth [1/m]
    Vector3f normal = Vector3f::Zero();  ///< mean, not of unit length
    float x = 0, y = 0;                  ///< centre [px]
};

/// Over-segmentation: a watershed from one basin per cell of a grid.
struct Superpixels {
    Image<std::uint32_t> index;
    std::vector<Superpixel> superpixels;
    std::vector<SuperpixelBorder> borders;  ///< sorted by (a, b)
};

/// Grid cells have `cellSize`² pixels. The same result whatever the number of threads. Throws Error(Cancelled).
[[nodiscard]] Superpixels findSuperpixels(const SelectionPicture& picture, const BoundaryStrength& boundary,
                                          int cellSize, const Progress& progress);

}  // namespace core
