// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QAction>
#include <QCloseEvent>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>

#include "core/io/image_io.h"
#include "core/io/project.h"
#include "tests/support/photo_containers.h"
#include "tests/ui/support.h"
#include "ui/main_window.h"
#include "ui/new_photo_dialog.h"
#include "ui/widgets/notice_button.h"

namespace {

const QString kStudioFile = QStringLiteral(PATINA_SAMPLES "/studio/studio.patina");

/// The whole window without a canvas: no Vulkan, no display.
class Window : public testing::Test {
  protected:
    Window() : window_({.canvas = false, .device = {}}) {}
    void open(const QString& path) {
        window_.openFile(path);
        ASSERT_TRUE(test::waitUntil([&] { return !window_.working(); }, 60000));
    }
    void wait() {
        ASSERT_TRUE(test::waitUntil([&] { return !window_.working(); }, 60000));
    }
    void createFrom(const core::CreateOptions& options) {
        window_.createFrom(options);
        wait();
    }
    /// Files of a photograph of 32x24 pixels in a folder.
    core::CreateOptions photoIn(const QString& name) {
        QDir(folder_.path()).mkpath(name);
        const core::Scene scene = test::makeScene();
        const core::Photo& photo = *scene.photo;
        const QDir folder(folder_.filePath(name));
        core::CreateOptions options;
        options.color = folder.filePath("color.png").toStdString();
        options.depth = folder.filePath("depth.exr").toStdString();
        options.segments = folder.filePath("segments.png").toStdString();
        core::saveColor(photo.color, options.color);
        core::saveScalar(photo.depth, options.depth, "Z");
        core::saveLabels(photo.labels, options.segments);
        return options;
    }
    QMessageBox* errorDialog() { return window_.findChild<QMessageBox*>("errorDialog"); }
    core::Document& document() { return window_.workspace().document(); }
    QAction& action(const char* name) { return *test::child<QAction>(window_, name); }

    ui::MainWindow window_;
    QTemporaryDir folder_;
};

TEST_F(Window, OpensTheBundledSample) {
    open(kStudioFile);
    EXPECT_EQ(errorDialog(), nullptr);
    EXPECT_TRUE(window_.workspace().hasPhoto());
    EXPECT_NE(test::labelOf(window_.workspace().scene(), "vase"), 0);
    EXPECT_TRUE(window_.windowTitle().contains("studio"));
    EXPECT_FALSE(window_.isWindowModified());
}

TEST_F(Window, WrongFilesShowASentenceAndKeepTheDocument) {
    open(kStudioFile);
    window_.workspace().editScene("Rename", [](core::Scene& scene) { scene.segments[0].name = "desk"; });
    document().setSaved(document().path());
    const std::uint64_t revision = document().revision();
    QFile broken(folder_.filePath("broken.patina"));
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("{\"format\": \"patina\", ");
    broken.close();
    for (const char* name : {"broken.patina", "missing.patina"}) {
        open(folder_.filePath(name));
        ASSERT_NE(errorDialog(), nullptr) << name;
        EXPECT_TRUE(errorDialog()->text().contains(name)) << errorDialog()->text().toStdString();
        delete errorDialog();
        EXPECT_EQ(document().revision(), revision);
        EXPECT_EQ(document().scene().segments[0].name, "desk");
    }
}

TEST_F(Window, NoticesStayUntilTheyAreRead) {
    auto* button = test::child<ui::NoticeButton>(window_, "notices");
    EXPECT_TRUE(button->isHidden());
    createFrom(photoIn("a"));
    ASSERT_TRUE(window_.workspace().hasPhoto());
    const auto said = [&](const QString& part) { return button->notices().filter(part).size(); };
    EXPECT_EQ(said(QStringLiteral("field of view of 60")), 1) << button->notices().join('|').toStdString();
    EXPECT_FALSE(button->isHidden());
    EXPECT_GT(button->unread(), 0);
    QTest::qWait(50);
    EXPECT_EQ(said(QStringLiteral("field of view of 60")), 1);
    action("actionNotices").trigger();
    auto* list = test::child<QFrame>(*button, "noticeList");
    EXPECT_TRUE(list->isVisible());
    bool listed = false;
    for (const QLabel* row : list->findChildren<QLabel*>())
        listed = listed || row->text().contains(QStringLiteral("field of view of 60"));
    EXPECT_TRUE(listed);
    EXPECT_EQ(button->unread(), 0);
    EXPECT_EQ(said(QStringLiteral("field of view of 60")), 1) << "read, and still there";
    list->close();
    open(kStudioFile);
    EXPECT_EQ(said(QStringLiteral("field of view of 60")), 0) << "another photograph";
}

TEST_F(Window, PhotographsAreUnderOpenRecent) {
    core::CreateOptions options = photoIn("a");
    options.hfov = 0.7f;
    createFrom(options);
    open(kStudioFile);
    auto* menu = test::child<QMenu>(window_, "recentMenu");
    const QList<QAction*> actions = menu->actions();
    const auto entry = std::ranges::find_if(
        actions, [&](const QAction* each) { return each->toolTip() == QString::fromStdString(options.color); });
    ASSERT_NE(entry, actions.end());
    (*entry)->trigger();
    wait();
    EXPECT_EQ(document().scene().photo->source.color, options.color);
    EXPECT_EQ(document().scene().photo->source.depth, options.depth);
    EXPECT_NEAR(document().scene().photo->camera.fx, 16 / std::tan(0.35), 0.01);
}

TEST_F(Window, MovedFilesAreLocatedAllAtOnce) {
    createFrom(photoIn("a"));
    const QString project = folder_.filePath("p.patina");
    window_.saveTo(project);
    wait();
    ASSERT_TRUE(QDir(folder_.path()).rename("a", "b"));
    ASSERT_TRUE(QFile::rename(folder_.filePath("b/color.png"), folder_.filePath("b/renamed.png")));
    open(project);
    EXPECT_EQ(errorDialog(), nullptr);
    auto* box = test::child<QMessageBox>(window_, "locateDialog");
    EXPECT_TRUE(box->text().contains("color.png")) << box->text().toStdString();
    EXPECT_TRUE(box->text().contains("depth.exr"));
    for (QAbstractButton* button : box->buttons())
        if (box->buttonRole(button) == QMessageBox::AcceptRole) button->click();
    auto* chooser = test::child<QFileDialog>(window_, "locateFile");
    emit chooser->fileSelected(folder_.filePath("b/renamed.png"));
    wait();
    EXPECT_EQ(errorDialog(), nullptr);
    const core::PhotoSource& source = document().scene().photo->source;
    EXPECT_EQ(source.color, folder_.filePath("b/renamed.png").toStdString());
    EXPECT_EQ(source.depth, folder_.filePath("b/depth.exr").toStdString());
    EXPECT_EQ(source.segments, folder_.filePath("b/segments.png").toStdString());
    EXPECT_FALSE(test::child<ui::NoticeButton>(window_, "notices")->notices().filter("Save the project").isEmpty());
}

TEST_F(Window, TheDialogOfANewPhotographStaysOpenOnAnError) {
    window_.show();
    action("actionNew").trigger();
    auto* dialog = test::child<ui::NewPhotoDialog>(window_, "newPhotoDialog");
    auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
    for (const QPushButton* button : dialog->findChildren<QPushButton*>()) {
        if (button->objectName().endsWith("Browse")) {
            EXPECT_FALSE(button->autoDefault()) << "Enter would open the file dialog again";
        }
    }
    core::CreateOptions options = photoIn("a");
    test::child<QLineEdit>(*dialog, "newColor")->setText(QString::fromStdString(options.color));
    test::child<QLineEdit>(*dialog, "newDepth")->setText(folder_.filePath("missing.pfm"));
    test::child<QDoubleSpinBox>(*dialog, "newFieldOfView")->setValue(33);
    ok->click();
    ASSERT_TRUE(test::waitUntil([&] { return dialog->upToDate() && !window_.working(); }, 20000));
    EXPECT_TRUE(dialog->isVisible());
    auto* problem = test::child<QLabel>(*dialog, "newProblem");
    EXPECT_TRUE(problem->isVisible());
    EXPECT_TRUE(problem->text().contains("missing.pfm")) << problem->text().toStdString();
    EXPECT_EQ(test::child<QDoubleSpinBox>(*dialog, "newFieldOfView")->value(), 33);

    test::child<QLineEdit>(*dialog, "newDepth")->setText(QString::fromStdString(options.depth));
    QTest::keyClick(test::child<QLineEdit>(*dialog, "newDepth"), Qt::Key_Return);
    ASSERT_TRUE(test::waitUntil([&] { return window_.workspace().hasPhoto(); }, 20000));
    EXPECT_FALSE(dialog->isVisible());
}

TEST_F(Window, TheDialogSaysWhatIsInThePhotograph) {
    test::TempFolder folder;
    const std::vector<std::uint8_t> pixels(std::size_t{32} * 16, 128);
    const std::string second =
        test::withSegments(test::plainJpeg(folder, 16, 8, 1, {pixels.begin(), pixels.begin() + 128}),
                           test::xmpSegment(test::appleXmp("0.5", "2.5", 64, 32, {50, 0, 0, 0, 51, 0, 20, 15, 1})));
    test::writeBytes(folder / "m.jpg",
                     test::mpfFile(test::plainJpeg(folder, 32, 16, 1, pixels), test::exifSegment(1), second));
    ui::NewPhotoDialog dialog;
    auto* kind = test::child<QComboBox>(dialog, "newDepthKind");
    auto* found = test::child<QLabel>(dialog, "newFound");
    dialog.setColorFile(QString::fromStdString(folder / "m.jpg"));
    ASSERT_TRUE(test::waitUntil([&] { return found->text().contains("16 × 8"); }, 20000))
        << found->text().toStdString();
    EXPECT_TRUE(found->text().contains("field of view 65.2°")) << found->text().toStdString();
    EXPECT_EQ(kind->currentData().toInt(), static_cast<int>(core::DepthKind::Disparity));
    EXPECT_FALSE(dialog.options().depthKind.has_value()) << "as the file says";
    dialog.setColorFile(QString::fromStdString(folder / "none.jpg"));
    EXPECT_TRUE(test::waitUntil([&] { return found->text().contains("none.jpg"); }, 20000));
}

TEST_F(Window, UndoAndRedoAreNamedActions) {
    open(kStudioFile);
    EXPECT_FALSE(action("actionUndo").isEnabled());
    window_.workspace().editScene("Rename segment", [](core::Scene& scene) { scene.segments[0].name = "desk"; });
    EXPECT_TRUE(action("actionUndo").text().contains("Rename segment"));
    EXPECT_TRUE(window_.isWindowModified());
    action("actionUndo").trigger();
    EXPECT_EQ(document().scene().segments[0].name, "table");
    EXPECT_FALSE(window_.isWindowModified());
    EXPECT_TRUE(action("actionRedo").text().contains("Rename segment"));
    action("actionRedo").trigger();
    EXPECT_EQ(document().scene().segments[0].name, "desk");
}

TEST_F(Window, SavesAndOpensAgain) {
    open(kStudioFile);
    window_.workspace().editScene("Rename", [](core::Scene& scene) { scene.segments[0].name = "desk"; });
    const QString path = folder_.filePath("copy.patina");
    window_.saveTo(path);
    ASSERT_TRUE(test::waitUntil([&] { return !window_.working(); }, 20000));
    EXPECT_FALSE(window_.isWindowModified());
    EXPECT_EQ(document().path(), path.toStdString());
    open(kStudioFile);
    open(path);
    EXPECT_EQ(document().scene().segments[0].name, "desk");
}

TEST_F(Window, SaveThatFailsKeepsTheModifiedMark) {
    open(kStudioFile);
    window_.workspace().editScene("Rename", [](core::Scene& scene) { scene.segments[0].name = "desk"; });
    window_.saveTo(folder_.filePath("no/such/folder/x.patina"));
    ASSERT_TRUE(test::waitUntil([&] { return !window_.working(); }, 20000));
    ASSERT_NE(errorDialog(), nullptr);
    EXPECT_TRUE(window_.isWindowModified());
}

TEST_F(Window, AsksBeforeLosingChanges) {
    open(kStudioFile);
    window_.show();
    window_.workspace().editScene("Rename", [](core::Scene& scene) { scene.segments[0].name = "desk"; });
    window_.close();
    EXPECT_TRUE(window_.isVisible());
    auto* box = test::child<QMessageBox>(window_, "discardDialog");
    box->button(QMessageBox::Cancel)->click();
    EXPECT_TRUE(window_.isVisible());
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    window_.close();
    test::child<QMessageBox>(window_, "discardDialog")->button(QMessageBox::Discard)->click();
    EXPECT_FALSE(window_.isVisible());
}

TEST_F(Window, ExportsSegmentationAndEnvironment) {
    open(kStudioFile);
    const QString labels = folder_.filePath("labels.png");
    window_.exportSegmentation(labels);
    ASSERT_TRUE(test::waitUntil([&] { return !window_.working(); }, 20000));
    EXPECT_EQ(core::loadLabels(labels.toStdString()), window_.workspace().scene().photo->labels);
    ASSERT_TRUE(test::waitUntil([&] { return window_.settled(); }, 120000));
    const QString map = folder_.filePath("light.exr");
    window_.exportEnvironment(map);
    ASSERT_TRUE(test::waitUntil([&] { return !window_.working(); }, 20000));
    const core::ImageRgb light = core::loadColor(map.toStdString());
    EXPECT_TRUE(light.sameSize(window_.workspace().analysis()->environment->radiance));
}

TEST_F(Window, LayersAndExposureAgreeBetweenMenuAndToolBar) {
    open(kStudioFile);
    action("actionLayer_normals").trigger();
    auto* box = test::child<QComboBox>(window_, "layerBox");
    EXPECT_EQ(box->currentText(), ui::layerTitle(ui::ViewLayer::Normals));
    box->setCurrentIndex(static_cast<int>(ui::ViewLayer::Depth));
    EXPECT_TRUE(action("actionLayer_depth").isChecked());
    action("actionExposureUp").trigger();
    EXPECT_NEAR(test::child<QDoubleSpinBox>(window_, "exposure")->value(), 0.33, 0.01);
    action("actionExposureReset").trigger();
    EXPECT_EQ(test::child<QDoubleSpinBox>(window_, "exposure")->value(), 0);
}

TEST_F(Window, MainActionsHaveShortcutsAndHelp) {
    for (const char* name : {"actionNew", "actionOpen", "actionSave", "actionSaveAs", "actionExportPicture",
                             "actionQuit", "actionUndo", "actionRedo", "actionFit", "actionZoom100", "actionManual"}) {
        EXPECT_FALSE(action(name).shortcut().isEmpty()) << name;
        EXPECT_FALSE(action(name).statusTip().isEmpty()) << name;
    }
    QStringList shortcuts;
    for (const QAction* each : window_.findChildren<QAction*>()) {
        if (!each->shortcut().isEmpty()) shortcuts << each->shortcut().toString();
    }
    EXPECT_EQ(shortcuts.removeDuplicates(), 0);
}

TEST_F(Window, ManualIsBuiltIn) {
    QFile manual(QStringLiteral(":/docs/manual.md"));
    ASSERT_TRUE(manual.open(QIODevice::ReadOnly));
    EXPECT_TRUE(QString::fromUtf8(manual.readAll()).startsWith("# Patina"));
}

}  // namespace
