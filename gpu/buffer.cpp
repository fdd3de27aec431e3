// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/buffer.h"

#include <cstring>
#include <limits>
#include <utility>

#include "gpu/detail/command_buffer.h"
#include "gpu/detail/device_impl.h"
#include "gpu/detail/resources.h"
#include "gpu/detail/vulkan_map.h"

namespace gpu {

namespace detail {

BufferImpl::BufferImpl(DeviceImpl& owner, const BufferDescriptor& descriptor, bool staging)
    : Object(owner, descriptor.label), size(descriptor.size), usage(descriptor.usage) {
    require(size > 0, "Buffer ", quoted(label()), " has size 0; at least 1 byte is needed.");
    require(usage != BufferUsage::None, "Buffer ", quoted(label()), " has no usage.");
    require(!has(usage, BufferUsage::MapRead) ||
                (usage | BufferUsage::CopyDst | BufferUsage::MapRead) == (BufferUsage::CopyDst | BufferUsage::MapRead),
            "Buffer ", quoted(label()), " has usage ", toString(usage), "; MapRead only goes with CopyDst.");
    require(!has(usage, BufferUsage::MapWrite) || (usage | BufferUsage::CopySrc | BufferUsage::MapWrite) ==
                                                      (BufferUsage::CopySrc | BufferUsage::MapWrite),
            "Buffer ", quoted(label()), " has usage ", toString(usage), "; MapWrite only goes with CopySrc.");
    require(size <= owner.limits().maxBufferSize, "Buffer ", quoted(label()), " has ", size,
            " bytes; this device allows ", owner.limits().maxBufferSize, ".");
    try {
        createMemory(staging);
    } catch (...) {
        release();
        throw;
    }
}

void BufferImpl::createMemory(bool staging) {
    VkBufferCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = (size + 3) / 4 * 4;  // fills work on whole words
    info.usage = toVulkan(usage);
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    device().check(vkCreateBuffer(device().vk(), &info, nullptr, &vk), "vkCreateBuffer", label());
    device().labels().setName(VK_OBJECT_TYPE_BUFFER, vk, label());

    VkMemoryRequirements requirements;
    vkGetBufferMemoryRequirements(device().vk(), vk, &requirements);
    const bool read = has(usage, BufferUsage::MapRead);
    const bool write = has(usage, BufferUsage::MapWrite);
    VkMemoryPropertyFlags required = 0;
    VkMemoryPropertyFlags preferred = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    if (read) {
        required = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT;
        preferred = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
    } else if (write) {
        required = preferred = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    }
    allocation_ = device().memory().allocate(requirements, required, preferred, !staging,
                                             text("buffer ", quoted(label()), " of ", size, " bytes"));
    device().check(vkBindBufferMemory(device().vk(), vk, allocation_.memory, 0), "vkBindBufferMemory", label());
    if (read || write) host_ = device().memory().map(allocation_, label());
}

void BufferImpl::zero() {
    if (host_ != nullptr) {
        std::memset(host_, 0, static_cast<std::size_t>(size));
        device().memory().flushHostWrites(allocation_, label());
        return;
    }
    CommandBufferImpl& writes = device().inFlight().pendingWrites();
    writes.use(*this, kCopyWrite);
    writes.barrier();
    vkCmdFillBuffer(writes.vk, vk, 0, VK_WHOLE_SIZE, 0);
}

void BufferImpl::release() noexcept {
    if (vk == VK_NULL_HANDLE) return;
    vkDestroyBuffer(device().vk(), vk, nullptr);
    vk = VK_NULL_HANDLE;
    host_ = nullptr;
    device().memory().free(allocation_);
}

void BufferImpl::startMappedAtCreation() {
    mapState = BufferMapState::Mapped;
    mapMode_ = MapMode::Write;
    mapOffset_ = 0;
    mapSize_ = size;
    if (host_ == nullptr) creationData_.resize(static_cast<std::size_t>(size));
}

void BufferImpl::mapAsync(MapMode mode, std::uint64_t offset, std::uint64_t length, BufferMapCallback callback) {
    const BufferUsage needed = mode == MapMode::Read ? BufferUsage::MapRead : BufferUsage::MapWrite;
    require(has(usage, needed), "Buffer ", quoted(label()), " has usage ", toString(usage), "; mapping it needs ",
            toString(needed), ".");
    require(mapState == BufferMapState::Unmapped, "Buffer ", quoted(label()),
            " is mapped or about to be; unmap it before mapping it again.");
    require(offset <= size, "Mapping buffer ", quoted(label()), " at byte ", offset, " starts behind its ", size,
            " bytes.");
    if (length == kWholeSize) length = size - offset;
    require(length <= size - offset, "Mapping ", length, " bytes at byte ", offset, " goes past the ", size,
            " bytes of buffer ", quoted(label()), ".");
    device().inFlight().flushPendingWrites();
    mapState = BufferMapState::Pending;
    mapMode_ = mode;
    mapOffset_ = offset;
    mapSize_ = length;
    mapCallback_ = std::move(callback);
    device().inFlight().whenDone(
        lastSubmission, lastFrame, [self = internalReference(*this), request = ++mapRequest_](bool done) {
            if (self->mapState != BufferMapState::Pending || self->mapRequest_ != request) return;
            const BufferMapCallback mapped = std::exchange(self->mapCallback_, nullptr);
            self->mapState = done ? BufferMapState::Mapped : BufferMapState::Unmapped;
            if (done && self->mapMode_ == MapMode::Read) {
                self->device().memory().invalidateHostReads(self->allocation_, self->label());
            }
            if (!mapped) return;
            if (done) {
                mapped(MapAsyncStatus::Success, "");
            } else {
                mapped(MapAsyncStatus::Error,
                       text("Mapping buffer ", quoted(self->label()), " fails: the device is gone."));
            }
        });
}

void* BufferImpl::mappedRange(std::uint64_t offset, std::uint64_t length, bool forWriting) {
    require(mapState == BufferMapState::Mapped, "Buffer ", quoted(label()), " is not mapped.");
    require(!forWriting || mapMode_ == MapMode::Write, "Buffer ", quoted(label()),
            " is mapped for reading; getConstMappedRange is the call for that.");
    const std::uint64_t end = mapOffset_ + mapSize_;
    if (length == kWholeSize) length = offset <= end ? end - offset : 0;
    require(offset >= mapOffset_ && offset <= end && length <= end - offset, "Bytes ", offset, " to ", offset + length,
            " of buffer ", quoted(label()), " are not mapped; bytes ", mapOffset_, " to ", end, " are.");
    require(vk != VK_NULL_HANDLE, "Buffer ", quoted(label()), " died with its device.");
    return (host_ != nullptr ? host_ : creationData_.data()) + offset;
}

void BufferImpl::unmap() {
    if (mapState == BufferMapState::Pending) {
        mapState = BufferMapState::Unmapped;
        const BufferMapCallback callback = std::exchange(mapCallback_, nullptr);
        if (callback) {
            callback(MapAsyncStatus::Aborted,
                     text("Buffer ", quoted(label()), " is unmapped before its mapping is done."));
        }
        return;
    }
    require(mapState == BufferMapState::Mapped, "Buffer ", quoted(label()), " is not mapped.");
    mapState = BufferMapState::Unmapped;
    if (host_ != nullptr) {
        if (mapMode_ == MapMode::Write) device().memory().flushHostWrites(allocation_, label());
        return;
    }
    const std::vector<std::byte> data = std::exchange(creationData_, {});
    writeThroughQueue(*this, 0, data.data(), data.size());
}

}  // namespace detail

namespace {

detail::BufferImpl& bufferOf(const std::shared_ptr<detail::BufferImpl>& impl) {
    detail::require(impl != nullptr, "The buffer is an empty handle.");
    return *impl;
}

}  // namespace

std::uint64_t Buffer::size() const { return bufferOf(impl_).size; }
BufferUsage Buffer::usage() const { return bufferOf(impl_).usage; }
const std::string& Buffer::label() const { return bufferOf(impl_).label(); }
BufferMapState Buffer::mapState() const { return bufferOf(impl_).mapState; }

void Buffer::mapAsync(MapMode mode, std::uint64_t offset, std::uint64_t size, BufferMapCallback callback) const {
    detail::BufferImpl& buffer = bufferOf(impl_);
    buffer.device().guarded([&] { buffer.mapAsync(mode, offset, size, std::move(callback)); });
}

void* Buffer::getMappedRange(std::uint64_t offset, std::uint64_t size) const {
    return bufferOf(impl_).mappedRange(offset, size, true);
}

const void* Buffer::getConstMappedRange(std::uint64_t offset, std::uint64_t size) const {
    return bufferOf(impl_).mappedRange(offset, size, false);
}

void Buffer::unmap() const {
    detail::BufferImpl& buffer = bufferOf(impl_);
    buffer.device().guarded([&] { buffer.unmap(); });
}

}  // namespace gpu
