// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/sampler.h"

#include "gpu/detail/device_impl.h"
#include "gpu/detail/resources.h"
#include "gpu/detail/vulkan_map.h"

namespace gpu {

namespace detail {

SamplerImpl::SamplerImpl(DeviceImpl& owner, const SamplerDescriptor& descriptor)
    : Object(owner, descriptor.label),
      linear(descriptor.magFilter == FilterMode::Linear || descriptor.minFilter == FilterMode::Linear ||
             descriptor.mipmapFilter == FilterMode::Linear) {
    require(descriptor.lodMinClamp >= 0 && descriptor.lodMaxClamp >= descriptor.lodMinClamp, "Sampler ",
            quoted(label()), " clamps levels to [", descriptor.lodMinClamp, ", ", descriptor.lodMaxClamp,
            "]; a range that starts at 0 or above is expected.");
    VkSamplerCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = toVulkan(descriptor.magFilter);
    info.minFilter = toVulkan(descriptor.minFilter);
    info.mipmapMode =
        descriptor.mipmapFilter == FilterMode::Linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.addressModeU = toVulkan(descriptor.addressModeU);
    info.addressModeV = toVulkan(descriptor.addressModeV);
    info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.minLod = descriptor.lodMinClamp;
    info.maxLod = descriptor.lodMaxClamp;
    owner.check(vkCreateSampler(owner.vk(), &info, nullptr, &vk), "vkCreateSampler", label());
    owner.labels().setName(VK_OBJECT_TYPE_SAMPLER, vk, label());
}

void SamplerImpl::release() noexcept {
    if (vk == VK_NULL_HANDLE) return;
    vkDestroySampler(device().vk(), vk, nullptr);
    vk = VK_NULL_HANDLE;
}

}  // namespace detail

const std::string& Sampler::label() const {
    detail::require(impl_ != nullptr, "The sampler is an empty handle.");
    return impl_->label();
}

}  // namespace gpu
