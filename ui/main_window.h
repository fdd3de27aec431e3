// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <functional>
#include <memory>

#include "core/io/moved_files.h"
#include "core/io/project.h"
#include "core/scene/changes.h"
#include "ui/analysis_worker.h"
#include "ui/background_task.h"
#include "ui/canvas/canvas.h"
#include "ui/workspace.h"

class QActionGroup;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QProgressDialog;
class QStackedWidget;
class QVulkanInstance;

namespace ui {

class MaskPainter;
class NewPhotoDialog;
class NoticeButton;
class StartPage;
class SubstanceRuler;
class ToolBox;

struct WindowOptions {
    bool canvas = true;  ///< false: no Vulkan is touched (tests of everything else)
    QString device;      ///< part of the device's name or its index; "" = settings, then the usual rule
};

/// The application's window: menus, canvas, panels, files. Nothing long runs on its thread.
class MainWindow : public QMainWindow {
    Q_OBJECT
  public:
    explicit MainWindow(const WindowOptions& options = {}, QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] Workspace& workspace() { return workspace_; }
    [[nodiscard]] Canvas& canvas() { return *canvas_; }
    [[nodiscard]] ToolBox& toolBox() { return *toolBox_; }
    /// Whether everything the window shows is up to date: analysis, accumulation, no file operation running.
    [[nodiscard]] bool settled() const;
    /// Whether a file is being read or written.
    [[nodiscard]] bool working() const { return task_ != nullptr; }

  public slots:
    /// Opens a project in the background; a picture opens the dialog for a new one. Asks first when changes would be
    /// lost.
    void openFile(const QString& path);
    /// `dialog`, if any, is closed when the project is loaded and says why it is not otherwise.
    void createFrom(const core::CreateOptions& options, ui::NewPhotoDialog* dialog = nullptr);
    /// Opens a bundled project as a new one, so that saving asks for a place.
    void openSample(const QString& path);
    void saveTo(const QString& path, std::function<void()> then = {});
    /// Renders the scene to its sample count with a device of its own and saves it: the bytes patina-cli writes for the
    /// same project, samples and seed.
    void exportPicture(const QString& path);
    void exportSegmentation(const QString& path);
    void exportEnvironment(const QString& path);
    void showError(const QString& sentence);

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

  private:
    void makeActions();
    void makeFileMenu();
    void makeEditMenu();
    void makeSelectMenu();
    void makeViewMenu();
    void makeHelpMenu();
    void makeToolBar();
    void makeStatusBar();
    void makeDocks();
    QAction* addAction(QMenu* menu, const QString& key, const QString& text, const QKeySequence& shortcut,
                       const QString& help, const std::function<void()>& run);

    void sceneChanged(core::Stage stage);
    /// Hands the scene to the canvas if it renders differently from the one before.
    void showScene(const core::Scene& scene, const std::shared_ptr<const core::Analysis>& analysis);
    void analysisFinished(const std::shared_ptr<const AnalysisResult>& result);
    void documentReplaced();
    void setLayer(ViewLayer layer);
    void refreshLayerPicture();
    void setExposure(double stops);
    void updateTitle();
    void updateActions();
    void updateProgress();
    void showCursor(const CursorValue& value);
    void canvasFailed(const QString& sentence);

    void chooseNew(const QString& colorFile = {});
    void chooseOpen();
    void save(std::function<void()> then = {});
    void saveAs(std::function<void()> then = {});
    /// Asks where to save, beside the photograph first; `name` is proposed.
    void chooseFile(const QString& key, const QString& title, const QString& name, const QString& filter,
                    std::function<void(const QString&)> use);
    /// Keeps the picture of a project that is about to be closed, as the start page shows it.
    void rememberResult();
    void chooseExport(const QString& title, const QString& name, const QString& filter,
                      void (MainWindow::*write)(const QString&));
    /// Runs long work with a progress dialog; one piece at a time. `failed` is called instead of showing the error;
    /// `parent` is the window that waits.
    void runTask(const QString& title, BackgroundTask::Work work, std::function<void()> succeeded,
                 std::function<void(const QString&)> failed = {}, QWidget* parent = nullptr);
    void endTask();
    /// Calls `proceed` at once, or after the user has decided what becomes of unsaved changes.
    void confirmDiscard(std::function<void()> proceed);
    using LoadScene = std::function<core::Scene(core::Notes*, const core::Progress&)>;
    /// How a scene is opened and what follows.
    struct Opening {
        QString title;
        LoadScene load;
        QString path = {};  ///< of the project; "" = a new one
        QString file = {};  ///< the recent file whose picture this is; "" = none
        std::function<void()> opened = {};
        std::function<void(const QString&)> failed = {};
        QWidget* parent = nullptr;
    };
    void openScene(Opening opening);
    void openProject(const QString& path, const core::MovedFiles& moved);
    /// Asks for one of the files that a project misses, finds the others beside it and opens the project.
    void locateFiles(const QString& path, const core::MovedFiles& moved, const std::vector<std::string>& missing);
    /// The start page until something is open, then the canvas.
    void makeCentral();
    void openRecent(const QString& path);
    void refreshRecent();
    void readSettings();
    void writeSettings();
    void showManual();
    void showAbout();
    void chooseDevice();

    WindowOptions options_;
    std::unique_ptr<QVulkanInstance> vulkan_;  ///< outlives the canvas
    Workspace workspace_;
    AnalysisWorker worker_;
    QStackedWidget* pages_ = nullptr;
    StartPage* start_ = nullptr;
    Canvas* canvas_ = nullptr;
    MaskPainter* painter_ = nullptr;
    SubstanceRuler* ruler_ = nullptr;
    ToolBox* toolBox_ = nullptr;
    std::unique_ptr<BackgroundTask> task_;
    std::unique_ptr<BackgroundTask> layerTask_;
    QProgressDialog* progressDialog_ = nullptr;
    core::Scene shownScene_;  ///< on the canvas
    std::shared_ptr<const core::Analysis> shownAnalysis_;
    bool analysing_ = false;
    QString analysisStep_;
    bool closing_ = false;
    ViewLayer layer_ = ViewLayer::Result;
    double exposureStops_ = 0;

    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
    QAction* save_ = nullptr;
    QAction* saveAs_ = nullptr;
    QAction* exportPicture_ = nullptr;
    QAction* exportSegmentation_ = nullptr;
    QAction* exportEnvironment_ = nullptr;
    QActionGroup* layers_ = nullptr;
    QMenu* recent_ = nullptr;
    QMenu* panels_ = nullptr;
    QComboBox* layerBox_ = nullptr;
    QDoubleSpinBox* exposureBox_ = nullptr;
    QLabel* deviceLabel_ = nullptr;
    QLabel* zoomLabel_ = nullptr;
    QLabel* valueLabel_ = nullptr;
    QLabel* progressLabel_ = nullptr;
    NoticeButton* notices_ = nullptr;
    QProgressBar* progressBar_ = nullptr;
};

}  // namespace ui
