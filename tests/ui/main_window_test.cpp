// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QAction>
#include <QCloseEvent>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>

#include "core/io/image_io.h"
#include "core/io/project.h"
#include "tests/ui/support.h"
#include "ui/main_window.h"

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
