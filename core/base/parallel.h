// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <future>
#include <memory>
#include <thread>
#include <type_traits>
#include <utility>

#include "core/base/progress.h"

namespace core {

/// Calls `body(i)` for every i in [0, count) on all cores, in no particular order. Reports progress. Throws
/// Error(Cancelled), or what a body threw, once all running bodies have returned. A body should take about as long as a
/// row of pixels: long enough to be worth a checkpoint, short enough to stop promptly.
template <class Body>
void parallelFor(const Progress& progress, int count, const Body& body) {
    std::atomic<int> done{0};
    const float scale = count > 0 ? 1 / static_cast<float>(count) : 0.0f;
    tbb::parallel_for(tbb::blocked_range<int>(0, count, 4), [&](const tbb::blocked_range<int>& range) {
        for (int i = range.begin(); i != range.end(); ++i) {
            progress.checkpoint(scale * static_cast<float>(done.fetch_add(1, std::memory_order_relaxed)));
            body(i);
        }
    });
}

/// Runs `work`, which must own everything it uses, on a thread of its own. The future holds its result or exception;
/// unlike with std::async, dropping the future does not wait.
template <class Work>
[[nodiscard]] auto inBackground(Work work) {
    using Result = std::invoke_result_t<Work&>;
    const auto task = std::make_shared<std::packaged_task<Result()>>(std::move(work));
    std::future<Result> result = task->get_future();
    std::thread([task] { (*task)(); }).detach();
    return result;
}

}  // namespace core
