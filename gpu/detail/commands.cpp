// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/detail/commands.h"

#include <algorithm>
#include <cstring>

#include "gpu/detail/device_impl.h"
#include "gpu/detail/vulkan_map.h"

namespace gpu::detail {

void UsageScope::requireNoConflict(const std::string& where) const {
    for (std::size_t i = 0; i < uses_.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const ResourceUse& a = uses_[i];
            const ResourceUse& b = uses_[j];
            if (a.buffer != b.buffer || a.texture != b.texture || a.mipLevel != b.mipLevel) continue;
            require(a.access.write == b.access.write, a.buffer != nullptr ? "Buffer " : "Texture ",
                    quoted(a.buffer != nullptr ? a.buffer->label() : a.texture->label()), " is read and written by ",
                    where, ", through group ", b.group, " binding ", b.binding, " and group ", a.group, " binding ",
                    a.binding, "; use two resources or two mip levels.");
        }
    }
}

void UsageScope::record(CommandBufferImpl& commands) const {
    for (const ResourceUse& use : uses_) {
        if (use.buffer != nullptr) {
            commands.use(*use.buffer, use.access);
        } else {
            commands.use(*use.texture, use.mipLevel, use.access);
        }
    }
    commands.barrier();
}

void BindingState::setPipelineLayout(std::shared_ptr<PipelineLayoutImpl> layout) { layout_ = std::move(layout); }

void BindingState::setBindGroup(std::uint32_t index, const BindGroup& handle,
                                std::span<const std::uint32_t> dynamicOffsets, CommandBufferImpl& commands) {
    BindGroupImpl& group = resolve(handle, device_, "bind group");
    require(index < device_.limits().maxBindGroups, "Bind group ", quoted(group.label()), " is set at index ", index,
            "; this device allows ", device_.limits().maxBindGroups, " groups.");
    require(dynamicOffsets.size() == group.layout->dynamicCount, "Bind group ", quoted(group.label()), " is set with ",
            dynamicOffsets.size(), " dynamic offsets; its layout has ", group.layout->dynamicCount, ".");
    std::size_t next = 0;
    for (const BindGroupImpl::Bound& bound : group.bound) {
        if (!bound.entry.hasDynamicOffset) continue;
        const std::uint32_t offset = dynamicOffsets[next++];
        const std::uint32_t alignment = bound.entry.type == BindingType::UniformBuffer
                                            ? device_.limits().minUniformBufferOffsetAlignment
                                            : device_.limits().minStorageBufferOffsetAlignment;
        require(offset % alignment == 0, "Dynamic offset ", offset, " of bind group ", quoted(group.label()),
                " binding ", bound.entry.binding, " is not a multiple of ", alignment, ".");
        require(bound.offset + offset + bound.size <= bound.buffer->size, "Dynamic offset ", offset, " of bind group ",
                quoted(group.label()), " binding ", bound.entry.binding, " goes past the ", bound.buffer->size,
                " bytes of buffer ", quoted(bound.buffer->label()), ".");
    }
    if (slots_.size() <= index) slots_.resize(index + 1);
    slots_[index] = {internalReference(group), {dynamicOffsets.begin(), dynamicOffsets.end()}};
    commands.keep(group);
}

void BindingState::setImmediates(std::uint32_t rangeOffset, const void* data, std::size_t size,
                                 const std::string& pass) {
    require(rangeOffset % 4 == 0 && size % 4 == 0, "Pass ", quoted(pass), " sets ", size,
            " bytes of immediates at byte ", rangeOffset, "; both must be multiples of 4.");
    require(size <= kMaxImmediateSize && rangeOffset <= kMaxImmediateSize - size, "Pass ", quoted(pass), " sets ", size,
            " bytes of immediates at byte ", rangeOffset, "; ", kMaxImmediateSize, " bytes are allowed in all.");
    if (size == 0) return;
    std::memcpy(immediates_.data() + rangeOffset, data, size);
    for (std::size_t word = rangeOffset / 4; word < (rangeOffset + size) / 4; ++word) immediatesSet_.set(word);
}

void BindingState::requireComplete(const std::string& pipeline) const {
    for (std::uint32_t i = 0; i < layout_->groups.size(); ++i) {
        const BindGroupLayoutImpl& wanted = *layout_->groups[i];
        if (wanted.entries.empty()) continue;
        require(i < slots_.size() && slots_[i].group != nullptr, "Pipeline ", quoted(pipeline),
                " needs a bind group at ", i, "; none is set.");
        const BindGroupImpl& given = *slots_[i].group;
        require(given.bound.size() == wanted.entries.size(), "Bind group ", quoted(given.label()), " has ",
                given.bound.size(), " entries; pipeline ", quoted(pipeline), " expects ", wanted.entries.size(),
                " in group ", i, ".");
        for (std::size_t j = 0; j < wanted.entries.size(); ++j) {
            const BindGroupLayoutEntry& want = wanted.entries[j];
            const BindGroupLayoutEntry& have = given.bound[j].entry;
            require(want.binding == have.binding && want.visibility == have.visibility &&
                        toVulkan(want.type, want.hasDynamicOffset) == toVulkan(have.type, have.hasDynamicOffset),
                    "Bind group ", quoted(given.label()), " does not fit pipeline ", quoted(pipeline), ": group ", i,
                    " binding ", want.binding, " is expected to be a ", toString(want.type), "; the group has a ",
                    toString(have.type), " at binding ", have.binding,
                    have.visibility == want.visibility ? "." : " for other shader stages.");
            require(given.bound[j].buffer == nullptr || given.bound[j].size >= want.minBindingSize, "Bind group ",
                    quoted(given.label()), " binding ", want.binding, " has ", given.bound[j].size, " bytes; pipeline ",
                    quoted(pipeline), " needs ", want.minBindingSize, ".");
        }
    }
    for (std::uint32_t byte = 0; byte < layout_->immediateSize; byte += 4) {
        require(immediatesSet_.test(byte / 4), "Pipeline ", quoted(pipeline), " needs ", layout_->immediateSize,
                " bytes of immediates; byte ", byte, " is not set.");
    }
}

void BindingState::collectUses(UsageScope& scope) const {
    for (std::uint32_t i = 0; i < layout_->groups.size(); ++i) {
        const BindGroupLayoutImpl& wanted = *layout_->groups[i];
        for (std::size_t j = 0; j < wanted.entries.size(); ++j) {
            const BindGroupLayoutEntry& entry = wanted.entries[j];
            const BindGroupImpl::Bound& bound = slots_[i].group->bound[j];
            ResourceUse use;
            use.group = i;
            use.binding = entry.binding;
            use.access.stages = pipelineStages(entry.visibility);
            use.access.write = isWritable(entry.type);
            use.access.access = entry.type == BindingType::UniformBuffer ? VK_ACCESS_UNIFORM_READ_BIT
                                : use.access.write ? VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT
                                                   : VK_ACCESS_SHADER_READ_BIT;
            if (bound.buffer) {
                use.buffer = bound.buffer.get();
                scope.add(use);
            }
            if (!bound.view) continue;
            use.texture = bound.view->texture.get();
            for (std::uint32_t level = 0; level < bound.view->mipLevelCount; ++level) {
                use.mipLevel = bound.view->baseMipLevel + level;
                scope.add(use);
            }
        }
    }
}

BindingState::Snapshot BindingState::snapshot() const {
    Snapshot result;
    result.layout = layout_->vk;
    for (std::uint32_t i = 0; i < layout_->groups.size(); ++i) {
        if (layout_->groups[i]->entries.empty()) continue;
        result.sets.push_back(
            {i, static_cast<std::uint32_t>(slots_[i].dynamicOffsets.size()), slots_[i].group->set.set});
        result.dynamicOffsets.insert(result.dynamicOffsets.end(), slots_[i].dynamicOffsets.begin(),
                                     slots_[i].dynamicOffsets.end());
    }
    result.immediates.assign(immediates_.begin(), immediates_.begin() + layout_->immediateSize);
    return result;
}

void BindingState::Snapshot::record(VkCommandBuffer commandBuffer, VkPipelineBindPoint bindPoint) const {
    const std::uint32_t* offsets = dynamicOffsets.data();
    for (const Set& set : sets) {
        vkCmdBindDescriptorSets(commandBuffer, bindPoint, layout, set.index, 1, &set.vk, set.dynamicCount, offsets);
        offsets += set.dynamicCount;
    }
    if (!immediates.empty()) {
        vkCmdPushConstants(commandBuffer, layout, kImmediateStages, 0, static_cast<std::uint32_t>(immediates.size()),
                           immediates.data());
    }
}

}  // namespace gpu::detail
