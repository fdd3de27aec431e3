// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/shader_module.h"

#include <algorithm>

#include "gpu/detail/bindings.h"
#include "gpu/detail/device_impl.h"

namespace gpu {

namespace detail {

namespace {

/// SPIR-V capabilities that every Vulkan 1.1 device has without optional features (SPIR-V specification 3.31;
/// Vulkan specification, appendix "SPIR-V environment").
bool capabilityIsCore(std::uint32_t capability) {
    constexpr std::uint32_t kCore[] = {
        0,     // Matrix
        1,     // Shader
        40,    // InputAttachment
        43,    // Sampled1D
        44,    // Image1D
        46,    // SampledBuffer
        47,    // ImageBuffer
        50,    // ImageQuery
        51,    // DerivativeControl
        4437,  // DeviceGroup
    };
    return std::find(std::begin(kCore), std::end(kCore), capability) != std::end(kCore);
}

/// Subgroup capabilities depend on what the device offers in compute shaders.
bool subgroupSupports(const DeviceImpl& device, std::uint32_t capability) {
    struct Pair {
        std::uint32_t capability;
        VkSubgroupFeatureFlags feature;
    };
    constexpr Pair kPairs[] = {{61, VK_SUBGROUP_FEATURE_BASIC_BIT},      {62, VK_SUBGROUP_FEATURE_VOTE_BIT},
                               {63, VK_SUBGROUP_FEATURE_ARITHMETIC_BIT}, {64, VK_SUBGROUP_FEATURE_BALLOT_BIT},
                               {65, VK_SUBGROUP_FEATURE_SHUFFLE_BIT},    {66, VK_SUBGROUP_FEATURE_SHUFFLE_RELATIVE_BIT},
                               {67, VK_SUBGROUP_FEATURE_CLUSTERED_BIT},  {68, VK_SUBGROUP_FEATURE_QUAD_BIT}};
    const auto pair =
        std::find_if(std::begin(kPairs), std::end(kPairs), [&](const Pair& p) { return p.capability == capability; });
    if (pair == std::end(kPairs)) return false;
    VkPhysicalDeviceSubgroupProperties subgroup = {};
    subgroup.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
    VkPhysicalDeviceProperties2 properties = {};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &subgroup;
    vkGetPhysicalDeviceProperties2(device.physicalDevice(), &properties);
    return (subgroup.supportedOperations & pair->feature) != 0;
}

}  // namespace

ShaderModuleImpl::ShaderModuleImpl(DeviceImpl& owner, const ShaderModuleDescriptor& descriptor)
    : Object(owner, descriptor.label), reflection(reflectSpirv(descriptor.code, descriptor.label)) {
    for (const std::uint32_t capability : reflection.capabilities) {
        require(capabilityIsCore(capability) || subgroupSupports(owner, capability), "Shader module ", quoted(label()),
                " needs SPIR-V capability ", capability,
                ", which belongs to an optional feature; only what every Vulkan 1.1 device has is enabled.");
    }
    require(reflection.immediateSize <= kMaxImmediateSize, "Shader module ", quoted(label()), " declares ",
            reflection.immediateSize, " bytes of immediates; ", kMaxImmediateSize, " are allowed.");
    VkShaderModuleCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = descriptor.code.size_bytes();
    info.pCode = descriptor.code.data();
    owner.check(vkCreateShaderModule(owner.vk(), &info, nullptr, &vk), "vkCreateShaderModule", label());
    owner.labels().setName(VK_OBJECT_TYPE_SHADER_MODULE, vk, label());
}

void ShaderModuleImpl::release() noexcept {
    if (vk == VK_NULL_HANDLE) return;
    vkDestroyShaderModule(device().vk(), vk, nullptr);
    vk = VK_NULL_HANDLE;
}

}  // namespace detail

namespace {

detail::ShaderModuleImpl& moduleOf(const std::shared_ptr<detail::ShaderModuleImpl>& impl) {
    detail::require(impl != nullptr, "The shader module is an empty handle.");
    return *impl;
}

}  // namespace

const std::string& ShaderModule::label() const { return moduleOf(impl_).label(); }
ShaderStage ShaderModule::stage() const { return moduleOf(impl_).reflection.stage; }
std::array<std::uint32_t, 3> ShaderModule::workgroupSize() const { return moduleOf(impl_).reflection.workgroupSize; }
std::uint32_t ShaderModule::immediateSize() const { return moduleOf(impl_).reflection.immediateSize; }

BlockLayout ShaderModule::blockLayout(std::string_view structName) const {
    const detail::ShaderModuleImpl& module = moduleOf(impl_);
    const BlockLayout* found = nullptr;
    std::string names;
    for (const BlockLayout& block : module.reflection.structs) {
        names += (names.empty() ? "" : ", ") + block.name;
        if (block.name != structName) continue;
        detail::require(found == nullptr || found->members == block.members, "Struct ", structName,
                        " has two different layouts in shader module ", detail::quoted(module.label()), ".");
        found = &block;
    }
    detail::require(found != nullptr, "Shader module ", detail::quoted(module.label()), " has no struct ", structName,
                    " with a layout; it has: ", names, ".");
    return *found;
}

}  // namespace gpu
