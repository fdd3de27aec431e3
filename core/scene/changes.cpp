// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/changes.h"

#include <algorithm>

#include "core/material/drive_parameters.h"
#include "core/scene/params.h"

namespace core {
namespace {

/// The earliest stage that one of several changes touches.
class FirstStage {
  public:
    void touch(bool changed, Stage stage) {
        if (changed) stage_ = std::min(stage_, stage);
    }
    template <class Owner>
    void touch(std::span<const Param<Owner>> params, const Owner& before, const Owner& after) {
        for (const Param<Owner>& param : params) touch(param.get(before) != param.get(after), param.stage);
    }
    [[nodiscard]] Stage stage() const { return stage_; }

  private:
    Stage stage_ = Stage::Display;
};

/// The material without the weights, which are applied when the picture is composited; everything else in it is part
/// of its light transport.
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

bool anyTranslucent(const Scene& scene) {
    return std::ranges::any_of(scene.segments,
                               [](const Segment& s) { return s.visible && s.edit && s.edit->translucency; });
}

bool followsLuminance(const std::optional<Material>& edit) { return edit && drivenByLuminance(*edit); }

std::optional<Material> appliedEdit(const Segment& segment) { return segment.visible ? segment.edit : std::nullopt; }

void touchSegments(const Scene& before, const Scene& after, FirstStage& first) {
    first.touch(before.segments.size() != after.segments.size(), Stage::BackSide);
    if (before.segments.size() != after.segments.size()) return;
    // Light may reach a translucent segment by way of any other edited one.
    const Stage transport = anyTranslucent(before) || anyTranslucent(after) ? Stage::Irradiance : Stage::Reshade;
    for (std::size_t i = 0; i < before.segments.size(); ++i) {
        const Segment& a = before.segments[i];
        const Segment& b = after.segments[i];
        first.touch(segmentParams(), a, b);
        first.touch(a.label != b.label, Stage::BackSide);
        const std::optional<Material> old = appliedEdit(a), applied = appliedEdit(b);
        first.touch(followsLuminance(old) != followsLuminance(applied), Stage::Environment);
        first.touch(withoutWeights(old) != withoutWeights(applied), transport);
        first.touch(old != applied, Stage::Composite);
    }
}

}  // namespace

Stage firstChangedStage(const Scene& before, const Scene& after) {
    FirstStage first;
    first.touch(before.photo != after.photo, Stage::Input);
    first.touch(before.backDepth != after.backDepth, Stage::BackSide);
    const EnvironmentParams& a = before.environment;
    const EnvironmentParams& b = after.environment;
    first.touch(a.image != b.image || a.path != b.path, Stage::Environment);
    first.touch(sceneParams(), before, after);
    touchSegments(before, after, first);
    return first.stage();
}

}  // namespace core
