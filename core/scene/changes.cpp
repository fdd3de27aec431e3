// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/changes.h"

#include <algorithm>

#include "core/material/drive_parameters.h"

namespace core {
namespace {

bool sameLight(const EnvironmentParams& a, const EnvironmentParams& b) {
    return a.image == b.image && a.path == b.path && a.rotation == b.rotation && a.scale == b.scale && a.use == b.use &&
           a.fill == b.fill;
}

/// Weights are applied when the picture is put together; everything else in a material is part of its light transport.
std::optional<Material> withoutWeights(const std::optional<Material>& material) {
    if (!material) return std::nullopt;
    Material result = *material;
    result.blendNew = 1;
    result.blendOriginal = 0;
    if (result.translucency) {
        result.translucency->weight = 1;
        result.translucency->preset.clear();
    }
    return result;
}

Stage firstChangedSegmentStage(const Scene& before, const Scene& after) {
    if (before.segments.size() != after.segments.size()) return Stage::BackSide;
    Stage first = Stage::Display;
    bool translucent = false;
    for (const Scene* scene : {&before, &after})
        for (const Segment& segment : scene->segments)
            translucent = translucent || (segment.edit && segment.edit->translucency);
    const auto touch = [&](bool changed, Stage stage) {
        if (changed) first = std::min(first, stage);
    };
    for (std::size_t i = 0; i < before.segments.size(); ++i) {
        const Segment& a = before.segments[i];
        const Segment& b = after.segments[i];
        touch(a.smoothing != b.smoothing, Stage::Geometry);
        touch(a.label != b.label || a.backSide != b.backSide, Stage::BackSide);
        touch(a.glossy != b.glossy || a.reflectance != b.reflectance || a.lobeWidth != b.lobeWidth, Stage::Reflectance);
        const auto detail = [](const Segment& s) { return s.edit && drivenByLuminance(*s.edit); };
        touch(detail(a) != detail(b), Stage::Environment);
        // Light that reaches a translucent segment may come by way of any other edited one.
        touch(withoutWeights(a.edit) != withoutWeights(b.edit), translucent ? Stage::Irradiance : Stage::Reshade);
        touch(a.edit != b.edit, Stage::Composite);
    }
    return first;
}

}  // namespace

Stage firstChangedStage(const Scene& before, const Scene& after) {
    if (before.photo != after.photo) return Stage::Input;
    if (before.depthFilter != after.depthFilter) return Stage::Geometry;
    Stage first = firstChangedSegmentStage(before, after);
    const auto touch = [&](bool changed, Stage stage) {
        if (changed) first = std::min(first, stage);
    };
    touch(before.backDepth != after.backDepth, Stage::BackSide);
    touch(before.environment.height != after.environment.height, Stage::Reflectance);
    touch(!sameLight(before.environment, after.environment), Stage::Environment);
    const RenderParams& a = before.render;
    const RenderParams& b = after.render;
    touch(a.seed != b.seed || a.bounces != b.bounces || a.surfaceSamples != b.surfaceSamples ||
              a.irradianceSamples != b.irradianceSamples || a.diffusionQuality != b.diffusionQuality,
          Stage::Irradiance);
    touch(a.samples != b.samples || a.timeLimit != b.timeLimit, Stage::Reshade);
    touch(a.filter != b.filter, Stage::Composite);
    return first;
}

}  // namespace core
