// SPDX-License-Identifier: GPL-3.0-or-later
// From the start page to the first edited object, as a person does it: every action is a real event, and they are
// counted. Pictures of each step are written to first_edit/ in the working folder.
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QGuiApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QTimer>
#include <cstdlib>
#include <iostream>

#include "core/scene/scene.h"
#include "tests/ui/support.h"
#include "ui/canvas/canvas_window.h"
#include "ui/main_window.h"
#include "ui/new_photo_dialog.h"
#include "ui/tools/tool_box.h"

namespace {

/// A photograph, and where its main object is, in parts of width and height.
struct Subject {
    const char* name;
    QString file;
    double x, y;
};

class CanvasWindowTestFirstEdit : public testing::Test {
  protected:
    void SetUp() override {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        window_.resize(1400, 900);
        window_.show();
        ASSERT_TRUE(window_.canvas().available());
        QDir().mkpath(QStringLiteral("first_edit"));
    }
    void picture(const Subject& subject, const char* step) {
        // What was changed last is on the screen after a frame, which a software device may take long for.
        QTest::qWait(1500);
        window_.screen()->grabWindow(0).save(
            QStringLiteral("first_edit/%1_%2.jpg").arg(QString::fromUtf8(subject.name), QString::fromUtf8(step)),
            nullptr, 90);
    }
    void click(QWidget* widget, const QPoint& place) {
        QTest::mouseClick(widget, Qt::LeftButton, {}, place);
        ++actions_;
    }
    /// Types a path into the file dialog that the next action opens.
    void typeWhenAsked(const QString& path) {
        auto* timer = new QTimer(&window_);
        QObject::connect(timer, &QTimer::timeout, &window_, [this, timer, path] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr) return;
            timer->deleteLater();
            auto* name = test::child<QLineEdit>(*dialog, "fileNameEdit");
            name->setText(path);
            QTest::keyClick(name, Qt::Key_Return);
            ++actions_;
        });
        timer->start(50);
    }
    ui::CanvasWindow* native() {
        for (QWindow* each : QGuiApplication::allWindows())
            if (auto* canvas = qobject_cast<ui::CanvasWindow*>(each)) return canvas;
        return nullptr;
    }
    void openWithTheDialog(const Subject& subject) {
        typeWhenAsked(subject.file);
        auto* open = test::child<QPushButton>(window_, "startOpen");
        click(open, open->rect().center());
        ui::NewPhotoDialog* dialog = nullptr;
        ASSERT_TRUE(test::waitUntil(
            [&] {
                dialog = window_.findChild<ui::NewPhotoDialog*>("newPhotoDialog");
                return dialog != nullptr && dialog->isVisible() && dialog->upToDate();
            },
            120000));
        picture(subject, "1_dialog");
        QTest::keyClick(dialog, Qt::Key_Return);
        ++actions_;
        ASSERT_TRUE(test::waitUntil([&] { return window_.workspace().hasPhoto() && !window_.working(); }, 120000));
        ASSERT_EQ(window_.findChild<QObject*>("errorDialog"), nullptr);
    }
    void selectAndMakeSegment(const Subject& subject) {
        EXPECT_EQ(window_.toolBox().chosen(), "toolSmartSelect") << "nothing has to be chosen";
        ASSERT_TRUE(test::waitUntil([&] { return native() != nullptr && native()->isExposed(); }, 20000));
        const core::Camera& camera = window_.workspace().scene().photo->camera;
        const QPointF place = window_.canvas().widgetPosition(static_cast<int>(subject.x * camera.width),
                                                              static_cast<int>(subject.y * camera.height));
        QTest::mouseMove(native(), place.toPoint());
        QTest::mouseClick(native(), Qt::LeftButton, {}, place.toPoint());
        ++actions_;
        ASSERT_TRUE(test::waitUntil([&] { return !window_.toolBox().session().worker().busy(); }, 120000));
        ASSERT_NE(window_.toolBox().session().selection(), nullptr);
        picture(subject, "2_selected");
        QTest::keyClick(&window_.canvas(), Qt::Key_Return);
        ++actions_;
        ASSERT_TRUE(test::waitUntil([&] { return !window_.toolBox().session().changingSegments(); }, 20000));
        ASSERT_NE(window_.workspace().selectedSegment(), nullptr);
    }
    void makeItGlossyMetal() {
        auto* list = test::child<QAbstractItemView>(window_, "segmentList");
        int glossy = -1;
        for (int column = 0; column < list->model()->columnCount(); ++column)
            if (list->model()->headerData(column, Qt::Horizontal).toString() == QLatin1String("Glossy"))
                glossy = column;
        ASSERT_GE(glossy, 0);
        const QRect cell = list->visualRect(list->model()->index(0, glossy));
        ASSERT_FALSE(cell.isEmpty());
        // The box is in the cell's middle or at its left.
        for (const QPoint& place : {cell.center(), QPoint(cell.left() + 10, cell.center().y())}) {
            if (window_.workspace().selectedSegment()->glossy) break;
            QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, place);
        }
        ++actions_;
        EXPECT_TRUE(window_.workspace().selectedSegment()->glossy);
        auto* brdf = test::child<QComboBox>(window_, "materialBrdf");
        ASSERT_TRUE(brdf->isEnabled());
        click(brdf, brdf->rect().center());
        QAbstractItemView* popup = brdf->view();
        ASSERT_TRUE(test::waitUntil([&] { return popup->isVisible(); }, 5000));
        // A list that has just opened ignores the end of the click that opened it.
        QTest::qWait(QApplication::doubleClickInterval() + 100);
        const QModelIndex row = brdf->model()->index(brdf->findData(QStringLiteral("ggx")), 0);
        popup->scrollTo(row);
        QTest::mouseMove(popup->viewport(), popup->visualRect(row).center());
        click(popup->viewport(), popup->visualRect(row).center());
        EXPECT_TRUE(window_.workspace().selectedSegment()->edit.has_value());
    }
    void firstEdit(const Subject& subject) {
        QElapsedTimer clock;
        clock.start();
        picture(subject, "0_start");
        ASSERT_NO_FATAL_FAILURE(openWithTheDialog(subject));
        ASSERT_NO_FATAL_FAILURE(selectAndMakeSegment(subject));
        ASSERT_NO_FATAL_FAILURE(makeItGlossyMetal());
        window_.workspace().editScene("samples", [](core::Scene& scene) { scene.render.samples = 4; });
        ASSERT_TRUE(test::waitUntil([&] { return window_.settled(); }, 240000));
        picture(subject, "3_edited");
        EXPECT_LE(actions_, 8);
        std::cout << subject.name << ": " << actions_ << " actions, " << clock.elapsed() / 1000
                  << " s with all waiting for the machine\n";
    }

    ui::MainWindow window_;
    int actions_ = 0;
};

TEST_F(CanvasWindowTestFirstEdit, OnTheSamplesPhotograph) {
    firstEdit({"studio", QStringLiteral(PATINA_SAMPLES "/studio/color.jpg"), 0.37, 0.58});
}

class CanvasWindowTestFirstEditPhotographs : public CanvasWindowTestFirstEdit,
                                             public testing::WithParamInterface<Subject> {};

TEST_P(CanvasWindowTestFirstEditPhotographs, TakesEightActions) {
    const char* folder = std::getenv("PATINA_REFERENCE_DATA");
    if (folder == nullptr) GTEST_SKIP() << "PATINA_REFERENCE_DATA is not set";
    Subject subject = GetParam();
    subject.file = QDir(QString::fromUtf8(folder)).filePath(QStringLiteral("rgbd/") + subject.file);
    if (!QFile::exists(subject.file)) GTEST_SKIP() << subject.file.toStdString() << " does not exist";
    firstEdit(subject);
}

INSTANTIATE_TEST_SUITE_P(CanvasWindowTestPhones, CanvasWindowTestFirstEditPhotographs,
                         testing::Values(Subject{"pug", "heic_iphone13pro_pug/pug.heic", 0.45, 0.72},
                                         Subject{"vase", "jpeg_mpf_iphonex_vase/image-with-depth.jpg", 0.48, 0.46},
                                         Subject{"helmet", "jpeg_gdepth_greek_helmet/greek-helmet.jpg", 0.46, 0.49},
                                         Subject{"maneki_neko", "jpeg_gdepth_maneki_neko/yamasa-maneki-neko.jpg", 0.45,
                                                 0.43},
                                         Subject{"barstools", "jpeg_xdm_r200_barstools/xdm-photo4.jpg", 0.81, 0.42}),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
