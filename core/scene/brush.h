// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/image.h"
#include "core/scene/mask.h"

namespace core {

struct Brush {
    float radius = 20;      ///< [px]
    float hardness = 0.5f;  ///< fraction of the radius at full strength, [0, 1]
    float strength = 1;     ///< opacity of one stroke, [0, 1]
    bool erase = false;     ///< paints black
};

/// One stroke inside one segment. It gets no stronger where it crosses itself.
class BrushStroke {
  public:
    /// `labels` has the mask's size and has to outlive the stroke.
    BrushStroke(const Mask& before, const Brush& brush, const LabelImage& labels, std::uint16_t label);

    /// Continues to (x, y) in continuous picture coordinates; the first call is a dab.
    void moveTo(float x, float y);
    [[nodiscard]] const Mask& mask() const { return mask_; }

  private:
    Mask before_;
    Mask coverage_;
    Mask mask_;
    Brush brush_;
    const LabelImage* labels_;
    std::uint16_t label_;
    Vector2f last_{0, 0};
    bool begun_ = false;
};

}  // namespace core
