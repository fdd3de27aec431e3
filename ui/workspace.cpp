// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workspace.h"

#include <algorithm>
#include <utility>

#include "core/material/brdf_file.h"
#include "core/scene/changes.h"

namespace ui {

namespace {

std::string brdfName(const core::Material& material) {
    return material.brdfFile != nullptr ? material.brdf + ':' + material.brdfFile->path : material.brdf;
}

std::vector<std::uint16_t> labelsOf(const core::Scene& scene) {
    std::vector<std::uint16_t> labels;
    for (const core::Segment& segment : scene.segments) labels.push_back(segment.label);
    return labels;
}

}  // namespace

Workspace::Workspace(QObject* parent) : QObject(parent) {
    document_.setChangeListener([this](core::Stage stage) { changed(stage); });
}

void Workspace::setDocument(core::Document document) {
    document_ = std::move(document);
    document_.setChangeListener([this](core::Stage stage) { changed(stage); });
    analysis_.reset();
    materials_.clear();
    pickPixel(nullptr);
    selected_ = 0;
    selectedIn_ = {{document_.state(), selected_}};
    labels_ = labelsOf(scene());
    hasDepth_ = hasPhoto() && std::ranges::any_of(scene().photo->depth.image().pixels(), [](float z) { return z > 0; });
    setPaintedParameter({});
    ++generation_;
    analysisGeneration_ = generation_;
    emit documentReplaced();
    emit selectionChanged(selected_);
    emit analysisChanged();
    emit sceneChanged(core::Stage::Input);
}

void Workspace::changed(core::Stage stage) {
    ++generation_;
    if (stage <= core::Stage::Environment) analysisGeneration_ = generation_;
    restoreSelection();
    // Another segment may get the label.
    std::erase_if(materials_, [this](const auto& kept) { return scene().findSegment(kept.first.first) == nullptr; });
    if (paintedDrive() == nullptr) setPaintedParameter({});
    emit sceneChanged(stage);
}

void Workspace::restoreSelection() {
    std::vector<std::uint16_t> labels = labelsOf(scene());
    const bool others = labels != labels_;
    labels_ = std::move(labels);
    const auto known = selectedIn_.find(document_.state());
    if (others && known != selectedIn_.end())
        select(known->second);
    else if (scene().findSegment(selected_) == nullptr)
        select(0);
    selectedIn_[document_.state()] = selected_;
}

const core::Drive* Workspace::paintedDrive() const {
    const core::Segment* segment = selectedSegment();
    if (painted_.empty() || segment == nullptr || !segment->edit) return nullptr;
    for (const core::Drive& drive : segment->edit->drives)
        if (drive.parameter == painted_ && drive.mask != nullptr) return &drive;
    return nullptr;
}

void Workspace::setPaintedParameter(const std::string& parameter) {
    const std::string before = painted_;
    painted_ = parameter;
    if (paintedDrive() == nullptr) painted_.clear();
    if (painted_ != before) emit paintingChanged();
}

void Workspace::setBrush(const core::Brush& brush) {
    brush_ = brush;
    emit paintingChanged();
}

void Workspace::select(std::uint16_t label) {
    const std::uint16_t next = scene().findSegment(label) != nullptr ? label : std::uint16_t{0};
    if (next == selected_) return;
    document_.endMerge();
    pickPixel(nullptr);
    selected_ = next;
    selectedIn_[document_.state()] = next;
    setPaintedParameter({});
    emit selectionChanged(selected_);
}

void Workspace::setAnalysis(std::shared_ptr<const core::Analysis> analysis) {
    analysis_ = std::move(analysis);
    emit analysisChanged();
}

void Workspace::editSelected(const QString& label, const std::function<void(core::Segment&)>& change,
                             const QString& mergeKey) {
    const std::uint16_t target = selected_;
    if (scene().findSegment(target) == nullptr) return;
    editScene(
        label, [&](core::Scene& scene) { change(*scene.findSegment(target)); },
        mergeKey.isEmpty() ? mergeKey : mergeKey + QString::number(target));
}

void Workspace::editScene(const QString& label, const std::function<void(core::Scene&)>& change,
                          const QString& mergeKey) {
    document_.edit(label.toStdString(), change, mergeKey.toStdString());
}

void Workspace::pickPixel(std::function<void(int x, int y)> use) {
    const bool before = picking();
    picked_ = std::move(use);
    if (before || picking()) emit pickingChanged();
}

void Workspace::finishPicking(int x, int y) {
    const auto use = picked_;
    pickPixel(nullptr);
    if (use) use(x, y);
}

void Workspace::keepMaterial(std::uint16_t label, const core::Material& material) {
    materials_[{label, brdfName(material)}] = material;
}

const core::Material* Workspace::keptMaterial(std::uint16_t label, const core::Material& brdf) const {
    const auto kept = materials_.find({label, brdfName(brdf)});
    return kept != materials_.end() ? &kept->second : nullptr;
}

}  // namespace ui
