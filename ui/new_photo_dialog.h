// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <memory>

#include "core/io/photo_contents.h"
#include "core/io/project.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTimer;

namespace ui {

class BackgroundTask;

/// Asks for the files of a new project: photograph, depth and how it is stored, segments, field of view. Says what it
/// finds in the photograph. Stays open until the project is loaded: whoever shows it loads at `chosen`, then closes it
/// or calls `showProblem`.
class NewPhotoDialog : public QDialog {
    Q_OBJECT
  public:
    explicit NewPhotoDialog(QWidget* parent = nullptr);
    ~NewPhotoDialog() override;

    void setColorFile(const QString& path);
    [[nodiscard]] core::CreateOptions options() const;
    /// Says why the project cannot be made.
    void showProblem(const QString& sentence);

  signals:
    /// The user pressed OK.
    void chosen();

  private:
    QLineEdit* addFileRow(QFormLayout& form, const QString& key, const QString& label, const QString& toolTip,
                          const QString& filter);
    void makeDepthRows(QFormLayout& form);
    void updateOk();
    /// Looks into the photograph in the background, once more when it has changed meanwhile.
    void inspect();
    void showContents();
    [[nodiscard]] QString contentsText() const;

    QLineEdit* color_ = nullptr;
    QLineEdit* depth_ = nullptr;
    QLineEdit* segments_ = nullptr;
    QComboBox* depthKind_ = nullptr;
    QDoubleSpinBox* depthUnit_ = nullptr;
    QDoubleSpinBox* fieldOfView_ = nullptr;
    QLabel* found_ = nullptr;
    QLabel* problem_ = nullptr;
    QPushButton* ok_ = nullptr;
    QTimer* typing_ = nullptr;  ///< runs while the path may still change
    std::unique_ptr<BackgroundTask> inspection_;
    QString inspected_;                            ///< path of `contents_` or of the running inspection
    std::optional<core::PhotoContents> contents_;  ///< nullopt: unknown, or not a photograph
    QString contentsProblem_;
};

}  // namespace ui
