// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

namespace gpu::detail {

/// Compiles pipelines on a thread of its own, in order of request.
class PipelineCompiler {
  public:
    /// Calls Vulkan only: no object of this library may be touched from the thread.
    using Job = std::function<VkResult()>;

    PipelineCompiler() = default;
    ~PipelineCompiler() { stop(); }
    PipelineCompiler(const PipelineCompiler&) = delete;
    PipelineCompiler& operator=(const PipelineCompiler&) = delete;

    [[nodiscard]] std::future<VkResult> start(Job job);
    [[nodiscard]] bool busy() const { return unfinished_ > 0; }
    /// Drops jobs that have not begun (their futures become VK_NOT_READY) and waits for the rest.
    void stop();

  private:
    void run();

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<std::packaged_task<VkResult(bool run)>> queue_;
    bool stopping_ = false;
    std::atomic<int> unfinished_ = 0;
    std::thread thread_;
};

}  // namespace gpu::detail
