// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/detail/command_buffer.h"

#include <algorithm>
#include <cstring>

#include "gpu/detail/device_impl.h"
#include "gpu/detail/resources.h"

namespace gpu::detail {

CommandBufferImpl::CommandBufferImpl(DeviceImpl& owner, std::string name) : Object(owner, std::move(name)) {
    vk = owner.inFlight().allocateCommandBuffer(label());
    VkCommandBufferBeginInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    try {
        owner.check(vkBeginCommandBuffer(vk, &info), "vkBeginCommandBuffer", label());
    } catch (...) {
        release();
        throw;
    }
    waitForEarlierWork();
}

CommandBufferImpl::CommandBufferImpl(DeviceImpl& owner, std::string name, VkCommandBuffer adoptedBuffer)
    : Object(owner, std::move(name)), vk(adoptedBuffer), adopted(true) {
    waitForEarlierWork();
}

void CommandBufferImpl::waitForEarlierWork() {
    const VkMemoryBarrier barrier = {VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_MEMORY_WRITE_BIT,
                                     VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT};
    vkCmdPipelineBarrier(vk, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 1, &barrier, 0,
                         nullptr, 0, nullptr);
}

void CommandBufferImpl::release() noexcept {
    if (vk == VK_NULL_HANDLE) return;
    if (!adopted) device().inFlight().freeCommandBuffer(vk);
    vk = VK_NULL_HANDLE;
}

void CommandBufferImpl::use(BufferImpl& buffer, const Access& access) {
    keep(buffer);
    tracker_.use(&buffer, 0, access);
    if (buffer.mappable()) {
        mappable_.insert(&buffer);
        if (adopted) buffer.lastFrame = frame;
        hostReads_ = hostReads_ || (access.write && has(buffer.usage, BufferUsage::MapRead));
    }
}

void CommandBufferImpl::use(TextureImpl& texture, std::uint32_t mipLevel, const Access& access) {
    keep(texture);
    tracker_.use(&texture, mipLevel, access);
}

void CommandBufferImpl::end() {
    if (hostReads_) {
        const VkMemoryBarrier barrier = {VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_TRANSFER_WRITE_BIT,
                                         VK_ACCESS_HOST_READ_BIT};
        vkCmdPipelineBarrier(vk, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0, nullptr,
                             0, nullptr);
    }
    if (!adopted) device().check(vkEndCommandBuffer(vk), "vkEndCommandBuffer", label());
}

void CommandBufferImpl::requireNothingMapped() const {
    for (const BufferImpl* buffer : mappable_) {
        require(buffer->mapState == BufferMapState::Unmapped, "Buffer ", quoted(buffer->label()),
                " is mapped or about to be; unmap it before submitting commands that use it (", quoted(label()), ").");
    }
}

void CommandBufferImpl::markSubmitted(std::uint64_t serial) {
    submitted = true;
    for (BufferImpl* buffer : mappable_) buffer->lastSubmission = serial;
}

void writeThroughQueue(BufferImpl& buffer, std::uint64_t offset, const void* data, std::size_t size) {
    constexpr std::size_t kPiece = std::size_t{32} << 20;
    InFlight& inFlight = buffer.device().inFlight();
    const auto* bytes = static_cast<const std::byte*>(data);
    for (std::size_t done = 0; done < size;) {
        const std::size_t piece = std::min(kPiece, size - done);
        const InFlight::Staging staging = inFlight.stage(piece);
        std::memcpy(staging.data, bytes + done, piece);
        CommandBufferImpl& writes = inFlight.pendingWrites();
        writes.use(buffer, kCopyWrite);
        writes.barrier();
        const VkBufferCopy region = {staging.offset, offset + done, piece};
        vkCmdCopyBuffer(writes.vk, staging.buffer->vk, buffer.vk, 1, &region);
        done += piece;
        inFlight.limitStagedBytes(4 * kPiece);
    }
}

}  // namespace gpu::detail
