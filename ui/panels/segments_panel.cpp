// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/segments_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <ranges>

#include "ui/canvas/display.h"

namespace ui {

namespace {

enum Column { kName, kGlossy, kEdited, kColumnCount };
constexpr int kLabelRole = Qt::UserRole;

QPixmap swatch(std::uint16_t label) {
    const core::Vector3f c = segmentColor(label);
    QPixmap pixmap(14, 14);
    pixmap.fill(QColor::fromRgbF(c.x(), c.y(), c.z()));
    return pixmap;
}

}  // namespace

SegmentsPanel::SegmentsPanel(Workspace& workspace, QWidget* parent) : Panel(workspace, parent) {
    list_ = new QTreeWidget(this);
    list_->setObjectName(QStringLiteral("segmentList"));
    list_->setAccessibleName(tr("Segments"));
    list_->setColumnCount(kColumnCount);
    list_->setHeaderLabels({tr("Segment"), tr("Glossy"), tr("Edited")});
    list_->headerItem()->setToolTip(kGlossy,
                                    tr("Glossy segments show reflections, from which the light is recovered."));
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(kName, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(kGlossy, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(kEdited, QHeaderView::ResizeToContents);
    list_->setToolTip(tr("Click to select a segment, double-click to rename it, check the box to flag it as glossy."));
    hint_ = new QLabel(tr("No segments: open a project, or a photograph with a label map."), this);
    hint_->setObjectName(QStringLiteral("segmentHint"));
    hint_->setWordWrap(true);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(list_, 1);
    layout->addWidget(hint_);

    connect(list_, &QTreeWidget::itemChanged, this, &SegmentsPanel::applyChange);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (refreshing_) return;
        this->workspace().select(item != nullptr ? static_cast<std::uint16_t>(item->data(kName, kLabelRole).toUInt())
                                                 : std::uint16_t{0});
    });
    connect(&workspace, &Workspace::sceneChanged, this, &SegmentsPanel::refresh);
    connect(&workspace, &Workspace::selectionChanged, this, &SegmentsPanel::showSelection);
    refresh();
}

void SegmentsPanel::refresh() {
    const auto& segments = workspace().scene().segments;
    refreshing_ = true;
    const bool sameRows =
        std::ranges::equal(segments, std::views::iota(0, list_->topLevelItemCount()), {}, &core::Segment::label,
                           [this](int row) { return list_->topLevelItem(row)->data(kName, kLabelRole).toUInt(); });
    if (!sameRows) {
        list_->clear();
        for (const core::Segment& segment : segments) {
            auto* item = new QTreeWidgetItem(list_);
            item->setData(kName, kLabelRole, segment.label);
            item->setIcon(kName, swatch(segment.label));
            item->setFlags(item->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
            item->setTextAlignment(kEdited, Qt::AlignCenter);
        }
    }
    for (int row = 0; row < list_->topLevelItemCount(); ++row) {
        const core::Segment& segment = segments[static_cast<std::size_t>(row)];
        QTreeWidgetItem* item = list_->topLevelItem(row);
        item->setText(kName, QString::fromStdString(segment.name));
        item->setToolTip(kName,
                         tr("Segment %1, label %2").arg(QString::fromStdString(segment.name)).arg(segment.label));
        item->setCheckState(kGlossy, segment.glossy ? Qt::Checked : Qt::Unchecked);
        item->setToolTip(kGlossy, tr("Treat the segment's colours as reflections"));
        item->setText(kEdited, segment.edit ? QStringLiteral("●") : QString());
        item->setToolTip(kEdited, segment.edit ? tr("Has a new material") : tr("Unchanged"));
    }
    hint_->setVisible(segments.empty());
    refreshing_ = false;
    showSelection(workspace().selectedLabel());
}

QTreeWidgetItem* SegmentsPanel::itemOf(std::uint16_t label) const {
    for (int row = 0; row < list_->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = list_->topLevelItem(row);
        if (item->data(kName, kLabelRole).toUInt() == label) return item;
    }
    return nullptr;
}

void SegmentsPanel::showSelection(quint16 label) {
    refreshing_ = true;
    QTreeWidgetItem* item = itemOf(label);
    list_->setCurrentItem(item);
    if (item == nullptr) list_->clearSelection();
    refreshing_ = false;
}

void SegmentsPanel::applyChange(QTreeWidgetItem* item, int column) {
    if (refreshing_) return;
    const auto label = static_cast<std::uint16_t>(item->data(kName, kLabelRole).toUInt());
    const core::Segment* segment = workspace().scene().findSegment(label);
    if (segment == nullptr) return;
    if (column == kGlossy) {
        const bool glossy = item->checkState(kGlossy) == Qt::Checked;
        if (glossy == segment->glossy) return;
        workspace().editScene(glossy ? tr("Flag %1 as glossy").arg(QString::fromStdString(segment->name))
                                     : tr("Flag %1 as not glossy").arg(QString::fromStdString(segment->name)),
                              [&](core::Scene& scene) { scene.findSegment(label)->glossy = glossy; });
    } else if (column == kName) {
        const std::string name = item->text(kName).trimmed().toStdString();
        if (name == segment->name) return;
        const auto& all = workspace().scene().segments;
        const bool taken = std::ranges::any_of(
            all, [&](const core::Segment& other) { return other.label != label && other.name == name; });
        if (name.empty() || taken) {
            emit message(name.empty()
                             ? tr("A segment needs a name.")
                             : tr("There is already a segment named \"%1\".").arg(QString::fromStdString(name)));
            refresh();
            return;
        }
        workspace().editScene(tr("Rename segment"), [&](core::Scene& scene) { scene.findSegment(label)->name = name; });
    }
}

}  // namespace ui
