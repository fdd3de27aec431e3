// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "gpu/bind_group.h"
#include "gpu/buffer.h"
#include "gpu/handle.h"
#include "gpu/pipeline.h"
#include "gpu/query_set.h"
#include "gpu/texture.h"
#include "gpu/types.h"

namespace gpu {

class Device;
struct ExternalRenderPassDescriptor;  // gpu/adopt.h

struct CommandEncoderDescriptor {
    std::string label = {};
};

/// Timestamps taken around a pass.
struct PassTimestampWrites {
    QuerySet querySet = {};
    std::uint32_t beginningOfPassWriteIndex = 0;
    std::uint32_t endOfPassWriteIndex = 1;
};

struct ComputePassDescriptor {
    std::string label = {};
    std::optional<PassTimestampWrites> timestampWrites = {};
};

struct RenderPassColorAttachment {
    TextureView view = {};
    LoadOp loadOp = LoadOp::Clear;
    StoreOp storeOp = StoreOp::Store;
    Color clearValue = {};
};

struct RenderPassDescriptor {
    std::string label = {};
    std::vector<RenderPassColorAttachment> colorAttachments = {};
    std::optional<PassTimestampWrites> timestampWrites = {};
};

/// Location in a buffer for a copy from or to a texture.
struct TexelCopyBufferInfo {
    Buffer buffer = {};
    TexelCopyBufferLayout layout = {};
};

/// Finished commands; submitted once.
class CommandBuffer : public Handle<detail::CommandBufferImpl> {
  public:
    using Handle::Handle;
};

/// Dispatches of compute shaders. Each dispatch sees what the ones before it wrote.
class ComputePassEncoder : public Handle<detail::ComputePassImpl> {
  public:
    using Handle::Handle;

    void setPipeline(const ComputePipeline& pipeline) const;
    /// One dynamic offset [bytes] per entry with hasDynamicOffset, in order of binding.
    void setBindGroup(std::uint32_t index, const BindGroup& group,
                      std::span<const std::uint32_t> dynamicOffsets = {}) const;
    /// Sets bytes [rangeOffset, rangeOffset + size) of the shader's immediates (GLSL: its push_constant block),
    /// multiples of 4 within kMaxImmediateSize. They stay set for all later dispatches of the pass, whatever the
    /// pipeline; a dispatch needs every byte its pipeline declares and ignores the rest.
    void setImmediates(std::uint32_t rangeOffset, const void* data, std::size_t size) const;
    template <class T>
    requires(std::is_trivially_copyable_v<T> &&
             sizeof(T) <= kMaxImmediateSize) void setImmediates(std::uint32_t rangeOffset, const T& block) const {
        setImmediates(rangeOffset, &block, sizeof(T));
    }

    /// Runs x*y*z workgroups. A count of 0 does nothing.
    void dispatchWorkgroups(std::uint32_t x, std::uint32_t y = 1, std::uint32_t z = 1) const;
    /// The counts are three uint32 at `offset` (a multiple of 4) in a buffer with usage Indirect.
    void dispatchWorkgroupsIndirect(const Buffer& buffer, std::uint64_t offset) const;

    void writeTimestamp(const QuerySet& querySet, std::uint32_t index) const;
    void pushDebugGroup(const std::string& label) const;
    void popDebugGroup() const;
    void insertDebugMarker(const std::string& label) const;
    void end() const;
};

/// Draw calls. Nothing is recorded before end(), because the barriers of the whole pass must come first.
class RenderPassEncoder : public Handle<detail::RenderPassImpl> {
  public:
    using Handle::Handle;

    void setPipeline(const RenderPipeline& pipeline) const;
    void setBindGroup(std::uint32_t index, const BindGroup& group,
                      std::span<const std::uint32_t> dynamicOffsets = {}) const;
    void setImmediates(std::uint32_t rangeOffset, const void* data, std::size_t size) const;
    template <class T>
    requires(std::is_trivially_copyable_v<T> &&
             sizeof(T) <= kMaxImmediateSize) void setImmediates(std::uint32_t rangeOffset, const T& block) const {
        setImmediates(rangeOffset, &block, sizeof(T));
    }
    void setVertexBuffer(std::uint32_t slot, const Buffer& buffer, std::uint64_t offset = 0) const;
    void setIndexBuffer(const Buffer& buffer, IndexFormat format, std::uint64_t offset = 0) const;
    /// Pixels; y down. Initially the whole attachment.
    void setViewport(float x, float y, float width, float height, float minDepth = 0, float maxDepth = 1) const;
    void setScissorRect(std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) const;
    void draw(std::uint32_t vertexCount, std::uint32_t instanceCount = 1, std::uint32_t firstVertex = 0,
              std::uint32_t firstInstance = 0) const;
    void drawIndexed(std::uint32_t indexCount, std::uint32_t instanceCount = 1, std::uint32_t firstIndex = 0,
                     std::int32_t baseVertex = 0, std::uint32_t firstInstance = 0) const;
    void end() const;
};

/// Records commands. Barriers follow from usage, also between dispatches; callers never write one.
///
/// A call that throws has recorded nothing. While a pass is open only the pass may record.
class CommandEncoder : public Handle<detail::CommandEncoderImpl> {
  public:
    using Handle::Handle;

    [[nodiscard]] ComputePassEncoder beginComputePass(const ComputePassDescriptor& descriptor = {}) const;
    [[nodiscard]] RenderPassEncoder beginRenderPass(const RenderPassDescriptor& descriptor) const;
    /// A pass into a framebuffer owned by someone else (a window).
    [[nodiscard]] RenderPassEncoder beginRenderPass(const ExternalRenderPassDescriptor& descriptor) const;

    void copyBufferToBuffer(const Buffer& source, std::uint64_t sourceOffset, const Buffer& destination,
                            std::uint64_t destinationOffset, std::uint64_t size) const;
    void copyBufferToTexture(const TexelCopyBufferInfo& source, const TexelCopyTextureInfo& destination,
                             const Extent3D& copySize) const;
    void copyTextureToBuffer(const TexelCopyTextureInfo& source, const TexelCopyBufferInfo& destination,
                             const Extent3D& copySize) const;
    void copyTextureToTexture(const TexelCopyTextureInfo& source, const TexelCopyTextureInfo& destination,
                              const Extent3D& copySize) const;
    /// Zeroes a range; offset and size are multiples of 4 (size may be kWholeSize). Needs usage CopyDst.
    void clearBuffer(const Buffer& buffer, std::uint64_t offset = 0, std::uint64_t size = kWholeSize) const;
    /// Zeroes one level. Needs usage CopyDst.
    void clearTexture(const Texture& texture, std::uint32_t mipLevel = 0) const;
    /// Writes at this point of the command stream, so that one buffer can hold different values for different
    /// dispatches of an encoder; at most 64 KiB, offset and size multiples of 4. Needs usage CopyDst.
    void writeBuffer(const Buffer& buffer, std::uint64_t offset, const void* data, std::size_t size) const;

    void writeTimestamp(const QuerySet& querySet, std::uint32_t index) const;
    /// Writes `count` 64-bit ticks to `destination` (usage QueryResolve).
    void resolveQuerySet(const QuerySet& querySet, std::uint32_t first, std::uint32_t count, const Buffer& destination,
                         std::uint64_t destinationOffset) const;

    void pushDebugGroup(const std::string& label) const;
    void popDebugGroup() const;
    void insertDebugMarker(const std::string& label) const;

    /// The callback runs, inside tick() or a later call on this thread, once the device has run this encoder's
    /// commands.
    void onCompleted(std::function<void()> callback) const;

    /// Ends recording. On an adopted frame the result is empty and the command buffer's owner submits.
    CommandBuffer finish() const;

    [[nodiscard]] Device device() const;
};

}  // namespace gpu
