// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/panel.h"

#include <QBoxLayout>
#include <utility>

#include "ui/widgets/param_control.h"
#include "ui/widgets/param_slider.h"

namespace ui {

namespace {

/// Value that the analysis chose for an automatic parameter of a segment; monostate before it is known.
core::ParamValue estimateOf(std::string_view key, const core::Analysis* analysis, std::uint16_t label) {
    if (analysis == nullptr) return {};
    if (key == "smoothing") {
        const auto found = analysis->smoothing.find(label);
        return found != analysis->smoothing.end() ? found->second : 0.0f;
    }
    const core::Reflectance* reflectance = analysis->findReflectance(label);
    if (reflectance == nullptr) return {};
    if (key == "reflectance") return reflectance->rho;
    if (key == "lobe_width") return reflectance->alpha;
    return {};
}

}  // namespace

ParamControl* Panel::addControl(const core::ParamRow& row, QBoxLayout* layout) {
    auto* control = new ParamControl(row, this);
    layout->addWidget(control);
    connect(control, &ParamControl::editingFinished, &workspace_, &Workspace::endMerge);
    return control;
}

void Panel::addControls(core::ParamGroup group, QBoxLayout* layout) {
    for (const core::SegmentParam& param : core::segmentParams()) {
        if (param.group != group) continue;
        ParamControl* control = addControl(param, layout);
        segmentControls_.emplace_back(&param, control);
        connect(control, &ParamControl::edited, this,
                [this, &param, control](const core::ParamValue& value, bool continues) {
                    workspace_.editSelected(
                        tr("Change %1").arg(control->label()),
                        [&](core::Segment& segment) { param.set(segment, value); },
                        continues ? control->name() : QString());
                });
    }
    for (const core::SceneParam& param : core::sceneParams()) {
        if (param.group != group) continue;
        ParamControl* control = addControl(param, layout);
        sceneControls_.emplace_back(&param, control);
        connect(control, &ParamControl::edited, this,
                [this, &param, control](const core::ParamValue& value, bool continues) {
                    workspace_.editScene(
                        tr("Change %1").arg(control->label()), [&](core::Scene& scene) { param.set(scene, value); },
                        continues ? control->name() : QString());
                });
    }
}

void Panel::refreshControls() {
    const core::Segment* segment = workspace_.selectedSegment();
    for (const auto& [param, control] : segmentControls_) {
        control->setEnabled(segment != nullptr);
        if (segment == nullptr) continue;
        control->setValue(param->get(*segment), estimateOf(param->key, workspace_.analysis().get(), segment->label));
    }
    for (const auto& [param, control] : sceneControls_) {
        control->setEnabled(workspace_.hasPhoto());
        control->setValue(param->get(workspace_.scene()));
    }
}

ParamControl* Panel::control(std::string_view key) const {
    for (const auto& [param, control] : segmentControls_)
        if (key == param->key) return control;
    for (const auto& [param, control] : sceneControls_)
        if (key == param->key) return control;
    return nullptr;
}

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

}  // namespace ui
