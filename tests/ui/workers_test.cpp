// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QProgressDialog>
#include <QPushButton>
#include <QSignalSpy>
#include <QThread>
#include <algorithm>
#include <atomic>

#include "core/scene/segments.h"
#include "tests/ui/support.h"
#include "ui/analysis_worker.h"
#include "ui/background_task.h"
#include "ui/scene_change.h"
#include "ui/workspace.h"

namespace {

TEST(BackgroundTask, ReportsOnTheThreadThatMadeIt) {
    QThread* finishedOn = nullptr;
    ui::BackgroundTask task([](const core::Progress& progress) { progress.checkpoint(0.5f); });
    QSignalSpy progress(&task, &ui::BackgroundTask::progress);
    QObject::connect(&task, &ui::BackgroundTask::succeeded, &task, [&] { finishedOn = QThread::currentThread(); });
    task.start();
    ASSERT_TRUE(test::waitUntil([&] { return finishedOn != nullptr; }, 5000));
    EXPECT_EQ(finishedOn, QThread::currentThread());
    ASSERT_EQ(progress.size(), 1);
    EXPECT_EQ(progress[0][0].toString(), "Working");
}

TEST(BackgroundTask, AnErrorIsASentenceAndNotAnEnd) {
    ui::BackgroundTask task(
        [](const core::Progress&) { throw core::Error(core::ErrorKind::Input, "The file is broken."); });
    QSignalSpy failed(&task, &ui::BackgroundTask::failed);
    QSignalSpy succeeded(&task, &ui::BackgroundTask::succeeded);
    task.start();
    ASSERT_TRUE(test::waitUntil([&] { return failed.size() == 1; }, 5000));
    EXPECT_EQ(failed[0][0].toString(), "The file is broken.");
    EXPECT_EQ(succeeded.size(), 0);
}

TEST(BackgroundTask, CancelEndsEndlessWork) {
    ui::BackgroundTask task([](const core::Progress& progress) {
        for (;;) progress.checkpoint(0);
    });
    QSignalSpy cancelled(&task, &ui::BackgroundTask::cancelled);
    task.start();
    task.cancel();
    EXPECT_TRUE(test::waitUntil([&] { return cancelled.size() == 1; }, 5000));
}

TEST(BackgroundTask, DestructionStopsTheWork) {
    auto task = std::make_unique<ui::BackgroundTask>([](const core::Progress& progress) {
        for (;;) progress.checkpoint(0);
    });
    task->start();
    task.reset();
    QCoreApplication::processEvents();
    SUCCEED();
}

TEST(AnalysisWorker, DeliversTheLatestRequest) {
    ui::AnalysisWorker worker;
    std::vector<std::uint64_t> generations;
    QObject::connect(&worker, &ui::AnalysisWorker::finished, &worker,
                     [&](const std::shared_ptr<const ui::AnalysisResult>& result) {
                         generations.push_back(result->generation);
                         EXPECT_NE(result->analysis, nullptr);
                     });
    core::Scene scene = test::makeScene();
    for (std::uint64_t generation = 1; generation <= 50; ++generation) {
        scene.segments[1].backSide.minThickness = 0.001f * static_cast<float>(generation);
        worker.request(generation, scene);
    }
    ASSERT_TRUE(test::waitUntil([&] { return !generations.empty() && generations.back() == 50; }, 20000));
    EXPECT_TRUE(std::is_sorted(generations.begin(), generations.end()));
    EXPECT_LT(generations.size(), 50u);
}

TEST(AnalysisWorker, UnusableSceneIsASentence) {
    ui::AnalysisWorker worker;
    QSignalSpy failed(&worker, &ui::AnalysisWorker::failed);
    core::Scene scene = test::makeScene();
    scene.backDepth = std::make_shared<core::ImageF>(3, 3, 1.0f);
    worker.request(3, scene);
    ASSERT_TRUE(test::waitUntil([&] { return failed.size() == 1; }, 20000));
    EXPECT_EQ(failed[0][0].toULongLong(), 3u);
    EXPECT_FALSE(failed[0][1].toString().isEmpty());
}

TEST(AnalysisWorker, MakesItsKernelsOnItsOwnThread) {
    ui::AnalysisWorker worker;
    std::vector<std::thread::id> makers;
    worker.setKernels([&]() -> std::unique_ptr<core::AnalysisKernels> {
        makers.push_back(std::this_thread::get_id());
        if (makers.size() == 1) throw std::runtime_error("There is no device.");
        return nullptr;
    });
    QSignalSpy failed(&worker, &ui::AnalysisWorker::failed);
    QSignalSpy finished(&worker, &ui::AnalysisWorker::finished);
    worker.request(1, test::makeScene());
    ASSERT_TRUE(test::waitUntil([&] { return failed.size() == 1; }, 20000));
    EXPECT_EQ(failed[0][1].toString(), "There is no device.");
    worker.request(2, test::makeScene());
    ASSERT_TRUE(test::waitUntil([&] { return finished.size() == 1; }, 20000));
    worker.request(3, test::makeScene());
    ASSERT_TRUE(test::waitUntil([&] { return finished.size() == 2; }, 20000));
    ASSERT_EQ(makers.size(), 2u) << "asked again after a failure, kept after a success";
    EXPECT_NE(makers[1], std::this_thread::get_id());
}

TEST(Workspace, KnowsWhichEditsTouchTheAnalysis) {
    ui::Workspace workspace;
    workspace.setDocument(core::Document(test::makeScene()));
    const std::uint64_t opened = workspace.analysisGeneration();
    workspace.editScene("name", [](core::Scene& scene) { scene.segments[0].name = "other"; });
    EXPECT_EQ(workspace.analysisGeneration(), opened);
    EXPECT_GT(workspace.generation(), opened);
    workspace.editScene("flag", [](core::Scene& scene) { scene.segments[0].glossy = true; });
    EXPECT_EQ(workspace.analysisGeneration(), workspace.generation());
}

TEST(Workspace, UndoAndRedoSelectTheSegmentsTheyBring) {
    ui::Workspace workspace;
    workspace.setDocument(core::Document(test::makeScene()));
    workspace.select(1);
    core::BinaryMask corner(32, 24);
    corner(0, 0) = 1;
    workspace.editScene("New segment", [&](core::Scene& scene) { scene = core::withSegment(scene, corner, "object"); });
    const std::uint16_t made = test::labelOf(workspace.scene(), "object");
    workspace.select(made);
    workspace.document().undo();
    EXPECT_EQ(workspace.selectedLabel(), 1);
    workspace.document().redo();
    EXPECT_EQ(workspace.selectedLabel(), made);
    workspace.editSelected("Flag", [](core::Segment& segment) { segment.glossy = true; });
    workspace.select(2);
    workspace.document().undo();
    EXPECT_EQ(workspace.selectedLabel(), 2) << "the segments stay, and so does what is selected";
}

/// A photograph whose labels are not changed at once.
core::Scene makeLargeScene() {
    auto photo = std::make_shared<core::Photo>();
    photo->camera = core::Camera::fromHorizontalFov(1100, 1000, 1.0f);
    photo->color = core::ImageRgb(1100, 1000, core::Vector3f(0.2f, 0.3f, 0.4f));
    photo->depth = core::ImageF(1100, 1000, 2.0f);
    photo->labels = core::LabelImage(1100, 1000, 1);
    core::Scene scene;
    scene.photo = photo;
    core::addMissingSegments(scene);
    return scene;
}

TEST(SceneChange, IsMadeInTheBackgroundAndKeepsWhatWasChangedMeanwhile) {
    ui::Workspace workspace;
    workspace.setDocument(core::Document(makeLargeScene()));
    QWidget owner;
    ui::SceneChange change(workspace, &owner);
    std::atomic<bool> go = false;
    std::atomic<int> rounds = 0;
    int done = 0;
    const auto lock = [&](core::Scene scene, core::Notes*, const core::Progress&) {
        while (!go) QThread::msleep(1);
        ++rounds;
        EXPECT_NE(QThread::currentThread(), qApp->thread());
        scene.segments[0].locked = true;
        return scene;
    };
    change.run("Lock", lock, [&](const core::Scene&, const core::Notes&) { ++done; });
    EXPECT_TRUE(change.running());
    workspace.editScene("Rename", [](core::Scene& scene) { scene.segments[0].name = "desk"; });
    go = true;
    ASSERT_TRUE(test::waitUntil([&] { return !change.running() && done == 1; }, 20000));
    EXPECT_EQ(rounds, 2);
    EXPECT_EQ(workspace.scene().segments[0].name, "desk");
    EXPECT_TRUE(workspace.scene().segments[0].locked);
    workspace.document().undo();
    EXPECT_FALSE(workspace.scene().segments[0].locked);
    EXPECT_EQ(workspace.scene().segments[0].name, "desk");
}

TEST(SceneChange, ShowsItsProgressAndIsCancelled) {
    ui::Workspace workspace;
    workspace.setDocument(core::Document(makeLargeScene()));
    QWidget owner;
    owner.show();
    ui::SceneChange change(workspace, &owner);
    QStringList messages;
    QObject::connect(&change, &ui::SceneChange::message, [&](const QString& text) { messages << text; });
    const core::Scene before = workspace.scene();
    change.run(
        "Endless",
        [](const core::Scene& scene, core::Notes*, const core::Progress& progress) {
            for (;;) {
                QThread::msleep(1);
                progress.checkpoint(0.5f);
            }
            return scene;
        },
        [](const core::Scene&, const core::Notes&) { FAIL(); });
    auto* dialog = test::child<QProgressDialog>(owner, "changeProgress");
    ASSERT_TRUE(test::waitUntil([&] { return dialog->isVisible() && dialog->value() == 500; }, 20000));
    change.run(
        "Another", [](const core::Scene& scene, core::Notes*, const core::Progress&) { return scene; },
        [](const core::Scene&, const core::Notes&) { FAIL(); });
    EXPECT_EQ(messages.size(), 1) << "one at a time";
    auto* cancel = dialog->findChild<QPushButton*>();
    ASSERT_NE(cancel, nullptr);
    QTest::mouseClick(cancel, Qt::LeftButton);
    ASSERT_TRUE(test::waitUntil([&] { return !change.running(); }, 20000));
    EXPECT_EQ(messages.back(), "Cancelled.");
    EXPECT_TRUE(workspace.scene() == before);
    EXPECT_FALSE(workspace.document().canUndo());
}

TEST(SceneChange, IsNotMadeWhenItWasCancelledTooLateToStop) {
    ui::Workspace workspace;
    workspace.setDocument(core::Document(makeLargeScene()));
    QWidget owner;
    ui::SceneChange change(workspace, &owner);
    std::atomic<bool> go = false;
    change.run(
        "Lock",
        [&go](core::Scene scene, core::Notes*, const core::Progress&) {
            while (!go) QThread::msleep(1);
            scene.segments[0].locked = true;
            return scene;
        },
        [](const core::Scene&, const core::Notes&) { FAIL(); });
    emit test::child<QProgressDialog>(owner, "changeProgress")->canceled();
    go = true;
    ASSERT_TRUE(test::waitUntil([&] { return !change.running(); }, 20000));
    EXPECT_FALSE(workspace.scene().segments[0].locked);
}

}  // namespace
