// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shaded_scene.h"

#include <algorithm>

#include "core/material/brdf.h"
#include "core/shading/segment_shading.h"

namespace render {
namespace {

std::uint16_t highestOf(const core::LabelImage& labels) {
    const auto pixels = labels.pixels();
    return pixels.empty() ? std::uint16_t{0} : *std::max_element(pixels.begin(), pixels.end());
}

/// By label, up to `highest`; labels without a segment keep the photograph.
std::vector<kernel::SegmentShading> shadingTable(const core::Scene& scene, const core::Analysis& analysis,
                                                 std::uint16_t highest) {
    std::vector<kernel::SegmentShading> table = core::buildSegmentShading(scene, analysis);
    for (kernel::SegmentShading& entry : table)
        if (entry.blend.w == 0) entry.brdf = kernel::BrdfParams{};
    kernel::SegmentShading untouched{};
    untouched.blend = {1, 0, 0, 0};
    if (table.size() <= highest) table.resize(std::size_t{highest} + 1, untouched);
    return table;
}

}  // namespace

std::uint32_t ShadedScene::brdfs() const {
    std::uint32_t found = 0;
    for (const kernel::SegmentShading& entry : shading) found |= 1u << entry.brdf.type;
    return found;
}

bool isEdited(const core::Segment& segment) { return segment.edit && core::usable(*segment.edit); }

ShadedScene shadeScene(const core::Scene& scene, std::shared_ptr<const core::Analysis> analysis,
                       const ShadedScene& previous) {
    ShadedScene shaded;
    shaded.scene = scene;
    shaded.analysis = std::move(analysis);
    shaded.highestLabel = scene.photo == previous.scene.photo ? previous.highestLabel : highestOf(scene.photo->labels);
    shaded.shading = shadingTable(scene, *shaded.analysis, shaded.highestLabel);
    shaded.drives = core::buildDrives(scene, *shaded.analysis, shaded.shading);
    shaded.measured = placeMeasured(scene, shaded.shading);
    shaded.userBrdfs = placeUserBrdfs(scene, shaded.shading);
    shaded.revision = previous.revision + 1;
    return shaded;
}

}  // namespace render
