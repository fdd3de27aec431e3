// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/material/measured_brdf.h"
#include "core/scene/scene.h"
#include "gpu/device.h"
#include "shaders/shared/path.h"

namespace render {

/// Measured BRDFs in the order of their tables on the device.
using MeasuredFiles = std::vector<std::shared_ptr<const core::MeasuredBrdf>>;

/// The measured BRDFs of a scene's edits, each once; writes the begin of their tables into `shading` (by label).
[[nodiscard]] MeasuredFiles placeMeasured(const core::Scene& scene, std::span<kernel::SegmentShading> shading);

/// Tables of measured BRDFs in one buffer (shaders/brdf/measured.h).
class MeasuredTables {
  public:
    /// Throws core::Error(Input) for more tables than one buffer of the device can hold.
    static void requireFits(const gpu::Device& device, const MeasuredFiles& files);
    /// Buffer with these tables; replaced when they change.
    [[nodiscard]] const gpu::Buffer& upload(const gpu::Device& device, const MeasuredFiles& files);

  private:
    MeasuredFiles files_;
    gpu::Buffer buffer_;
};

}  // namespace render
