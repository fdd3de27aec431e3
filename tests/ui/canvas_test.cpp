// SPDX-License-Identifier: GPL-3.0-or-later
// The real window with the real canvas. Needs a display with Vulkan: CTest starts it on a virtual one with lavapipe.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QGuiApplication>
#include <QLabel>
#include <QScreen>
#include <QSlider>
#include <QTemporaryDir>
#include <QThread>
#include <QToolButton>
#include <QTreeView>
#include <QWindow>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/analysis/pipeline.h"
#include "core/io/image_io.h"
#include "core/io/project.h"
#include "gpu/instance.h"
#include "render/renderer.h"
#include "tests/ui/stall_meter.h"
#include "tests/ui/support.h"
#include "ui/canvas/canvas_renderer.h"
#include "ui/canvas/canvas_window.h"
#include "ui/canvas/display.h"
#include "ui/main_window.h"
#include "ui/recent_files.h"

namespace {

const QString kSample = QStringLiteral(PATINA_SAMPLES "/studio/studio.patina");

class CanvasWindowTest : public testing::Test {
  protected:
    void SetUp() override {
        window_.resize(1400, 900);
        window_.show();
        test::showCanvas(window_);
        ASSERT_TRUE(window_.canvas().available())
            << test::child<QLabel>(window_, "canvasMessage")->text().toStdString();
        ASSERT_TRUE(test::waitUntil([&] { return !window_.canvas().deviceName().isEmpty(); }, 20000));
    }
    void open() {
        window_.openFile(kSample);
        ASSERT_TRUE(test::waitUntil([&] { return window_.workspace().hasPhoto(); }, 30000));
    }
    std::uint16_t label(const char* name) { return test::labelOf(window_.workspace().scene(), name); }
    void settle() {
        ASSERT_TRUE(test::waitUntil([&] { return window_.settled(); }, 100000));
    }
    void setSamples(int count) { test::child<QDoubleSpinBox>(window_, "renderSamples")->setValue(count); }
    void chooseBrdf(const char* key) {
        auto* box = test::child<QComboBox>(window_, "materialBrdf");
        box->setCurrentIndex(box->findData(QString::fromUtf8(key)));
        emit box->activated(box->currentIndex());
    }
    QTreeView& segmentList() { return *test::child<QTreeView>(window_, "segmentList"); }
    QModelIndex row(const QString& segment) { return test::segmentRow(segmentList(), segment); }
    /// The widget's pixel that shows a picture pixel's centre.
    QPoint widgetPixel(int x, int y) {
        const QPointF place = window_.canvas().widgetPosition(x, y);
        return {static_cast<int>(std::floor(place.x())), static_cast<int>(std::floor(place.y()))};
    }
    /// What is on the screen at a picture pixel.
    QColor screenColor(int x, int y) {
        const QPoint global = window_.canvas().mapToGlobal(widgetPixel(x, y));
        return window_.screen()->grabWindow(0, global.x(), global.y(), 1, 1).toImage().pixelColor(0, 0);
    }

    ui::MainWindow window_;
    QTemporaryDir folder_;
};

// Opens the sample, flags a segment, changes a material, waits, exports; the file equals the headless one.
constexpr qint64 kLongestStall = 200;  // [ms] on a machine that does nothing else

/// By how much the machine is overbooked, ≥ 1: what runs beside a test stalls its window too.
double othersShare() {
    double load = 0;
    if (getloadavg(&load, 1) != 1) return 1;
    return std::max(1.0, load / std::max(1, QThread::idealThreadCount()));
}

TEST_F(CanvasWindowTest, EditedPictureIsExportedAsTheHeadlessOne) {
    test::StallMeter stalls;
    open();
    setSamples(4);
    settle();
    ASSERT_TRUE(row("bowl").isValid());
    const QModelIndex glossy = row("bowl").siblingAtColumn(1);
    QTest::mouseClick(segmentList().viewport(), Qt::LeftButton, {}, segmentList().visualRect(glossy).center());
    EXPECT_TRUE(window_.workspace().scene().findSegment(label("bowl"))->glossy);
    settle();
    segmentList().setCurrentIndex(row("bowl"));
    chooseBrdf("phong");
    auto* exponent = test::child<QSlider>(window_, "exponentSlider");
    // What blocks the thread does so in every round; a busy machine seldom does.
    qint64 longest = std::numeric_limits<qint64>::max();
    for (int round = 0; round < 5 && longest >= kLongestStall; ++round) {
        stalls.reset();
        for (const int position : {200, 300, 400, 500 + round}) {
            exponent->setValue(position);
            QTest::qWait(30);
        }
        emit exponent->sliderReleased();
        settle();
        longest = std::min(longest, stalls.longest());
    }
    RecordProperty("longest_stall_ms", static_cast<int>(longest));
    EXPECT_LT(static_cast<double>(longest), static_cast<double>(kLongestStall) * othersShare())
        << "the window's thread was blocked";
    EXPECT_EQ(window_.canvas().progress().samples, 4);
    EXPECT_EQ(window_.canvas().progress().droppedSamples, 0u);

    const QString picture = folder_.filePath("window.exr");
    window_.exportPicture(picture);
    settle();
    ASSERT_EQ(window_.findChild<QObject*>("errorDialog"), nullptr);
    const QString project = folder_.filePath("edited.patina");
    window_.saveTo(project);
    settle();

    const core::Scene scene = core::loadProject(project.toStdString());
    const auto analysis = core::AnalysisPipeline().run(scene);
    const core::ImageRgb headless =
        render::renderImage(gpu::Instance::create().requestAdapter().requestDevice({.label = "test"}), scene, analysis);
    const std::string reference = folder_.filePath("headless.exr").toStdString();
    core::saveColor(headless, reference);
    const core::ImageRgb expected = core::loadColor(reference);
    const core::ImageRgb actual = core::loadColor(picture.toStdString());
    ASSERT_TRUE(actual.sameSize(expected));
    EXPECT_TRUE(actual == expected) << "the same project, seed and samples give the same pixels";

    // Something was edited, and only where the bowl is, mixed pixels at its outline included.
    const core::Photo& photo = *scene.photo;
    const std::uint16_t bowl = test::labelOf(scene, "bowl");
    const auto showsBowl = [&](int x, int y) {
        for (int v = y - 2; v <= y + 2; ++v)
            for (int u = x - 2; u <= x + 2; ++u)
                if (photo.labels.contains(u, v) && photo.labels(u, v) == bowl) return true;
        return false;
    };
    std::size_t changedInside = 0;
    std::size_t changedOutside = 0;
    for (int y = 0; y < actual.height(); ++y)
        for (int x = 0; x < actual.width(); ++x) {
            if (actual(x, y).isApprox(photo.color(x, y), 0.02f)) continue;
            if (photo.labels(x, y) == bowl) ++changedInside;
            if (!showsBowl(x, y)) ++changedOutside;
        }
    EXPECT_GT(changedInside, 1000u);
    EXPECT_EQ(changedOutside, 0u);
}

TEST(CanvasWindowTestStart, GivesWayToTheCanvasOfThePhotograph) {
    ui::MainWindow window;
    window.resize(1000, 700);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    EXPECT_TRUE(test::child<QWidget>(window, "startPage")->isVisible());
    EXPECT_FALSE(window.canvas().isVisible());
    QTest::qWait(200);
    window.openFile(kSample);
    ASSERT_TRUE(test::waitUntil([&] { return window.workspace().hasPhoto() && window.settled(); }, 100000));
    EXPECT_FALSE(test::child<QWidget>(window, "startPage")->isVisible());
    EXPECT_FALSE(window.canvas().deviceName().isEmpty());
    const QPoint middle = window.canvas().mapToGlobal(window.canvas().widgetPosition(440, 330).toPoint());
    const core::Vector3f& there = window.workspace().scene().photo->color(440, 330);
    const QColor expected = ui::displayColor(there);
    ASSERT_TRUE(test::waitUntil(
        [&] {
            const QColor seen = window.screen()->grabWindow(0, middle.x(), middle.y(), 1, 1).toImage().pixelColor(0, 0);
            return std::abs(seen.red() - expected.red()) + std::abs(seen.green() - expected.green()) < 60;
        },
        10000))
        << "the canvas shows the photograph";
}

TEST_F(CanvasWindowTest, ShowsThePhotographAndPicksSegments) {
    open();
    const core::Photo& photo = *window_.workspace().scene().photo;
    window_.canvas().setZoom(1);
    QTest::qWait(1000);
    // Colour on the screen: the photograph through the sRGB transfer function.
    for (const auto& [x, y] : {std::pair{480, 320}, std::pair{300, 300}, std::pair{600, 400}}) {
        const core::Vector3f& linear = photo.color(x, y);
        const QColor shown = screenColor(x, y);
        const auto encoded = [](float v) {
            v = std::clamp(v, 0.0f, 1.0f);
            return 255 * (v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f);
        };
        EXPECT_NEAR(shown.red(), encoded(linear.x()), 2) << x << "," << y;
        EXPECT_NEAR(shown.green(), encoded(linear.y()), 2) << x << "," << y;
        EXPECT_NEAR(shown.blue(), encoded(linear.z()), 2) << x << "," << y;
    }
    // A click in the middle of a segment selects it.
    QWindow* native = nullptr;
    for (QWindow* each : QGuiApplication::allWindows()) {
        if (each->surfaceType() == QSurface::VulkanSurface && each->isExposed()) native = each;
    }
    ASSERT_NE(native, nullptr);
    for (int y = 0; y < photo.labels.height(); y += 40) {
        for (int x = 0; x < photo.labels.width(); x += 60) {
            const QPoint place = widgetPixel(x, y);
            if (!window_.canvas().rect().contains(place)) continue;
            QTest::mouseClick(native, Qt::LeftButton, {}, place);
            ASSERT_EQ(window_.workspace().selectedLabel(), photo.labels(x, y)) << x << "," << y;
        }
    }
}

TEST_F(CanvasWindowTest, UndoRedoAndMinimisingDoNotDisturbRefinement) {
    open();
    setSamples(2);
    window_.workspace().select(label("vase"));
    chooseBrdf("ggx");
    auto* alpha = test::child<QSlider>(window_, "alphaSlider");
    alpha->setValue(900);
    emit alpha->sliderReleased();
    const float rough = window_.workspace().selectedSegment()->edit->values[0];
    test::child<QAction>(window_, "actionUndo")->trigger();
    EXPECT_NE(window_.workspace().selectedSegment()->edit->values[0], rough);
    test::child<QAction>(window_, "actionRedo")->trigger();
    EXPECT_EQ(window_.workspace().selectedSegment()->edit->values[0], rough);
    window_.resize(900, 700);
    window_.hide();
    QTest::qWait(100);
    window_.show();
    window_.resize(1300, 860);
    settle();
    EXPECT_EQ(window_.canvas().progress().droppedSamples, 0u);
    for (const char* layer : {"original", "depth", "normals", "segments", "backDepth", "coverage", "result"}) {
        test::child<QAction>(window_, (std::string("actionLayer_") + layer).c_str())->trigger();
        settle();
        QTest::qWait(50);
    }
    EXPECT_EQ(window_.findChild<QObject*>("errorDialog"), nullptr);
}

TEST_F(CanvasWindowTest, AStrokeOfTheBrushIsOneStepAndShows) {
    open();
    setSamples(1);
    window_.workspace().select(label("bag"));
    chooseBrdf("lambert");
    auto* add = test::child<QComboBox>(window_, "driveAdd");
    add->setCurrentIndex(add->findData(QStringLiteral("albedo")));
    emit add->activated(add->currentIndex());
    ASSERT_EQ(window_.workspace().paintedParameter(), "albedo");
    settle();
    const core::Drive& drive = *window_.workspace().paintedDrive();
    EXPECT_EQ(drive.mask->value(180, 420), 0.0f);
    const QColor unpainted = screenColor(180, 420);

    ui::CanvasWindow* native = nullptr;
    for (QWindow* each : QGuiApplication::allWindows())
        if (auto* canvas = qobject_cast<ui::CanvasWindow*>(each)) native = canvas;
    ASSERT_NE(native, nullptr);
    // A mask shown in red at once, the picture later; the thread of the window is never held up.
    test::StallMeter stalls;
    QTest::mousePress(native, Qt::LeftButton, {}, widgetPixel(140, 420));
    for (int x = 140; x <= 220; x += 4) {
        QTest::mouseMove(native, widgetPixel(x, 420));
        QTest::qWait(15);
    }
    const auto overlayShown = [&] { return screenColor(180, 420).red() > unpainted.red() / 2 + 60; };
    EXPECT_TRUE(test::waitUntil(overlayShown, 1000));
    QTest::mouseRelease(native, Qt::LeftButton, {}, widgetPixel(220, 420));
    const qint64 longest = stalls.longest();
    RecordProperty("longest_stall_ms", static_cast<int>(longest));
    EXPECT_LT(static_cast<double>(longest), static_cast<double>(kLongestStall) * othersShare());
    const core::Drive* painted = window_.workspace().paintedDrive();
    ASSERT_NE(painted, nullptr);
    EXPECT_EQ(painted->mask->value(180, 420), 1.0f);
    EXPECT_EQ(painted->mask->value(180, 460), 0.0f);
    EXPECT_EQ(window_.workspace().selectedLabel(), label("bag")) << "painting selects nothing";

    test::child<QToolButton>(window_, "drive_albedo_paint")->click();
    EXPECT_EQ(window_.workspace().paintedParameter(), "");
    settle();
    QTest::qWait(100);
    EXPECT_LT(screenColor(180, 420).green(), unpainted.green() - 20) << "white is the dark end";
    test::child<QAction>(window_, "actionUndo")->trigger();
    EXPECT_EQ(window_.workspace().selectedSegment()->edit->drives[0].mask->value(180, 420), 0.0f);
    EXPECT_EQ(window_.workspace().selectedSegment()->edit->drives.size(), 1u) << "one stroke, one step";
    EXPECT_EQ(window_.findChild<QObject*>("errorDialog"), nullptr);
}

TEST_F(CanvasWindowTest, RulerShowsTheSizeOfATranslucentSegment) {
    open();
    setSamples(1);
    window_.workspace().editScene(QStringLiteral("fewer samples"),
                                  [](core::Scene& scene) { scene.render.surfaceSamples = 500; });
    window_.workspace().select(label("vase"));
    chooseBrdf("lambert");
    // White pixels of the longest row at the picture's lower left, where the sample has a dark table.
    const auto barLength = [&] {
        settle();
        QTest::qWait(100);
        const ui::Canvas& canvas = window_.canvas();
        const QPoint corner = widgetPixel(0, window_.workspace().scene().photo->color.height() - 1);
        const QPoint global = canvas.mapToGlobal(corner - QPoint(0, 80));
        const QImage image = window_.screen()->grabWindow(0, global.x(), global.y(), 300, 80).toImage();
        int longest = 0;
        for (int y = 0; y < image.height(); ++y) {
            int white = 0;
            for (int x = 0; x < image.width(); ++x) white += qGray(image.pixel(x, y)) > 250 ? 1 : 0;
            longest = std::max(longest, white);
        }
        return longest;
    };
    EXPECT_LT(barLength(), 20) << "an opaque segment";
    auto* group = test::child<QGroupBox>(window_, "translucency");
    group->setChecked(true);
    emit group->clicked(true);
    const int length = barLength();
    EXPECT_GT(length, 78);
    EXPECT_LT(length, 203);
    test::child<QAction>(window_, "actionRuler")->setChecked(false);
    EXPECT_LT(barLength(), 20) << "hidden";
    test::child<QAction>(window_, "actionRuler")->setChecked(true);
    EXPECT_GT(barLength(), 78);
    window_.workspace().select(label("bag"));
    EXPECT_LT(barLength(), 20) << "another segment";
}

TEST_F(CanvasWindowTest, WhatIsDrawnInPartsIsWhatIsDrawnAtOnce) {
    open();
    setSamples(1);
    window_.workspace().select(label("vase"));
    chooseBrdf("ggx");
    settle();
    ui::Canvas& canvas = window_.canvas();
    const auto screen = [&] {
        QTest::qWait(200);
        const QPoint corner = canvas.mapToGlobal(QPoint(0, 0));
        return window_.screen()->grabWindow(0, corner.x(), corner.y(), canvas.width(), canvas.height()).toImage();
    };
    auto* alpha = test::child<QSlider>(window_, "alphaSlider");
    int position = 200;
    for (const double zoom : {0.6, 1.5, 2.0}) {
        canvas.setZoom(zoom);
        const QImage before = screen();
        for (int i = 0; i < 4; ++i) {  // frames in which only the vase is drawn
            alpha->setValue(position += 50);
            QTest::qWait(30);
        }
        settle();
        const QImage parts = screen();
        EXPECT_NE(parts, before);
        canvas.setExposure(0);  // as it is, but all is drawn again
        EXPECT_EQ(screen(), parts) << zoom;
    }
}

TEST_F(CanvasWindowTest, AResizedWindowShowsAllOfItsPicture) {
    open();
    setSamples(1);
    settle();
    ui::Canvas& canvas = window_.canvas();
    const auto screen = [&] {
        QTest::qWait(200);
        const QPoint corner = canvas.mapToGlobal(QPoint(0, 0));
        return window_.screen()->grabWindow(0, corner.x(), corner.y(), canvas.width(), canvas.height()).toImage();
    };
    for (int round = 0; round < 6; ++round) {
        window_.resize(878, 480);
        QTest::qWait(150);
        window_.resize(1580, 980);
        const QImage resized = screen();
        canvas.setExposure(0);  // as it is, but all is drawn again
        EXPECT_EQ(screen(), resized) << "round " << round;
    }
}

// Only the order of things can be tested: no driver can be asked to lose its device.
TEST_F(CanvasWindowTest, StartsAgainAfterTheDeviceWasLost) {
    open();
    setSamples(1);
    settle();
    auto* message = test::child<QLabel>(window_, "canvasMessage");
    ui::CanvasWindow* native = nullptr;
    for (QWindow* each : QGuiApplication::allWindows())
        if (auto* canvas = qobject_cast<ui::CanvasWindow*>(each)) native = canvas;
    ASSERT_NE(native, nullptr);
    for (int loss = 0; loss < 4; ++loss) {
        native->renderer()->logicalDeviceLost();
        ASSERT_TRUE(test::waitUntil([&] { return message->isVisible(); }, 5000));
        EXPECT_TRUE(message->text().contains(QStringLiteral("is being restarted"))) << message->text().toStdString();
        if (loss < 3) {
            ASSERT_TRUE(test::waitUntil([&] { return !message->isVisible() && window_.settled(); }, 60000)) << loss;
        }
    }
    ASSERT_TRUE(
        test::waitUntil([&] { return message->text().contains(QStringLiteral("whenever this picture")); }, 5000));
    window_.workspace().select(label("vase"));
    chooseBrdf("lambert");
    ASSERT_TRUE(test::waitUntil([&] { return !message->isVisible() && window_.settled(); }, 60000))
        << "after another edit";
}

TEST_F(CanvasWindowTest, TheStartPageShowsTheResult) {
    open();
    setSamples(2);
    segmentList().setCurrentIndex(row("bowl"));
    chooseBrdf("phong");
    settle();
    const QString project = folder_.filePath("edited.patina");
    window_.saveTo(project);
    settle();
    const QImage small = ui::RecentFiles::thumbnail(project);
    const QImage photograph = ui::makeThumbnail(window_.workspace().scene().photo->color);
    ASSERT_EQ(small.size(), photograph.size());
    EXPECT_LE(std::max(small.width(), small.height()), ui::kThumbnailSide);
    // It differs where the bowl is, and only there.
    const core::LabelImage& labels = window_.workspace().scene().photo->labels;
    const std::uint16_t bowl = label("bowl");
    double inside = 0, outside = 0, insideCount = 0, outsideCount = 0;
    for (int y = 0; y < small.height(); ++y)
        for (int x = 0; x < small.width(); ++x) {
            const QColor a = small.pixelColor(x, y), b = photograph.pixelColor(x, y);
            const double difference =
                std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
            const bool here = labels(x * labels.width() / small.width(), y * labels.height() / small.height()) == bowl;
            (here ? inside : outside) += difference;
            (here ? insideCount : outsideCount) += 1;
        }
    EXPECT_GT(inside / insideCount, 20);
    EXPECT_LT(outside / outsideCount, 10);
    // Opening it again does not put the photograph in its place.
    window_.openFile(project);
    ASSERT_TRUE(test::waitUntil([&] { return !window_.working(); }, 60000));
    EXPECT_EQ(ui::RecentFiles::thumbnail(project), small);
}

}  // namespace
