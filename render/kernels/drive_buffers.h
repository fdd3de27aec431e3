// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/shading/drive_table.h"
#include "gpu/device.h"

namespace render {

/// A scene's drives and the planes of values they refer to (shaders/lib/drives.glsl).
class DriveBuffers {
  public:
    /// Uploads what differs from the last table: of a mask that was painted on, the rows with changed tiles. True when
    /// a buffer is another one than before, so that bind groups with the old one are stale.
    bool upload(const gpu::Device& device, const core::DriveTable& table);

    // Valid once something was uploaded.
    [[nodiscard]] const gpu::Buffer& drives() const { return drives_; }
    [[nodiscard]] const gpu::Buffer& values() const { return values_; }

  private:
    gpu::Buffer drives_, values_;
    std::vector<core::DrivePlane> planes_;  ///< what `values_` holds
};

}  // namespace render
