// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "core/io/project.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QPushButton;

namespace ui {

/// Asks for the files of a new project: photograph, depth and how it is stored, segments, field of view.
class NewPhotoDialog : public QDialog {
    Q_OBJECT
  public:
    explicit NewPhotoDialog(QWidget* parent = nullptr);

    void setColorFile(const QString& path);
    [[nodiscard]] core::CreateOptions options() const;

  private:
    QLineEdit* addFileRow(QFormLayout& form, const QString& key, const QString& label, const QString& toolTip,
                          const QString& filter);
    void updateOk();

    QLineEdit* color_ = nullptr;
    QLineEdit* depth_ = nullptr;
    QLineEdit* segments_ = nullptr;
    QComboBox* depthKind_ = nullptr;
    QDoubleSpinBox* depthUnit_ = nullptr;
    QDoubleSpinBox* fieldOfView_ = nullptr;
    QPushButton* ok_ = nullptr;
};

}  // namespace ui
