// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/command_encoder.h"

#include <algorithm>

#include "gpu/detail/commands.h"
#include "gpu/detail/copies.h"
#include "gpu/detail/device_impl.h"
#include "gpu/device.h"

namespace gpu {

namespace detail {

CommandEncoderImpl::~CommandEncoderImpl() {
    if (finished_ || !commands_->adopted) return;
    // The owner submits the frame anyway, so the writes it depends on must go first.
    try {
        commands_->end();
        if (!device_->lost() && !device_->destroyed()) device_->inFlight().flushPendingWrites();
    } catch (const Error&) {
        // There is no caller to inform; the next call on the device reports the same error.
    }
}

void CommandEncoderImpl::requireOpen() const {
    require(!finished_, "Encoder ", quoted(label_), " is finished; make a new one to record more.");
}

std::shared_ptr<CommandBufferImpl> CommandEncoderImpl::finish() {
    requireOpen();
    require(!passOpen, "Encoder ", quoted(label_), " cannot finish: a pass is open.");
    require(debugGroups == 0, "Encoder ", quoted(label_), " cannot finish: ", debugGroups, " debug groups are open.");
    require(!invalid_, "Encoder ", quoted(label_), " cannot finish: an earlier call on it failed.");
    finished_ = true;
    if (commands_->adopted) {
        commands_->requireNothingMapped();
        commands_->end();
        device_->inFlight().flushPendingWrites();
        return nullptr;
    }
    commands_->end();
    return commands_;
}

void CommandEncoderImpl::writeTimestamp(QuerySetImpl& querySet, std::uint32_t index, VkPipelineStageFlagBits stage) {
    require(index < querySet.count, "Query set ", quoted(querySet.label()), " has ", querySet.count,
            " queries; there is no query ", index, ".");
    commands_->keep(querySet);
    vkCmdResetQueryPool(commands_->vk, querySet.vk, index, 1);
    vkCmdWriteTimestamp(commands_->vk, stage, querySet.vk, index);
}

void CommandEncoderImpl::executionBarrier() {
    vkCmdPipelineBarrier(commands_->vk, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
                         nullptr, 0, nullptr, 0, nullptr);
}

}  // namespace detail

namespace {

detail::CommandEncoderImpl& encoderOf(const std::shared_ptr<detail::CommandEncoderImpl>& impl) {
    detail::require(impl != nullptr, "The command encoder is an empty handle.");
    return *impl;
}

/// A copy's buffer side in Vulkan's terms, checked.
VkBufferImageCopy copyRegion(const detail::BufferImpl& buffer, BufferUsage usage, const TexelCopyBufferLayout& layout,
                             const detail::TextureImpl& texture, const TexelCopyTextureInfo& place,
                             const Extent3D& size) {
    const std::uint32_t texel = texelSize(texture.format);
    const std::uint64_t rowBytes = std::uint64_t{size.width} * texel;
    const std::uint64_t stride = layout.bytesPerRow == 0 ? rowBytes : layout.bytesPerRow;
    detail::require(stride >= rowBytes && stride % texel == 0, "Buffer ", detail::quoted(buffer.label()), " has ",
                    stride, " bytes per row; a multiple of ", texel, " that holds ", size.width,
                    " texels is expected.");
    detail::require(layout.offset % texel == 0 && layout.offset % 4 == 0, "Copying texels at byte ", layout.offset,
                    " of buffer ", detail::quoted(buffer.label()), ": a multiple of ", std::max(texel, 4u),
                    " is expected.");
    const std::uint64_t bytes = size.height == 0 ? 0 : (size.height - 1) * stride + rowBytes;
    detail::requireBufferRange(buffer, usage, layout.offset, bytes, "copying texels");
    VkBufferImageCopy region = {};
    region.bufferOffset = layout.offset;
    region.bufferRowLength = static_cast<std::uint32_t>(stride / texel);
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, place.mipLevel, 0, 1};
    region.imageOffset = {static_cast<std::int32_t>(place.origin.x), static_cast<std::int32_t>(place.origin.y), 0};
    region.imageExtent = {size.width, size.height, 1};
    return region;
}

bool isEmpty(const Extent3D& size) { return size.width == 0 || size.height == 0; }

}  // namespace

void CommandEncoder::copyBufferToBuffer(const Buffer& source, std::uint64_t sourceOffset, const Buffer& destination,
                                        std::uint64_t destinationOffset, std::uint64_t size) const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    encoder.record([&] {
        auto& from = detail::resolve(source, *encoder.device(), "source buffer");
        auto& to = detail::resolve(destination, *encoder.device(), "destination buffer");
        detail::require(&from != &to, "Buffer ", detail::quoted(from.label()),
                        " is copied to itself; use two buffers.");
        detail::requireBufferRange(from, BufferUsage::CopySrc, sourceOffset, size, "copying from it");
        detail::requireBufferRange(to, BufferUsage::CopyDst, destinationOffset, size, "copying to it");
        if (size == 0) return;
        encoder.commands().use(from, detail::kCopyRead);
        encoder.commands().use(to, detail::kCopyWrite);
        encoder.commands().barrier();
        const VkBufferCopy region = {sourceOffset, destinationOffset, size};
        vkCmdCopyBuffer(encoder.commands().vk, from.vk, to.vk, 1, &region);
    });
}

void CommandEncoder::copyBufferToTexture(const TexelCopyBufferInfo& source, const TexelCopyTextureInfo& destination,
                                         const Extent3D& copySize) const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    encoder.record([&] {
        auto& from = detail::resolve(source.buffer, *encoder.device(), "source buffer");
        auto& to = detail::resolve(destination.texture, *encoder.device(), "destination texture");
        detail::requireTextureRegion(to, TextureUsage::CopyDst, destination, copySize, "copying to it");
        const VkBufferImageCopy region =
            copyRegion(from, BufferUsage::CopySrc, source.layout, to, destination, copySize);
        if (isEmpty(copySize)) return;
        encoder.commands().use(from, detail::kCopyRead);
        encoder.commands().use(to, destination.mipLevel, detail::kCopyWrite);
        encoder.commands().barrier();
        vkCmdCopyBufferToImage(encoder.commands().vk, from.vk, to.vk, VK_IMAGE_LAYOUT_GENERAL, 1, &region);
    });
}

void CommandEncoder::copyTextureToBuffer(const TexelCopyTextureInfo& source, const TexelCopyBufferInfo& destination,
                                         const Extent3D& copySize) const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    encoder.record([&] {
        auto& from = detail::resolve(source.texture, *encoder.device(), "source texture");
        auto& to = detail::resolve(destination.buffer, *encoder.device(), "destination buffer");
        detail::requireTextureRegion(from, TextureUsage::CopySrc, source, copySize, "copying from it");
        const VkBufferImageCopy region =
            copyRegion(to, BufferUsage::CopyDst, destination.layout, from, source, copySize);
        if (isEmpty(copySize)) return;
        encoder.commands().use(from, source.mipLevel, detail::kCopyRead);
        encoder.commands().use(to, detail::kCopyWrite);
        encoder.commands().barrier();
        vkCmdCopyImageToBuffer(encoder.commands().vk, from.vk, VK_IMAGE_LAYOUT_GENERAL, to.vk, 1, &region);
    });
}

void CommandEncoder::copyTextureToTexture(const TexelCopyTextureInfo& source, const TexelCopyTextureInfo& destination,
                                          const Extent3D& copySize) const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    encoder.record([&] {
        auto& from = detail::resolve(source.texture, *encoder.device(), "source texture");
        auto& to = detail::resolve(destination.texture, *encoder.device(), "destination texture");
        detail::requireTextureRegion(from, TextureUsage::CopySrc, source, copySize, "copying from it");
        detail::requireTextureRegion(to, TextureUsage::CopyDst, destination, copySize, "copying to it");
        detail::require(from.format == to.format, "Textures ", detail::quoted(from.label()), " (",
                        toString(from.format), ") and ", detail::quoted(to.label()), " (", toString(to.format),
                        ") have different formats; a copy needs equal ones.");
        detail::require(&from != &to || source.mipLevel != destination.mipLevel, "Level ", source.mipLevel,
                        " of texture ", detail::quoted(from.label()), " is copied to itself.");
        if (isEmpty(copySize)) return;
        encoder.commands().use(from, source.mipLevel, detail::kCopyRead);
        encoder.commands().use(to, destination.mipLevel, detail::kCopyWrite);
        encoder.commands().barrier();
        VkImageCopy region = {};
        region.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, source.mipLevel, 0, 1};
        region.srcOffset = {static_cast<std::int32_t>(source.origin.x), static_cast<std::int32_t>(source.origin.y), 0};
        region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, destination.mipLevel, 0, 1};
        region.dstOffset = {static_cast<std::int32_t>(destination.origin.x),
                            static_cast<std::int32_t>(destination.origin.y), 0};
        region.extent = {copySize.width, copySize.height, 1};
        vkCmdCopyImage(encoder.commands().vk, from.vk, VK_IMAGE_LAYOUT_GENERAL, to.vk, VK_IMAGE_LAYOUT_GENERAL, 1,
                       &region);
    });
}

void CommandEncoder::clearBuffer(const Buffer& handle, std::uint64_t offset, std::uint64_t size) const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    encoder.record([&] {
        auto& buffer = detail::resolve(handle, *encoder.device(), "buffer");
        const std::uint64_t length = size == kWholeSize && offset <= buffer.size ? buffer.size - offset : size;
        detail::requireBufferRange(buffer, BufferUsage::CopyDst, offset, length, "clearing it");
        const bool toTheEnd = offset + length == buffer.size;
        detail::require(offset % 4 == 0 && (length % 4 == 0 || toTheEnd), "Clearing ", length, " bytes at byte ",
                        offset, " of buffer ", detail::quoted(buffer.label()), ": multiples of 4 are expected.");
        if (length == 0) return;
        encoder.commands().use(buffer, detail::kCopyWrite);
        encoder.commands().barrier();
        vkCmdFillBuffer(encoder.commands().vk, buffer.vk, offset, (length + 3) / 4 * 4, 0);
    });
}

void CommandEncoder::clearTexture(const Texture& handle, std::uint32_t mipLevel) const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    encoder.record([&] {
        auto& texture = detail::resolve(handle, *encoder.device(), "texture");
        const TexelCopyTextureInfo place{.texture = handle, .mipLevel = mipLevel, .origin = {}};
        detail::requireTextureRegion(texture, TextureUsage::CopyDst, place, {0, 0, 1}, "clearing it");
        encoder.commands().use(texture, mipLevel, detail::kCopyWrite);
        encoder.commands().barrier();
        const VkClearColorValue zero = {};
        const VkImageSubresourceRange range = {VK_IMAGE_ASPECT_COLOR_BIT, mipLevel, 1, 0, 1};
        vkCmdClearColorImage(encoder.commands().vk, texture.vk, VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &range);
    });
}

void CommandEncoder::writeBuffer(const Buffer& handle, std::uint64_t offset, const void* data, std::size_t size) const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    encoder.record([&] {
        auto& buffer = detail::resolve(handle, *encoder.device(), "buffer");
        detail::requireBufferRange(buffer, BufferUsage::CopyDst, offset, size, "writing to it");
        detail::require(offset % 4 == 0 && size % 4 == 0 && size <= 65536, "Writing ", size, " bytes at byte ", offset,
                        " of buffer ", detail::quoted(buffer.label()),
                        " inside an encoder: multiples of 4, at most 65536 bytes, are expected.");
        if (size == 0) return;
        encoder.commands().use(buffer, detail::kCopyWrite);
        encoder.commands().barrier();
        vkCmdUpdateBuffer(encoder.commands().vk, buffer.vk, offset, size, data);
    });
}

void CommandEncoder::writeTimestamp(const QuerySet& querySet, std::uint32_t index) const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    encoder.record([&] {
        encoder.writeTimestamp(detail::resolve(querySet, *encoder.device(), "query set"), index,
                               VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT);
    });
}

void CommandEncoder::resolveQuerySet(const QuerySet& handle, std::uint32_t first, std::uint32_t count,
                                     const Buffer& destination, std::uint64_t destinationOffset) const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    encoder.record([&] {
        auto& querySet = detail::resolve(handle, *encoder.device(), "query set");
        auto& buffer = detail::resolve(destination, *encoder.device(), "destination buffer");
        detail::require(first <= querySet.count && count <= querySet.count - first, "Query set ",
                        detail::quoted(querySet.label()), " has ", querySet.count, " queries; ", first, " to ",
                        first + count, " go past them.");
        detail::requireBufferRange(buffer, BufferUsage::QueryResolve, destinationOffset, std::uint64_t{8} * count,
                                   "resolving queries");
        detail::require(destinationOffset % 8 == 0, "Queries are resolved at byte ", destinationOffset, " of buffer ",
                        detail::quoted(buffer.label()), "; a multiple of 8 is expected.");
        if (count == 0) return;
        encoder.commands().keep(querySet);
        encoder.commands().use(buffer, detail::kCopyWrite);
        encoder.commands().barrier();
        vkCmdCopyQueryPoolResults(encoder.commands().vk, querySet.vk, first, count, buffer.vk, destinationOffset, 8,
                                  VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
    });
}

void CommandEncoder::pushDebugGroup(const std::string& label) const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    encoder.record([&] {
        encoder.device()->labels().begin(encoder.commands().vk, label);
        ++encoder.debugGroups;
    });
}

void CommandEncoder::popDebugGroup() const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    encoder.record([&] {
        detail::require(encoder.debugGroups > 0, "Encoder ", detail::quoted(encoder.label()),
                        " has no open debug group.");
        --encoder.debugGroups;
        encoder.device()->labels().end(encoder.commands().vk);
    });
}

void CommandEncoder::insertDebugMarker(const std::string& label) const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    encoder.record([&] { encoder.device()->labels().insert(encoder.commands().vk, label); });
}

void CommandEncoder::onCompleted(std::function<void()> callback) const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    encoder.guardedCall([&] {
        encoder.requireOpen();
        if (callback) encoder.commands().onCompleted.push_back(std::move(callback));
    });
}

CommandBuffer CommandEncoder::finish() const {
    detail::CommandEncoderImpl& encoder = encoderOf(impl_);
    return encoder.guardedCall([&] {
        std::shared_ptr<detail::CommandBufferImpl> commands = encoder.finish();
        return commands ? CommandBuffer(detail::makeHandle(encoder.device(), std::move(commands))) : CommandBuffer();
    });
}

Device CommandEncoder::device() const { return Device(encoderOf(impl_).device()); }

}  // namespace gpu
