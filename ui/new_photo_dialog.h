// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <memory>
#include <optional>
#include <vector>

#include "core/io/depth_beside.h"
#include "core/io/photo_contents.h"
#include "core/io/project.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTimer;
class QToolButton;

namespace ui {

class BackgroundTask;
class DepthView;
struct DepthPoints;

/// Opens a photograph: says what is in its file, shows its depth in space, and has a switch for everything that may be
/// read wrongly. The files are read once, in the background. Stays open until the project is loaded: whoever shows it
/// loads at `chosen`, then closes it or calls `showProblem`.
class NewPhotoDialog : public QDialog {
    Q_OBJECT
  public:
    explicit NewPhotoDialog(QWidget* parent = nullptr);
    ~NewPhotoDialog() override;

    void setColorFile(const QString& path);
    [[nodiscard]] core::CreateOptions options() const;
    /// The files of `options`, colour included; nullptr when they could not be read.
    [[nodiscard]] std::shared_ptr<const core::PhotoFiles> files() const;
    /// Says why the project cannot be made.
    void showProblem(const QString& sentence);
    /// Whether everything that is shown belongs to what was entered.
    [[nodiscard]] bool upToDate() const;

  signals:
    /// The user pressed Open, and the files have been read.
    void chosen();

  private:
    /// What the dialog shows, apart from the segments.
    struct Query {
        QString color;
        QString depth;
        std::optional<core::DepthKind> kind;
        std::optional<double> unit;  ///< [m]
        std::optional<float> hfov;   ///< [rad]
        bool operator==(const Query&) const = default;
    };
    struct Findings;
    /// Both sides of the last exchange of near and far, so that a second one takes it back exactly.
    struct Exchange {
        std::optional<core::DepthKind> kindBefore;
        double unitBefore = 0;  ///< as in `depthUnit_`: 0 = automatic
        std::optional<core::DepthKind> kindAfter;
        double unitAfter = 0;
    };

    QLineEdit* addFileRow(QFormLayout& form, const QString& key, const QString& label, const QString& toolTip,
                          const QString& filter);
    QWidget* makeSwitches();
    void makeDepthRows(QFormLayout& form);
    QWidget* makeMore();
    QWidget* makeView();
    [[nodiscard]] Query query() const;
    /// Where the dialog that chooses this file starts: at the file, or beside the photograph.
    [[nodiscard]] QString startOf(const QLineEdit& edit) const;
    /// Forgets what the user said about the photograph before.
    void colorChanged();
    void exchangeNearAndFar();
    /// Starts looking in the background unless that is done or still going on.
    void refresh();
    void take(const std::shared_ptr<const Findings>& findings);
    void showFindings(const Findings& findings);
    void showNothing(const QString& sentence);
    void pressOpen();
    [[nodiscard]] QString contentsText(const Findings& findings) const;
    [[nodiscard]] static QString depthText(const Findings& findings);
    static Findings look(const Query& query, const std::shared_ptr<const Findings>& before);
    static void readFiles(Findings& findings, const std::shared_ptr<const Findings>& before);
    static void interpret(Findings& findings);

    QLineEdit* color_ = nullptr;
    QLineEdit* depth_ = nullptr;
    QLineEdit* segments_ = nullptr;
    QComboBox* depthKind_ = nullptr;
    QPushButton* exchange_ = nullptr;
    QDoubleSpinBox* depthUnit_ = nullptr;
    QDoubleSpinBox* fieldOfView_ = nullptr;
    QLabel* found_ = nullptr;
    DepthView* view_ = nullptr;
    std::vector<QToolButton*> viewButtons_;  ///< the sides it can be seen from
    QLabel* depthText_ = nullptr;
    QProgressBar* reading_ = nullptr;
    QLabel* problem_ = nullptr;
    QPushButton* open_ = nullptr;
    QTimer* typing_ = nullptr;  ///< runs while what was entered may still change
    std::unique_ptr<BackgroundTask> task_;
    std::shared_ptr<const Findings> findings_;  ///< the latest; nullptr = none yet
    std::optional<core::DepthKind> kind_;       ///< as the user chose it
    std::optional<core::DepthBeside> beside_;   ///< the map that was entered by itself
    std::optional<Exchange> exchanged_;
    bool opening_ = false;  ///< Open was pressed while the files are being read
};

}  // namespace ui
