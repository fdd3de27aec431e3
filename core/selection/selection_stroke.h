// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/binary_mask.h"
#include "core/base/pixel.h"

namespace core {

/// Brush that adds pixels to a selection, or takes them out.
struct SelectionBrush {
    float radius = 20;  ///< [px], > 0
    /// Part of the radius, [0, 1], in which everything is painted; the rim around it takes only pixels that look like
    /// those inside.
    float hardness = 1;
    bool erase = false;
    bool stopAtDepthEdges = false;  ///< paints only the surface that is under the brush's middle
};

/// One stroke. Its images have the mask's size and outlive it; `depth` [m] is 0 where there is none.
class SelectionStroke {
  public:
    /// `focal` [px] is the focal length, which says how steeply depth may change on one surface.
    SelectionStroke(BinaryMask before, const SelectionBrush& brush, const ImageRgb& color, const ImageF& depth,
                    float focal);

    /// Continues to (x, y) in continuous picture coordinates; the first call is a dab. Returns the box of pixels that
    /// may have changed, which is empty when the brush is outside the picture.
    PixelBox moveTo(float x, float y);
    [[nodiscard]] const BinaryMask& mask() const { return mask_; }

  private:
    [[nodiscard]] PixelBox dab(Vector2f center);
    [[nodiscard]] std::optional<Vector3f> meanUnder(Vector2f center, const PixelBox& box) const;
    [[nodiscard]] bool onSurface(int x, int y, float distance, float centerDepth) const;

    BinaryMask mask_;
    SelectionBrush brush_;
    const ImageRgb* color_;
    const ImageF* depth_;
    float focal_;
    std::optional<Vector2f> last_;
};

}  // namespace core
