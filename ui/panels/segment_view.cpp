// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/segment_view.h"

#include <QApplication>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>

#include "ui/panels/segment_model.h"
#include "ui/widgets/line_icon.h"

namespace ui {

namespace {

/// Draws switches in the middle of their cell: a check box, an eye, a lock; faint when they are off.
class SegmentDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        if (!SegmentModel::isSwitch(index.column())) return QStyledItemDelegate::paint(painter, option, index);
        const QStyle* style = option.widget != nullptr ? option.widget->style() : QApplication::style();
        style->drawPrimitive(QStyle::PE_PanelItemViewItem, &option, painter, option.widget);
        const bool on = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
        constexpr float kFaint = 0.4f;
        QColor color = option.palette.color(option.state.testFlag(QStyle::State_Selected) ? QPalette::HighlightedText
                                                                                          : QPalette::Text);
        if (!on) color.setAlphaF(kFaint);
        constexpr int kSide = 16;
        QRectF place(0, 0, kSide, kSide);
        place.moveCenter(QRectF(option.rect).center());
        paintLineIcon(*painter, switchIcon(index.column(), on), place, color);
    }
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        constexpr int kRowMargin = 4;
        QSize size = QStyledItemDelegate::sizeHint(option, index);
        size.setHeight(std::max(size.height(), SegmentThumbnails::kHeight + kRowMargin));
        return size;
    }

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->decorationSize = {SegmentThumbnails::kSwatchWidth + SegmentThumbnails::kWidth,
                                  SegmentThumbnails::kHeight};
    }

  private:
    static const char* switchIcon(int column, bool on) {
        if (column == SegmentModel::kGlossy) return on ? icons::kChecked : icons::kUnchecked;
        if (column == SegmentModel::kVisible) return on ? icons::kShown : icons::kHidden;
        return on ? icons::kLocked : icons::kUnlocked;
    }
};

}  // namespace

SegmentView::SegmentView(SegmentModel& model, QWidget* parent) : QTreeView(parent), model_(model) {
    setModel(&model);
    setItemDelegate(new SegmentDelegate(this));
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked);
    setDragDropMode(QAbstractItemView::DragDrop);
    setDragDropOverwriteMode(true);  // drops are on rows, not between them
    setDefaultDropAction(Qt::CopyAction);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTextElideMode(Qt::ElideMiddle);
    header()->setSortIndicatorClearable(true);
    header()->setSortIndicator(-1, Qt::AscendingOrder);
    setSortingEnabled(true);
    header()->setStretchLastSection(false);
    header()->setSectionsMovable(false);
    header()->setMinimumSectionSize(16);
    header()->moveSection(header()->visualIndex(SegmentModel::kVisible), 0);
    sizeColumns();
}

void SegmentView::sizeColumns() {
    for (int column = 0; column < SegmentModel::kColumnCount; ++column)
        header()->setSectionResizeMode(column,
                                       column == SegmentModel::kName ? QHeaderView::Stretch : QHeaderView::Fixed);
    constexpr int kPadding = 10, kPictogram = 24;
    const auto textWidth = [this](const QString& text) { return fontMetrics().horizontalAdvance(text) + kPadding; };
    for (const int column : {SegmentModel::kVisible, SegmentModel::kLocked, SegmentModel::kEdited})
        header()->resizeSection(column, kPictogram);
    for (const int column : {SegmentModel::kGlossy, SegmentModel::kArea})
        header()->resizeSection(
            column, std::max(textWidth(model_.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString()),
                             column == SegmentModel::kArea ? textWidth(QStringLiteral("<0.1 %")) : kPictogram));
}

void SegmentView::changeEvent(QEvent* event) {
    QTreeView::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) sizeColumns();
}

std::vector<std::uint16_t> SegmentView::chosen() const {
    std::vector<int> rows;
    for (const QItemSelectionRange& range : selectionModel()->selection())
        for (int row = range.top(); row <= range.bottom(); ++row) rows.push_back(row);
    std::ranges::sort(rows);
    rows.erase(std::ranges::unique(rows).begin(), rows.end());
    std::vector<std::uint16_t> labels;
    labels.reserve(rows.size());
    for (const int row : rows) labels.push_back(model_.labelAt(row));
    return labels;
}

bool SegmentView::isChosen(std::uint16_t label) const { return selectionModel()->isSelected(model_.indexOf(label)); }

void SegmentView::choose(const std::vector<std::uint16_t>& labels) {
    std::vector<int> rows;
    for (const std::uint16_t label : labels)
        if (const QModelIndex index = model_.indexOf(label); index.isValid()) rows.push_back(index.row());
    if (rows.empty()) {
        selectionModel()->clear();
        return;
    }
    const int first = rows.front();
    std::ranges::sort(rows);
    QItemSelection selection;
    for (std::size_t i = 0; i < rows.size();) {
        std::size_t end = i + 1;
        while (end < rows.size() && rows[end] <= rows[end - 1] + 1) ++end;
        selection.append(
            QItemSelectionRange(model_.index(rows[i], 0), model_.index(rows[end - 1], SegmentModel::kColumnCount - 1)));
        i = end;
    }
    selectionModel()->setCurrentIndex(model_.index(first, SegmentModel::kName), QItemSelectionModel::NoUpdate);
    selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
}

QModelIndex SegmentView::switchAt(const QMouseEvent& event) const {
    const QModelIndex index = indexAt(event.position().toPoint());
    return event.button() == Qt::LeftButton && SegmentModel::isSwitch(index.column()) ? index : QModelIndex();
}

void SegmentView::mousePressEvent(QMouseEvent* event) {
    pressed_ = switchAt(*event);
    if (!pressed_.isValid()) QTreeView::mousePressEvent(event);
}

void SegmentView::mouseDoubleClickEvent(QMouseEvent* event) {
    pressed_ = switchAt(*event);
    if (!pressed_.isValid()) QTreeView::mouseDoubleClickEvent(event);
}

void SegmentView::mouseMoveEvent(QMouseEvent* event) {
    if (!pressed_.isValid()) QTreeView::mouseMoveEvent(event);
}

void SegmentView::mouseReleaseEvent(QMouseEvent* event) {
    if (!pressed_.isValid()) return QTreeView::mouseReleaseEvent(event);
    const QModelIndex index = pressed_;
    pressed_ = QPersistentModelIndex();
    if (switchAt(*event) != index) return;
    const bool on = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
    model_.setData(index, on ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
}

bool SegmentView::event(QEvent* event) {
    // The window has a use for Ctrl+A too.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->matches(QKeySequence::SelectAll))
        event->accept();
    return QTreeView::event(event);
}

void SegmentView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && event->modifiers() == Qt::NoModifier && state() != EditingState) {
        emit glossyWanted();
        return;
    }
    QTreeView::keyPressEvent(event);
}

}  // namespace ui
