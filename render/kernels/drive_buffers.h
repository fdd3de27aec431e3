// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/shading/drive_table.h"
#include "gpu/device.h"

namespace render {

/// A scene's drives and the planes of values they refer to (shaders/lib/drives.glsl).
class DriveBuffers {
  public:
    /// Uploads what differs from the last table: for a mask that was painted on, the rows with changed tiles. Buffers
    /// are replaced only when they no longer fit.
    void upload(const gpu::Device& device, const core::DriveTable& table);

    // Valid after the first upload.
    [[nodiscard]] const gpu::Buffer& drives() const { return drives_; }
    [[nodiscard]] const gpu::Buffer& values() const { return values_; }

  private:
    void writeChangedRows(const gpu::Device& device, const core::DriveTable& table);

    gpu::Buffer drives_, values_;
    std::vector<core::DrivePlane> planes_;  ///< contents of `values_`
};

}  // namespace render
