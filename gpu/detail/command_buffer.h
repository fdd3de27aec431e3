// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_set>
#include <vector>

#include "gpu/detail/object.h"
#include "gpu/detail/usage_tracker.h"

namespace gpu::detail {

class BufferImpl;
class TextureImpl;

/// A Vulkan command buffer, what it uses, and what happens when it has run.
class CommandBufferImpl final : public Object {
  public:
    CommandBufferImpl(DeviceImpl& device, std::string label);
    /// Records into a command buffer that its owner began and will submit.
    CommandBufferImpl(DeviceImpl& device, std::string label, VkCommandBuffer adopted);
    ~CommandBufferImpl() override { release(); }
    void release() noexcept override;

    /// Keeps an object alive until the commands have run.
    void keep(Object& object) { kept_.insert(object.shared_from_this()); }
    void use(BufferImpl& buffer, const Access& access);
    void use(TextureImpl& texture, std::uint32_t mipLevel, const Access& access);
    /// Records the barrier for the uses noted since the last command.
    void barrier() { tracker_.flush(vk); }
    /// Ends recording; on an adopted command buffer only makes results visible to the host.
    void end();
    /// Throws when a buffer this uses is mapped or about to be.
    void requireNothingMapped() const;
    void markSubmitted(std::uint64_t serial);
    /// Lets go of everything the commands used.
    void releaseUsed() { kept_.clear(); }

    VkCommandBuffer vk = VK_NULL_HANDLE;
    const bool adopted = false;
    bool submitted = false;
    std::uint64_t frame = 0;  ///< number of the adopted frame; 0 for others
    std::vector<std::function<void()>> onCompleted;

  private:
    void waitForEarlierWork();

    UsageTracker tracker_;
    std::unordered_set<std::shared_ptr<Object>> kept_;
    std::unordered_set<BufferImpl*> mappable_;
    bool hostReads_ = false;
};

/// Copies data into a buffer before the next submission, in pieces of the staging memory's size.
void writeThroughQueue(BufferImpl& buffer, std::uint64_t offset, const void* data, std::size_t size);

}  // namespace gpu::detail
