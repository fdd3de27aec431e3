// SPDX-License-Identifier: GPL-3.0-or-later
// The menus and the tool bar of MainWindow.
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QTextBrowser>
#include <QToolBar>
#include <QVBoxLayout>

#include "ui/action.h"
#include "ui/canvas/substance_ruler.h"
#include "ui/main_window.h"
#include "ui/tools/tool_box.h"
#include "ui/widgets/notice_button.h"

namespace ui {

QAction* MainWindow::addAction(QMenu* menu, const QString& key, const QString& text, const QKeySequence& shortcut,
                               const QString& help, const std::function<void()>& run) {
    QAction* action = makeAction(this, key, text, shortcut, help, run);
    menu->addAction(action);
    return action;
}

void MainWindow::makeActions() {
    makeFileMenu();
    makeEditMenu();
    makeSelectMenu();
    makeViewMenu();
    makeHelpMenu();
}

void MainWindow::makeFileMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&File"));
    addAction(menu, "actionNew", tr("&New from photograph…"), QKeySequence::New,
              tr("Start a project from a photograph and its depth"), [this] { chooseNew(); });
    addAction(menu, "actionOpen", tr("&Open…"), QKeySequence::Open, tr("Open a photograph or a project"),
              [this] { chooseOpen(); });
    recent_ = menu->addMenu(tr("Open &recent"));
    recent_->setObjectName(QStringLiteral("recentMenu"));
    menu->addSeparator();
    save_ = addAction(menu, "actionSave", tr("&Save"), QKeySequence::Save, tr("Save the project"), [this] { save(); });
    saveAs_ = addAction(menu, "actionSaveAs", tr("Save &as…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
                        tr("Save the project under another name"), [this] { saveAs(); });
    menu->addSeparator();
    exportPicture_ = addAction(
        menu, "actionExportPicture", tr("&Export picture…"), QKeySequence(Qt::CTRL | Qt::Key_E),
        tr("Render the edited photograph with all samples and save it"), [this] {
            chooseExport(tr("Export picture"), QStringLiteral("edited.png"),
                         tr("PNG, 16 bit (*.png);;OpenEXR, linear (*.exr);;TIFF, 16 bit (*.tif);;JPEG (*.jpg);;"
                            "Radiance HDR, linear (*.hdr)"),
                         &MainWindow::exportPicture);
        });
    exportSegmentation_ =
        addAction(menu, "actionExportSegmentation", tr("Export se&gmentation…"), {}, tr("Save the label map"), [this] {
            chooseExport(tr("Export segmentation"), QStringLiteral("segments.png"),
                         tr("PNG (*.png);;TIFF (*.tif);;OpenEXR (*.exr)"), &MainWindow::exportSegmentation);
        });
    exportEnvironment_ =
        addAction(menu, "actionExportEnvironment", tr("Export en&vironment…"), {},
                  tr("Save the light around the scene as a latitude-longitude map"), [this] {
                      chooseExport(tr("Export environment"), QStringLiteral("environment.exr"),
                                   tr("OpenEXR, linear (*.exr);;Radiance HDR, linear (*.hdr);;PNG (*.png)"),
                                   &MainWindow::exportEnvironment);
                  });
    menu->addSeparator();
    addAction(menu, "actionDevice", tr("&Device…"), {}, tr("Choose the graphics device"), [this] { chooseDevice(); });
    menu->addSeparator();
    addAction(menu, "actionQuit", tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), tr("Quit Patina"),
              [this] { close(); });
}

void MainWindow::makeEditMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Edit"));
    undo_ = addAction(menu, "actionUndo", tr("&Undo"), QKeySequence::Undo, tr("Undo the last change"), [this] {
        if (!toolBox_->undo()) workspace_.document().undo();
    });
    redo_ = addAction(menu, "actionRedo", tr("&Redo"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z),
                      tr("Redo the last undone change"), [this] { workspace_.document().redo(); });
    menu->addSeparator();
    addAction(menu, "actionDeselect", tr("&Deselect segment"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A),
              tr("Edit no segment"), [this] { workspace_.select(0); });
}

void MainWindow::makeSelectMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Select"));
    menu->setToolTipsVisible(true);
    toolBox_->fillMenu(*menu);
}

void MainWindow::makeViewMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&View"));
    layers_ = new QActionGroup(this);
    int number = 1;
    for (const ViewLayer layer : kViewLayers) {
        QAction* action = addAction(menu, QStringLiteral("actionLayer_") + layerKey(layer), layerTitle(layer),
                                    QKeySequence(QStringLiteral("Ctrl+%1").arg(number++)),
                                    tr("Show: %1").arg(layerTitle(layer)), [this, layer] { setLayer(layer); });
        action->setCheckable(true);
        layers_->addAction(action);
    }
    layers_->actions().front()->setChecked(true);
    menu->addSeparator();
    addAction(menu, "actionFit", tr("&Fit in window"), QKeySequence(Qt::CTRL | Qt::Key_0), tr("Show the whole picture"),
              [this] { canvas_->zoomToFit(); });
    addAction(menu, "actionZoom100", tr("&100 %"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_0),
              tr("Show one picture pixel per screen pixel"), [this] { canvas_->setZoom(1); });
    addAction(menu, "actionZoomIn", tr("Zoom &in"), QKeySequence::ZoomIn, tr("Enlarge the view"),
              [this] { canvas_->setZoom(canvas_->zoom() * 1.4142); });
    addAction(menu, "actionZoomOut", tr("Zoom &out"), QKeySequence::ZoomOut, tr("Shrink the view"),
              [this] { canvas_->setZoom(canvas_->zoom() / 1.4142); });
    menu->addSeparator();
    constexpr double kStep = 1.0 / 3;
    addAction(menu, "actionExposureUp", tr("&Brighter"), QKeySequence(Qt::CTRL | Qt::Key_BracketRight),
              tr("Brighten the view by a third of a stop; the picture stays the same"),
              [this] { setExposure(exposureStops_ + kStep); });
    addAction(menu, "actionExposureDown", tr("&Darker"), QKeySequence(Qt::CTRL | Qt::Key_BracketLeft),
              tr("Darken the view by a third of a stop; the picture stays the same"),
              [this] { setExposure(exposureStops_ - kStep); });
    addAction(menu, "actionExposureReset", tr("&Normal exposure"), QKeySequence(Qt::CTRL | Qt::Key_Backslash),
              tr("Show the picture at its own exposure"), [this] { setExposure(0); });
    menu->addSeparator();
    QAction* outline = addAction(menu, "actionOutline", tr("Selection ou&tline"), QKeySequence(Qt::CTRL | Qt::Key_H),
                                 tr("Outline the selected segment"), [] {});
    outline->setCheckable(true);
    outline->setChecked(true);
    connect(outline, &QAction::toggled, this, [this](bool on) { canvas_->setOutlineShown(on); });
    QAction* ruler = addAction(menu, "actionRuler", tr("&Ruler"), QKeySequence(Qt::CTRL | Qt::Key_R),
                               tr("Show the scale of the selected translucent object"), [] {});
    ruler->setCheckable(true);
    ruler->setChecked(true);
    connect(ruler, &QAction::toggled, ruler_, &SubstanceRuler::setShown);
    QAction* pause = addAction(menu, "actionPause", tr("&Pause refinement"), QKeySequence(Qt::CTRL | Qt::Key_P),
                               tr("Show changes without refining them, so that the device stays idle"), [] {});
    pause->setCheckable(true);
    connect(pause, &QAction::toggled, this, [this](bool on) {
        canvas_->setRefining(!on);
        updateProgress();
    });
    menu->addSeparator();
    addAction(menu, "actionNotices", tr("&Notices"), QKeySequence(Qt::Key_F8),
              tr("List what was found in the files and assumed by the analysis"), [this] { notices_->showList(); });
    panels_ = menu->addMenu(tr("&Panels"));
}

void MainWindow::makeHelpMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Help"));
    addAction(menu, "actionManual", tr("&Manual"), QKeySequence::HelpContents, tr("Read how to use Patina"),
              [this] { showManual(); });
    addAction(menu, "actionAbout", tr("&About Patina"), {}, tr("Show version and graphics device"),
              [this] { showAbout(); });
}

void MainWindow::makeToolBar() {
    auto* bar = new QToolBar(tr("Tools"), this);
    bar->setObjectName(QStringLiteral("toolBar"));
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    for (const char* key : {"actionOpen", "actionSave", "actionExportPicture"}) {
        bar->addAction(findChild<QAction*>(QString::fromUtf8(key)));
    }
    bar->addSeparator();
    bar->addAction(undo_);
    bar->addAction(redo_);
    bar->addSeparator();
    bar->addWidget(new QLabel(tr(" Show "), bar));
    layerBox_ = new QComboBox(bar);
    layerBox_->setObjectName(QStringLiteral("layerBox"));
    layerBox_->setAccessibleName(tr("Layer shown"));
    layerBox_->setToolTip(tr("Choose what the canvas shows. Hold C or the right mouse button to see the original."));
    for (const ViewLayer layer : kViewLayers) layerBox_->addItem(layerTitle(layer));
    connect(layerBox_, &QComboBox::currentIndexChanged, this,
            [this](int index) { setLayer(kViewLayers.at(static_cast<std::size_t>(index))); });
    bar->addWidget(layerBox_);
    bar->addWidget(new QLabel(tr("  Exposure "), bar));
    exposureBox_ = new QDoubleSpinBox(bar);
    exposureBox_->setObjectName(QStringLiteral("exposure"));
    exposureBox_->setAccessibleName(tr("Exposure of the view"));
    exposureBox_->setToolTip(tr("Brightness of the view in stops; the picture stays the same"));
    exposureBox_->setRange(-10, 10);
    exposureBox_->setSingleStep(1.0 / 3);
    exposureBox_->setDecimals(2);
    exposureBox_->setSuffix(tr(" EV"));
    connect(exposureBox_, &QDoubleSpinBox::valueChanged, this, &MainWindow::setExposure);
    bar->addWidget(exposureBox_);
    bar->addSeparator();
    for (const char* key : {"actionFit", "actionZoom100", "actionPause"}) {
        bar->addAction(findChild<QAction*>(QString::fromUtf8(key)));
    }
    addToolBar(bar);
}

void MainWindow::showManual() {
    auto* dialog = new QDialog(this);
    dialog->setObjectName(QStringLiteral("manual"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Manual"));
    dialog->resize(760, 720);
    auto* text = new QTextBrowser(dialog);
    text->setOpenExternalLinks(true);
    text->setSearchPaths({QStringLiteral(":/docs")});
    QFile file(QStringLiteral(":/docs/manual.md"));
    if (file.open(QIODevice::ReadOnly)) text->setMarkdown(QString::fromUtf8(file.readAll()));
    auto* layout = new QVBoxLayout(dialog);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(text);
    dialog->show();
}

void MainWindow::showAbout() {
    const QString device = canvas_->deviceName().isEmpty() ? tr("none") : canvas_->deviceName();
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, tr("About Patina"),
        tr("<h3>Patina %1</h3><p>Changes the materials of objects in a photograph.</p>"
           "<p>After S. Bergmann, T. Ritschel, C. Dachsbacher, <i>Interactive Appearance Editing in RGB-D Images</i>, "
           "VMV 2014.</p><p>Device: %2<br>Qt %3</p><p>Free software under the GNU General Public License, version 3 or "
           "later.</p>")
            .arg(QStringLiteral(PATINA_VERSION), device.toHtmlEscaped(), QString::fromUtf8(qVersion())),
        QMessageBox::Ok, this);
    box->setObjectName(QStringLiteral("about"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

}  // namespace ui
