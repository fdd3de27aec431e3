// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/scene/scene.h"
#include "core/shading/drive_table.h"
#include "render/kernels/measured_tables.h"
#include "render/kernels/user_kernels.h"
#include "shaders/shared/path.h"

namespace render {

/// The picture that rays march through.
struct PictureLayers {
    std::shared_ptr<const core::Photo> photo;
    std::shared_ptr<const core::Surface> front, back;
    bool operator==(const PictureLayers&) const = default;
};

/// A scene with the tables that kernels need of its materials.
struct ShadedScene {
    core::Scene scene;
    std::shared_ptr<const core::Analysis> analysis;
    std::uint16_t highestLabel = 0;               ///< of the photograph
    std::vector<kernel::SegmentShading> shading;  ///< by label, up to the highest
    core::DriveTable drives;
    MeasuredFiles measured;
    UserFiles userBrdfs;
    std::uint64_t revision = 0;  ///< number of this scene among those the renderer got; 0 = none yet

    [[nodiscard]] PictureLayers layers() const {
        if (!analysis) return {};
        return {scene.photo, analysis->front, analysis->back};
    }
    /// BRDFs that paths may meet, bit = id.
    [[nodiscard]] std::uint32_t brdfs() const;
};

/// True for a segment that the renderer shades.
[[nodiscard]] bool isEdited(const core::Segment& segment);

/// The tables of `scene`, which follows `previous`. Throws core::Error for an unknown BRDF and for more BRDFs from
/// files than kernels can hold.
[[nodiscard]] ShadedScene shadeScene(const core::Scene& scene, std::shared_ptr<const core::Analysis> analysis,
                                     const ShadedScene& previous);

}  // namespace render
