// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/segments_panel.h"

#include <QLabel>
#include <QMenu>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/analysis/notes.h"
#include "ui/panels/segment_actions.h"
#include "ui/panels/segment_model.h"
#include "ui/panels/segment_view.h"
#include "ui/words.h"

namespace ui {

SegmentsPanel::SegmentsPanel(Workspace& workspace, QWidget* parent) : Panel(workspace, parent) {
    model_ = new SegmentModel(this);
    list_ = new SegmentView(*model_, this);
    list_->setObjectName(QStringLiteral("segmentList"));
    list_->setAccessibleName(tr("Segments"));
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    list_->setMinimumHeight(120);
    actions_ = new SegmentActions(workspace, this);
    hint_ = new QLabel(this);
    hint_->setObjectName(QStringLiteral("segmentHint"));
    hint_->setWordWrap(true);
    hint_->setTextFormat(Qt::PlainText);
    hint_->setContentsMargins(0, 2, 0, 2);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(4);
    layout->addWidget(list_, 1);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(0);
    makeButtons(*buttons);
    layout->addLayout(buttons);
    layout->addWidget(hint_);

    connectList();
    connectActions();
    connect(&workspace, &Workspace::sceneChanged, this, &SegmentsPanel::refresh);
    connect(&workspace, &Workspace::selectionChanged, this, &SegmentsPanel::showSelection);
    connect(&workspace, &Workspace::analysisChanged, this, &SegmentsPanel::refreshHint);
    refresh();
}

void SegmentsPanel::makeButtons(QBoxLayout& layout) {
    for (QAction* action : actions_->all()) {
        if (action == nullptr) continue;
        auto* button = new QToolButton(this);
        button->setObjectName(action->objectName() + QStringLiteral("Button"));
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        button->setAutoRaise(true);
        layout.addWidget(button);
    }
    layout.addStretch(1);
}

void SegmentsPanel::connectList() {
    connect(model_, &SegmentModel::renamed, actions_, &SegmentActions::rename);
    connect(model_, &SegmentModel::switched, this, [this](quint16 label, int column, bool on) {
        const std::vector<std::uint16_t> one{label};
        if (column == SegmentModel::kGlossy) actions_->setGlossy(one, on);
        if (column == SegmentModel::kVisible) actions_->setVisible(one, on);
        if (column == SegmentModel::kLocked) actions_->setLocked(one, on);
    });
    connect(model_, &SegmentModel::segmentsDropped, this,
            [this](const std::vector<std::uint16_t>& dragged, quint16 target) {
                std::vector<std::uint16_t> labels{target};
                labels.insert(labels.end(), dragged.begin(), dragged.end());
                actions_->merge(labels);
            });
    connect(model_, &SegmentModel::filesDropped, actions_, &SegmentActions::importFiles);
    connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &SegmentsPanel::rowsChanged);
    // Otherwise a change of the selection follows.
    connect(list_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& current) {
        if (list_->selectionModel()->isSelected(current)) rowsChanged();
    });
    connect(list_, &QWidget::customContextMenuRequested, this, &SegmentsPanel::showMenu);
    connect(list_, &SegmentView::glossyWanted, actions_, &SegmentActions::toggleGlossy);
}

void SegmentsPanel::connectActions() {
    connect(actions_, &SegmentActions::message, this, &Panel::message);
    connect(actions_, &SegmentActions::error, this, &Panel::error);
    connect(actions_, &SegmentActions::notices, this, &Panel::notices);
    connect(actions_, &SegmentActions::renameWanted, this,
            [this](quint16 label) { list_->edit(model_->indexOf(label)); });
    connect(actions_, &SegmentActions::chooseWanted, this, [this](const std::vector<std::uint16_t>& labels) {
        choose(labels);
        rowsChanged();
    });
}

void SegmentsPanel::rowsChanged() {
    if (refreshing_) return;
    const std::vector<std::uint16_t> chosen = list_->chosen();
    const std::uint16_t current = model_->labelAt(list_->currentIndex().row());
    actions_->setChosen(chosen);
    const QScopedValueRollback fromList(choosing_, true);
    if (std::ranges::find(chosen, current) != chosen.end())
        workspace().select(current);
    else
        workspace().select(chosen.empty() ? std::uint16_t{0} : chosen.front());
}

void SegmentsPanel::choose(const std::vector<std::uint16_t>& labels) {
    const QScopedValueRollback quiet(refreshing_, true);
    list_->choose(labels);
}

void SegmentsPanel::refresh() {
    const std::uint16_t selected = workspace().selectedLabel();
    std::vector<std::uint16_t> chosen = list_->chosen();
    const int scrolled = list_->verticalScrollBar()->value();
    {
        const QScopedValueRollback quiet(refreshing_, true);
        model_->setScene(workspace().scene());
    }
    const auto place = std::ranges::find(chosen, selected);
    if (place == chosen.end())
        chosen = {selected};
    else
        std::rotate(chosen.begin(), place, place + 1);
    // Segments that came or went take the selection of rows with them.
    if (list_->selectionModel()->selection().isEmpty() || !list_->isChosen(selected)) {
        choose(chosen);
        list_->verticalScrollBar()->setValue(scrolled);
    }
    actions_->setChosen(list_->chosen());
    refreshHint();
}

void SegmentsPanel::showSelection(quint16 label) {
    if (choosing_) return;
    if (list_->chosen() != std::vector<std::uint16_t>(label != 0 ? 1 : 0, label)) choose({label});
    actions_->setChosen(list_->chosen());
}

void SegmentsPanel::showMenu(const QPoint& place) {
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("segmentMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    for (QAction* action : actions_->all())
        if (action != nullptr)
            menu->addAction(action);
        else
            menu->addSeparator();
    // The window's, which has it in its File menu too.
    if (auto* segmentation = window()->findChild<QAction*>(QStringLiteral("actionExportSegmentation")))
        menu->addAction(segmentation);
    menu->popup(list_->viewport()->mapToGlobal(place));
}

void SegmentsPanel::refreshHint() {
    const QString text = hint();
    hint_->setText(text);
    hint_->setVisible(!text.isEmpty());
}

QString SegmentsPanel::hint() {
    const core::Scene& scene = workspace().scene();
    if (!workspace().hasPhoto()) return tr("Open a photograph: File > Open, or drop it on the window.");
    if (scene.segments.empty()) return tr("Click an object in the picture with Smart select, then press Enter.");
    if (std::ranges::none_of(scene.segments, &core::Segment::glossy))
        return tr("Tick Glossy for an object with reflections: the light is recovered from them.");
    return glossyHint();
}

QString SegmentsPanel::glossyHint() {
    const core::Scene& scene = workspace().scene();
    const std::shared_ptr<const core::Analysis>& analysis = workspace().analysis();
    std::vector<std::pair<std::string, bool>> glossy;
    for (const core::Segment& segment : scene.segments)
        if (segment.glossy) glossy.emplace_back(segment.name, segment.reflectance.has_value());
    if (known_.analysis.lock() == analysis && known_.photo.lock() == scene.photo && known_.glossy == glossy)
        return known_.hint;
    known_ = {analysis, scene.photo, std::move(glossy), {}};
    if (analysis == nullptr) return {};
    const core::Notes notes = core::glossyNotes(scene, *analysis);
    if (!notes.empty()) known_.hint = translated(notes.front());
    return known_.hint;
}

}  // namespace ui
