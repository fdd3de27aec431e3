// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/bind_group.h"

#include <algorithm>
#include <deque>

#include "gpu/detail/bindings.h"
#include "gpu/detail/device_impl.h"
#include "gpu/detail/vulkan_map.h"

namespace gpu {

namespace detail {

BindGroupLayoutImpl::BindGroupLayoutImpl(DeviceImpl& owner, const BindGroupLayoutDescriptor& descriptor)
    : Object(owner, descriptor.label), entries(descriptor.entries) {
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.binding < b.binding; });
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const BindGroupLayoutEntry& entry = entries[i];
        require(i == 0 || entry.binding != entries[i - 1].binding, "Bind group layout ", quoted(label()),
                " has binding ", entry.binding, " twice.");
        require(entry.visibility != ShaderStage::None, "Bind group layout ", quoted(label()), " binding ",
                entry.binding, " is visible to no shader stage.");
        require(isBuffer(entry.type) || !entry.hasDynamicOffset, "Bind group layout ", quoted(label()), " binding ",
                entry.binding, " is a ", toString(entry.type), "; only buffers have dynamic offsets.");
        require(!isWritable(entry.type) || entry.visibility == ShaderStage::Compute, "Bind group layout ",
                quoted(label()), " binding ", entry.binding, " is a ", toString(entry.type),
                " that a vertex or fragment shader may write; without optional features only compute shaders may (is "
                "`readonly` missing?).");
        if (entry.hasDynamicOffset) ++dynamicCount;
        VkDescriptorSetLayoutBinding binding = {};
        binding.binding = entry.binding;
        binding.descriptorType = toVulkan(entry.type, entry.hasDynamicOffset);
        binding.descriptorCount = 1;
        binding.stageFlags = toVulkan(entry.visibility);
        bindings.push_back(binding);
    }
    VkDescriptorSetLayoutCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    info.bindingCount = static_cast<std::uint32_t>(bindings.size());
    info.pBindings = bindings.data();
    VkDescriptorSetLayoutSupport support = {};
    support.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_SUPPORT;
    vkGetDescriptorSetLayoutSupport(owner.vk(), &info, &support);
    require(support.supported == VK_TRUE, "Bind group layout ", quoted(label()), " has ", entries.size(),
            " entries, more than this device allows.");
    owner.check(vkCreateDescriptorSetLayout(owner.vk(), &info, nullptr, &vk), "vkCreateDescriptorSetLayout", label());
    owner.labels().setName(VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, vk, label());
}

void BindGroupLayoutImpl::release() noexcept {
    if (vk == VK_NULL_HANDLE) return;
    vkDestroyDescriptorSetLayout(device().vk(), vk, nullptr);
    vk = VK_NULL_HANDLE;
}

const BindGroupLayoutEntry* BindGroupLayoutImpl::find(std::uint32_t binding) const {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const BindGroupLayoutEntry& entry) { return entry.binding == binding; });
    return found == entries.end() ? nullptr : &*found;
}

BindGroupImpl::BindGroupImpl(DeviceImpl& owner, const BindGroupDescriptor& descriptor)
    : Object(owner, descriptor.label),
      layout(internalReference(resolve(descriptor.layout, owner, "bind group layout"))) {
    for (const BindGroupLayoutEntry& entry : layout->entries) {
        bound.push_back({.entry = entry, .buffer = {}, .offset = 0, .size = 0, .view = {}, .sampler = {}});
    }
    std::vector<bool> given(bound.size(), false);
    for (const BindGroupEntry& entry : descriptor.entries) {
        const auto place =
            std::find_if(bound.begin(), bound.end(), [&](const Bound& b) { return b.entry.binding == entry.binding; });
        require(place != bound.end(), "Bind group ", quoted(label()), " gives binding ", entry.binding,
                ", which layout ", quoted(layout->label()),
                " does not have (a shader's unused bindings are not in its layout).");
        const auto index = static_cast<std::size_t>(place - bound.begin());
        require(!given[index], "Bind group ", quoted(label()), " gives binding ", entry.binding, " twice.");
        given[index] = true;
        const BindingType type = place->entry.type;
        const bool wantsView = isSampled(type) || isStorageTexture(type);
        const bool wantsSampler = type == BindingType::Sampler || type == BindingType::CombinedTextureSampler;
        require(static_cast<bool>(entry.buffer) == isBuffer(type) &&
                    static_cast<bool>(entry.textureView) == wantsView &&
                    static_cast<bool>(entry.sampler) == wantsSampler,
                "Bind group ", quoted(label()), " binding ", entry.binding, " is a ", toString(type), " in layout ",
                quoted(layout->label()), "; given are ", entry.buffer ? "a buffer" : "no buffer", ", ",
                entry.textureView ? "a texture view" : "no texture view", ", ",
                entry.sampler ? "a sampler" : "no sampler", ".");
        if (entry.buffer) checkBuffer(entry, *place);
        if (entry.sampler) place->sampler = internalReference(resolve(entry.sampler, owner, "sampler"));
        if (entry.textureView) checkTexture(entry, *place);
    }
    for (std::size_t i = 0; i < bound.size(); ++i) {
        require(given[i], "Bind group ", quoted(label()), " does not give binding ", bound[i].entry.binding, " (a ",
                toString(bound[i].entry.type), ") of layout ", quoted(layout->label()), ".");
    }
    set = owner.descriptorPools().allocate(layout->vk, label());
    owner.labels().setName(VK_OBJECT_TYPE_DESCRIPTOR_SET, set.set, label());
    write();
}

void BindGroupImpl::checkBuffer(const BindGroupEntry& entry, Bound& place) {
    BufferImpl& buffer = resolve(entry.buffer, device(), "buffer");
    const bool uniform = place.entry.type == BindingType::UniformBuffer;
    const BufferUsage usage = uniform ? BufferUsage::Uniform : BufferUsage::Storage;
    const Limits& limits = device().limits();
    const std::string where =
        text("Bind group ", quoted(label()), " binding ", entry.binding, ", buffer ", quoted(buffer.label()));
    require(has(buffer.usage, usage), where, ": the buffer has usage ", toString(buffer.usage), "; ", toString(usage),
            " is needed.");
    const std::uint32_t alignment =
        uniform ? limits.minUniformBufferOffsetAlignment : limits.minStorageBufferOffsetAlignment;
    require(entry.offset % alignment == 0, where, ": offset ", entry.offset, " is not a multiple of ", alignment, ".");
    require(entry.offset < buffer.size, where, ": offset ", entry.offset, " is behind the buffer's ", buffer.size,
            " bytes.");
    const std::uint64_t size = entry.size == kWholeSize ? buffer.size - entry.offset : entry.size;
    require(size > 0 && size <= buffer.size - entry.offset, where, ": ", size, " bytes at byte ", entry.offset,
            " do not fit its ", buffer.size, " bytes.");
    require(size >= place.entry.minBindingSize, where, ": ", size, " bytes are bound; the shader's block needs ",
            place.entry.minBindingSize, ".");
    const std::uint64_t limit = uniform ? limits.maxUniformBufferBindingSize : limits.maxStorageBufferBindingSize;
    require(size <= limit, where, ": ", size, " bytes are bound; this device allows ", limit, " for a ",
            toString(place.entry.type), ".");
    place.buffer = internalReference(buffer);
    place.offset = entry.offset;
    place.size = size;
}

void BindGroupImpl::checkTexture(const BindGroupEntry& entry, Bound& place) {
    TextureViewImpl& view = resolve(entry.textureView, device(), "texture view");
    const TextureImpl& texture = *view.texture;
    const bool storage = isStorageTexture(place.entry.type);
    const TextureUsage usage = storage ? TextureUsage::StorageBinding : TextureUsage::TextureBinding;
    const std::string where =
        text("Bind group ", quoted(label()), " binding ", entry.binding, ", texture ", quoted(texture.label()));
    require(has(texture.usage, usage), where, ": the texture has usage ", toString(texture.usage), "; ",
            toString(usage), " is needed.");
    if (storage) {
        require(view.mipLevelCount == 1, where, ": the view has ", view.mipLevelCount,
                " levels; a storage texture has 1.");
        require(place.entry.storageFormat == TextureFormat::Undefined || place.entry.storageFormat == texture.format,
                where, ": the format is ", toString(texture.format), "; the shader expects ",
                toString(place.entry.storageFormat), ".");
    } else {
        const TextureSampleType given = sampleTypeOf(texture.format);
        require(place.entry.sampleType == TextureSampleType::Any || place.entry.sampleType == given, where, ": format ",
                toString(texture.format), " holds ", given == TextureSampleType::Uint ? "integers" : "floats",
                "; the shader's texture type expects something else.");
        require(!place.sampler || !place.sampler->linear || formatFilters(device(), texture.format), where,
                ": this device does not filter format ", toString(texture.format), " linearly.");
    }
    place.view = internalReference(view);
}

void BindGroupImpl::write() {
    std::deque<VkDescriptorBufferInfo> buffers;
    std::deque<VkDescriptorImageInfo> images;
    std::vector<VkWriteDescriptorSet> writes;
    for (const Bound& place : bound) {
        VkWriteDescriptorSet write = {};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = set.set;
        write.dstBinding = place.entry.binding;
        write.descriptorCount = 1;
        write.descriptorType = toVulkan(place.entry.type, place.entry.hasDynamicOffset);
        if (place.buffer) {
            buffers.push_back({place.buffer->vk, place.offset, place.size});
            write.pBufferInfo = &buffers.back();
        } else {
            images.push_back({place.sampler ? place.sampler->vk : VK_NULL_HANDLE,
                              place.view ? place.view->vk : VK_NULL_HANDLE, VK_IMAGE_LAYOUT_GENERAL});
            write.pImageInfo = &images.back();
        }
        writes.push_back(write);
    }
    vkUpdateDescriptorSets(device().vk(), static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
}

void BindGroupImpl::release() noexcept {
    if (set.set == VK_NULL_HANDLE) return;
    vkFreeDescriptorSets(device().vk(), set.pool, 1, &set.set);
    set = {};
}

PipelineLayoutImpl::PipelineLayoutImpl(DeviceImpl& owner, std::string name,
                                       std::vector<std::shared_ptr<BindGroupLayoutImpl>> bindGroupLayouts,
                                       std::uint32_t immediateBytes)
    : Object(owner, std::move(name)), groups(std::move(bindGroupLayouts)), immediateSize(immediateBytes) {
    require(groups.size() <= owner.limits().maxBindGroups, "Pipeline layout ", quoted(label()), " has ", groups.size(),
            " bind groups; this device allows ", owner.limits().maxBindGroups, ".");
    require(immediateSize <= kMaxImmediateSize && immediateSize % 4 == 0, "Pipeline layout ", quoted(label()), " has ",
            immediateSize, " bytes of immediates; a multiple of 4 up to ", kMaxImmediateSize, " is expected.");
    std::vector<VkDescriptorSetLayout> setLayouts;
    for (const auto& group : groups) setLayouts.push_back(group->vk);
    const VkPushConstantRange range = {kImmediateStages, 0, immediateSize};
    VkPipelineLayoutCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = static_cast<std::uint32_t>(setLayouts.size());
    info.pSetLayouts = setLayouts.data();
    info.pushConstantRangeCount = immediateSize > 0 ? 1 : 0;
    info.pPushConstantRanges = &range;
    owner.check(vkCreatePipelineLayout(owner.vk(), &info, nullptr, &vk), "vkCreatePipelineLayout", label());
    owner.labels().setName(VK_OBJECT_TYPE_PIPELINE_LAYOUT, vk, label());
}

void PipelineLayoutImpl::release() noexcept {
    if (vk == VK_NULL_HANDLE) return;
    vkDestroyPipelineLayout(device().vk(), vk, nullptr);
    vk = VK_NULL_HANDLE;
}

}  // namespace detail

const std::string& BindGroupLayout::label() const {
    detail::require(impl_ != nullptr, "The bind group layout is an empty handle.");
    return impl_->label();
}

const std::vector<BindGroupLayoutEntry>& BindGroupLayout::entries() const {
    detail::require(impl_ != nullptr, "The bind group layout is an empty handle.");
    return impl_->entries;
}

const std::string& BindGroup::label() const {
    detail::require(impl_ != nullptr, "The bind group is an empty handle.");
    return impl_->label();
}

const std::string& PipelineLayout::label() const {
    detail::require(impl_ != nullptr, "The pipeline layout is an empty handle.");
    return impl_->label();
}

}  // namespace gpu
