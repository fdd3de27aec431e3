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
// every pixel in the box around the segment; kernels and the reference renderer compute each driven parameter of the
// pixel they shade from them, at every surface a path meets, so that evaluation, sampling and density agree.

/// Stored values of the box around one segment; those of a mask or of the texture's detail.
struct DrivePlane {
    std::shared_ptr<const Mask> mask;
    std::shared_ptr<const ImageF> detail;  ///< when `mask` is nullptr
    int x = 0, y = 0, width = 0, height = 0;
    std::size_t offset = 0;  ///< of its first value among all planes'

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
/// parameters that the material does not have are left out, and those by luminance until the analysis knows the detail.
[[nodiscard]] DriveTable buildDrives(const Scene& scene, const Analysis& analysis,
                                     std::span<kernel::SegmentShading> shading);

/// What a parameter is in every pixel of a segment, scalars three times; zero elsewhere. Throws Error(Usage) when the
/// segment is not edited or has no such parameter.
[[nodiscard]] ImageRgb effectiveParameter(const Scene& scene, const Analysis& analysis, const Segment& segment,
                                          std::string_view parameter);

}  // namespace core
