// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/queue.h"

#include <algorithm>
#include <cstring>

#include "gpu/detail/command_buffer.h"
#include "gpu/detail/copies.h"
#include "gpu/detail/device_impl.h"

namespace gpu {

namespace {

detail::DeviceImpl& queueDevice(const std::shared_ptr<detail::DeviceImpl>& impl) {
    detail::require(impl != nullptr, "The queue is an empty handle.");
    return *impl;
}

}  // namespace

void Queue::submit(std::span<const CommandBuffer> commandBuffers) const {
    detail::DeviceImpl& device = queueDevice(impl_);
    device.guarded([&] {
        std::vector<std::shared_ptr<detail::CommandBufferImpl>> internal;
        for (const CommandBuffer& commandBuffer : commandBuffers) {
            auto& resolved = detail::resolve(commandBuffer, device, "command buffer");
            const auto twice = std::find_if(internal.begin(), internal.end(),
                                            [&](const auto& other) { return other.get() == &resolved; });
            detail::require(twice == internal.end(), "Command buffer ", detail::quoted(resolved.label()),
                            " is submitted twice at once.");
            internal.push_back(detail::internalReference(resolved));
        }
        device.inFlight().submit(internal);
    });
}

void Queue::writeBuffer(const Buffer& handle, std::uint64_t offset, const void* data, std::size_t size) const {
    detail::DeviceImpl& device = queueDevice(impl_);
    device.guarded([&] {
        detail::BufferImpl& buffer = detail::resolve(handle, device, "buffer");
        detail::requireBufferRange(buffer, BufferUsage::CopyDst, offset, size, "writing to it");
        detail::require(buffer.mapState == BufferMapState::Unmapped, "Buffer ", detail::quoted(buffer.label()),
                        " is mapped or about to be; unmap it before writing to it.");
        detail::writeThroughQueue(buffer, offset, data, size);
    });
}

void Queue::writeTexture(const TexelCopyTextureInfo& destination, const void* data, std::size_t dataSize,
                         const TexelCopyBufferLayout& layout, const Extent3D& writeSize) const {
    detail::DeviceImpl& device = queueDevice(impl_);
    device.guarded([&] {
        detail::TextureImpl& texture = detail::resolve(destination.texture, device, "texture");
        detail::requireTextureRegion(texture, TextureUsage::CopyDst, destination, writeSize, "writing to it");
        const std::size_t texel = texelSize(texture.format);
        const std::size_t rowBytes = writeSize.width * texel;
        const std::size_t stride = layout.bytesPerRow == 0 ? rowBytes : layout.bytesPerRow;
        detail::require(stride >= rowBytes, "Writing to texture ", detail::quoted(texture.label()), " with ", stride,
                        " bytes per row; a row of ", writeSize.width, " texels has ", rowBytes, ".");
        const std::size_t needed = writeSize.height == 0 ? 0
                                                         : static_cast<std::size_t>(layout.offset) +
                                                               (writeSize.height - 1) * stride + rowBytes;
        detail::require(dataSize >= needed, "Writing ", writeSize.width, "x", writeSize.height, " texels to texture ",
                        detail::quoted(texture.label()), " needs ", needed, " bytes; ", dataSize, " are given.");
        if (rowBytes == 0) return;
        constexpr std::size_t kPiece = std::size_t{32} << 20;
        const std::size_t rowsPerPiece = std::max<std::size_t>(1, kPiece / rowBytes);
        const auto* source = static_cast<const std::byte*>(data) + layout.offset;
        for (std::size_t row = 0; row < writeSize.height;) {
            const std::size_t rows = std::min<std::size_t>(rowsPerPiece, writeSize.height - row);
            const auto staging = device.inFlight().stage(rows * rowBytes);
            for (std::size_t i = 0; i < rows; ++i) {
                std::memcpy(staging.data + i * rowBytes, source + (row + i) * stride, rowBytes);
            }
            detail::CommandBufferImpl& writes = device.inFlight().pendingWrites();
            writes.use(texture, destination.mipLevel, detail::kCopyWrite);
            writes.barrier();
            VkBufferImageCopy region = {};
            region.bufferOffset = staging.offset;
            region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, destination.mipLevel, 0, 1};
            region.imageOffset = {static_cast<std::int32_t>(destination.origin.x),
                                  static_cast<std::int32_t>(destination.origin.y + row), 0};
            region.imageExtent = {writeSize.width, static_cast<std::uint32_t>(rows), 1};
            vkCmdCopyBufferToImage(writes.vk, staging.buffer->vk, texture.vk, VK_IMAGE_LAYOUT_GENERAL, 1, &region);
            row += rows;
            device.inFlight().limitStagedBytes(4 * kPiece);
        }
    });
}

void Queue::writeTexture(const Texture& texture, const void* data, std::size_t dataSize) const {
    detail::DeviceImpl& device = queueDevice(impl_);
    Extent3D size = {};
    const bool valid = device.guarded([&] {
        const detail::TextureImpl& resolved = detail::resolve(texture, device, "texture");
        size = resolved.size;
        const std::size_t expected = std::size_t{size.width} * size.height * texelSize(resolved.format);
        detail::require(dataSize == expected, "Filling texture ", detail::quoted(resolved.label()), " needs ", expected,
                        " bytes; ", dataSize, " are given.");
        return true;
    });
    if (valid) writeTexture({.texture = texture, .mipLevel = 0, .origin = {}}, data, dataSize, {}, size);
}

void Queue::onSubmittedWorkDone(std::function<void()> callback) const {
    detail::DeviceImpl& device = queueDevice(impl_);
    device.guarded([&] {
        detail::InFlight& inFlight = device.inFlight();
        inFlight.flushPendingWrites();
        inFlight.whenDone(inFlight.lastSubmission(), inFlight.lastFrame(), [callback = std::move(callback)](bool) {
            if (callback) callback();
        });
    });
}

}  // namespace gpu
