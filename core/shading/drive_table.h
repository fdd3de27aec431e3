// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/material/drive_parameters.h"
#include "core/scene/mask.h"
#include "core/scene/scene.h"
#include "shaders/shared/path.h"

namespace core {

// Spatially varying edits. A segment's drives become a table (kernel::Drive) and planes of stored values, one value for
// every pixel in the box around the segment. From these, kernels and the reference renderer compute the driven
// parameters of each pixel they shade, at every surface a path meets, so that evaluation, sampling and density agree.

/// Stored values in the box around one segment, of a mask or of the texture detail.
struct DrivePlane {
    std::shared_ptr<const Mask> mask;
    std::shared_ptr<const ImageF> detail;  ///< when `mask` is nullptr
    int x = 0, y = 0, width = 0, height = 0;
    std::size_t offset = 0;  ///< index of its first value among those of all planes

    /// Rows [first, first + rows) of the plane.
    void copyRows(int first, int rows, std::span<float> target) const;
};

struct DriveTable {
    std::vector<kernel::Drive> drives;
    std::vector<std::uint32_t> planeOf;  ///< plane of each drive
    std::vector<DrivePlane> planes;
    std::size_t valueCount = 0;

    [[nodiscard]] bool empty() const { return drives.empty(); }
    [[nodiscard]] std::vector<float> values() const;
};

/// The drives of all edited segments; sets SegmentShading::drives, with `shading` from buildSegmentShading. Drives of
/// parameters that the material lacks are left out, as are drives by luminance until the analysis has the detail.
[[nodiscard]] DriveTable buildDrives(const Scene& scene, const Analysis& analysis,
                                     std::span<kernel::SegmentShading> shading);

/// Value of a parameter in every pixel of a segment, scalars repeated three times; zero elsewhere. Throws Error(Usage)
/// when the segment is not edited or has no such parameter.
[[nodiscard]] ImageRgb effectiveParameter(const Scene& scene, const Analysis& analysis, const Segment& segment,
                                          std::string_view parameter);

}  // namespace core
