// SPDX-License-Identifier: GPL-3.0-or-later
// Stopping in the middle of the back sides leaves what was there.
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string_view>
#include <thread>

#include "core/analysis/step.h"
#include "core/base/error.h"
#include "tests/support/ray_scene.h"

namespace {

TEST(BackSideCancel, StopsAtTheNextCheckpointAndLeavesTheOldBack) {
    const core::Scene scene = test::stillLife(test::testCamera(240, 180)).scene();
    core::analysis::Board board;
    board.scene = &scene;
    core::analysis::recoverDepthStep().run(board, {});
    core::analysis::computeNormalsStep().run(board, {});
    const core::analysis::Step step = core::analysis::backSideStep();
    std::atomic<int> checkpoints = 0;
    step.run(board, {core::Progress([&](core::Task, float) { ++checkpoints; })});
    const auto before = board.back;
    const core::ImageF depth = before->surface.depth;
    const int all = checkpoints;
    ASSERT_GT(all, 4);

    for (const int stop : {1, all / 4, all / 2, all - 1}) {
        std::atomic<bool> cancel = false;
        checkpoints = 0;
        const core::Progress progress(
            [&](core::Task, float) {
                if (++checkpoints >= stop) cancel = true;
            },
            &cancel);
        try {
            step.run(board, {progress});
            FAIL() << "stopped at checkpoint " << stop << " of " << all;
        } catch (const core::Error& error) {
            EXPECT_EQ(error.kind(), core::ErrorKind::Cancelled);
        }
        // Threads that run beside the one that stops may have passed their own check just before.
        EXPECT_LE(checkpoints, stop + static_cast<int>(std::thread::hardware_concurrency())) << "of " << all;
        EXPECT_EQ(board.back, before);
        EXPECT_EQ(board.back->surface.depth, depth);
    }
    step.run(board, {});
    EXPECT_EQ(board.back->surface.depth, depth);
}

}  // namespace
