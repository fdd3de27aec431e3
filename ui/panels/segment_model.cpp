// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/segment_model.h"

#include <QCollator>
#include <QGuiApplication>
#include <QLocale>
#include <QMimeData>
#include <QPalette>
#include <QUrl>
#include <algorithm>
#include <numeric>

#include "ui/widgets/line_icon.h"

namespace ui {

namespace {
const QString kSegmentsMime = QStringLiteral("application/x-patina-segments");

QStringList localFiles(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile()) paths << url.toLocalFile();
    return paths;
}
}  // namespace

SegmentModel::SegmentModel(QObject* parent) : QAbstractTableModel(parent) {}

bool SegmentModel::isSwitch(int column) { return column == kGlossy || column == kVisible || column == kLocked; }

void SegmentModel::setScene(const core::Scene& scene) {
    const bool otherPhoto = scene.photo != photo_;
    photo_ = scene.photo;
    if (otherPhoto) extents_ = photo_ ? core::segmentExtents(photo_->labels) : core::LabelTable<core::SegmentExtent>();
    std::vector<Row> rows;
    rows.reserve(scene.segments.size());
    for (const core::Segment& s : scene.segments)
        rows.push_back({s.label, QString::fromStdString(s.name), s.glossy, s.visible, s.locked, s.edit.has_value(),
                        extents_[s.label]});
    if (!std::ranges::equal(rows, rows_, {}, &Row::label, &Row::label)) {
        beginResetModel();
        rows_ = std::move(rows);
        sortRows();
        endResetModel();
        return;
    }
    int first = rowCount(), last = -1;
    bool reorder = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i] == rows_[i]) continue;
        reorder = reorder || sortsDifferently(rows[i], rows_[i]);
        first = std::min(first, static_cast<int>(place_[i]));
        last = std::max(last, static_cast<int>(place_[i]));
    }
    rows_ = std::move(rows);
    if (last >= 0) emit dataChanged(index(first, 0), index(last, kColumnCount - 1));
    if (reorder) sortKeepingSelection();
}

bool SegmentModel::sortsDifferently(const Row& a, const Row& b) const {
    switch (sortColumn_) {
        case kName:
            return a.name != b.name;
        case kArea:
            return a.extent.pixels != b.extent.pixels;
        case kGlossy:
            return a.glossy != b.glossy;
        case kVisible:
            return a.visible != b.visible;
        case kLocked:
            return a.locked != b.locked;
        case kEdited:
            return a.edited != b.edited;
        default:
            return false;
    }
}

void SegmentModel::sortRows() {
    order_.resize(rows_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    const auto sortBy = [this](const auto& value) {
        if (sortOrder_ == Qt::AscendingOrder)
            std::ranges::stable_sort(order_, std::less(), value);
        else
            std::ranges::stable_sort(order_, std::greater(), value);
    };
    const auto sortByFlag = [&](bool Row::*flag) { sortBy([this, flag](std::uint32_t i) { return rows_[i].*flag; }); };
    if (sortColumn_ == kName) {
        QCollator collator;
        collator.setNumericMode(true);
        collator.setCaseSensitivity(Qt::CaseInsensitive);
        std::vector<QCollatorSortKey> keys;
        keys.reserve(rows_.size());
        for (const Row& row : rows_) keys.push_back(collator.sortKey(row.name));
        const bool ascending = sortOrder_ == Qt::AscendingOrder;
        std::ranges::stable_sort(order_, [&](std::uint32_t a, std::uint32_t b) {
            return ascending ? keys[a] < keys[b] : keys[b] < keys[a];
        });
    } else if (sortColumn_ == kArea) {
        sortBy([this](std::uint32_t i) { return rows_[i].extent.pixels; });
    } else if (sortColumn_ == kGlossy) {
        sortByFlag(&Row::glossy);
    } else if (sortColumn_ == kVisible) {
        sortByFlag(&Row::visible);
    } else if (sortColumn_ == kLocked) {
        sortByFlag(&Row::locked);
    } else if (sortColumn_ == kEdited) {
        sortByFlag(&Row::edited);
    }
    place_.resize(order_.size());
    for (std::size_t row = 0; row < order_.size(); ++row) place_[order_[row]] = static_cast<std::uint32_t>(row);
}

void SegmentModel::sortKeepingSelection() {
    emit layoutAboutToBeChanged({}, VerticalSortHint);
    const QModelIndexList before = persistentIndexList();
    std::vector<std::uint16_t> labels;
    labels.reserve(static_cast<std::size_t>(before.size()));
    for (const QModelIndex& each : before) labels.push_back(labelAt(each.row()));
    sortRows();
    QModelIndexList after;
    after.reserve(before.size());
    for (qsizetype i = 0; i < before.size(); ++i)
        after << indexOf(labels[static_cast<std::size_t>(i)]).siblingAtColumn(before[i].column());
    changePersistentIndexList(before, after);
    emit layoutChanged({}, VerticalSortHint);
}

void SegmentModel::sort(int column, Qt::SortOrder order) {
    sortColumn_ = column;
    sortOrder_ = order;
    sortKeepingSelection();
}

QModelIndex SegmentModel::indexOf(std::uint16_t label) const {
    const auto found = std::ranges::lower_bound(rows_, label, {}, &Row::label);
    if (found == rows_.end() || found->label != label) return {};
    return index(static_cast<int>(place_[static_cast<std::size_t>(found - rows_.begin())]), kName);
}

std::uint16_t SegmentModel::labelAt(int row) const {
    return row >= 0 && row < rowCount() ? at(row).label : std::uint16_t{0};
}

int SegmentModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int SegmentModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumnCount; }

QString SegmentModel::share(std::size_t pixels) const {
    const double percent =
        100 * static_cast<double>(pixels) / static_cast<double>(std::max<std::size_t>(1, photo_->labels.size()));
    if (percent < 0.1) return tr("<%1 %").arg(QLocale().toString(0.1, 'f', 1));
    return tr("%1 %").arg(QLocale().toString(percent, 'f', percent < 10 ? 1 : 0));
}

QVariant SegmentModel::text(const Row& row, int column) const {
    if (column == kName) return row.name;
    if (column == kArea) return share(row.extent.pixels);
    if (column == kEdited && row.edited) return QStringLiteral("●");
    return {};
}

QVariant SegmentModel::toolTip(const Row& row, int column) const {
    switch (column) {
        case kName:
            return tr("Segment %1, label %2").arg(row.name).arg(row.label);
        case kGlossy:
            return tr("Treat the segment's colours as reflections");
        case kEdited:
            return row.edited ? tr("Has a new material") : tr("Unchanged");
        case kArea:
            return tr("%1 of %2 pixels")
                .arg(QLocale().toString(static_cast<qulonglong>(row.extent.pixels)))
                .arg(QLocale().toString(static_cast<qulonglong>(photo_->labels.size())));
        case kVisible:
            return row.visible ? tr("Its new material is shown. Click to hide it.")
                               : tr("It is shown as photographed; its material is kept. Click to show it.");
        case kLocked:
            return row.locked ? tr("Its pixels cannot be changed. Click to unlock it.")
                              : tr("Click to protect its pixels from changes.");
        default:
            return {};
    }
}

QVariant SegmentModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const Row& row = at(index.row());
    const int column = index.column();
    const auto check = [](bool on) { return on ? Qt::Checked : Qt::Unchecked; };
    switch (role) {
        case kLabelRole:
            return row.label;
        case Qt::DisplayRole:
        case Qt::EditRole:
            return text(row, column);
        case Qt::ToolTipRole:
            return toolTip(row, column);
        case Qt::DecorationRole:
            if (column == kName) return thumbnails_.find(*photo_, row.label, row.extent, qGuiApp->devicePixelRatio());
            return {};
        case Qt::CheckStateRole:
            if (column == kGlossy) return check(row.glossy);
            if (column == kVisible) return check(row.visible);
            if (column == kLocked) return check(row.locked);
            return {};
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(column == kArea   ? Qt::AlignRight | Qt::AlignVCenter
                                       : column == kName ? Qt::AlignLeft | Qt::AlignVCenter
                                                         : Qt::Alignment(Qt::AlignCenter));
        case Qt::ForegroundRole:
            if (!row.visible) return QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text);
            return {};
        case Qt::AccessibleTextRole:
            if (isSwitch(column)) return headerData(column, Qt::Horizontal, Qt::AccessibleTextRole);
            return text(row, column);
        default:
            return {};
    }
}

QVariant SegmentModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    const QString names[kColumnCount] = {tr("Segment"), tr("Glossy"),  tr("Edited"),
                                         tr("Area"),    tr("Visible"), tr("Locked")};
    const QString toolTips[kColumnCount] = {tr("Sort by name"),
                                            tr("Glossy segments show reflections, from which the light is recovered."),
                                            tr("Segments with a new material"),
                                            tr("Share of the picture"),
                                            tr("Whether the new material is shown"),
                                            tr("Whether the pixels are protected")};
    const bool pictogram = section == kVisible || section == kLocked;
    switch (role) {
        case Qt::DisplayRole:
            if (section == kEdited) return QStringLiteral("●");
            return pictogram ? QVariant() : names[section];
        case Qt::DecorationRole:
            if (pictogram) return lineIcon(section == kVisible ? icons::kShown : icons::kLocked).pixmap(16, 16);
            return {};
        case Qt::ToolTipRole:
            return toolTips[section];
        case Qt::AccessibleTextRole:
            return names[section];
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(section == kName ? Qt::AlignLeft | Qt::AlignVCenter
                                                        : Qt::Alignment(Qt::AlignCenter));
        default:
            return {};
    }
}

Qt::ItemFlags SegmentModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::ItemIsDropEnabled;
    Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsDragEnabled | Qt::ItemIsDropEnabled |
                          Qt::ItemNeverHasChildren;
    if (index.column() == kName) flags |= Qt::ItemIsEditable;
    if (isSwitch(index.column())) flags |= Qt::ItemIsUserCheckable;
    return flags;
}

bool SegmentModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || index.row() >= rowCount()) return false;
    const std::uint16_t label = labelAt(index.row());
    if (role == Qt::EditRole && index.column() == kName)
        emit renamed(label, value.toString().trimmed());
    else if (role == Qt::CheckStateRole && isSwitch(index.column()))
        emit switched(label, index.column(), value.toInt() == Qt::Checked);
    else
        return false;
    return true;
}

QStringList SegmentModel::mimeTypes() const { return {kSegmentsMime, QStringLiteral("text/uri-list")}; }

QMimeData* SegmentModel::mimeData(const QModelIndexList& indexes) const {
    // The address tells this list's drags from those of other windows.
    QByteArray bytes = QByteArray::number(reinterpret_cast<quintptr>(this));
    for (const QModelIndex& each : indexes)
        if (each.column() == kName) bytes += ' ' + QByteArray::number(labelAt(each.row()));
    auto* data = new QMimeData;
    data->setData(kSegmentsMime, bytes);
    return data;
}

std::vector<std::uint16_t> SegmentModel::draggedLabels(const QMimeData& data) const {
    QList<QByteArray> words = data.data(kSegmentsMime).split(' ');
    std::vector<std::uint16_t> labels;
    if (words.takeFirst().toULongLong() != reinterpret_cast<quintptr>(this)) return labels;
    for (const QByteArray& word : words) labels.push_back(word.toUShort());
    return labels;
}

bool SegmentModel::canDropMimeData(const QMimeData* data, Qt::DropAction, int, int, const QModelIndex& parent) const {
    if (photo_ == nullptr) return false;
    if (!localFiles(*data).isEmpty()) return true;
    const std::vector<std::uint16_t> dragged = draggedLabels(*data);
    return parent.isValid() && !dragged.empty() && std::ranges::count(dragged, labelAt(parent.row())) == 0;
}

bool SegmentModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                const QModelIndex& parent) {
    if (!canDropMimeData(data, action, row, column, parent)) return false;
    if (const QStringList paths = localFiles(*data); !paths.isEmpty())
        emit filesDropped(paths);
    else
        emit segmentsDropped(draggedLabels(*data), labelAt(parent.row()));
    return true;
}

}  // namespace ui
