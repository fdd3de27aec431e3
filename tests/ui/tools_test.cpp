// SPDX-License-Identifier: GPL-3.0-or-later
// Every selection tool in the real window, by the mouse and the keyboard.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLocale>
#include <QSlider>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QWindow>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/io/image_io.h"
#include "core/io/project.h"
#include "core/selection/mask_operations.h"
#include "tests/ui/support.h"
#include "ui/canvas/canvas_window.h"
#include "ui/main_window.h"
#include "ui/tools/tool_box.h"
#include "ui/tools/tool_registry.h"
#include "ui/widgets/param_slider.h"

namespace {

const QString kStudio = QStringLiteral(PATINA_SAMPLES "/studio/studio.patina");

/// Named like the other window tests on a display, which CTest runs one at a time.
class CanvasWindowTestTools : public testing::Test {
  protected:
    void SetUp() override {
        window_.resize(1400, 900);
        window_.show();
        ASSERT_TRUE(window_.canvas().available());
        window_.openFile(kStudio);
        ASSERT_TRUE(test::waitUntil([&] { return window_.workspace().hasPhoto(); }, 30000));
        ASSERT_TRUE(test::waitUntil([&] { return !window_.canvas().deviceName().isEmpty(); }, 20000));
        // A virtual display has no window manager to do it.
        QApplication::setActiveWindow(&window_);
        window_.workspace().editScene("samples", [](core::Scene& scene) { scene.render.samples = 1; });
        document().setSaved(document().path());
        for (QWindow* each : QGuiApplication::allWindows())
            if (auto* canvas = qobject_cast<ui::CanvasWindow*>(each)) native_ = canvas;
        ASSERT_NE(native_, nullptr);
        ASSERT_TRUE(test::waitUntil([&] { return window_.settled(); }, 100000));
    }
    QPoint at(int x, int y) {
        const QPointF place = window_.canvas().widgetPosition(x, y);
        return {static_cast<int>(std::floor(place.x())), static_cast<int>(std::floor(place.y()))};
    }
    void click(int x, int y, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseMove(native_, at(x, y));
        QTest::mouseClick(native_, Qt::LeftButton, modifiers, at(x, y));
        finish();
    }
    void drag(const std::vector<QPoint>& points, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(native_, Qt::LeftButton, modifiers, at(points.front().x(), points.front().y()));
        for (const QPoint& point : points) QTest::mouseMove(native_, at(point.x(), point.y()));
        QTest::mouseRelease(native_, Qt::LeftButton, modifiers, at(points.back().x(), points.back().y()));
        finish();
    }
    void key(Qt::Key key) { QTest::keyClick(&window_.canvas(), key); }
    void finish() {
        ASSERT_TRUE(test::waitUntil([&] { return !session().worker().busy(); }, 30000));
    }
    void choose(const char* tool) {
        QAction* action = test::child<QAction>(window_, tool);
        ASSERT_TRUE(action->isEnabled());
        action->trigger();
        EXPECT_EQ(window_.toolBox().chosen(), tool);
        window_.canvas().setFocus();
    }
    ui::SelectionSession& session() { return window_.toolBox().session(); }
    QAction& action(const char* name) { return *test::child<QAction>(window_, name); }
    const core::Scene& scene() { return window_.workspace().scene(); }
    core::Document& document() { return window_.workspace().document(); }
    bool isSelected(int x, int y) { return !session().selected().empty() && session().selected()(x, y) != 0; }
    std::size_t selectedCount() {
        return static_cast<std::size_t>(std::ranges::count(session().selected().pixels(), std::uint8_t{1}));
    }
    /// Overlap of the selection with a segment of the sample.
    double overlap(const char* name) {
        const std::uint16_t label = test::labelOf(scene(), name);
        const core::LabelImage& labels = scene().photo->labels;
        double both = 0, either = 0;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            const bool there = labels[i] == label, here = session().selected()[i] != 0;
            both += there && here ? 1 : 0;
            either += there || here ? 1 : 0;
        }
        return both / either;
    }
    /// A pixel far inside a segment.
    QPoint middleOf(const char* name) {
        const std::uint16_t label = test::labelOf(scene(), name);
        const core::LabelImage& labels = scene().photo->labels;
        core::BinaryMask mask(labels.width(), labels.height());
        for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = labels[i] == label ? 1 : 0;
        QPoint last;
        for (int radius = 1; radius < 200; radius += 4) {
            const core::BinaryMask inner = core::shrinkMask(mask, radius);
            std::vector<QPoint> pixels;
            for (int y = 0; y < inner.height(); ++y)
                for (int x = 0; x < inner.width(); ++x)
                    if (inner(x, y) != 0) pixels.emplace_back(x, y);
            if (pixels.empty()) break;
            last = pixels[pixels.size() / 2];
        }
        return last;
    }
    /// Undo takes the selection back to what it was, redo brings it again.
    void expectOneStep(const std::shared_ptr<const core::PixelSelection>& before) {
        const core::BinaryMask after = session().selected();
        ASSERT_TRUE(document().canUndo());
        action("actionUndo").trigger();
        EXPECT_EQ(session().selection(), before);
        action("actionRedo").trigger();
        EXPECT_TRUE(session().selected() == after);
    }

    ui::MainWindow window_;
    ui::CanvasWindow* native_ = nullptr;
    QTemporaryDir folder_;
};

TEST_F(CanvasWindowTestTools, SmartSelectTakesAnObjectWithOneClick) {
    choose("toolSmartSelect");
    const QPoint vase = middleOf("vase");
    click(vase.x(), vase.y());
    EXPECT_GT(overlap("vase"), 0.9);
    expectOneStep(nullptr);
    EXPECT_FALSE(window_.isWindowModified()) << "a selection is not saved";

    // A second object, then away with it.
    const auto first = session().selection();
    const QPoint bag = middleOf("bag");
    click(bag.x(), bag.y());
    EXPECT_TRUE(isSelected(bag.x(), bag.y()));
    EXPECT_TRUE(isSelected(vase.x(), vase.y()));
    expectOneStep(first);
    click(bag.x(), bag.y(), Qt::AltModifier);
    EXPECT_FALSE(isSelected(bag.x(), bag.y()));
    EXPECT_TRUE(isSelected(vase.x(), vase.y()));
}

TEST_F(CanvasWindowTestTools, ThePreviewShowsWhatAClickWouldSelect) {
    choose("toolSmartSelect");
    const QPoint vase = middleOf("vase");
    QTest::mouseMove(native_, at(vase.x(), vase.y()));
    const auto marked = [&] { return window_.canvas().overlay()->codes()(vase.x(), vase.y()) != 0; };
    ASSERT_TRUE(test::waitUntil(marked, 10000));
    EXPECT_EQ(session().selection(), nullptr) << "nothing is selected yet";
    EXPECT_FALSE(document().canUndo() && document().undoLabel() == "Select");
    click(vase.x(), vase.y());
    EXPECT_TRUE(isSelected(vase.x(), vase.y()));
}

TEST_F(CanvasWindowTestTools, FastClicksAreAllCounted) {
    choose("toolSmartSelect");
    const QPoint vase = middleOf("vase"), bag = middleOf("bag");
    QTest::mouseClick(native_, Qt::LeftButton, {}, at(vase.x(), vase.y()));
    QTest::mouseClick(native_, Qt::LeftButton, {}, at(bag.x(), bag.y()));
    finish();
    EXPECT_TRUE(isSelected(vase.x(), vase.y()));
    EXPECT_TRUE(isSelected(bag.x(), bag.y()));
}

TEST_F(CanvasWindowTestTools, ClicksOutsideThePictureAreStated) {
    choose("toolSmartSelect");
    click(-20, 30);
    EXPECT_EQ(session().selection(), nullptr);
    click(1, 1);
    EXPECT_NE(session().selection(), nullptr) << "the border is in the picture";
}

TEST_F(CanvasWindowTestTools, EnterMakesASegmentThatIsSavedWithTheProject) {
    choose("toolSmartSelect");
    const std::size_t before = scene().segments.size();
    const QPoint place(60, 60);
    ASSERT_EQ(scene().photo->labels(place.x(), place.y()), 0) << "something without a segment";
    choose("toolLasso");
    drag({{40, 40}, {120, 40}, {120, 120}, {40, 120}, {40, 42}});
    ASSERT_TRUE(isSelected(60, 60));
    key(Qt::Key_Return);
    ASSERT_EQ(scene().segments.size(), before + 1);
    EXPECT_EQ(session().selection(), nullptr);
    const core::Segment* made = window_.workspace().selectedSegment();
    ASSERT_NE(made, nullptr) << "it is edited next";
    EXPECT_EQ(scene().photo->labels(60, 60), made->label);
    EXPECT_TRUE(window_.isWindowModified());
    const core::LabelImage labels = scene().photo->labels;

    action("actionUndo").trigger();
    EXPECT_EQ(scene().segments.size(), before);
    EXPECT_TRUE(isSelected(60, 60)) << "the selection is there again";
    action("actionRedo").trigger();
    EXPECT_EQ(scene().segments.size(), before + 1);

    const QString project = folder_.filePath("with.patina");
    window_.saveTo(project);
    ASSERT_TRUE(test::waitUntil([&] { return !window_.working(); }, 60000));
    ASSERT_EQ(window_.findChild<QObject*>("errorDialog"), nullptr);
    const core::Scene again = core::loadProject(project.toStdString());
    EXPECT_TRUE(again.photo->labels == labels);
}

TEST_F(CanvasWindowTestTools, TheBrushPaintsAndAltErases) {
    choose("toolBrush");
    drag({{60, 60}, {100, 60}});
    EXPECT_TRUE(isSelected(80, 60));
    EXPECT_FALSE(isSelected(80, 160));
    expectOneStep(nullptr);
    const auto painted = session().selection();
    drag({{60, 60}, {100, 60}}, Qt::AltModifier);
    EXPECT_FALSE(isSelected(80, 60));
    action("actionUndo").trigger();
    EXPECT_EQ(session().selection(), painted);
    choose("toolEraser");
    drag({{80, 60}, {81, 60}});
    EXPECT_FALSE(isSelected(80, 60));
    EXPECT_TRUE(isSelected(45, 60));
    // The keys [ and ] change the brush of both.
    const float radius = native_->state().brushRadius;
    key(Qt::Key_BracketRight);
    EXPECT_GT(native_->state().brushRadius, radius);
    choose("toolBrush");
    EXPECT_GT(native_->state().brushRadius, radius);
}

TEST_F(CanvasWindowTestTools, TheBrushStopsAtDepthEdgesIfAsked) {
    choose("toolBrush");
    test::child<QCheckBox>(window_, "selectionBrushStops")->setChecked(true);
    const QPoint vase = middleOf("vase");
    test::child<QSlider>(window_, "selectionBrushRadiusSlider")->setValue(1000);
    drag({vase, vase + QPoint(1, 0)});
    EXPECT_TRUE(isSelected(vase.x(), vase.y()));
    const core::ImageF& depth = scene().photo->depth;
    const float z = depth(vase.x(), vase.y());
    for (int y = 0; y < depth.height(); y += 7)
        for (int x = 0; x < depth.width(); x += 7)
            if (isSelected(x, y)) {
                EXPECT_LT(std::abs(depth(x, y) / z - 1), 3 * 500 / scene().photo->camera.fx + 0.02f);
            }
}

TEST_F(CanvasWindowTestTools, ShapesCombineAsTheBarAndTheKeysSay) {
    choose("toolLasso");
    drag({{40, 40}, {140, 40}, {140, 140}, {40, 140}, {40, 42}});
    const std::size_t square = selectedCount();
    EXPECT_NEAR(static_cast<double>(square), 100 * 100, 900);
    expectOneStep(nullptr);
    drag({{100, 40}, {200, 40}, {200, 140}, {100, 140}, {100, 42}}, Qt::ShiftModifier);
    EXPECT_NEAR(static_cast<double>(selectedCount()), 160 * 100, 1400);
    drag({{100, 40}, {200, 40}, {200, 140}, {100, 140}, {100, 42}}, Qt::AltModifier);
    EXPECT_NEAR(static_cast<double>(selectedCount()), 60 * 100, 900);
    action("useIntersect").trigger();
    drag({{20, 40}, {70, 40}, {70, 140}, {20, 140}, {20, 42}});
    EXPECT_NEAR(static_cast<double>(selectedCount()), 30 * 100, 700);
    action("useReplace").trigger();
    drag({{300, 300}, {340, 300}, {340, 340}, {300, 340}, {300, 302}});
    EXPECT_FALSE(isSelected(60, 60));
    EXPECT_TRUE(isSelected(320, 320));
    key(Qt::Key_Escape);
    EXPECT_EQ(session().selection(), nullptr);
}

TEST_F(CanvasWindowTestTools, ThePolygonIsClosedInThreeWays) {
    choose("toolPolygon");
    const auto corner = [&](int x, int y) { click(x, y); };
    corner(40, 40);
    corner(140, 40);
    corner(140, 140);
    corner(200, 200);
    key(Qt::Key_Backspace);
    corner(40, 140);
    EXPECT_EQ(session().selection(), nullptr) << "still open";
    key(Qt::Key_Return);
    EXPECT_TRUE(isSelected(60, 130));
    EXPECT_FALSE(isSelected(160, 160));
    EXPECT_EQ(scene().segments.size(), core::loadProject(kStudio.toStdString()).segments.size())
        << "Enter closed the outline and made no segment";
    expectOneStep(nullptr);

    corner(300, 300);
    corner(360, 300);
    corner(360, 360);
    corner(301, 301);
    EXPECT_TRUE(isSelected(350, 320)) << "a click on the first corner";

    corner(40, 40);
    corner(140, 40);
    QTest::mouseClick(native_, Qt::LeftButton, {}, at(140, 140));
    QTest::mouseDClick(native_, Qt::LeftButton, {}, at(140, 140));
    finish();
    EXPECT_TRUE(isSelected(130, 60)) << "a double click";

    corner(300, 300);
    key(Qt::Key_Escape);
    EXPECT_TRUE(isSelected(130, 60)) << "Escape drops the outline, not the selection";
}

TEST_F(CanvasWindowTestTools, DepthSelectsAPlaneOrARange) {
    choose("toolDepth");
    const QPoint vase = middleOf("vase");
    click(vase.x(), vase.y());
    EXPECT_TRUE(isSelected(vase.x(), vase.y()));
    const float z = scene().photo->depth.image()(vase.x(), vase.y());
    for (std::size_t i = 0; i < session().selected().size(); i += 13)
        if (session().selected()[i] != 0) {
            EXPECT_NEAR(scene().photo->depth.image()[i] / z, 1, 0.021);
        }
    expectOneStep(nullptr);
    test::child<QComboBox>(window_, "depthShape")->setCurrentIndex(1);
    const QPoint table = middleOf("table");
    ASSERT_EQ(scene().photo->labels(table.x(), table.y()), test::labelOf(scene(), "table"));
    click(table.x(), table.y());
    EXPECT_TRUE(isSelected(table.x(), table.y())) << table.x() << ", " << table.y();
    EXPECT_GT(overlap("table"), 0.8);
}

TEST_F(CanvasWindowTestTools, RefiningMovesTheOutlineToTheObject) {
    const std::uint16_t label = test::labelOf(scene(), "vase");
    core::PixelSelection rough;
    rough.mask = core::BinaryMask(scene().photo->color.width(), scene().photo->color.height());
    for (std::size_t i = 0; i < rough.mask.size(); ++i) rough.mask[i] = scene().photo->labels[i] == label ? 1 : 0;
    rough.mask = core::growMask(rough.mask, 4);
    session().replace("rough", rough);
    const double before = overlap("vase");
    test::child<QSpinBox>(window_, "selectionWidth")->setValue(8);
    action("actionRefineSelection").trigger();
    finish();
    EXPECT_GT(overlap("vase"), before + 0.02);
    std::size_t moved = 0;
    for (std::size_t i = 0; i < rough.mask.size(); ++i)
        if (rough.mask[i] != session().selected()[i]) ++moved;
    EXPECT_EQ(window_.statusBar()->currentMessage(),
              QStringLiteral("Refined: %1 pixels changed").arg(QLocale().toString(quint64{moved})));
    action("actionUndo").trigger();
    // By the brush, only where it was.
    choose("toolRefine");
    const core::BinaryMask old = session().selected();
    const QPoint vase = middleOf("vase");
    int edge = vase.x();
    while (isSelected(edge, vase.y())) ++edge;
    drag({{edge, vase.y() - 20}, {edge, vase.y() + 20}});
    std::size_t changed = 0;
    for (int y = 0; y < old.height(); ++y)
        for (int x = 0; x < old.width(); ++x)
            if (old(x, y) != session().selected()(x, y)) {
                ++changed;
                EXPECT_LT(std::hypot(x - edge, y - vase.y()), 60);
            }
    EXPECT_GT(changed, 20u);
}

TEST_F(CanvasWindowTestTools, OperationsChangeTheSelection) {
    choose("toolLasso");
    drag({{100, 100}, {200, 100}, {200, 200}, {100, 200}, {100, 102}});
    const std::size_t square = selectedCount();
    test::child<QSpinBox>(window_, "selectionWidth")->setValue(10);
    const auto run = [&](const char* name) {
        action(name).trigger();
        finish();
        return selectedCount();
    };
    const std::size_t grown = run("actionGrowSelection");
    EXPECT_NEAR(static_cast<double>(grown), 120 * 120, 900);
    EXPECT_NEAR(static_cast<double>(run("actionShrinkSelection")), static_cast<double>(square), 300);
    const std::size_t all = scene().photo->color.size();
    const std::size_t inverted = run("actionInvertSelection");
    EXPECT_NEAR(static_cast<double>(inverted), static_cast<double>(all - square), 300);
    EXPECT_EQ(run("actionFillSelection"), all);
    action("actionSelectAll").trigger();
    EXPECT_EQ(selectedCount(), all);
    action("actionClearSelection").trigger();
    EXPECT_EQ(session().selection(), nullptr);
    EXPECT_FALSE(action("actionGrowSelection").isEnabled());
    EXPECT_FALSE(action("actionMakeSegment").isEnabled());
}

TEST_F(CanvasWindowTestTools, SegmentsAreChangedByTheSelection) {
    window_.workspace().select(test::labelOf(scene(), "bowl"));
    const std::uint16_t bowl = window_.workspace().selectedLabel();
    const auto area = [&] { return std::ranges::count(scene().photo->labels.pixels(), bowl); };
    const auto before = area();
    choose("toolLasso");
    drag({{40, 40}, {60, 40}, {60, 60}, {40, 60}, {40, 42}});
    const auto extra = static_cast<std::ptrdiff_t>(selectedCount());
    ASSERT_GT(extra, 200);
    action("actionAddToSegment").trigger();
    EXPECT_EQ(area(), before + extra);
    EXPECT_EQ(window_.workspace().selectedLabel(), bowl);
    action("actionUndo").trigger();
    EXPECT_EQ(area(), before);
    EXPECT_TRUE(action("actionTakeFromSegment").isEnabled());
}

TEST_F(CanvasWindowTestTools, FindObjectsLeavesSegmentsAlone) {
    // Without the segments of the sample.
    window_.workspace().editScene("none", [](core::Scene& scene) {
        auto photo = std::make_shared<core::Photo>(*scene.photo);
        photo->labels = core::LabelImage(photo->color.width(), photo->color.height());
        scene.photo = photo;
        scene.segments.clear();
    });
    action("actionFindObjects").trigger();
    finish();
    EXPECT_GE(scene().segments.size(), 3u);
    const std::size_t found = scene().segments.size();
    action("actionUndo").trigger();
    EXPECT_TRUE(scene().segments.empty());
    action("actionRedo").trigger();
    EXPECT_EQ(scene().segments.size(), found);
}

TEST_F(CanvasWindowTestTools, EveryToolHasAButtonAKeyAndASentence) {
    for (const ui::ToolEntry& entry : ui::toolRegistry()) {
        SCOPED_TRACE(entry.key);
        QAction& tool = action(entry.key);
        EXPECT_FALSE(tool.icon().isNull());
        EXPECT_FALSE(tool.toolTip().isEmpty());
        window_.canvas().setFocus();
        QTest::keyClick(&window_, tool.shortcut()[0].key());
        EXPECT_EQ(window_.toolBox().chosen(), entry.key);
        EXPECT_FALSE(test::child<QLabel>(window_, "toolHint")->text().isEmpty());
    }
    // The wheel and the space bar still move the picture.
    choose("toolLasso");
    const double zoom = window_.canvas().zoom();
    key(Qt::Key_Space);
    EXPECT_EQ(window_.canvas().zoom(), zoom);
}

TEST_F(CanvasWindowTestTools, RedoSelectsTheSegmentAgain) {
    window_.workspace().select(test::labelOf(scene(), "bowl"));
    const std::uint16_t bowl = window_.workspace().selectedLabel();
    choose("toolLasso");
    drag({{40, 40}, {90, 40}, {90, 90}, {40, 90}, {40, 42}});
    key(Qt::Key_Return);
    const std::uint16_t made = window_.workspace().selectedLabel();
    ASSERT_NE(made, bowl);
    ASSERT_NE(made, 0);
    QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(scene().findSegment(made), nullptr);
    EXPECT_EQ(window_.workspace().selectedLabel(), bowl);
    QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(window_.workspace().selectedLabel(), made);
}

TEST_F(CanvasWindowTestTools, TheLargestBrushFollowsThePicture) {
    const int longer = std::max(scene().photo->camera.width, scene().photo->camera.height);
    choose("toolBrush");
    auto* slider = test::child<ui::ParamSlider>(window_, "selectionBrushRadius");
    const double small = std::max(500.0, longer / 2.0);
    EXPECT_EQ(slider->spec().maximum, small);
    auto photo = std::make_shared<core::Photo>();
    photo->camera = core::Camera::fromHorizontalFov(4000, 20, 1.0f);
    photo->color = core::ImageRgb(4000, 20, core::Vector3f(0.2f, 0.2f, 0.2f));
    photo->depth = core::ImageF(4000, 20, 1.0f);
    photo->labels = core::LabelImage(4000, 20);
    core::Scene wide;
    wide.photo = photo;
    window_.workspace().setDocument(core::Document(wide));
    choose("toolBrush");
    EXPECT_EQ(slider->spec().maximum, 2000);
    slider->setValue(20);
    const double before = slider->value();
    key(Qt::Key_BracketRight);
    const double first = slider->value();
    key(Qt::Key_BracketRight);
    EXPECT_NEAR(slider->value() / first, first / before, 0.02) << "by a factor";
    for (int i = 0; i < 60; ++i) key(Qt::Key_BracketRight);
    EXPECT_EQ(slider->value(), 2000);
    // Half of the way is far less than half of the size.
    auto* bar = test::child<QSlider>(window_, "selectionBrushRadiusSlider");
    bar->setValue(bar->maximum() / 2);
    EXPECT_NEAR(slider->value(), std::sqrt(2000.0), 2);
}

}  // namespace
