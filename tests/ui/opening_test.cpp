// SPDX-License-Identifier: GPL-3.0-or-later
// The way to the first picture: start page, opening dialog, depth in space.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QToolButton>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>

#include "core/io/image_io.h"
#include "core/io/project.h"
#include "core/scene/segments.h"
#include "tests/ui/support.h"
#include "ui/main_window.h"
#include "ui/new_photo_dialog.h"
#include "ui/recent_files.h"
#include "ui/samples.h"
#include "ui/start_page.h"
#include "ui/widgets/depth_view.h"
#include "ui/widgets/notice_button.h"

namespace {

const QString kStudioProject = QStringLiteral(PATINA_SAMPLES "/studio/studio.patina");

/// Mean position of the pixels of one colour; the first value is negative when there is none.
Eigen::Vector2d placeOf(QRgb color, const QImage& image) {
    Eigen::Vector2d sum(0, 0);
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixel(x, y) == color) {
                sum += Eigen::Vector2d(x + 0.5, y + 0.5);
                ++count;
            }
    return count > 0 ? Eigen::Vector2d(sum / count) : Eigen::Vector2d(-1, -1);
}

std::shared_ptr<ui::DepthPoints> fewPoints() {
    auto points = std::make_shared<ui::DepthPoints>();
    points->camera = {200, 100, 100, 110, 90, 55};
    points->positions = {{0, 0, 2}, {0.5f, -0.2f, 1.5f}, {-0.4f, 0.3f, 3}};
    points->colors = {qRgb(255, 0, 0), qRgb(0, 255, 0), qRgb(0, 0, 255)};
    points->sizes = {1e-4f, 1e-4f, 1e-4f};
    points->nearest = 1.5f;
    points->middle = 2;
    points->farthest = 3;
    return points;
}

TEST(DepthViewTest, PointsAreWhereASecondCameraSeesThem) {
    const auto points = fewPoints();
    const QSize size(420, 300);
    ui::DepthView view;
    view.resize(size);
    view.setPoints(points);
    for (const auto& [yaw, pitch] : {std::pair{0.0, 0.0}, {0.5, 0.0}, {-0.3, 0.4}, {1.2, -0.6}}) {
        SCOPED_TRACE(std::to_string(yaw) + " " + std::to_string(pitch));
        view.setAngles(yaw, pitch);
        const QImage image = view.drawPoints(size);
        // A camera that stands aside and looks at the middle, from its place and what it looks at.
        const Eigen::Vector3d target(0, 0, 2);
        const Eigen::Vector3d place = target + 2 * Eigen::Vector3d(std::sin(yaw) * std::cos(pitch), -std::sin(pitch),
                                                                   -std::cos(yaw) * std::cos(pitch));
        const Eigen::Vector3d forward = (target - place).normalized();
        const Eigen::Vector3d right = Eigen::Vector3d(0, 1, 0).cross(forward).normalized();
        const Eigen::Vector3d down = forward.cross(right);
        const double scale = std::min(size.width() / 200.0, size.height() / 100.0) * view.zoom();
        for (std::size_t i = 0; i < points->positions.size(); ++i) {
            const Eigen::Vector3d p = points->positions[i].cast<double>() - place;
            const Eigen::Vector2d expected(
                size.width() * (0.5 + view.shift().x()) + scale * (90 - 100 + 100 * p.dot(right) / p.dot(forward)),
                size.height() * (0.5 + view.shift().y()) + scale * (55 - 50 + 110 * p.dot(down) / p.dot(forward)));
            const Eigen::Vector2d seen = placeOf(points->colors[i], image);
            EXPECT_LT((seen - expected).norm(), 1) << i << ": " << seen.transpose() << ", " << expected.transpose();
        }
    }
}

TEST(DepthViewTest, FromTheFrontItIsThePhotograph) {
    core::Camera camera = core::Camera::fromHorizontalFov(60, 40, 0.9f);
    camera.cx += 4;
    core::ImageRgb color(60, 40);
    core::ImageF depth(60, 40);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x) {
            color(x, y) = {static_cast<float>(x) / 60, static_cast<float>(y) / 40, 0.5f};
            depth(x, y) = x < 30 ? 1.0f + 0.01f * static_cast<float>(y) : 4.0f;
        }
    const auto points = std::make_shared<ui::DepthPoints>(ui::makeDepthPoints(color, depth, camera));
    ASSERT_EQ(points->positions.size(), color.size());
    ui::DepthView view;
    view.resize(240, 160);
    view.setPoints(points);
    view.showSide(ui::DepthView::Side::Front);
    const QImage image = view.drawPoints({240, 160});
    for (int y = 1; y < 40; y += 3)
        for (int x = 1; x < 60; x += 3) {
            if (x > 27 && x < 32) continue;
            // Four screen pixels stand for one of the photograph; neighbours may overlap at their borders.
            const QColor seen = image.pixelColor(4 * x + 2, 4 * y + 2);
            const QColor expected = QColor::fromRgb(points->colors[static_cast<std::size_t>(y * 60 + x)]);
            EXPECT_LE(std::abs(seen.red() - expected.red()) + std::abs(seen.green() - expected.green()), 24)
                << x << ", " << y;
        }
}

TEST(DepthViewTest, NearPointsHideFarOnes) {
    auto points = fewPoints();
    points->positions = {{0, 0, 2.5f}, {0, 0, 1.5f}, {0, 0, 2}};
    ui::DepthView view;
    view.resize(200, 100);
    view.setPoints(points);
    view.setAngles(0, 0);
    const QImage image = view.drawPoints({200, 100});
    EXPECT_GE(placeOf(points->colors[1], image).x(), 0);
    EXPECT_LT(placeOf(points->colors[0], image).x(), 0);
    view.setAngles(std::numbers::pi / 2, 0);
    const QImage side = view.drawPoints({200, 100});
    EXPECT_LT(placeOf(points->colors[1], side).x(), placeOf(points->colors[2], side).x()) << "near is at the left";
    EXPECT_LT(placeOf(points->colors[2], side).x(), placeOf(points->colors[0], side).x());
    view.setAngles(0, std::numbers::pi / 2);
    const QImage top = view.drawPoints({200, 100});
    EXPECT_GT(placeOf(points->colors[1], top).y(), placeOf(points->colors[0], top).y()) << "near is at the bottom";
}

TEST(DepthViewTest, StrangePointsAreHarmless) {
    auto points = fewPoints();
    points->positions = {{1e30f, 0, 1e30f}, {0, 0, 1e-30f}, {0, -1e20f, 5}};
    points->sizes = {1e30f, 1e-30f, 1};
    ui::DepthView view;
    view.resize(100, 80);
    for (const float middle : {1e-30f, 2.0f, 1e4f}) {
        points->middle = middle;
        view.setPoints(points);
        for (const auto side : {ui::DepthView::Side::Turned, ui::DepthView::Side::Top, ui::DepthView::Side::Right}) {
            view.showSide(side);
            EXPECT_FALSE(view.grab().isNull());
        }
    }
    view.setPoints(nullptr, "nothing");
    EXPECT_FALSE(view.grab().isNull());
}

/// Time that this thread has computed, whatever else the machine does [ms].
double threadMilliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

TEST(DepthViewTest, TurnsAtThirtyFramesASecond) {
    constexpr int kWidth = 365;
    constexpr int kHeight = 273;
    const core::Camera camera = core::Camera::fromHorizontalFov(kWidth, kHeight, 1.1f);
    const core::ImageRgb color(kWidth, kHeight, core::Vector3f(0.2f, 0.4f, 0.3f));
    core::ImageF depth(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            depth(x, y) = 1 + 0.4f * std::sin(0.04f * static_cast<float>(x)) * std::cos(0.06f * static_cast<float>(y));
    const auto points = std::make_shared<ui::DepthPoints>(ui::makeDepthPoints(color, depth, camera));
    ASSERT_GE(points->positions.size(), 99000U);
    ASSERT_LE(points->positions.size(), static_cast<std::size_t>(ui::kMaxDepthPoints));
    ui::DepthView view;
    const QSize size(960, 720);
    view.resize(size);
    view.setPoints(points);
    constexpr int kFrames = 40;
    std::vector<double> milliseconds;
    for (int i = 0; i < kFrames; ++i) {
        view.setAngles(-1.2 + 2.4 * i / kFrames, 0.3);
        const double start = threadMilliseconds();
        const QPixmap frame = view.grab();
        milliseconds.push_back(threadMilliseconds() - start);
    }
    std::sort(milliseconds.begin(), milliseconds.end());
    const double middle = milliseconds[kFrames / 2];
    std::printf("depth view, %zu points, %d x %d: %.1f ms of computing per frame (slowest %.1f ms)\n",
                points->positions.size(), size.width(), size.height(), middle, milliseconds.back());
    EXPECT_LT(middle, 33);
}

/// Opening in the whole window without a canvas.
class Opening : public testing::Test {
  protected:
    Opening() : window_({.canvas = false, .device = {}}) {
        window_.resize(1200, 800);
        window_.show();
    }
    ~Opening() override { QSettings().clear(); }

    [[nodiscard]] QString file(const QString& name) const { return folder_.filePath(name); }
    /// A card in front of a slanted wall, 64 x 48 pixels.
    void writeColor(const QString& name, int width = 64, int height = 48) const {
        core::ImageRgb color(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                color(x, y) = card(x, y) ? core::Vector3f(0.8f, 0.3f, 0.1f)
                                         : core::Vector3f(0.1f, 0.02f * static_cast<float>(x % 32), 0.4f);
        core::saveColor(color, file(name).toStdString());
    }
    void writeDepth(const QString& name, int width = 64, int height = 48) const {
        core::ImageF depth(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) depth(x, y) = card(x, y) ? 1.0f : 2.0f + 0.01f * static_cast<float>(x);
        core::saveScalar(depth, file(name).toStdString(), "Z");
    }
    static bool card(int x, int y) { return x >= 20 && x < 40 && y >= 12 && y < 36; }

    ui::NewPhotoDialog* openDialog(const QString& name) {
        window_.openFile(file(name));
        auto* dialog = test::child<ui::NewPhotoDialog>(window_, "newPhotoDialog");
        settle(*dialog);
        return dialog;
    }
    static void settle(ui::NewPhotoDialog& dialog) {
        ASSERT_TRUE(test::waitUntil([&] { return dialog.upToDate(); }, 20000));
        // A suggested depth map is entered after the photograph has been read.
        QTest::qWait(1);
        ASSERT_TRUE(test::waitUntil([&] { return dialog.upToDate(); }, 20000));
    }
    static ui::DepthView& view(ui::NewPhotoDialog& dialog) {
        return *test::child<ui::DepthView>(dialog, "newDepthView");
    }
    static QImage picture(ui::NewPhotoDialog& dialog) {
        settle(dialog);
        return view(dialog).grab().toImage();
    }
    void waitForPhoto() {
        ASSERT_TRUE(test::waitUntil([&] { return window_.workspace().hasPhoto() && !window_.working(); }, 20000));
    }
    [[nodiscard]] const core::Photo& photo() { return *window_.workspace().scene().photo; }
    [[nodiscard]] int noticesWith(const QString& part) {
        return static_cast<int>(test::child<ui::NoticeButton>(window_, "notices")->notices().filter(part).size());
    }
    QListWidget& recent() { return *test::child<QListWidget>(window_, "startRecent"); }
    static QPoint middleOf(QListWidget& list, int row) { return list.visualItemRect(list.item(row)).center(); }

    QTemporaryDir folder_;
    ui::MainWindow window_;
};

TEST_F(Opening, EverySwitchChangesThePictureOfTheDepth) {
    writeColor("vase.png");
    writeDepth("vase_depth.exr");
    ui::NewPhotoDialog& dialog = *openDialog("vase.png");
    EXPECT_EQ(test::child<QLineEdit>(dialog, "newDepth")->text(), file("vase_depth.exr")) << "found by its name";
    ASSERT_NE(view(dialog).points(), nullptr) << view(dialog).reason().toStdString();
    const QImage first = picture(dialog);
    QImage before = first;
    const auto changed = [&](const char* what) {
        const QImage now = picture(dialog);
        EXPECT_NE(now, before) << what;
        before = now;
    };
    auto* kind = test::child<QComboBox>(dialog, "newDepthKind");
    ASSERT_TRUE(kind->isEnabled());
    kind->setFocus();
    for (const char* name : {"distance", "disparity"}) {
        QTest::keyClick(kind, Qt::Key_Down);
        changed(name);
    }
    QTest::keyClick(kind, Qt::Key_Down);
    EXPECT_EQ(dialog.options().depthKind, core::DepthKind::Inverse);
    QTest::keyClick(kind, Qt::Key_Home);
    EXPECT_EQ(dialog.options().depthKind, core::DepthKind::Z);
    EXPECT_EQ(picture(dialog), first);
    before = first;

    const float middle = view(dialog).points()->middle;
    const float card = view(dialog).points()->nearest;
    QTest::mouseClick(test::child<QPushButton>(dialog, "newExchange"), Qt::LeftButton);
    changed("near and far");
    EXPECT_NEAR(view(dialog).points()->middle, middle, 0.011f) << "the middle stays where it is, to one column";
    EXPECT_NEAR(view(dialog).points()->farthest, middle * middle / card, 0.01f) << "the card is behind the wall now";
    QTest::mouseClick(test::child<QPushButton>(dialog, "newExchange"), Qt::LeftButton);
    changed("near and far back");
    EXPECT_EQ(picture(dialog), first);

    test::child<QDoubleSpinBox>(dialog, "newDepthUnit")->setValue(0.3);
    changed("unit");
    EXPECT_NEAR(view(dialog).points()->middle, 0.3f * middle, 1e-3f);
    test::child<QDoubleSpinBox>(dialog, "newFieldOfView")->setValue(25);
    changed("field of view");
    for (const char* side : {"newViewFront", "newViewTop", "newViewSide", "newViewTurned"}) {
        QTest::mouseClick(test::child<QToolButton>(dialog, side), Qt::LeftButton);
        changed(side);
    }

    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open)->click();
    waitForPhoto();
    EXPECT_NEAR(photo().depth(30, 24), 0.3f, 1e-5f) << "what was shown is what is opened";
    EXPECT_NEAR(photo().camera.fx, 32 / std::tan(12.5 * std::numbers::pi / 180), 0.01);
}

TEST_F(Opening, TheMouseTurnsAndZoomsTheDepth) {
    writeColor("vase.png");
    writeDepth("vase_depth.exr");
    ui::NewPhotoDialog& dialog = *openDialog("vase.png");
    ui::DepthView& depth = view(dialog);
    const QImage first = picture(dialog);
    const double yaw = depth.yaw();
    const QPoint start = depth.rect().center();
    QTest::mousePress(&depth, Qt::LeftButton, {}, start);
    QTest::mouseMove(&depth, start + QPoint(40, 25));
    QTest::mouseRelease(&depth, Qt::LeftButton, {}, start + QPoint(40, 25));
    EXPECT_LT(depth.yaw(), yaw) << "the scene follows the pointer, so the camera goes the other way";
    const QImage turned = picture(dialog);
    EXPECT_NE(turned, first);
    QTest::keyClick(&depth, Qt::Key_Left);
    EXPECT_NE(picture(dialog), turned);
    QTest::keyClick(&depth, Qt::Key_Plus);
    EXPECT_GT(depth.zoom(), 0);
    QTest::mouseDClick(&depth, Qt::LeftButton, {}, start);
    QTest::mouseRelease(&depth, Qt::LeftButton, {}, start);
    test::child<QPushButton>(dialog, "newColorBrowse")->setFocus();
    const QImage again = picture(dialog);
    QTest::mouseMove(&depth, start + QPoint(3, 3));
    EXPECT_EQ(depth.yaw(), yaw);
    EXPECT_EQ(again, first);
}

TEST_F(Opening, EnterOpensWhatWasRead) {
    writeColor("vase.png");
    writeDepth("vase_depth.exr");
    ui::NewPhotoDialog& dialog = *openDialog("vase.png");
    // They are not read again.
    for (const char* name : {"vase.png", "vase_depth.exr"}) ASSERT_TRUE(QFile::remove(file(name)));
    QTest::keyClick(&dialog, Qt::Key_Return);
    waitForPhoto();
    EXPECT_EQ(photo().depth(30, 24), 1);
    EXPECT_FALSE(dialog.isVisible());
}

TEST_F(Opening, EnterWhileReadingOpensAfterwards) {
    writeColor("vase.png");
    writeDepth("vase_depth.exr");
    window_.openFile(file("vase.png"));
    auto* dialog = test::child<ui::NewPhotoDialog>(window_, "newPhotoDialog");
    QTest::keyClick(dialog, Qt::Key_Return);
    waitForPhoto();
    EXPECT_EQ(photo().depth(30, 24), 1) << "with the depth map beside it";
}

TEST_F(Opening, APhotographWithoutDepthOpensAndSaysWhatIsMissing) {
    writeColor("alone.png");
    ui::NewPhotoDialog& dialog = *openDialog("alone.png");
    EXPECT_EQ(view(dialog).points(), nullptr);
    EXPECT_TRUE(view(dialog).reason().contains("No depth found")) << view(dialog).reason().toStdString();
    EXPECT_FALSE(test::child<QComboBox>(dialog, "newDepthKind")->isEnabled());
    QTest::keyClick(&dialog, Qt::Key_Return);
    waitForPhoto();
    EXPECT_EQ(photo().depth(30, 24), 0);
    EXPECT_EQ(noticesWith("materials cannot be changed"), 1);
    ASSERT_TRUE(test::waitUntil([&] { return window_.settled(); }, 60000));
    auto* error = window_.findChild<QMessageBox*>("errorDialog");
    EXPECT_EQ(error, nullptr) << (error != nullptr ? error->text().toStdString() : "");
}

TEST_F(Opening, AWrongFileSaysSoAndKeepsWhatWasEntered) {
    QFile broken(file("broken.png"));
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("no picture");
    broken.close();
    ui::NewPhotoDialog& dialog = *openDialog("broken.png");
    EXPECT_TRUE(view(dialog).reason().contains("broken.png")) << view(dialog).reason().toStdString();
    test::child<QDoubleSpinBox>(dialog, "newFieldOfView")->setValue(44);
    test::child<QLineEdit>(dialog, "newSegments")->setText("labels.png");
    QTest::keyClick(&dialog, Qt::Key_Return);
    auto* problem = test::child<QLabel>(dialog, "newProblem");
    ASSERT_TRUE(test::waitUntil([&] { return problem->isVisible(); }, 20000));
    EXPECT_TRUE(problem->text().contains("broken.png"));
    EXPECT_TRUE(dialog.isVisible());
    EXPECT_EQ(test::child<QDoubleSpinBox>(dialog, "newFieldOfView")->value(), 44);
    EXPECT_EQ(test::child<QLineEdit>(dialog, "newSegments")->text(), "labels.png");
    EXPECT_EQ(test::child<QLineEdit>(dialog, "newColor")->text(), file("broken.png"));
}

TEST_F(Opening, DepthOfOtherProportionsIsStated) {
    writeColor("vase.png");
    writeDepth("vase_depth.exr", 48, 48);
    ui::NewPhotoDialog& dialog = *openDialog("vase.png");
    EXPECT_TRUE(view(dialog).reason().contains("48x48")) << view(dialog).reason().toStdString();
    EXPECT_TRUE(view(dialog).reason().contains("64x48"));
    QTest::keyClick(&dialog, Qt::Key_Return);
    ASSERT_TRUE(test::waitUntil([&] { return test::child<QLabel>(dialog, "newProblem")->isVisible(); }, 20000));
    EXPECT_FALSE(window_.workspace().hasPhoto()) << "not opened without the depth that was asked for";
    test::child<QLineEdit>(dialog, "newDepth")->clear();
    QTest::keyClick(&dialog, Qt::Key_Return);
    waitForPhoto();
    EXPECT_EQ(photo().depth(30, 24), 0);
}

TEST_F(Opening, AnUnknownUnitIsAssumedAndSaid) {
    writeColor("vase.png");
    QImage map(64, 48, QImage::Format_Grayscale8);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) map.setPixel(x, y, card(x, y) ? qRgb(90, 90, 90) : qRgb(200, 200, 200));
    ASSERT_TRUE(map.save(file("vase_depth.png")));
    ui::NewPhotoDialog& dialog = *openDialog("vase.png");
    ASSERT_NE(view(dialog).points(), nullptr) << view(dialog).reason().toStdString();
    EXPECT_TRUE(test::child<QLabel>(dialog, "newDepthText")->text().contains("assumed"));
    QTest::keyClick(&dialog, Qt::Key_Return);
    waitForPhoto();
    EXPECT_NEAR(photo().depth(2, 2), 1, 1e-4f);
    EXPECT_NEAR(photo().depth(30, 24), 0.45f, 1e-4f);
}

TEST_F(Opening, TheNameOfAMapTellsItsKind) {
    writeColor("vase.png");
    writeDepth("vase_disparity.exr");
    ui::NewPhotoDialog& dialog = *openDialog("vase.png");
    EXPECT_EQ(dialog.options().depthKind, core::DepthKind::Disparity);
    EXPECT_EQ(test::child<QComboBox>(dialog, "newDepthKind")->currentData().toInt(),
              static_cast<int>(core::DepthKind::Disparity));
    writeColor("pot.png");
    test::child<QLineEdit>(dialog, "newColor")->setText(file("pot.png"));
    settle(dialog);
    EXPECT_EQ(test::child<QLineEdit>(dialog, "newDepth")->text(), "") << "it belonged to the other photograph";
}

TEST_F(Opening, SegmentsAreUnderMore) {
    writeColor("vase.png");
    ui::NewPhotoDialog& dialog = *openDialog("vase.png");
    auto* segments = test::child<QLineEdit>(dialog, "newSegments");
    EXPECT_FALSE(segments->isVisible());
    QTest::mouseClick(test::child<QToolButton>(dialog, "newMore"), Qt::LeftButton);
    EXPECT_TRUE(segments->isVisible());
}

TEST_F(Opening, TheStartPageOpensRecentFilesByClickAndByKey) {
    EXPECT_TRUE(test::child<QWidget>(window_, "startPage")->isVisible());
    EXPECT_FALSE(recent().isVisible()) << "nothing was opened yet";
    writeColor("vase.png");
    writeDepth("vase_depth.exr");
    openDialog("vase.png");
    QTest::keyClick(test::child<ui::NewPhotoDialog>(window_, "newPhotoDialog"), Qt::Key_Return);
    waitForPhoto();
    EXPECT_FALSE(test::child<QWidget>(window_, "startPage")->isVisible());
    window_.saveTo(file("vase.patina"));
    ASSERT_TRUE(test::waitUntil([&] { return !window_.working(); }, 20000));
    const auto opens = [&](const QString& name, const std::function<void(QListWidget&, int)>& act) {
        SCOPED_TRACE(name.toStdString());
        ui::MainWindow fresh({.canvas = false, .device = {}});
        fresh.resize(1200, 800);
        fresh.show();
        auto& list = *test::child<QListWidget>(fresh, "startRecent");
        ASSERT_TRUE(list.isVisible());
        QTest::qWait(10);
        int row = 0;
        while (row < list.count() && list.item(row)->text() != name) ++row;
        ASSERT_LT(row, list.count());
        EXPECT_FALSE(ui::RecentFiles::thumbnail(file(name)).isNull());
        act(list, row);
        ASSERT_TRUE(test::waitUntil([&] { return fresh.workspace().hasPhoto() && !fresh.working(); }, 20000));
        EXPECT_EQ(fresh.workspace().scene().photo->depth(30, 24), 1);
        EXPECT_FALSE(list.isVisible());
    };
    opens("vase.patina", [](QListWidget& list, int row) {
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, middleOf(list, row));
    });
    opens("vase.png", [](QListWidget& list, int row) {
        list.setFocus();
        list.setCurrentRow(row);
        QTest::keyClick(&list, Qt::Key_Return);
    });
}

TEST_F(Opening, ThePictureOfARecentFileIsThatFile) {
    writeColor("vase.png");
    openDialog("vase.png");
    QTest::keyClick(test::child<ui::NewPhotoDialog>(window_, "newPhotoDialog"), Qt::Key_Return);
    waitForPhoto();
    const QImage small = ui::RecentFiles::thumbnail(file("vase.png"));
    ASSERT_EQ(small.size(), QSize(64, 48));
    const QImage whole(file("vase.png"));
    const QColor a = small.pixelColor(30, 24);
    const QColor b = whole.pixelColor(30, 24);
    EXPECT_LE(std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()), 4);
    core::ImageRgb large(2000, 500, core::Vector3f(1, 0, 0));
    const QImage reduced = ui::makeThumbnail(large);
    EXPECT_EQ(reduced.width(), ui::kThumbnailSide);
    EXPECT_EQ(reduced.pixelColor(10, 10).red(), 255);
    EXPECT_TRUE(ui::makeThumbnail(core::ImageRgb()).isNull());
}

TEST_F(Opening, AFileThatIsGoneIsGreyAndCanBeRemoved) {
    for (const char* name : {"a.patina", "b.patina"}) {
        QFile::copy(kStudioProject, file(name));
        ui::RecentFiles::add(file(name));
    }
    ASSERT_TRUE(QFile::remove(file("a.patina")));
    test::child<ui::StartPage>(window_, "startPage")->refresh();
    QTest::qWait(10);
    ASSERT_EQ(recent().count(), 2);
    const QListWidgetItem* gone = recent().item(1);
    EXPECT_TRUE(gone->text().startsWith("a.patina"));
    EXPECT_TRUE(gone->text().contains("not found"));
    EXPECT_TRUE(gone->toolTip().contains("moved, renamed or deleted")) << gone->toolTip().toStdString();
    EXPECT_NE(gone->foreground().color(), recent().item(0)->foreground().color());
    QTest::mouseClick(recent().viewport(), Qt::LeftButton, {}, middleOf(recent(), 1));
    QTest::qWait(20);
    EXPECT_FALSE(window_.working());
    EXPECT_FALSE(window_.workspace().hasPhoto());
    EXPECT_EQ(recent().currentRow(), 1);
    QTest::keyClick(&recent(), Qt::Key_Delete);
    EXPECT_EQ(recent().count(), 1);
    EXPECT_EQ(ui::RecentFiles::files(), QStringList{file("b.patina")});
    recent().setCurrentRow(0);
    QTest::mouseClick(test::child<QPushButton>(window_, "startRemove"), Qt::LeftButton);
    EXPECT_TRUE(ui::RecentFiles::files().isEmpty());
    EXPECT_TRUE(QFile::exists(file("b.patina"))) << "only the entry goes";
}

TEST_F(Opening, TheSampleOpensEditedAndAsANewProject) {
    ASSERT_FALSE(ui::bundledSamples().empty());
    auto& samples = *test::child<QListWidget>(window_, "startSamples");
    ASSERT_EQ(samples.count(), static_cast<int>(ui::bundledSamples().size()));
    QTest::qWait(10);
    QTest::mouseClick(samples.viewport(), Qt::LeftButton, {}, middleOf(samples, 0));
    ASSERT_TRUE(test::waitUntil([&] { return window_.workspace().hasPhoto() && !window_.working(); }, 60000));
    const core::Scene& scene = window_.workspace().scene();
    EXPECT_TRUE(std::ranges::any_of(scene.segments, [](const core::Segment& s) { return s.edit.has_value(); }));
    EXPECT_TRUE(window_.workspace().document().path().empty()) << "saving must not write into the program's files";
    EXPECT_TRUE(ui::RecentFiles::files().isEmpty());
}

TEST_F(Opening, TheStartPageIsReachedByKeyboard) {
    QFile::copy(kStudioProject, file("a.patina"));
    ui::RecentFiles::add(file("a.patina"));
    auto* page = test::child<ui::StartPage>(window_, "startPage");
    page->refresh();
    test::child<QPushButton>(window_, "startOpen")->setFocus();
    QStringList reached;
    for (int i = 0; i < 6; ++i) {
        QWidget* focus = page->focusWidget();
        if (focus == nullptr) break;
        reached << focus->objectName();
        QTest::keyClick(focus, Qt::Key_Tab);
    }
    for (const char* name : {"startOpen", "startRecent", "startSamples"})
        EXPECT_TRUE(reached.contains(QString::fromUtf8(name))) << reached.join(' ').toStdString();
    for (const auto* list : page->findChildren<QListWidget*>()) EXPECT_FALSE(list->accessibleName().isEmpty());
}

TEST_F(Opening, WithoutDepthTheMaterialAndTheToolsSayWhatIsMissing) {
    const auto makeSegment = [&] {
        core::BinaryMask mask(64, 48);
        mask(30, 24) = 1;
        window_.workspace().editScene("segment",
                                      [&](core::Scene& scene) { scene = core::withSegment(scene, mask, "card"); });
        window_.workspace().select(1);
    };
    auto& hint = *test::child<QLabel>(window_, "materialHint");
    auto& brdf = *test::child<QComboBox>(window_, "materialBrdf");
    auto& tool = *test::child<QAction>(window_, "toolDepth");
    auto& find = *test::child<QAction>(window_, "actionFindObjects");
    writeColor("alone.png");
    QTest::keyClick(openDialog("alone.png"), Qt::Key_Return);
    waitForPhoto();
    makeSegment();
    EXPECT_FALSE(brdf.isEnabled());
    EXPECT_TRUE(hint.isVisibleTo(&window_));
    EXPECT_TRUE(hint.text().contains("no depth")) << hint.text().toStdString();
    for (QAction* action : {&tool, &find}) {
        EXPECT_FALSE(action->isEnabled());
        EXPECT_TRUE(action->toolTip().contains("needs depth")) << action->toolTip().toStdString();
    }
    writeColor("vase.png");
    writeDepth("vase_depth.exr");
    window_.workspace().document().setSaved(file("alone.patina").toStdString());
    core::CreateOptions options;
    options.color = file("vase.png").toStdString();
    options.depth = file("vase_depth.exr").toStdString();
    window_.createFrom(options);
    ASSERT_TRUE(test::waitUntil([&] { return !window_.working(); }, 20000));
    makeSegment();
    EXPECT_TRUE(brdf.isEnabled());
    EXPECT_FALSE(hint.isVisibleTo(&window_));
    for (QAction* action : {&tool, &find}) {
        EXPECT_TRUE(action->isEnabled());
        EXPECT_FALSE(action->toolTip().contains("needs depth"));
    }
}

TEST_F(Opening, WhileItReadsTheDialogShowsNothingThatNobodyKnows) {
    writeColor("vase.png");
    writeDepth("vase_depth.exr");
    window_.openFile(file("vase.png"));
    auto* dialog = test::child<ui::NewPhotoDialog>(window_, "newPhotoDialog");
    const auto boxes = {test::child<QDoubleSpinBox>(*dialog, "newDepthUnit"),
                        test::child<QDoubleSpinBox>(*dialog, "newFieldOfView")};
    const auto views = {test::child<QToolButton>(*dialog, "newViewTurned"),
                        test::child<QToolButton>(*dialog, "newViewFront"),
                        test::child<QToolButton>(*dialog, "newViewTop")};
    for (const QDoubleSpinBox* box : boxes) {
        EXPECT_FALSE(box->isEnabled());
        EXPECT_EQ(box->text().trimmed(), "");
    }
    for (const QToolButton* button : views) EXPECT_FALSE(button->isEnabled());
    EXPECT_EQ(test::child<QComboBox>(*dialog, "newDepthKind")->currentText(), "");
    settle(*dialog);
    for (const QDoubleSpinBox* box : boxes) {
        EXPECT_TRUE(box->isEnabled());
        EXPECT_TRUE(box->text().startsWith("automatic")) << box->text().toStdString();
    }
    for (const QToolButton* button : views) EXPECT_TRUE(button->isEnabled());
    EXPECT_EQ(test::child<QComboBox>(*dialog, "newDepthKind")->currentText(), "Depth along the viewing axis");
}

TEST_F(Opening, SavingProposesThePhotographsFolderAndName) {
    writeColor("vase.png");
    writeDepth("vase_depth.exr");
    QTest::keyClick(openDialog("vase.png"), Qt::Key_Return);
    waitForPhoto();
    test::child<QAction>(window_, "actionExportPicture")->trigger();
    auto* picture = test::child<QFileDialog>(window_, "exportFile");
    EXPECT_EQ(picture->directory().absolutePath(), folder_.path());
    EXPECT_EQ(QFileInfo(picture->selectedFiles().value(0)).fileName(), "vase-edited.png");
    picture->selectNameFilter(picture->nameFilters().at(1));
    emit picture->filterSelected(picture->nameFilters().at(1));
    EXPECT_EQ(picture->defaultSuffix(), "exr");
    delete picture;
    test::child<QAction>(window_, "actionSave")->trigger();
    auto* project = test::child<QFileDialog>(window_, "saveFile");
    EXPECT_EQ(project->directory().absolutePath(), folder_.path());
    auto* name = test::child<QLineEdit>(*project, "fileNameEdit");
    EXPECT_EQ(name->text(), "vase.patina");
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_TRUE(test::waitUntil([&] { return QFile::exists(file("vase.patina")) && !window_.working(); }, 20000));
    EXPECT_EQ(window_.workspace().document().path(), file("vase.patina").toStdString());
    EXPECT_EQ(ui::RecentFiles::lastFolder(), folder_.path());
}

}  // namespace
