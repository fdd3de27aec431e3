// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <type_traits>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/command_encoder.h"
#include "gpu/handle.h"
#include "gpu/texture.h"
#include "gpu/types.h"

namespace gpu {

/// Where finished command buffers go. Commands run in the order of submission; a write made here runs after everything
/// submitted before it and before everything submitted after it (for an adopted frame: before the frame whose encoder
/// is finished next).
class Queue : public Handle<detail::DeviceImpl> {
  public:
    using Handle::Handle;

    void submit(std::span<const CommandBuffer> commandBuffers) const;
    void submit(std::initializer_list<CommandBuffer> commandBuffers) const {
        submit(std::span<const CommandBuffer>(commandBuffers.begin(), commandBuffers.size()));
    }
    void submit(const CommandBuffer& commandBuffer) const { submit(std::span(&commandBuffer, 1)); }

    /// Copies `data` into the buffer (usage CopyDst). The data is copied before the call returns. Any size.
    void writeBuffer(const Buffer& buffer, std::uint64_t offset, const void* data, std::size_t size) const;
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void writeBuffer(const Buffer& buffer, std::uint64_t offset, std::span<const T> data) const {
        writeBuffer(buffer, offset, data.data(), data.size_bytes());
    }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void writeBuffer(const Buffer& buffer, std::uint64_t offset, const std::vector<T>& data) const {
        writeBuffer(buffer, offset, data.data(), data.size() * sizeof(T));
    }

    /// Copies texels into one level of a texture (usage CopyDst). Any size.
    void writeTexture(const TexelCopyTextureInfo& destination, const void* data, std::size_t dataSize,
                      const TexelCopyBufferLayout& layout, const Extent3D& writeSize) const;
    /// Same, for tightly packed rows that fill level 0.
    void writeTexture(const Texture& texture, const void* data, std::size_t dataSize) const;

    /// The callback runs, inside tick() or a later call on this thread, once everything submitted so far has completed.
    void onSubmittedWorkDone(std::function<void()> callback) const;
};

}  // namespace gpu
