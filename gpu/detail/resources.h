// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/detail/device_memory.h"
#include "gpu/detail/object.h"
#include "gpu/query_set.h"
#include "gpu/sampler.h"
#include "gpu/texture.h"

namespace gpu::detail {

class BufferImpl final : public Object {
  public:
    /// `staging` buffers belong to the library: mapped, and not counted.
    BufferImpl(DeviceImpl& device, const BufferDescriptor& descriptor, bool staging);
    ~BufferImpl() override { release(); }
    void release() noexcept override;

    /// Zeroes a new buffer before the next submission.
    void zero();
    void startMappedAtCreation();
    void mapAsync(MapMode mode, std::uint64_t offset, std::uint64_t size, BufferMapCallback callback);
    void* mappedRange(std::uint64_t offset, std::uint64_t size, bool forWriting);
    void unmap();

    [[nodiscard]] bool mappable() const { return host_ != nullptr; }
    [[nodiscard]] std::byte* host() const { return host_; }

    VkBuffer vk = VK_NULL_HANDLE;
    std::uint64_t size = 0;
    BufferUsage usage = BufferUsage::None;
    BufferMapState mapState = BufferMapState::Unmapped;
    std::uint64_t lastSubmission = 0;  ///< last one that used the buffer; only for mappable buffers
    std::uint64_t lastFrame = 0;

  private:
    void createMemory(bool staging);

    Allocation allocation_;
    std::byte* host_ = nullptr;  // the whole buffer, mapped for as long as it lives
    MapMode mapMode_ = MapMode::Read;
    std::uint64_t mapOffset_ = 0;
    std::uint64_t mapSize_ = 0;
    std::uint64_t mapRequest_ = 0;
    BufferMapCallback mapCallback_;
    std::vector<std::byte> creationData_;  // contents of a buffer mapped at creation but not host-visible
};

class TextureImpl final : public Object {
  public:
    TextureImpl(DeviceImpl& device, const TextureDescriptor& descriptor);
    ~TextureImpl() override { release(); }
    void release() noexcept override;

    /// Transitions a new texture to its layout and zeroes it before the next submission.
    void zero();
    [[nodiscard]] std::uint32_t mipWidth(std::uint32_t level) const;
    [[nodiscard]] std::uint32_t mipHeight(std::uint32_t level) const;

    VkImage vk = VK_NULL_HANDLE;
    Extent3D size;
    TextureFormat format = TextureFormat::Undefined;
    TextureUsage usage = TextureUsage::None;
    std::uint32_t mipLevelCount = 1;

  private:
    Allocation allocation_;
};

class TextureViewImpl final : public Object {
  public:
    TextureViewImpl(DeviceImpl& device, TextureImpl& texture, const TextureViewDescriptor& descriptor);
    ~TextureViewImpl() override { release(); }
    void release() noexcept override;

    VkImageView vk = VK_NULL_HANDLE;
    std::shared_ptr<TextureImpl> texture;
    std::uint32_t baseMipLevel = 0;
    std::uint32_t mipLevelCount = 1;
};

class SamplerImpl final : public Object {
  public:
    SamplerImpl(DeviceImpl& device, const SamplerDescriptor& descriptor);
    ~SamplerImpl() override { release(); }
    void release() noexcept override;

    VkSampler vk = VK_NULL_HANDLE;
    bool linear = false;
};

class QuerySetImpl final : public Object {
  public:
    QuerySetImpl(DeviceImpl& device, const QuerySetDescriptor& descriptor);
    ~QuerySetImpl() override { release(); }
    void release() noexcept override;

    /// Seconds between two timestamps that have been written and completed; negative when not available.
    [[nodiscard]] double secondsBetween(std::uint32_t first, std::uint32_t second) const;

    VkQueryPool vk = VK_NULL_HANDLE;
    std::uint32_t count = 0;
};

/// Throws unless the device can give this format these usages.
void requireFormatSupport(const DeviceImpl& device, TextureFormat format, TextureUsage usage, const std::string& label);
[[nodiscard]] bool formatSupports(const DeviceImpl& device, TextureFormat format, TextureUsage usage);
[[nodiscard]] bool formatFilters(const DeviceImpl& device, TextureFormat format);

}  // namespace gpu::detail
