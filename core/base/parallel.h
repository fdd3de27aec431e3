// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <memory>
#include <numeric>
#include <thread>
#include <type_traits>
#include <utility>

#include "core/base/progress.h"

namespace core {

/// Stride through [0, count) that visits everything once and whose first visits are already spread over the whole.
[[nodiscard]] inline long scatteringStride(int count) {
    constexpr double kGoldenRatio = 0.618;
    long stride = std::max(1L, std::lround(kGoldenRatio * count));
    while (std::gcd(stride, static_cast<long>(count)) != 1) ++stride;
    return stride;
}

/// Calls `body(i)` for every i in [0, count) on all cores. Reports progress, which follows time even if all the work is
/// at one end of the range, because parts far from each other follow each other. Throws Error(Cancelled), or what a
/// body threw, once all running bodies have returned. A body should take about as long as a row of pixels: long enough
/// to be worth a checkpoint, short enough to stop promptly.
template <class Body>
void parallelFor(const Progress& progress, int count, const Body& body) {
    constexpr int kPart = 4;
    if (count <= 0) return;
    const int parts = (count + kPart - 1) / kPart;
    const long stride = scatteringStride(parts);
    const float scale = 1 / static_cast<float>(count);
    std::atomic<int> done{0};
    tbb::parallel_for(tbb::blocked_range<int>(0, parts), [&](const tbb::blocked_range<int>& range) {
        for (int part = range.begin(); part != range.end(); ++part) {
            const int first = kPart * static_cast<int>(part * stride % parts);
            for (int i = first; i < std::min(first + kPart, count); ++i) {
                progress.checkpoint(scale * static_cast<float>(done.fetch_add(1, std::memory_order_relaxed)));
                body(i);
            }
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
