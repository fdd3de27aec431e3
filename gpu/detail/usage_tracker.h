// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>

namespace gpu::detail {

/// How a command touches a resource.
struct Access {
    VkPipelineStageFlags stages = 0;
    VkAccessFlags access = 0;
    bool write = false;
};

inline constexpr Access kCopyRead = {VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT, false};
inline constexpr Access kCopyWrite = {VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, true};
inline constexpr Access kIndirectRead = {VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT, VK_ACCESS_INDIRECT_COMMAND_READ_BIT,
                                         false};
inline constexpr Access kVertexRead = {VK_PIPELINE_STAGE_VERTEX_INPUT_BIT, VK_ACCESS_VERTEX_ATTRIBUTE_READ_BIT, false};
inline constexpr Access kIndexRead = {VK_PIPELINE_STAGE_VERTEX_INPUT_BIT, VK_ACCESS_INDEX_READ_BIT, false};
inline constexpr Access kAttachmentWrite = {VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                                            VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                                            true};

/// Finds the memory barriers a command buffer needs between its own commands.
///
/// State is kept per buffer and per mip level, for one command buffer. Earlier work (other submissions, frames of an
/// adopted device, in whatever order they were recorded) is covered by the full barrier at the start of every command
/// buffer, so no state outlives the recording. All images stay in VK_IMAGE_LAYOUT_GENERAL, which leaves no
/// layout to track and lets plain memory barriers do.
class UsageTracker {
  public:
    /// Notes that the next command touches a resource, and which earlier uses it must wait for.
    void use(const void* resource, std::uint32_t subresource, const Access& access) {
        State& state = states_[Key{resource, subresource}];
        if (access.write) {
            if ((state.readStages | state.write.stages) != 0) {
                wait(state.readStages | state.write.stages, state.write.access, access);
            }
            state = State{.write = access, .visibleStages = 0, .visibleAccess = 0, .readStages = 0};
            return;
        }
        const bool visible = (access.stages & ~state.visibleStages) == 0 && (access.access & ~state.visibleAccess) == 0;
        if (state.write.stages != 0 && !visible) {
            // Widening only one of the two would claim combinations that no barrier has covered.
            Access wanted = access;
            wanted.stages |= state.visibleStages;
            wanted.access |= state.visibleAccess;
            wait(state.write.stages, state.write.access, wanted);
            state.visibleStages = wanted.stages;
            state.visibleAccess = wanted.access;
        }
        state.readStages |= access.stages;
    }

    /// Records the barrier the noted uses need, if any; call right before the command.
    void flush(VkCommandBuffer commandBuffer) {
        if (sourceStages_ == 0) return;
        const VkMemoryBarrier barrier = {VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, sourceAccess_, destinationAccess_};
        vkCmdPipelineBarrier(commandBuffer, sourceStages_, destinationStages_, 0, 1, &barrier, 0, nullptr, 0, nullptr);
        sourceStages_ = destinationStages_ = 0;
        sourceAccess_ = destinationAccess_ = 0;
    }

  private:
    struct Key {
        const void* resource;
        std::uint32_t subresource;
        bool operator==(const Key&) const = default;
    };
    struct KeyHash {
        std::size_t operator()(const Key& key) const {
            return std::hash<const void*>()(key.resource) ^ (std::size_t{key.subresource} * 0x9e3779b97f4a7c15u);
        }
    };
    struct State {
        Access write = {};                       ///< last write, if stages is not 0
        VkPipelineStageFlags visibleStages = 0;  ///< stages that have waited for `write`
        VkAccessFlags visibleAccess = 0;
        VkPipelineStageFlags readStages = 0;  ///< stages of reads since `write`
    };

    void wait(VkPipelineStageFlags stages, VkAccessFlags writes, const Access& next) {
        constexpr VkAccessFlags kWrites =
            VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
        sourceStages_ |= stages;
        sourceAccess_ |= writes & kWrites;
        destinationStages_ |= next.stages;
        destinationAccess_ |= next.access;
    }

    std::unordered_map<Key, State, KeyHash> states_;
    VkPipelineStageFlags sourceStages_ = 0;
    VkPipelineStageFlags destinationStages_ = 0;
    VkAccessFlags sourceAccess_ = 0;
    VkAccessFlags destinationAccess_ = 0;
};

}  // namespace gpu::detail
