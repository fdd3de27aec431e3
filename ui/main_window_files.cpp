// SPDX-License-Identifier: GPL-3.0-or-later
// Files of MainWindow: everything that reads or writes, off the window's thread.
#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPointer>
#include <QProgressDialog>
#include <QPushButton>
#include <QRegularExpression>
#include <QStatusBar>
#include <algorithm>
#include <utility>

#include "core/analysis/pipeline.h"
#include "core/io/image_io.h"
#include "core/io/project.h"
#include "gpu/adapter.h"
#include "gpu/instance.h"
#include "render/analysis/gpu_analysis_kernels.h"
#include "render/renderer.h"
#include "ui/main_window.h"
#include "ui/new_photo_dialog.h"
#include "ui/recent_files.h"
#include "ui/start_page.h"
#include "ui/widgets/notice_button.h"
#include "ui/words.h"

namespace ui {

namespace {
/// Share of the time to open a file that reading takes; converting the picture for the canvas takes the rest.
constexpr float kLoadedEnd = 0.95f;

}  // namespace

void MainWindow::runTask(const QString& title, BackgroundTask::Work work, std::function<void()> succeeded,
                         std::function<void(const QString&)> failed, QWidget* parent) {
    if (task_ != nullptr) {
        statusBar()->showMessage(tr("Please wait until the current task has finished."), 4000);
        return;
    }
    // Busy until the first step is done, because reading a picture does not say how far it is.
    progressDialog_ = new QProgressDialog(title, tr("Cancel"), 0, 0, parent != nullptr ? parent : this);
    progressDialog_->setObjectName(QStringLiteral("progressDialog"));
    progressDialog_->setWindowTitle(tr("Patina"));
    progressDialog_->setWindowModality(Qt::WindowModal);
    progressDialog_->setMinimumDuration(500);
    progressDialog_->setAutoClose(false);
    progressDialog_->setAutoReset(false);
    progressDialog_->setValue(0);
    task_ = std::make_unique<BackgroundTask>(std::move(work));
    connect(progressDialog_, &QProgressDialog::canceled, task_.get(), &BackgroundTask::cancel);
    connect(task_.get(), &BackgroundTask::progress, this, [this, title](const QString& step, double fraction) {
        if (progressDialog_ == nullptr || progressDialog_->wasCanceled()) return;
        progressDialog_->setLabelText(step.isEmpty() ? title : QStringLiteral("%1\n%2").arg(title, step));
        constexpr int kWhole = 1000;
        const int done = static_cast<int>(fraction * kWhole);
        progressDialog_->setMaximum(done > 0 ? kWhole : 0);
        progressDialog_->setValue(done);
    });
    connect(task_.get(), &BackgroundTask::succeeded, this, [this, succeeded = std::move(succeeded)] {
        // A copy, because endTask() destroys this lambda.
        const auto then = succeeded;
        endTask();
        then();
    });
    connect(task_.get(), &BackgroundTask::failed, this, [this, failed = std::move(failed)](const QString& sentence) {
        const QString text = sentence;
        const auto then = failed;
        endTask();
        if (then)
            then(text);
        else
            showError(text);
    });
    connect(task_.get(), &BackgroundTask::cancelled, this, [this] {
        endTask();
        statusBar()->showMessage(tr("Cancelled."), 4000);
    });
    task_->start();
}

void MainWindow::endTask() {
    canvas_->setSuspended(false);
    if (progressDialog_ != nullptr) progressDialog_->deleteLater();
    progressDialog_ = nullptr;
    task_.release()->deleteLater();
}

void MainWindow::confirmDiscard(std::function<void()> proceed) {
    if (!workspace_.document().modified()) {
        proceed();
        return;
    }
    auto* box =
        new QMessageBox(QMessageBox::Question, tr("Patina"), tr("The project has unsaved changes. Save them first?"),
                        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    box->setObjectName(QStringLiteral("discardDialog"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(box, &QMessageBox::buttonClicked, this, [this, box, proceed = std::move(proceed)](QAbstractButton* button) {
        const auto then = proceed;
        if (box->standardButton(button) == QMessageBox::Save) save(then);
        if (box->standardButton(button) == QMessageBox::Discard) then();
    });
    box->open();
}

void MainWindow::openFile(const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    static const QStringList kPictures = {"exr", "png", "jpg",  "jpeg", "tif", "tiff",
                                          "hdr", "pfm", "heic", "heif", "pcd"};
    if (kPictures.contains(suffix)) {
        chooseNew(path);
        return;
    }
    openProject(path, {});
}

void MainWindow::openProject(const QString& path, const core::MovedFiles& moved) {
    confirmDiscard([this, path, moved] {
        openScene({.title = tr("Opening %1").arg(QFileInfo(path).fileName()),
                   .load =
                       [path, moved](core::Notes* notes, const core::Progress& progress) {
                           return core::loadProject(path.toStdString(), notes, progress, moved);
                       },
                   .path = path,
                   .file = path,
                   .opened =
                       [this, path, moved] {
                           if (moved.empty()) return;
                           notices_->setNotices(QStringLiteral("moved"),
                                                {tr("Files of \"%1\" were found in another folder. Save the project to "
                                                    "keep their new places.")
                                                     .arg(QFileInfo(path).fileName())});
                       },
                   .failed =
                       [this, path, moved](const QString& sentence) {
                           std::vector<std::string> missing;
                           try {
                               missing = core::missingFiles(path.toStdString(), moved);
                           } catch (const core::Error&) {
                               // The sentence says it.
                           }
                           if (missing.empty())
                               showError(sentence);
                           else
                               locateFiles(path, moved, missing);
                       }});
    });
}

void MainWindow::locateFiles(const QString& path, const core::MovedFiles& moved,
                             const std::vector<std::string>& missing) {
    constexpr std::size_t kListed = 8;
    QStringList names;
    for (std::size_t i = 0; i < std::min(missing.size(), kListed); ++i) names << QString::fromStdString(missing[i]);
    if (missing.size() > kListed) names << QStringLiteral("…");
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Patina"),
                                tr("Files of \"%1\" cannot be found:").arg(QFileInfo(path).fileName()) +
                                    QStringLiteral("\n\n") + names.join(QLatin1Char('\n')),
                                QMessageBox::Cancel, this);
    box->setObjectName(QStringLiteral("locateDialog"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(tr("Choose where the first one is now. The others are looked for beside it."));
    QPushButton* locate = box->addButton(tr("Locate…"), QMessageBox::AcceptRole);
    box->setDefaultButton(locate);
    connect(locate, &QPushButton::clicked, this, [this, path, moved, missing] {
        const QString first = QFileInfo(QString::fromStdString(missing.front())).fileName();
        auto* chooser = new QFileDialog(this, tr("Locate %1").arg(first), QFileInfo(path).absolutePath(),
                                        tr("%1 (%1);;All files (*)").arg(first));
        chooser->setObjectName(QStringLiteral("locateFile"));
        chooser->setAttribute(Qt::WA_DeleteOnClose);
        chooser->setFileMode(QFileDialog::ExistingFile);
        connect(chooser, &QFileDialog::fileSelected, this, [this, path, moved, missing](const QString& place) {
            core::MovedFiles all = moved;
            all.merge(core::filesBeside(missing, missing.front(), place.toStdString()));
            openProject(path, all);
        });
        chooser->open();
    });
    box->open();
}

void MainWindow::createFrom(const core::CreateOptions& options, NewPhotoDialog* dialog) {
    const QPointer<NewPhotoDialog> asking(dialog);
    const std::shared_ptr<const core::PhotoFiles> files = dialog != nullptr ? dialog->files() : nullptr;
    confirmDiscard([this, options, asking, files] {
        openScene({.title = tr("Loading %1").arg(QFileInfo(QString::fromStdString(options.color)).fileName()),
                   .load =
                       [options, files](core::Notes* notes, const core::Progress& progress) {
                           return files != nullptr ? core::createScene(options, *files, notes, progress)
                                                   : core::createScene(options, notes, progress);
                       },
                   .file = QString::fromStdString(options.color),
                   .opened =
                       [this, options, asking] {
                           RecentFiles::addPhoto(options);
                           refreshRecent();
                           if (asking) asking->accept();
                       },
                   .failed =
                       [this, asking](const QString& sentence) {
                           if (asking)
                               asking->showProblem(sentence);
                           else
                               showError(sentence);
                       },
                   .parent = asking});
    });
}

void MainWindow::openSample(const QString& path) {
    confirmDiscard([this, path] {
        openScene({.title = tr("Opening %1").arg(QFileInfo(path).fileName()),
                   .load = [path](core::Notes* notes, const core::Progress& progress) {
                       return core::loadProject(path.toStdString(), notes, progress);
                   }});
    });
}

void MainWindow::openRecent(const QString& path) {
    if (const auto photo = RecentFiles::photo(path))
        createFrom(*photo);
    else
        openFile(path);
}

void MainWindow::openScene(Opening opening) {
    struct Loaded {
        core::Scene scene;
        core::Notes notes;
        std::shared_ptr<const CanvasPicture> original;
    };
    auto loaded = std::make_shared<Loaded>();
    runTask(
        opening.title,
        [loaded, load = std::move(opening.load), file = opening.file,
         isProject = !opening.path.isEmpty()](const core::Progress& whole) {
            const core::Progress progress = whole.of(core::Task::LoadPhoto);
            loaded->scene = load(&loaded->notes, progress.part(0, kLoadedEnd));
            progress.checkpoint(kLoadedEnd);
            loaded->original = makeCanvasPicture({loaded->scene.photo->color, false});
            // A project keeps the picture of its result.
            if (!file.isEmpty() && (!isProject || RecentFiles::thumbnail(file).isNull()))
                RecentFiles::setThumbnail(file, makeThumbnail(loaded->scene.photo->color));
            progress.checkpoint(1);
        },
        [this, loaded, path = opening.path, opened = std::move(opening.opened)] {
            rememberResult();
            workspace_.setDocument(core::Document(std::move(loaded->scene), path.toStdString()));
            canvas_->setOriginal(loaded->original);
            refreshLayerPicture();
            if (!path.isEmpty()) {
                RecentFiles::add(path);
                refreshRecent();
            }
            notices_->setNotices(QStringLiteral("file"), translatedEach(loaded->notes));
            notices_->setNotices(QStringLiteral("moved"), {});
            if (opened) opened();
        },
        std::move(opening.failed), opening.parent);
}

void MainWindow::chooseNew(const QString& colorFile) {
    auto* dialog = new NewPhotoDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (!colorFile.isEmpty()) dialog->setColorFile(colorFile);
    connect(dialog, &NewPhotoDialog::chosen, this, [this, dialog] { createFrom(dialog->options(), dialog); });
    dialog->open();
}

void MainWindow::chooseOpen() {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Open"), RecentFiles::lastFolder(),
        tr("Projects and photographs (*.patina *.exr *.jpg *.jpeg *.heic *.heif *.png *.tif "
           "*.tiff *.hdr *.pfm *.pcd);;Patina projects (*.patina);;All files (*)"));
    if (!path.isEmpty()) openFile(path);
}

void MainWindow::save(std::function<void()> then) {
    const QString path = QString::fromStdString(workspace_.document().path());
    if (path.isEmpty()) {
        saveAs(std::move(then));
    } else {
        saveTo(path, std::move(then));
    }
}

void MainWindow::chooseFile(const QString& key, const QString& title, const QString& name, const QString& filter,
                            std::function<void(const QString&)> use) {
    auto* chooser = new QFileDialog(this, title, RecentFiles::folder(workspace_.document(), true), filter);
    chooser->setObjectName(key);
    chooser->setAttribute(Qt::WA_DeleteOnClose);
    chooser->setAcceptMode(QFileDialog::AcceptSave);
    const auto suffix = [chooser] {
        return chooser->selectedNameFilter().section("*.", 1).section(QRegularExpression("[ )]"), 0, 0);
    };
    chooser->setDefaultSuffix(suffix());
    connect(chooser, &QFileDialog::filterSelected, chooser, [chooser, suffix] { chooser->setDefaultSuffix(suffix()); });
    chooser->selectFile(name);
    connect(chooser, &QFileDialog::fileSelected, this, [use = std::move(use)](const QString& path) { use(path); });
    chooser->open();
}

void MainWindow::saveAs(std::function<void()> then) {
    const QString name = RecentFiles::baseName(workspace_.document());
    chooseFile(QStringLiteral("saveFile"), tr("Save as"),
               (name.isEmpty() ? QStringLiteral("untitled") : name) + QStringLiteral(".patina"),
               tr("Patina projects (*.patina)"), [this, then](const QString& path) { saveTo(path, then); });
}

void MainWindow::rememberResult() {
    const core::Document& document = workspace_.document();
    if (document.path().empty() || document.modified()) return;
    const core::ImageRgb result = canvas_->reducedResult(kThumbnailSide);
    if (!result.empty()) RecentFiles::setThumbnail(QString::fromStdString(document.path()), makeThumbnail(result));
}

void MainWindow::saveTo(const QString& path, std::function<void()> then) {
    const std::uint64_t generation = workspace_.generation();
    runTask(
        tr("Saving %1").arg(QFileInfo(path).fileName()),
        [scene = workspace_.scene(), result = canvas_->reducedResult(kThumbnailSide), path](const core::Progress&) {
            core::saveProject(scene, path.toStdString());
            RecentFiles::setThumbnail(path, makeThumbnail(result.empty() ? scene.photo->color.image() : result));
        },
        [this, path, generation, then = std::move(then)] {
            // Changes made during the write are not in the file.
            if (generation == workspace_.generation()) workspace_.document().setSaved(path.toStdString());
            RecentFiles::add(path);
            refreshRecent();
            updateTitle();
            statusBar()->showMessage(tr("Saved %1").arg(path), 4000);
            if (then) then();
        });
}

void MainWindow::chooseExport(const QString& title, const QString& name, const QString& filter,
                              void (MainWindow::*write)(const QString&)) {
    chooseFile(QStringLiteral("exportFile"), title,
               RecentFiles::baseName(workspace_.document()) + QLatin1Char('-') + name, filter,
               [this, write](const QString& path) { (this->*write)(path); });
}

void MainWindow::exportPicture(const QString& path) {
    if (!workspace_.hasPhoto()) return;
    const std::shared_ptr<const core::Analysis> known = analysing_ ? nullptr : workspace_.analysis();
    // The preview waits, because the export uses the same device.
    canvas_->setSuspended(true);
    runTask(
        tr("Exporting %1").arg(QFileInfo(path).fileName()),
        [scene = workspace_.scene(), known, path,
         wish = options_.device.toStdString()](const core::Progress& progress) {
            const gpu::Device device =
                gpu::Instance::create().requestAdapter({.device = wish}).requestDevice({.label = "export"});
            std::shared_ptr<const core::Analysis> analysis = known;
            if (analysis == nullptr) {
                const auto kernels = render::createAnalysisKernels(render::analysisTwinFromEnvironment(), wish);
                analysis =
                    core::AnalysisPipeline().run(scene, progress, kernels ? *kernels : core::cpuAnalysisKernels());
            }
            core::Scene whole = scene;
            whole.render.timeLimit = 0;
            core::saveColor(render::renderImage(device, whole, analysis, progress.of(core::Task::Render)),
                            path.toStdString());
        },
        [this, path] { statusBar()->showMessage(tr("Exported %1").arg(path), 6000); });
}

void MainWindow::exportSegmentation(const QString& path) {
    if (!workspace_.hasPhoto()) return;
    runTask(
        tr("Exporting %1").arg(QFileInfo(path).fileName()),
        [photo = workspace_.scene().photo, path](const core::Progress&) {
            core::saveLabels(photo->labels, path.toStdString());
        },
        [this, path] { statusBar()->showMessage(tr("Exported %1").arg(path), 6000); });
}

void MainWindow::exportEnvironment(const QString& path) {
    const auto analysis = workspace_.analysis();
    if (analysis == nullptr || analysis->environment == nullptr) return;
    runTask(
        tr("Exporting %1").arg(QFileInfo(path).fileName()),
        [map = analysis->environment, path](const core::Progress&) {
            core::saveDirectionalMap(*map, path.toStdString());
        },
        [this, path] { statusBar()->showMessage(tr("Exported %1").arg(path), 6000); });
}

void MainWindow::refreshRecent() {
    recent_->clear();
    for (const QString& path : RecentFiles::files()) {
        QAction* action = recent_->addAction(QFileInfo(path).fileName());
        action->setToolTip(path);
        action->setStatusTip(path);
        connect(action, &QAction::triggered, this, [this, path] { openRecent(path); });
    }
    recent_->setEnabled(!recent_->isEmpty());
    start_->refresh();
}

}  // namespace ui
