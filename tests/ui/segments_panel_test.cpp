// SPDX-License-Identifier: GPL-3.0-or-later
// The Segments panel in the window, used with mouse and keys.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QThread>
#include <QToolButton>
#include <QTreeView>
#include <QUrl>
#include <algorithm>
#include <cstdlib>

#include "core/io/image_io.h"
#include "core/io/project.h"
#include "core/scene/segments.h"
#include "tests/ui/support.h"
#include "ui/main_window.h"
#include "ui/panels/segment_actions.h"
#include "ui/panels/segment_model.h"
#include "ui/panels/segment_thumbnails.h"
#include "ui/panels/segments_panel.h"
#include "ui/widgets/notice_button.h"

namespace {

using Column = ui::SegmentModel::Column;
using Labels = std::vector<std::uint16_t>;

/// 48x32 pixels: 1 "wall" around all, 2 "card", 3 "cups" in two pieces, 4 "lid" between them.
core::LabelImage fourSegments() {
    core::LabelImage labels(48, 32, 1);
    const auto fill = [&](int x0, int y0, int w, int h, std::uint16_t label) {
        for (int y = y0; y < y0 + h; ++y)
            for (int x = x0; x < x0 + w; ++x) labels(x, y) = label;
    };
    fill(4, 4, 12, 8, 2);
    fill(4, 18, 8, 8, 3);
    fill(30, 18, 6, 8, 3);
    fill(20, 18, 4, 4, 4);
    return labels;
}

class SegmentsPanelTest : public testing::Test {
  protected:
    SegmentsPanelTest() : window_({.canvas = false, .device = {}}) {}

    void SetUp() override {
        core::Scene scene = test::makeScene();
        const core::LabelImage labels = fourSegments();
        core::ImageRgb color(48, 32);
        core::ImageF depth(48, 32);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            color[i] = core::Vector3f(0.1f, 0.2f, 0.05f) * static_cast<float>(labels[i]);
            depth[i] = 3.0f - 0.2f * static_cast<float>(labels[i]);
        }
        core::CreateOptions options;
        options.color = file("color.exr");
        options.depth = file("depth.exr");
        options.segments = file("labels.png");
        core::saveColor(color, options.color);
        core::saveScalar(depth, options.depth, "Z");
        core::saveLabels(labels, options.segments);
        window_.resize(1300, 800);
        window_.show();
        window_.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
        window_.createFrom(options);
        wait();
        ASSERT_EQ(scene_().segments.size(), 4U);
        const char* names[] = {"wall", "card", "cups", "lid"};
        document().edit("names", [&](core::Scene& next) {
            for (std::size_t i = 0; i < 4; ++i) next.segments[i].name = names[i];
        });
        QTest::qWait(1);
    }

    std::string file(const QString& name) { return folder_.filePath(name).toStdString(); }
    void wait() {
        ASSERT_TRUE(test::waitUntil([&] { return !window_.working(); }, 60000));
    }
    core::Document& document() { return window_.workspace().document(); }
    const core::Scene& scene_() { return window_.workspace().scene(); }
    const core::Segment& segment(std::uint16_t label) { return *scene_().findSegment(label); }
    ui::SegmentsPanel& panel() { return *test::child<ui::SegmentsPanel>(window_, "segments"); }
    QTreeView& list() { return *test::child<QTreeView>(window_, "segmentList"); }
    ui::SegmentModel& model() { return dynamic_cast<ui::SegmentModel&>(*list().model()); }
    QModelIndex cell(std::uint16_t label, int column = Column::kName) {
        return model().indexOf(label).siblingAtColumn(column);
    }
    void click(std::uint16_t label, int column = Column::kName, Qt::KeyboardModifiers modifiers = {}) {
        const QModelIndex index = cell(label, column);
        list().scrollTo(index);
        QTest::mouseClick(list().viewport(), Qt::LeftButton, modifiers, list().visualRect(index).center());
    }
    /// Chooses exactly these rows with the mouse.
    void choose(const Labels& labels) {
        for (std::size_t i = 0; i < labels.size(); ++i)
            click(labels[i], Column::kName, i > 0 ? Qt::ControlModifier : Qt::NoModifier);
        ASSERT_EQ(chosen(), sorted(labels));
    }
    static Labels sorted(Labels labels) {
        std::ranges::sort(labels);
        return labels;
    }
    Labels chosen() {
        Labels labels;
        for (const QModelIndex& row : list().selectionModel()->selectedRows())
            labels.push_back(model().labelAt(row.row()));
        return sorted(labels);
    }
    void key(int code, Qt::KeyboardModifiers modifiers = {}) {
        // A progress dialog may just have been closed.
        window_.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
        list().setFocus();
        QTest::keyClick(&list(), static_cast<Qt::Key>(code), modifiers);
    }
    QAction& action(const char* name) { return *test::child<QAction>(panel(), name); }
    void press(const char* button) { QTest::mouseClick(test::child<QToolButton>(panel(), button), Qt::LeftButton); }
    /// Through the menu that the right button opens.
    void fromMenu(std::uint16_t label, const char* name) {
        const QPoint place = list().visualRect(cell(label)).center();
        QContextMenuEvent open(QContextMenuEvent::Mouse, place, list().viewport()->mapToGlobal(place));
        QApplication::sendEvent(list().viewport(), &open);
        auto* menu = test::child<QMenu>(panel(), "segmentMenu");
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(&action(name)).center());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QTest::qWait(1);
    }
    void drop(QMimeData& data, const QPoint& place) {
        QDragEnterEvent enter(place, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(list().viewport(), &enter);
        QDragMoveEvent move(place, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(list().viewport(), &move);
        if (!move.isAccepted()) return;
        QDropEvent drop(place, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(list().viewport(), &drop);
    }
    void dropFiles(const QStringList& names) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& name : names) urls << QUrl::fromLocalFile(folder_.filePath(name));
        data.setUrls(urls);
        drop(data, list().viewport()->rect().bottomLeft() - QPoint(-20, 5));
        ASSERT_TRUE(test::waitUntil([&] { return !panel().actions().working(); }, 30000));
        QTest::qWait(1);
    }
    QString errorText() {
        auto* dialog = window_.findChild<QMessageBox*>(QStringLiteral("errorDialog"));
        if (dialog == nullptr) return {};
        const QString text = dialog->text();
        delete dialog;
        return text;
    }
    /// One step was made since `before`; undo and redo give exactly the two states, also in the list.
    void expectOneStep(const core::Scene& before, const std::string& name) {
        EXPECT_EQ(document().undoLabel(), name);
        const core::Scene after = scene_();
        EXPECT_FALSE(after == before);
        document().undo();
        EXPECT_TRUE(scene_() == before) << name;
        expectListed();
        document().redo();
        EXPECT_TRUE(scene_() == after) << name;
        expectListed();
    }
    /// The list shows the scene.
    void expectListed() {
        ASSERT_EQ(model().rowCount(), static_cast<int>(scene_().segments.size()));
        for (const core::Segment& s : scene_().segments) {
            const auto on = [&](int column) {
                return cell(s.label, column).data(Qt::CheckStateRole).toInt() == Qt::Checked;
            };
            EXPECT_EQ(cell(s.label).data().toString().toStdString(), s.name);
            EXPECT_EQ(on(Column::kGlossy), s.glossy);
            EXPECT_EQ(on(Column::kVisible), s.visible);
            EXPECT_EQ(on(Column::kLocked), s.locked);
            EXPECT_EQ(cell(s.label, Column::kEdited).data().toString().isEmpty(), !s.edit);
            const auto pixels = std::ranges::count(scene_().photo->labels.pixels(), s.label);
            EXPECT_TRUE(cell(s.label, Column::kArea)
                            .data(Qt::ToolTipRole)
                            .toString()
                            .startsWith(QLocale().toString(static_cast<qlonglong>(pixels))));
        }
    }
    void giveMaterial(std::uint16_t label) {
        document().edit("material", [&](core::Scene& scene) { scene.findSegment(label)->edit.emplace(); });
    }

    ui::MainWindow window_;
    QTemporaryDir folder_;
};

TEST_F(SegmentsPanelTest, AClickOnASwitchChangesItAndNothingElse) {
    click(2);
    const core::Scene before = scene_();
    click(3, Column::kGlossy);
    EXPECT_TRUE(segment(3).glossy);
    EXPECT_EQ(window_.workspace().selectedLabel(), 2) << "the selection stays";
    expectOneStep(before, "Flag cups as glossy");
    click(3, Column::kGlossy);
    EXPECT_FALSE(segment(3).glossy);
    const core::Scene shown = scene_();
    click(4, Column::kVisible);
    EXPECT_FALSE(segment(4).visible);
    expectOneStep(shown, "Hide lid");
    const core::Scene unlocked = scene_();
    click(1, Column::kLocked);
    EXPECT_TRUE(segment(1).locked);
    expectOneStep(unlocked, "Lock wall");
    EXPECT_EQ(chosen(), Labels{2});
    // Pressed on one and released on another: nothing.
    const core::Scene now = scene_();
    QTest::mousePress(list().viewport(), Qt::LeftButton, {}, list().visualRect(cell(1, Column::kLocked)).center());
    QTest::mouseRelease(list().viewport(), Qt::LeftButton, {}, list().visualRect(cell(2, Column::kLocked)).center());
    EXPECT_TRUE(scene_() == now);
    choose({2, 3});
    key(Qt::Key_Space);
    EXPECT_TRUE(segment(2).glossy && segment(3).glossy) << "Space flags all that are selected";
    expectOneStep(now, "Flag 2 segments as glossy");
}

TEST_F(SegmentsPanelTest, RenamingByKeyAndByDoubleClick) {
    click(2);
    const core::Scene before = scene_();
    key(Qt::Key_F2);
    auto* editor = list().viewport()->findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    QTest::keyClicks(editor, QStringLiteral("badge"));
    QTest::keyClick(editor, Qt::Key_Delete);
    QTest::keyClick(editor, Qt::Key_Return);
    QTest::qWait(1);
    EXPECT_EQ(segment(2).name, "badge");
    expectOneStep(before, "Rename segment");
    const core::Scene renamed = scene_();
    for (const char* name : {"wall", "  "}) {
        QTest::mouseDClick(list().viewport(), Qt::LeftButton, {}, list().visualRect(cell(2)).center());
        editor = list().viewport()->findChild<QLineEdit*>();
        ASSERT_NE(editor, nullptr);
        editor->selectAll();
        QTest::keyClicks(editor, QString::fromUtf8(name));
        QTest::keyClick(editor, Qt::Key_Return);
        QTest::qWait(1);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        EXPECT_TRUE(scene_() == renamed) << name;
        EXPECT_FALSE(window_.statusBar()->currentMessage().isEmpty());
        EXPECT_EQ(cell(2).data().toString(), QStringLiteral("badge"));
        window_.statusBar()->clearMessage();
    }
}

TEST_F(SegmentsPanelTest, MergingKeepsTheUppermost) {
    giveMaterial(2);
    giveMaterial(4);
    choose({1});
    EXPECT_FALSE(action("segmentMerge").isEnabled());
    choose({4, 2, 3});
    EXPECT_TRUE(action("segmentMerge").toolTip().contains(QStringLiteral("card")));
    const core::Scene before = scene_();
    key(Qt::Key_M, Qt::ControlModifier);
    EXPECT_EQ(scene_().segments.size(), 2U);
    EXPECT_EQ(segment(2), *before.findSegment(2));
    EXPECT_EQ(std::ranges::count(scene_().photo->labels.pixels(), 2), 12 * 8 + 8 * 8 + 6 * 8 + 4 * 4);
    EXPECT_EQ(chosen(), Labels{2});
    EXPECT_TRUE(window_.statusBar()->currentMessage().contains(QStringLiteral("The material of \"lid\" is gone")));
    expectOneStep(before, "Merge segments");
    EXPECT_EQ(errorText(), QString());
}

TEST_F(SegmentsPanelTest, SplittingFromTheMenu) {
    choose({2});
    EXPECT_FALSE(action("segmentSplit").isEnabled()) << "in one piece";
    giveMaterial(3);
    choose({3});
    ASSERT_TRUE(action("segmentSplit").isEnabled());
    const core::Scene before = scene_();
    fromMenu(3, "segmentSplit");
    ASSERT_EQ(scene_().segments.size(), 5U);
    EXPECT_EQ(segment(5).name, "cups 2");
    EXPECT_EQ(segment(5).edit, segment(3).edit);
    EXPECT_EQ(scene_().photo->labels(4, 18), 3) << "the larger piece";
    EXPECT_EQ(scene_().photo->labels(30, 18), 5);
    EXPECT_EQ(chosen(), (Labels{3, 5}));
    EXPECT_EQ(window_.workspace().selectedLabel(), 3);
    expectOneStep(before, "Split cups");
    EXPECT_FALSE(action("segmentSplit").isEnabled());
}

TEST_F(SegmentsPanelTest, DeletingSparesLockedOnes) {
    choose({2, 4});
    document().edit("lock", [](core::Scene& scene) { scene.segments[3].locked = true; });
    EXPECT_EQ(chosen(), (Labels{2, 4})) << "an edit leaves the selection";
    const core::Scene before = scene_();
    key(Qt::Key_Delete);
    EXPECT_EQ(scene_().findSegment(std::uint16_t{2}), nullptr);
    EXPECT_EQ(scene_().photo->labels(5, 5), 0);
    EXPECT_EQ(scene_().photo->labels(20, 18), 4);
    EXPECT_TRUE(window_.statusBar()->currentMessage().contains(QStringLiteral("\"lid\" is locked")));
    expectOneStep(before, "Delete 2 segments");
    choose({4});
    EXPECT_FALSE(action("segmentDelete").isEnabled());
    const std::uint64_t revision = document().revision();
    key(Qt::Key_Delete);
    EXPECT_EQ(document().revision(), revision);
}

TEST_F(SegmentsPanelTest, DuplicatingTakesTheSelectedPixels) {
    giveMaterial(2);
    choose({2});
    EXPECT_FALSE(action("segmentDuplicate").isEnabled());
    EXPECT_TRUE(action("segmentDuplicate").toolTip().contains(QStringLiteral("share no pixels")));
    auto selection = std::make_shared<core::PixelSelection>();
    selection->mask = core::BinaryMask(48, 32);
    for (int y = 4; y < 12; ++y) selection->mask(4, y) = selection->mask(44, y) = 1;
    document().edit("select", [&](core::Scene& scene) { scene.selection = selection; });
    ASSERT_TRUE(action("segmentDuplicate").isEnabled());
    const core::Scene before = scene_();
    key(Qt::Key_J, Qt::ControlModifier);
    ASSERT_EQ(scene_().segments.size(), 5U);
    EXPECT_EQ(segment(5).name, "card 2");
    EXPECT_EQ(segment(5).edit, segment(2).edit);
    for (int y = 4; y < 12; ++y) EXPECT_EQ(scene_().photo->labels(44, y), 5);
    EXPECT_EQ(scene_().photo->labels(4, 4), 5);
    EXPECT_EQ(scene_().photo->labels(5, 4), 2);
    EXPECT_EQ(scene_().selection, nullptr);
    EXPECT_EQ(chosen(), Labels{5});
    expectOneStep(before, "Duplicate card");
}

TEST_F(SegmentsPanelTest, SelectingWhatIsEditedAndPixels) {
    EXPECT_FALSE(action("segmentSelectEdited").isEnabled());
    giveMaterial(2);
    giveMaterial(4);
    const std::uint64_t revision = document().revision();
    press("segmentSelectEditedButton");
    EXPECT_EQ(chosen(), (Labels{2, 4}));
    EXPECT_EQ(document().revision(), revision) << "selecting rows is no edit";
    const core::Scene before = scene_();
    press("segmentSelectPixelsButton");
    ASSERT_NE(scene_().selection, nullptr);
    EXPECT_EQ(scene_().selection->mask, core::maskOfSegments(scene_().photo->labels, Labels{2, 4}));
    expectOneStep(before, "Select pixels");
    const std::uint64_t selected = document().revision();
    press("segmentSelectPixelsButton");
    EXPECT_EQ(document().revision(), selected) << "the same pixels again";
}

TEST_F(SegmentsPanelTest, HidingAndLockingSeveral) {
    choose({2, 3});
    core::Scene before = scene_();
    press("segmentVisibleButton");
    EXPECT_FALSE(segment(2).visible || segment(3).visible);
    EXPECT_EQ(action("segmentVisible").text(), QStringLiteral("Show"));
    expectOneStep(before, "Hide 2 segments");
    before = scene_();
    press("segmentVisibleButton");
    EXPECT_TRUE(segment(2).visible && segment(3).visible);
    expectOneStep(before, "Show 2 segments");
    before = scene_();
    press("segmentLockedButton");
    EXPECT_TRUE(segment(2).locked && segment(3).locked);
    expectOneStep(before, "Lock 2 segments");
    EXPECT_FALSE(action("segmentMerge").isEnabled());
    EXPECT_FALSE(action("segmentDelete").isEnabled());
    before = scene_();
    fromMenu(2, "segmentLocked");
    EXPECT_FALSE(segment(2).locked || segment(3).locked);
    expectOneStep(before, "Unlock 2 segments");
}

TEST_F(SegmentsPanelTest, FilesDroppedOnTheListBecomeSegments) {
    core::ImageF soft(48, 32, 0.0f);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x)
            soft(x, y) =
                std::clamp(6.5f - std::hypot(static_cast<float>(x) - 38, static_cast<float>(y) - 8), 0.0f, 1.0f);
    core::saveScalar(soft, file("lamp.png"), "Y", 65535);
    core::Scene before = scene_();
    dropFiles({"lamp.png"});
    EXPECT_EQ(errorText(), QString());
    ASSERT_EQ(scene_().segments.size(), 5U) << "soft edges are one object";
    EXPECT_EQ(segment(5).name, "lamp");
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x) EXPECT_EQ(scene_().photo->labels(x, y) == 5, soft(x, y) >= 0.5f);
    EXPECT_EQ(chosen(), Labels{5});
    EXPECT_FALSE(test::child<ui::NoticeButton>(window_, "notices")->notices().filter("soft edges").isEmpty());
    expectOneStep(before, "Import segments");

    // Several at once, one of half the size.
    core::LabelImage half(24, 16, 0);
    half(0, 0) = 7;
    half(1, 0) = 9;
    core::saveLabels(half, file("map.png"));
    before = scene_();
    dropFiles({"map.png", "lamp.png"});
    EXPECT_EQ(errorText(), QString());
    ASSERT_EQ(scene_().segments.size(), 7U) << "the first lamp lost all of its pixels";
    EXPECT_EQ(segment(7).name, "map 7");
    EXPECT_EQ(segment(9).name, "map 9");
    EXPECT_EQ(scene_().photo->labels(1, 1), 7);
    EXPECT_EQ(scene_().photo->labels(2, 1), 9);
    expectOneStep(before, "Import segments");

    core::saveLabels(core::LabelImage(30, 32, 1), file("other.png"));
    before = scene_();
    dropFiles({"other.png"});
    EXPECT_TRUE(errorText().contains(QStringLiteral("30x32")));
    dropFiles({"missing.png"});
    EXPECT_TRUE(errorText().contains(QStringLiteral("missing.png")));
    core::saveLabels(core::LabelImage(48, 32, 0), file("empty.png"));
    dropFiles({"empty.png"});
    EXPECT_TRUE(errorText().contains(QStringLiteral("empty")));
    EXPECT_TRUE(scene_() == before);
}

TEST_F(SegmentsPanelTest, MasksAndMapsComeFromTheDialogAndGoToFiles) {
    choose({2, 4});
    const core::BinaryMask mask = core::maskOfSegments(scene_().photo->labels, Labels{2, 4});
    fromMenu(2, "segmentExportMask");
    auto* target = test::child<QFileDialog>(window_, "segmentMaskFile");
    EXPECT_EQ(target->acceptMode(), QFileDialog::AcceptSave);
    emit target->fileSelected(folder_.filePath("mask.png"));
    target->close();
    ASSERT_TRUE(test::waitUntil([&] { return !panel().actions().working(); }, 30000));
    const core::LabelImage written = core::loadLabels(file("mask.png"));
    for (std::size_t i = 0; i < mask.size(); ++i) ASSERT_EQ(written[i], mask[i] != 0 ? 255 : 0);

    press("segmentImportButton");
    auto* source = test::child<QFileDialog>(window_, "segmentImportFile");
    emit source->filesSelected({folder_.filePath("mask.png")});
    source->close();
    ASSERT_TRUE(test::waitUntil([&] { return scene_().segments.size() == 3; }, 30000));
    EXPECT_EQ(core::maskOfSegments(scene_().photo->labels, chosen()), mask);
    panel().actions().exportMask(folder_.filePath("no/such/folder.png"));
    ASSERT_TRUE(test::waitUntil([&] { return !panel().actions().working(); }, 30000));
    QTest::qWait(1);
    EXPECT_NE(errorText(), QString());
}

TEST_F(SegmentsPanelTest, RowsDroppedOnARowAreMergedIntoIt) {
    choose({2, 3});
    const std::unique_ptr<QMimeData> data(model().mimeData(list().selectionModel()->selectedIndexes()));
    core::Scene before = scene_();
    drop(*data, list().visualRect(cell(3)).center());
    EXPECT_TRUE(scene_() == before) << "onto one of themselves";
    QMimeData foreign;
    foreign.setData(QStringLiteral("application/x-patina-segments"), "1 2 3");
    drop(foreign, list().visualRect(cell(4)).center());
    EXPECT_TRUE(scene_() == before) << "from another window";
    drop(*data, list().visualRect(cell(4)).center());
    ASSERT_EQ(scene_().segments.size(), 2U);
    EXPECT_EQ(segment(4).name, "lid");
    EXPECT_EQ(std::ranges::count(scene_().photo->labels.pixels(), 4), 12 * 8 + 8 * 8 + 6 * 8 + 4 * 4);
    expectOneStep(before, "Merge segments");
    document().undo();
    document().edit("lock", [](core::Scene& scene) { scene.segments[3].locked = true; });
    before = scene_();
    drop(*data, list().visualRect(cell(4)).center());
    EXPECT_TRUE(errorText().contains(QStringLiteral("\"lid\" is locked")));
    EXPECT_TRUE(scene_() == before);
}

TEST_F(SegmentsPanelTest, TheHeaderSorts) {
    const auto shown = [&] {
        Labels labels;
        for (int row = 0; row < model().rowCount(); ++row) labels.push_back(model().labelAt(row));
        return labels;
    };
    const auto clickHeader = [&](int column) {
        QHeaderView& header = *list().header();
        const QPoint place(header.sectionViewportPosition(column) + header.sectionSize(column) / 2,
                           header.height() / 2);
        QTest::mouseClick(header.viewport(), Qt::LeftButton, {}, place);
    };
    choose({3});
    EXPECT_EQ(shown(), (Labels{1, 2, 3, 4}));
    clickHeader(Column::kName);
    EXPECT_EQ(shown(), (Labels{2, 3, 4, 1}));
    EXPECT_EQ(chosen(), Labels{3});
    EXPECT_EQ(window_.workspace().selectedLabel(), 3);
    document().edit("name", [](core::Scene& scene) { scene.segments[2].name = "zebra"; });
    EXPECT_EQ(shown(), (Labels{2, 4, 1, 3})) << "stays sorted";
    EXPECT_EQ(chosen(), Labels{3});
    clickHeader(Column::kName);
    EXPECT_EQ(shown(), (Labels{3, 1, 4, 2}));
    clickHeader(Column::kName);
    EXPECT_EQ(shown(), (Labels{1, 2, 3, 4})) << "the third click: as in the file";
    clickHeader(Column::kArea);
    EXPECT_EQ(shown(), (Labels{4, 2, 3, 1}));
    giveMaterial(4);
    clickHeader(Column::kEdited);
    clickHeader(Column::kEdited);
    EXPECT_EQ(shown().front(), 4);
    // The uppermost in the list is the one that stays.
    choose({2, 4});
    key(Qt::Key_M, Qt::ControlModifier);
    EXPECT_NE(scene_().findSegment(std::uint16_t{4}), nullptr);
    EXPECT_EQ(scene_().findSegment(std::uint16_t{2}), nullptr);
}

TEST_F(SegmentsPanelTest, SelectionGoesBothWays) {
    choose({2, 3});
    EXPECT_EQ(window_.workspace().selectedLabel(), 3) << "the last one that was clicked";
    window_.workspace().select(4);
    EXPECT_EQ(chosen(), Labels{4});
    window_.workspace().select(0);
    EXPECT_EQ(chosen(), Labels{});
    EXPECT_FALSE(action("segmentDelete").isEnabled());
    key(Qt::Key_A, Qt::ControlModifier);
    EXPECT_EQ(chosen(), (Labels{1, 2, 3, 4}));
    EXPECT_EQ(scene_().selection, nullptr) << "rows, not pixels";
    window_.workspace().select(1);
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().viewport()->rect().bottomLeft() - QPoint(-20, 5));
    EXPECT_EQ(window_.workspace().selectedLabel(), 0) << "beside all rows";
}

TEST_F(SegmentsPanelTest, TheHintSaysWhatToDoNext) {
    auto* hint = test::child<QLabel>(panel(), "segmentHint");
    EXPECT_TRUE(hint->text().startsWith(QStringLiteral("Tick Glossy")));
    click(2, Column::kGlossy);
    ASSERT_TRUE(test::waitUntil([&] { return window_.settled(); }, 60000));
    EXPECT_TRUE(hint->text().isEmpty() || hint->text().contains(QStringLiteral("card"))) << hint->text().toStdString();
    EXPECT_EQ(hint->isHidden(), hint->text().isEmpty());
    // Five pixels tell nothing.
    core::BinaryMask few(48, 32);
    for (int x = 0; x < 5; ++x) few(40 + x, 2) = 1;
    document().edit("few", [&](core::Scene& scene) {
        scene = core::withSegment(scene, few, "dot");
        for (core::Segment& s : scene.segments) s.glossy = s.name == "dot";
    });
    ASSERT_TRUE(test::waitUntil([&] { return window_.settled(); }, 60000));
    EXPECT_TRUE(hint->text().contains(QStringLiteral("only 5 pixels"))) << hint->text().toStdString();
    EXPECT_FALSE(hint->isHidden());
    choose({1});
    key(Qt::Key_A, Qt::ControlModifier);
    key(Qt::Key_Delete);
    EXPECT_TRUE(hint->text().startsWith(QStringLiteral("Click an object"))) << hint->text().toStdString();
    window_.workspace().setDocument({});
    EXPECT_TRUE(hint->text().startsWith(QStringLiteral("Open a photograph")));
}

TEST_F(SegmentsPanelTest, EveryChangeIsSavedAndOpensAgain) {
    core::saveLabels(core::LabelImage(48, 32, 1), file("all.png"));
    const std::vector<std::pair<const char*, std::function<void()>>> changes = {
        {"rename", [&] { panel().actions().rename(2, QStringLiteral("new name")); }},
        {"flags",
         [&] {
             click(2, Column::kGlossy);
             click(3, Column::kVisible);
             click(4, Column::kLocked);
         }},
        {"merge",
         [&] {
             choose({2, 3});
             press("segmentMergeButton");
         }},
        {"split",
         [&] {
             choose({3});
             press("segmentSplitButton");
         }},
        {"delete",
         [&] {
             choose({2});
             press("segmentDeleteButton");
         }},
        {"import", [&] { dropFiles({QStringLiteral("all.png")}); }},
        {"delete all",
         [&] {
             key(Qt::Key_A, Qt::ControlModifier);
             key(Qt::Key_Delete);
         }},
    };
    const QString first = folder_.filePath("first.patina");
    window_.saveTo(first);
    wait();
    for (const auto& [name, make] : changes) {
        SCOPED_TRACE(name);
        window_.openFile(first);
        wait();
        ASSERT_EQ(scene_().segments.size(), 4U);
        make();
        ASSERT_TRUE(document().modified());
        const core::Scene changed = scene_();
        const QString project = folder_.filePath("changed.patina");
        window_.saveTo(project);
        wait();
        EXPECT_EQ(errorText(), QString());
        EXPECT_FALSE(document().modified());
        window_.openFile(project);
        wait();
        ASSERT_EQ(errorText(), QString());
        EXPECT_EQ(scene_().photo->labels, changed.photo->labels);
        EXPECT_EQ(scene_().segments, changed.segments);
        const QString map = QString::fromStdString(scene_().photo->source.segments);
        const auto bytesOf = [](const QString& path) {
            QFile read(path);
            return !path.isEmpty() && read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
        };
        EXPECT_EQ(map.isEmpty(), scene_().segments.empty());
        const QByteArray bytes = bytesOf(map), projectBytes = bytesOf(project);
        window_.saveTo(project);
        wait();
        EXPECT_EQ(bytesOf(map), bytes);
        EXPECT_EQ(bytesOf(project), projectBytes);
        EXPECT_EQ(core::loadLabels(file("labels.png")), fourSegments()) << "the first map is as it was";
    }
}

TEST_F(SegmentsPanelTest, UndoAfterSavingWritesTheOldLabelsAgain) {
    choose({2});
    press("segmentDeleteButton");
    const QString project = folder_.filePath("p.patina");
    window_.saveTo(project);
    wait();
    document().undo();
    EXPECT_TRUE(document().modified());
    window_.saveTo(project);
    wait();
    window_.openFile(project);
    wait();
    EXPECT_EQ(scene_().photo->labels, fourSegments());
}

// As many segments as labels allow.
TEST(SegmentsPanelSize, AllLabelsOpenAndChangeWithoutAStall) {
    auto photo = std::make_shared<core::Photo>();
    photo->labels = core::LabelImage(1024, 1024, 0);
    photo->color = core::ImageRgb(1024, 1024, core::Vector3f(0.3f, 0.3f, 0.3f));
    for (std::size_t i = 0; i < photo->labels.size(); ++i) photo->labels[i] = static_cast<std::uint16_t>(i / 16);
    core::Scene scene;
    scene.photo = photo;
    core::addMissingSegments(scene);
    ASSERT_EQ(scene.segments.size(), 65535U);
    scene.segments[70].edit.emplace();

    ui::Workspace workspace;
    ui::SegmentsPanel panel(workspace);
    panel.resize(300, 500);
    panel.show();
    QCoreApplication::processEvents();
    const auto milliseconds = [](const std::function<void()>& work) {
        qint64 best = 1 << 30;
        for (int round = 0; round < 3; ++round) {
            QElapsedTimer timer;
            timer.start();
            work();
            QCoreApplication::processEvents();
            best = std::min(best, timer.elapsed());
        }
        return best;
    };
    const auto expectFast = [&](const char* what, const std::function<void()>& work) {
        const qint64 time = milliseconds(work);
        std::printf("65535 segments, %s: %lld ms\n", what, static_cast<long long>(time));
        double load = 0;
        (void)getloadavg(&load, 1);
        EXPECT_LT(static_cast<double>(time), 200 * std::max(1.0, load)) << what;
    };
    core::Document opened(scene);
    expectFast("open", [&] {
        core::Document copy = opened;
        workspace.setDocument(std::move(copy));
    });
    auto* list = test::child<QTreeView>(panel, "segmentList");
    EXPECT_EQ(list->model()->rowCount(), 65535);
    bool on = false;
    expectFast("edit of a flag", [&] { panel.actions().setGlossy({500}, on = !on); });
    int name = 0;
    expectFast("rename", [&] { panel.actions().rename(9, QStringLiteral("n%1").arg(++name)); });
    expectFast("undo", [&] { workspace.document().undo(); });
    std::uint16_t last = 1000;
    expectFast("merge of two", [&] {
        last = static_cast<std::uint16_t>(last + 2);
        panel.actions().merge({last, static_cast<std::uint16_t>(last + 1)});
    });
    expectFast("select all rows", [&] { list->selectAll(); });
    expectFast("select one", [&] { workspace.select(40000); });
    expectFast("sort by name", [&] { list->sortByColumn(0, Qt::AscendingOrder); });
    expectFast("rename while sorted", [&] { panel.actions().rename(9, QStringLiteral("n%1").arg(++name)); });
}

TEST(SegmentThumbnail, ShowsTheObjectAndDimsTheRest) {
    core::Photo photo;
    photo.labels = core::LabelImage(4000, 3000, 0);
    photo.color = core::ImageRgb(4000, 3000, core::Vector3f(0.1f, 0.1f, 0.1f));
    for (int y = 1000; y < 2000; ++y)
        for (int x = 1500; x < 2200; ++x) {
            photo.labels(x, y) = 3;
            photo.color(x, y) = {1, 0, 0};
        }
    for (int x = 0; x < 3; ++x) photo.labels(3997 + x, 2999) = 4;
    for (int y = 0; y < 3000; ++y) photo.labels(0, y) = 5;
    const auto extents = core::segmentExtents(photo.labels);
    const QSize size(80, 60);
    const QImage image = ui::segmentThumbnail(photo, 3, extents[3], size);
    EXPECT_EQ(image.pixel(40, 30), qRgb(255, 0, 0));
    const int beside = qRed(image.pixel(2, 30));
    EXPECT_LT(beside, 50);
    EXPECT_GT(beside, 10);
    EXPECT_EQ(qAlpha(ui::segmentThumbnail(photo, 4, extents[4], size).pixel(79, 59)), 255) << "in the corner";
    EXPECT_EQ(qAlpha(ui::segmentThumbnail(photo, 5, extents[5], size).pixel(40, 30)), 255);
    EXPECT_EQ(qAlpha(ui::segmentThumbnail(photo, 9, extents[9], size).pixel(40, 30)), 0) << "no pixel";
    QElapsedTimer timer;
    timer.start();
    constexpr int kRounds = 20;
    for (int i = 0; i < kRounds; ++i) (void)ui::segmentThumbnail(photo, 3, extents[3], size);
    const double each = static_cast<double>(timer.nsecsElapsed()) * 1e-6 / kRounds;
    std::printf("thumbnail of 80x60 pixels from 12 megapixels: %.2f ms\n", each);
    double load = 0;
    (void)getloadavg(&load, 1);
    EXPECT_LT(each, 10 * std::max(1.0, load));
}

// Hundreds of specks around two large pieces, in a photograph of 24 megapixels.
TEST(SegmentsPanelSize, SplittingALargeSegmentLeavesTheWindowFree) {
    auto photo = std::make_shared<core::Photo>();
    photo->labels = core::LabelImage(6000, 4000, 0);
    photo->color = core::ImageRgb(6000, 4000, core::Vector3f(0.3f, 0.3f, 0.3f));
    const auto fill = [&](int x0, int y0, int w, int h) {
        for (int y = y0; y < y0 + h; ++y)
            for (int x = x0; x < x0 + w; ++x) photo->labels(x, y) = 1;
    };
    fill(500, 500, 2000, 3000);
    fill(3500, 500, 1800, 3000);
    for (int i = 0; i < 500; ++i) fill(2600 + (i * 37) % 800, 100 + (i * 61) % 3800, 2, 2);
    core::Scene scene;
    scene.photo = photo;
    core::addMissingSegments(scene);
    ui::Workspace workspace;
    ui::SegmentsPanel panel(workspace);
    panel.resize(300, 500);
    panel.show();
    workspace.setDocument(core::Document(scene));
    workspace.select(1);
    QCoreApplication::processEvents();
    ASSERT_TRUE(test::child<QAction>(panel, "segmentSplit")->isEnabled());
    QTest::mouseClick(test::child<QToolButton>(panel, "segmentSplitButton"), Qt::LeftButton);
    ASSERT_TRUE(panel.actions().working());
    qint64 longest = 0, whole = 0;
    QElapsedTimer lap, all;
    all.start();
    while (panel.actions().working()) {
        lap.start();
        QCoreApplication::processEvents();
        longest = std::max(longest, lap.elapsed());
        QThread::msleep(1);
    }
    whole = all.elapsed();
    std::printf("split of 24 megapixels: %lld ms, window blocked for %lld ms\n", static_cast<long long>(whole),
                static_cast<long long>(longest));
    EXPECT_LT(longest, whole / 2);
    ASSERT_EQ(workspace.scene().segments.size(), 2u);
    EXPECT_EQ(workspace.selectedLabel(), 1);
    EXPECT_EQ(test::child<QTreeView>(panel, "segmentList")->selectionModel()->selectedRows().size(), 2);
}

}  // namespace
