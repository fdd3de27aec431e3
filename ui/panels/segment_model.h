// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/label_table.h"
#include "core/scene/scene.h"
#include "core/scene/segment_areas.h"
#include "ui/panels/segment_thumbnails.h"

namespace ui {

/// The segments of a scene as rows, sorted by any column. It changes nothing itself: what the user edits is emitted.
class SegmentModel : public QAbstractTableModel {
    Q_OBJECT
  public:
    enum Column { kName, kGlossy, kEdited, kArea, kVisible, kLocked, kColumnCount };
    static constexpr int kLabelRole = Qt::UserRole;

    explicit SegmentModel(QObject* parent = nullptr);

    /// Brings the rows up to date. Where the segments are the same, selection and editors stay.
    void setScene(const core::Scene& scene);

    /// Row of a segment, in column kName; invalid for an unknown label.
    [[nodiscard]] QModelIndex indexOf(std::uint16_t label) const;
    [[nodiscard]] std::uint16_t labelAt(int row) const;
    /// Columns in which a click switches something.
    [[nodiscard]] static bool isSwitch(int column);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    /// By label for column -1.
    void sort(int column, Qt::SortOrder order) override;

    [[nodiscard]] QStringList mimeTypes() const override;
    [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
    [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::CopyAction; }
    [[nodiscard]] bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                       const QModelIndex& parent) const override;
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

  signals:
    void renamed(quint16 label, const QString& name);
    /// `column` is one of the switches.
    void switched(quint16 label, int column, bool on);
    void segmentsDropped(const std::vector<std::uint16_t>& dragged, quint16 target);
    void filesDropped(const QStringList& paths);

  private:
    struct Row {
        std::uint16_t label = 0;
        QString name;
        bool glossy = false, visible = true, locked = false, edited = false;
        core::SegmentExtent extent;
        bool operator==(const Row&) const = default;
    };
    [[nodiscard]] const Row& at(int row) const { return rows_[order_[static_cast<std::size_t>(row)]]; }
    [[nodiscard]] QVariant text(const Row& row, int column) const;
    [[nodiscard]] QVariant toolTip(const Row& row, int column) const;
    [[nodiscard]] QString share(std::size_t pixels) const;
    /// Whether two rows may have another order in the sorted column.
    [[nodiscard]] bool sortsDifferently(const Row& a, const Row& b) const;
    void sortRows();
    void sortKeepingSelection();
    /// Labels of a drag that began in this list.
    [[nodiscard]] std::vector<std::uint16_t> draggedLabels(const QMimeData& data) const;

    std::shared_ptr<const core::Photo> photo_;
    core::LabelTable<core::SegmentExtent> extents_;
    std::vector<Row> rows_;             ///< by label
    std::vector<std::uint32_t> order_;  ///< index into `rows_` of each row shown
    std::vector<std::uint32_t> place_;  ///< the inverse
    int sortColumn_ = -1;
    Qt::SortOrder sortOrder_ = Qt::AscendingOrder;
    mutable SegmentThumbnails thumbnails_;
};

}  // namespace ui
