// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <memory>
#include <string>
#include <vector>

#include "core/material/drive_parameters.h"
#include "ui/workspace.h"

class QCheckBox;
class QComboBox;
class QToolButton;
class QVBoxLayout;

namespace ui {

class BackgroundTask;
class ColorButton;
class ParamSlider;

/// The parameters that vary over the selected segment, a row for each, and the brush.
class DriveList : public QGroupBox {
    Q_OBJECT
  public:
    explicit DriveList(Workspace& workspace, QWidget* parent = nullptr);
    ~DriveList() override;

    /// Loads a picture in the background as the mask of the drive of `parameter`.
    void loadMask(const QString& parameter, const QString& path);

  signals:
    void message(const QString& text);
    void error(const QString& sentence);
    /// The user added a parameter; `row` has its controls.
    void rowAdded(QWidget* row);

  private:
    struct Row {
        std::string parameter;
        core::DriveParameter info;
        QWidget* widget = nullptr;
        QComboBox* source = nullptr;
        QToolButton* paint = nullptr;
        ParamSlider* from = nullptr;  ///< scalars
        ParamSlider* to = nullptr;
        ColorButton* fromColor = nullptr;  ///< colours
        ColorButton* toColor = nullptr;
        ParamSlider* strength = nullptr;
        QCheckBox* invert = nullptr;
    };
    void makeBrush(QVBoxLayout* layout);
    void refresh();
    void rebuild(const core::Material& material);
    Row makeRow(const core::DriveParameter& parameter);
    void makeEnds(Row& row, QVBoxLayout* layout);
    void fillSources(Row& row, const core::Material& material) const;
    void show(Row& row, const core::Drive& drive, const core::Material& material, const core::Vector3f& estimated);
    void add(const std::string& parameter);
    void chooseSource(const std::string& parameter, const QString& source);
    void chooseImage(const std::string& parameter);
    void edit(const QString& label, const std::string& parameter, const std::function<void(core::Drive&)>& change,
              const QString& mergeKey = {});
    [[nodiscard]] std::shared_ptr<const core::Mask> emptyMask() const;
    /// Makes the drive follow a mask; a drive without ends gets ends that are visible.
    void follow(core::Drive& drive, std::shared_ptr<const core::Mask> mask) const;
    void setPainting(const std::string& parameter);
    [[nodiscard]] const core::Material* material() const;

    Workspace& workspace_;
    QComboBox* add_ = nullptr;
    QVBoxLayout* rowLayout_ = nullptr;
    QWidget* brush_ = nullptr;
    ParamSlider* radius_ = nullptr;
    ParamSlider* hardness_ = nullptr;
    ParamSlider* strength_ = nullptr;
    QCheckBox* erase_ = nullptr;
    std::string rowsOf_;  ///< BRDF and drives that the rows were made for
    std::vector<Row> rows_;
    std::unique_ptr<BackgroundTask> loading_;
};

}  // namespace ui
