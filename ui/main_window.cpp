// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QActionGroup>
#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QScrollArea>
#include <QSettings>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QStatusBar>
#include <QVulkanInstance>
#include <algorithm>

#include "core/analysis/notes.h"
#include "core/scene/changes.h"
#include "gpu/error.h"
#include "gpu/instance.h"
#include "render/analysis/gpu_analysis_kernels.h"
#include "render/kernels/brdf_check.h"
#include "ui/canvas/mask_painter.h"
#include "ui/canvas/substance_ruler.h"
#include "ui/panels/registry.h"
#include "ui/start_page.h"
#include "ui/tools/tool_box.h"
#include "ui/vulkan_support.h"
#include "ui/widgets/notice_button.h"
#include "ui/words.h"

namespace ui {

MainWindow::MainWindow(const WindowOptions& options, QWidget* parent) : QMainWindow(parent), options_(options) {
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    if (options_.device.isEmpty() && !qEnvironmentVariableIsSet("PATINA_DEVICE")) {
        options_.device = QSettings().value(QStringLiteral("device")).toString();
    }
    QString problem = tr("The canvas is disabled.");
    if (options_.canvas) {
        try {
            vulkan_ = createVulkanInstance(problem);
        } catch (const gpu::Error& error) {
            problem = translated(error);
        }
    }
    canvas_ = new Canvas(vulkan_.get(), problem, options_.device, this);
    makeCentral();
    painter_ = new MaskPainter(workspace_, *canvas_, this);
    ruler_ = new SubstanceRuler(workspace_, *canvas_, this);
    toolBox_ = new ToolBox(workspace_, *canvas_, this);

    makeActions();
    makeStatusBar();
    makeDocks();
    makeToolBar();
    toolBox_->addBars(*this);

    if (options_.canvas) {
        core::setUserBrdfCheck(render::userBrdfCheck(options_.device.toStdString()));
        worker_.setKernels([wish = options_.device.toStdString()] {
            return render::createAnalysisKernels(render::analysisTwinFromEnvironment(), wish);
        });
    }
    connect(&workspace_, &Workspace::sceneChanged, this, &MainWindow::sceneChanged);
    connect(&workspace_, &Workspace::documentReplaced, this, &MainWindow::documentReplaced);
    connect(&workspace_, &Workspace::selectionChanged, canvas_, &Canvas::setSelection);
    connect(&workspace_, &Workspace::analysisChanged, this, &MainWindow::updateActions);
    connect(&worker_, &AnalysisWorker::finished, this, &MainWindow::analysisFinished);
    connect(&worker_, &AnalysisWorker::progress, this, [this](const QString& step, double fraction) {
        if (!analysing_) return;
        analysisStep_ = tr("Analysing: %1, %2 %").arg(step).arg(static_cast<int>(fraction * 100));
        updateProgress();
    });
    connect(&worker_, &AnalysisWorker::failed, this, [this](quint64 generation, const QString& sentence) {
        if (generation < workspace_.analysisGeneration()) return;
        analysing_ = false;
        updateProgress();
        showError(sentence);
    });
    connect(canvas_, &Canvas::deviceReady, deviceLabel_, &QLabel::setText);
    connect(canvas_, &Canvas::progressChanged, this, &MainWindow::updateProgress);
    connect(canvas_, &Canvas::cursorMoved, this, &MainWindow::showCursor);
    connect(canvas_, &Canvas::segmentClicked, &workspace_, &Workspace::select);
    connect(canvas_, &Canvas::pixelPicked, &workspace_, &Workspace::finishPicking);
    connect(&workspace_, &Workspace::pickingChanged, this, [this] { canvas_->setPicking(workspace_.picking()); });
    connect(&toolBox_->session(), &SelectionSession::message, this,
            [this](const QString& text) { statusBar()->showMessage(text, 6000); });
    connect(&toolBox_->session(), &SelectionSession::error, this, &MainWindow::showError);
    connect(canvas_, &Canvas::failed, this, &MainWindow::canvasFailed);
    connect(canvas_, &Canvas::zoomChanged, this,
            [this](double zoom) { zoomLabel_->setText(tr("%1 %").arg(zoom * 100, 0, 'f', zoom < 0.1 ? 1 : 0)); });
    readSettings();
    // Otherwise the first number in a panel would have the focus, and with it the wheel.
    pages_->currentWidget()->setFocus();
    updateTitle();
    updateActions();
    updateProgress();
}

MainWindow::~MainWindow() {
    // Work that is still running must not call back into a half-destroyed window.
    task_.reset();
    layerTask_.reset();
    worker_.disconnect(this);
    workspace_.disconnect();
    delete toolBox_;
    delete painter_;
    delete ruler_;
    delete canvas_;
}

void MainWindow::makeCentral() {
    pages_ = new QStackedWidget(this);
    pages_->setObjectName(QStringLiteral("pages"));
    start_ = new StartPage(pages_);
    pages_->addWidget(start_);
    pages_->addWidget(canvas_);
    setCentralWidget(pages_);
    connect(start_, &StartPage::openPressed, this, &MainWindow::chooseOpen);
    connect(start_, &StartPage::recentChosen, this, &MainWindow::openRecent);
    connect(start_, &StartPage::sampleChosen, this, &MainWindow::openSample);
    connect(start_, &StartPage::recentRemoved, this, &MainWindow::refreshRecent);
}

bool MainWindow::settled() const {
    if (task_ != nullptr || analysing_ || toolBox_->session().worker().busy() ||
        toolBox_->session().changingSegments() || (layerTask_ != nullptr && layerTask_->running()))
        return false;
    if (!workspace_.hasPhoto() || !canvas_->available()) return true;
    return workspace_.analysis() != nullptr && canvas_->upToDate() && canvas_->progress().finished;
}

void MainWindow::makeStatusBar() {
    const auto add = [this](const QString& key, const QString& name, int width) {
        auto* label = new QLabel(this);
        label->setObjectName(key);
        label->setAccessibleName(name);
        label->setToolTip(name);
        if (width > 0) label->setMinimumWidth(width);
        label->setContentsMargins(6, 0, 6, 0);
        return label;
    };
    valueLabel_ = add(QStringLiteral("cursorValue"), tr("Value under the pointer"), 0);
    progressLabel_ = add(QStringLiteral("progressText"), tr("Current work"), 0);
    zoomLabel_ = add(QStringLiteral("zoomText"), tr("Zoom: screen pixels per picture pixel"), 48);
    deviceLabel_ = add(QStringLiteral("deviceName"), tr("Device in use"), 0);
    progressBar_ = new QProgressBar(this);
    progressBar_->setObjectName(QStringLiteral("progressBar"));
    progressBar_->setAccessibleName(tr("Rendering progress"));
    progressBar_->setFixedWidth(110);
    progressBar_->setMaximumHeight(14);
    progressBar_->setTextVisible(false);
    progressBar_->setRange(0, 1000);
    statusBar()->addWidget(valueLabel_, 1);
    notices_ = new NoticeButton(this);
    statusBar()->addPermanentWidget(notices_);
    statusBar()->addPermanentWidget(progressLabel_);
    statusBar()->addPermanentWidget(progressBar_);
    statusBar()->addPermanentWidget(zoomLabel_);
    statusBar()->addPermanentWidget(deviceLabel_);
}

void MainWindow::makeDocks() {
    QDockWidget* previous = nullptr;
    QDockWidget* firstOfTabs = nullptr;
    for (const PanelEntry& entry : panelRegistry()) {
        const QString key = QString::fromUtf8(entry.key);
        auto* dock = new QDockWidget(entry.translatedTitle(), this);
        dock->setObjectName(key + QStringLiteral("Dock"));
        Panel* panel = entry.make(workspace_, dock);
        panel->setObjectName(key);
        panel->setAccessibleName(entry.translatedTitle());
        auto* scroll = new QScrollArea(dock);
        scroll->setWidgetResizable(true);
        scroll->setFrameShape(QFrame::NoFrame);
        scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        scroll->setWidget(panel);
        scroll->setMinimumWidth(panel->minimumSizeHint().width() + 16);
        dock->setWidget(scroll);
        addDockWidget(entry.area, dock);
        if (entry.tabbed && previous != nullptr) tabifyDockWidget(previous, dock);
        if (!entry.tabbed && entry.area == Qt::RightDockWidgetArea) firstOfTabs = dock;
        previous = dock;
        panels_->addAction(dock->toggleViewAction());
        connect(panel, &Panel::message, this, [this](const QString& text) { statusBar()->showMessage(text, 6000); });
        connect(panel, &Panel::error, this, &MainWindow::showError);
        connect(panel, &Panel::notices, this,
                [this, key](const QStringList& sentences) { notices_->setNotices(key, sentences); });
    }
    if (firstOfTabs != nullptr) firstOfTabs->raise();
}

void MainWindow::documentReplaced() {
    layerTask_.reset();
    worker_.cancel();
    shownScene_ = {};
    shownAnalysis_.reset();
    canvas_->setPhoto(workspace_.scene().photo);
    if (pages_->currentWidget() != canvas_) {
        pages_->setCurrentWidget(canvas_);
        canvas_->setFocus();
    }
    notices_->setNotices(QStringLiteral("analysis"), {});
    updateTitle();
}

void MainWindow::sceneChanged(core::Stage stage) {
    updateTitle();
    updateActions();
    if (!workspace_.hasPhoto()) return;
    canvas_->setLabels(workspace_.scene().photo);
    if (stage <= core::Stage::Environment) {
        analysing_ = true;
        analysisStep_ = tr("Analysing");
        worker_.request(workspace_.generation(), workspace_.scene());
    } else if (!analysing_ && workspace_.analysis() != nullptr) {
        showScene(workspace_.scene(), workspace_.analysis());
    }
    updateProgress();
}

void MainWindow::showScene(const core::Scene& scene, const std::shared_ptr<const core::Analysis>& analysis) {
    core::Scene next = core::visibleScene(scene);
    next.selection.reset();
    if (next == shownScene_ && analysis == shownAnalysis_) return;
    shownScene_ = next;
    shownAnalysis_ = analysis;
    canvas_->setScene(next, analysis);
}

void MainWindow::analysisFinished(const std::shared_ptr<const AnalysisResult>& result) {
    if (result->scene.photo != workspace_.scene().photo) return;
    const bool current = result->generation >= workspace_.analysisGeneration();
    if (current) analysing_ = false;
    workspace_.setAnalysis(result->analysis);
    showScene(current ? workspace_.scene() : result->scene, result->analysis);
    refreshLayerPicture();
    updateProgress();
    if (!current) return;
    core::Notes notes = core::analysisNotes(workspace_.scene(), *result->analysis);
    notes.insert(notes.end(), result->notes.begin(), result->notes.end());
    notices_->setNotices(QStringLiteral("analysis"), translatedEach(notes));
}

void MainWindow::setLayer(ViewLayer layer) {
    layer_ = layer;
    layers_->actions().at(static_cast<int>(layer))->setChecked(true);
    const QSignalBlocker block(layerBox_);
    layerBox_->setCurrentIndex(static_cast<int>(layer));
    canvas_->setLayerPicture(nullptr);
    canvas_->setLayer(layer);
    refreshLayerPicture();
}

void MainWindow::refreshLayerPicture() {
    layerTask_.reset();
    if (layer_ == ViewLayer::Result || layer_ == ViewLayer::Original || !workspace_.hasPhoto()) return;
    auto picture = std::make_shared<std::shared_ptr<const CanvasPicture>>();
    layerTask_ = std::make_unique<BackgroundTask>([picture, layer = layer_, photo = workspace_.scene().photo,
                                                   analysis = workspace_.analysis()](const core::Progress&) {
        *picture = makeCanvasPicture(makeLayerPicture(layer, *photo, analysis.get()));
    });
    connect(layerTask_.get(), &BackgroundTask::succeeded, this,
            [this, picture] { canvas_->setLayerPicture(*picture); });
    connect(layerTask_.get(), &BackgroundTask::failed, this, &MainWindow::showError);
    layerTask_->start();
}

void MainWindow::setExposure(double stops) {
    exposureStops_ = std::clamp(stops, -10.0, 10.0);
    const QSignalBlocker block(exposureBox_);
    exposureBox_->setValue(exposureStops_);
    canvas_->setExposure(static_cast<float>(exposureStops_));
}

void MainWindow::updateTitle() {
    const core::Document& document = workspace_.document();
    const QString name = document.path().empty()
                             ? tr("Untitled")
                             : QFileInfo(QString::fromStdString(document.path())).completeBaseName();
    setWindowTitle(workspace_.hasPhoto() ? tr("%1[*] - Patina").arg(name) : tr("Patina"));
    setWindowModified(document.modified());
}

void MainWindow::updateActions() {
    const core::Document& document = workspace_.document();
    const bool photo = workspace_.hasPhoto();
    undo_->setEnabled(document.canUndo());
    redo_->setEnabled(document.canRedo());
    undo_->setText(document.canUndo() ? tr("&Undo %1").arg(QString::fromStdString(document.undoLabel())) : tr("&Undo"));
    redo_->setText(document.canRedo() ? tr("&Redo %1").arg(QString::fromStdString(document.redoLabel())) : tr("&Redo"));
    undo_->setIconText(tr("Undo"));
    redo_->setIconText(tr("Redo"));
    save_->setEnabled(photo);
    saveAs_->setEnabled(photo);
    exportPicture_->setEnabled(photo);
    exportSegmentation_->setEnabled(photo && !workspace_.scene().segments.empty());
    exportEnvironment_->setEnabled(workspace_.analysis() != nullptr && workspace_.analysis()->environment != nullptr);
}

void MainWindow::updateProgress() {
    const render::Renderer::Progress progress = canvas_->progress();
    QString text;
    int permille = 0;
    bool shown = true;
    if (!workspace_.hasPhoto()) {
        shown = false;
    } else if (analysing_) {
        text = analysisStep_;
        shown = false;
    } else if (progress.finished) {
        text = progress.target > 0 ? tr("Finished, %1 samples").arg(progress.samples) : tr("Finished");
        if (progress.timeUp) text = tr("Time limit, %1 of %2 samples").arg(progress.samples).arg(progress.target);
        permille = 1000;
        shown = false;
    } else if (progress.target > 0) {
        text = (canvas_->refining() ? tr("%1 of %2 samples") : tr("Paused, %1 of %2 samples"))
                   .arg(progress.samples)
                   .arg(progress.target);
        permille = static_cast<int>(progress.fraction * 1000);
    } else {
        shown = false;
    }
    progressLabel_->setText(text);
    progressBar_->setValue(permille);
    progressBar_->setVisible(shown);
}

void MainWindow::showCursor(const CursorValue& value) {
    if (!value.inside || !workspace_.hasPhoto()) {
        valueLabel_->clear();
        return;
    }
    const core::Scene& scene = workspace_.scene();
    const core::Photo& photo = *scene.photo;
    if (!photo.color.contains(value.x, value.y)) return;
    const auto rgb = [](const core::Vector3f& c) {
        return QStringLiteral("%1 %2 %3")
            .arg(static_cast<double>(c.x()), 0, 'f', 3)
            .arg(static_cast<double>(c.y()), 0, 'f', 3)
            .arg(static_cast<double>(c.z()), 0, 'f', 3);
    };
    const core::Vector3f& original = photo.color(value.x, value.y);
    QString text = tr("(%1, %2)   %3").arg(value.x).arg(value.y).arg(rgb(original));
    if (value.hasResult && !value.result.isApprox(original, 1e-3f)) text += tr("  →  %1").arg(rgb(value.result));
    const float z = photo.depth.contains(value.x, value.y) ? photo.depth(value.x, value.y) : 0.0f;
    text += z > 0 ? tr("   %1 m").arg(static_cast<double>(z), 0, 'f', 3) : tr("   no depth");
    const std::uint16_t label =
        photo.labels.contains(value.x, value.y) ? photo.labels(value.x, value.y) : std::uint16_t{0};
    if (const core::Segment* segment = scene.findSegment(label))
        text += QStringLiteral("   ") + QString::fromStdString(segment->name);
    valueLabel_->setText(text);
}

void MainWindow::canvasFailed(const QString& sentence) {
    deviceLabel_->setText(tr("No device"));
    statusBar()->showMessage(sentence, 10000);
}

void MainWindow::showError(const QString& sentence) {
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Patina"), sentence, QMessageBox::Ok, this);
    box->setObjectName(QStringLiteral("errorDialog"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->open();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!closing_ && workspace_.document().modified()) {
        event->ignore();
        confirmDiscard([this] {
            closing_ = true;
            close();
        });
        return;
    }
    rememberResult();
    writeSettings();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const auto urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.front().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    openFile(event->mimeData()->urls().front().toLocalFile());
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_C && event->modifiers() == Qt::NoModifier) {
        if (!event->isAutoRepeat()) canvas_->setComparing(true);
        return;
    }
    if (event->key() == Qt::Key_Escape && workspace_.picking()) {
        workspace_.pickPixel(nullptr);
        return;
    }
    // Enter and Escape are the tools' also where a list or button has the focus, but not where something is typed.
    const bool general =
        event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Escape;
    const bool typing =
        qobject_cast<QLineEdit*>(focusWidget()) != nullptr || qobject_cast<QAbstractSpinBox*>(focusWidget()) != nullptr;
    if ((focusWidget() == canvas_ || (general && !typing)) && toolBox_->pressKey(*event)) return;
    QMainWindow::keyPressEvent(event);
}

void MainWindow::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_C) {
        if (!event->isAutoRepeat()) canvas_->setComparing(false);
        return;
    }
    if (toolBox_->releaseKey(*event)) return;
    QMainWindow::keyReleaseEvent(event);
}

void MainWindow::readSettings() {
    const QSettings settings;
    if (!restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray())) resize(1440, 900);
    restoreState(settings.value(QStringLiteral("state")).toByteArray());
    refreshRecent();
}

void MainWindow::writeSettings() {
    QSettings settings;
    settings.setValue(QStringLiteral("geometry"), saveGeometry());
    settings.setValue(QStringLiteral("state"), saveState());
}

void MainWindow::chooseDevice() {
    QStringList names = {tr("Automatic")};
    try {
        for (const gpu::Adapter& adapter : gpu::Instance::create().adapters()) {
            names << QString::fromStdString(adapter.info().name);
        }
    } catch (const gpu::Error& error) {
        showError(translated(error));
        return;
    }
    QSettings settings;
    const int current =
        std::max(0, static_cast<int>(names.indexOf(settings.value(QStringLiteral("device")).toString())));
    bool accepted = false;
    const QString name = QInputDialog::getItem(this, tr("Device"), tr("Render on (takes effect after restart):"), names,
                                               current, false, &accepted);
    if (accepted) settings.setValue(QStringLiteral("device"), name == names.front() ? QString() : name);
}

}  // namespace ui
