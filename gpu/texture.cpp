// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/texture.h"

#include <algorithm>

#include "gpu/detail/command_buffer.h"
#include "gpu/detail/device_impl.h"
#include "gpu/detail/resources.h"
#include "gpu/detail/vulkan_map.h"

namespace gpu {

namespace detail {

namespace {

VkFormatFeatureFlags featuresOf(const DeviceImpl& device, TextureFormat format) {
    VkFormatProperties properties;
    vkGetPhysicalDeviceFormatProperties(device.physicalDevice(), toVulkan(format), &properties);
    return properties.optimalTilingFeatures;
}

VkFormatFeatureFlags featuresFor(TextureUsage usage) {
    VkFormatFeatureFlags features = VK_FORMAT_FEATURE_TRANSFER_DST_BIT;
    if (has(usage, TextureUsage::CopySrc)) features |= VK_FORMAT_FEATURE_TRANSFER_SRC_BIT;
    if (has(usage, TextureUsage::TextureBinding)) features |= VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
    if (has(usage, TextureUsage::StorageBinding)) features |= VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT;
    if (has(usage, TextureUsage::RenderAttachment)) features |= VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT;
    return features;
}

}  // namespace

bool formatSupports(const DeviceImpl& device, TextureFormat format, TextureUsage usage) {
    const VkFormatFeatureFlags needed = featuresFor(usage);
    return format != TextureFormat::Undefined && (featuresOf(device, format) & needed) == needed;
}

bool formatFilters(const DeviceImpl& device, TextureFormat format) {
    return (featuresOf(device, format) & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT) != 0;
}

void requireFormatSupport(const DeviceImpl& device, TextureFormat format, TextureUsage usage,
                          const std::string& label) {
    require(formatSupports(device, format, usage), "Texture ", quoted(label), " of format ", toString(format),
            " cannot have usage ", toString(usage), " on this device.");
}

TextureImpl::TextureImpl(DeviceImpl& owner, const TextureDescriptor& descriptor)
    : Object(owner, descriptor.label),
      size(descriptor.size),
      format(descriptor.format),
      usage(descriptor.usage),
      mipLevelCount(descriptor.mipLevelCount) {
    const std::uint32_t limit = owner.limits().maxTextureDimension2D;
    require(format != TextureFormat::Undefined, "Texture ", quoted(label()), " has no format.");
    require(usage != TextureUsage::None, "Texture ", quoted(label()), " has no usage.");
    require(size.width > 0 && size.height > 0 && size.depthOrArrayLayers == 1, "Texture ", quoted(label()), " is ",
            size.width, "x", size.height, "x", size.depthOrArrayLayers, "; a two-dimensional size is expected.");
    require(size.width <= limit && size.height <= limit, "Texture ", quoted(label()), " is ", size.width, "x",
            size.height, "; this device allows ", limit, "x", limit, ".");
    const std::uint32_t levels = fullMipLevelCount(size.width, size.height);
    require(mipLevelCount >= 1 && mipLevelCount <= levels, "Texture ", quoted(label()), " has ", mipLevelCount,
            " levels; ", size.width, "x", size.height, " texels have 1 to ", levels, ".");
    requireFormatSupport(owner, format, usage, label());
    VkImageCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = toVulkan(format);
    info.extent = {size.width, size.height, 1};
    info.mipLevels = mipLevelCount;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = toVulkan(usage);
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    info.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    try {
        owner.check(vkCreateImage(owner.vk(), &info, nullptr, &vk), "vkCreateImage", label());
        owner.labels().setName(VK_OBJECT_TYPE_IMAGE, vk, label());
        VkMemoryRequirements requirements;
        vkGetImageMemoryRequirements(owner.vk(), vk, &requirements);
        require(requirements.size <= owner.limits().maxBufferSize, "Texture ", quoted(label()), " (", size.width, "x",
                size.height, ", ", toString(format), ") needs ", requirements.size, " bytes; this device allows ",
                owner.limits().maxBufferSize, ".");
        allocation_ = owner.memory().allocate(
            requirements, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, true,
            text("texture ", quoted(label()), " (", size.width, "x", size.height, ", ", toString(format), ")"));
        owner.check(vkBindImageMemory(owner.vk(), vk, allocation_.memory, 0), "vkBindImageMemory", label());
    } catch (...) {
        release();
        throw;
    }
}

void TextureImpl::zero() {
    CommandBufferImpl& writes = device().inFlight().pendingWrites();
    VkImageMemoryBarrier barrier = {};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = vk;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, mipLevelCount, 0, 1};
    vkCmdPipelineBarrier(writes.vk, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0,
                         nullptr, 1, &barrier);
    for (std::uint32_t level = 0; level < mipLevelCount; ++level) writes.use(*this, level, kCopyWrite);
    const VkClearColorValue zero = {};
    vkCmdClearColorImage(writes.vk, vk, VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &barrier.subresourceRange);
}

void TextureImpl::release() noexcept {
    if (vk == VK_NULL_HANDLE) return;
    vkDestroyImage(device().vk(), vk, nullptr);
    vk = VK_NULL_HANDLE;
    device().memory().free(allocation_);
}

std::uint32_t TextureImpl::mipWidth(std::uint32_t level) const { return std::max(1u, size.width >> level); }
std::uint32_t TextureImpl::mipHeight(std::uint32_t level) const { return std::max(1u, size.height >> level); }

TextureViewImpl::TextureViewImpl(DeviceImpl& owner, TextureImpl& viewed, const TextureViewDescriptor& descriptor)
    : Object(owner, descriptor.label.empty() ? viewed.label() : descriptor.label),
      texture(internalReference(viewed)),
      baseMipLevel(descriptor.baseMipLevel),
      mipLevelCount(descriptor.mipLevelCount) {
    require(baseMipLevel < viewed.mipLevelCount, "A view of texture ", quoted(viewed.label()), " starts at level ",
            baseMipLevel, "; it has ", viewed.mipLevelCount, ".");
    if (mipLevelCount == kAllMipLevels) mipLevelCount = viewed.mipLevelCount - baseMipLevel;
    require(mipLevelCount > 0 && mipLevelCount <= viewed.mipLevelCount - baseMipLevel, "A view of texture ",
            quoted(viewed.label()), " has ", mipLevelCount, " levels from level ", baseMipLevel, "; the texture has ",
            viewed.mipLevelCount, ".");
    constexpr TextureUsage kViewable =
        TextureUsage::TextureBinding | TextureUsage::StorageBinding | TextureUsage::RenderAttachment;
    require((viewed.usage & kViewable) != TextureUsage::None, "Texture ", quoted(viewed.label()), " has usage ",
            toString(viewed.usage), "; a view needs one of ", toString(kViewable), ".");
    VkImageViewCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    info.image = viewed.vk;
    info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    info.format = toVulkan(viewed.format);
    info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, baseMipLevel, mipLevelCount, 0, 1};
    owner.check(vkCreateImageView(owner.vk(), &info, nullptr, &vk), "vkCreateImageView", label());
    owner.labels().setName(VK_OBJECT_TYPE_IMAGE_VIEW, vk, label());
}

void TextureViewImpl::release() noexcept {
    if (vk == VK_NULL_HANDLE) return;
    vkDestroyImageView(device().vk(), vk, nullptr);
    vk = VK_NULL_HANDLE;
}

}  // namespace detail

namespace {

detail::TextureImpl& textureOf(const std::shared_ptr<detail::TextureImpl>& impl) {
    detail::require(impl != nullptr, "The texture is an empty handle.");
    return *impl;
}

detail::TextureViewImpl& viewOf(const std::shared_ptr<detail::TextureViewImpl>& impl) {
    detail::require(impl != nullptr, "The texture view is an empty handle.");
    return *impl;
}

}  // namespace

std::uint32_t Texture::width() const { return textureOf(impl_).size.width; }
std::uint32_t Texture::height() const { return textureOf(impl_).size.height; }
std::uint32_t Texture::mipLevelCount() const { return textureOf(impl_).mipLevelCount; }
TextureFormat Texture::format() const { return textureOf(impl_).format; }
TextureUsage Texture::usage() const { return textureOf(impl_).usage; }
const std::string& Texture::label() const { return textureOf(impl_).label(); }

TextureView Texture::createView(const TextureViewDescriptor& descriptor) const {
    detail::TextureImpl& texture = textureOf(impl_);
    detail::DeviceImpl& device = texture.device();
    return device.guarded([&] {
        return TextureView(detail::makeHandle(device.shared_from_this(),
                                              std::make_shared<detail::TextureViewImpl>(device, texture, descriptor)));
    });
}

std::uint32_t TextureView::baseMipLevel() const { return viewOf(impl_).baseMipLevel; }
std::uint32_t TextureView::mipLevelCount() const { return viewOf(impl_).mipLevelCount; }
std::uint32_t TextureView::width() const { return viewOf(impl_).texture->mipWidth(impl_->baseMipLevel); }
std::uint32_t TextureView::height() const { return viewOf(impl_).texture->mipHeight(impl_->baseMipLevel); }
TextureFormat TextureView::format() const { return viewOf(impl_).texture->format; }

}  // namespace gpu
