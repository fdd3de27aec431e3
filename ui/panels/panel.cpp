// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/panel.h"

#include <utility>

#include "ui/widgets/param_slider.h"

namespace ui {

ParamSlider* Panel::addSegmentSlider(const ParamSpec& spec, std::function<void(core::Segment&, float)> set) {
    auto* slider = new ParamSlider(spec, this);
    connect(slider, &ParamSlider::valueChanged, this, [this, spec, set = std::move(set)](double value) {
        workspace_.editSelected(
            tr("Change %1").arg(spec.label), [&](core::Segment& segment) { set(segment, static_cast<float>(value)); },
            spec.key);
    });
    connect(slider, &ParamSlider::editingFinished, &workspace_, &Workspace::endMerge);
    return slider;
}

ParamSlider* Panel::addSceneSlider(const ParamSpec& spec, std::function<void(core::Scene&, float)> set) {
    auto* slider = new ParamSlider(spec, this);
    connect(slider, &ParamSlider::valueChanged, this, [this, spec, set = std::move(set)](double value) {
        workspace_.editScene(
            tr("Change %1").arg(spec.label), [&](core::Scene& scene) { set(scene, static_cast<float>(value)); },
            spec.key);
    });
    connect(slider, &ParamSlider::editingFinished, &workspace_, &Workspace::endMerge);
    return slider;
}

}  // namespace ui
