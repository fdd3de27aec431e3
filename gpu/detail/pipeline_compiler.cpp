// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/detail/pipeline_compiler.h"

#include <utility>

namespace gpu::detail {

std::future<VkResult> PipelineCompiler::start(Job job) {
    std::packaged_task<VkResult(bool)> task([job = std::move(job)](bool run) { return run ? job() : VK_NOT_READY; });
    std::future<VkResult> result = task.get_future();
    {
        const std::lock_guard lock(mutex_);
        queue_.push_back(std::move(task));
        ++unfinished_;
        if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
    }
    wake_.notify_one();
    return result;
}

void PipelineCompiler::run() {
    while (true) {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
        if (queue_.empty()) return;
        std::packaged_task<VkResult(bool)> task = std::move(queue_.front());
        queue_.pop_front();
        const bool wanted = !stopping_;
        lock.unlock();
        task(wanted);
        --unfinished_;
    }
}

void PipelineCompiler::stop() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_one();
    if (thread_.joinable()) thread_.join();
}

}  // namespace gpu::detail
