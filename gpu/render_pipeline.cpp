// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "gpu/adopt.h"
#include "gpu/detail/bindings.h"
#include "gpu/detail/device_impl.h"
#include "gpu/detail/vulkan_map.h"

namespace gpu::detail {

VkRenderPass createRenderPass(DeviceImpl& device, const std::vector<TextureFormat>& formats,
                              const std::vector<RenderPassColorAttachment>* attachments, const std::string& label) {
    std::vector<VkAttachmentDescription> descriptions;
    std::vector<VkAttachmentReference> references;
    for (std::size_t i = 0; i < formats.size(); ++i) {
        VkAttachmentDescription description = {};
        description.format = toVulkan(formats[i]);
        description.samples = VK_SAMPLE_COUNT_1_BIT;
        const bool load = attachments == nullptr || (*attachments)[i].loadOp == LoadOp::Load;
        const bool store = attachments == nullptr || (*attachments)[i].storeOp == StoreOp::Store;
        description.loadOp = load ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR;
        description.storeOp = store ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE;
        description.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
        description.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
        description.initialLayout = VK_IMAGE_LAYOUT_GENERAL;
        description.finalLayout = VK_IMAGE_LAYOUT_GENERAL;
        descriptions.push_back(description);
        references.push_back({static_cast<std::uint32_t>(i), VK_IMAGE_LAYOUT_GENERAL});
    }
    VkSubpassDescription subpass = {};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = static_cast<std::uint32_t>(references.size());
    subpass.pColorAttachments = references.data();
    VkRenderPassCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = static_cast<std::uint32_t>(descriptions.size());
    info.pAttachments = descriptions.data();
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    VkRenderPass renderPass = VK_NULL_HANDLE;
    device.check(vkCreateRenderPass(device.vk(), &info, nullptr, &renderPass), "vkCreateRenderPass", label);
    device.labels().setName(VK_OBJECT_TYPE_RENDER_PASS, renderPass, label);
    return renderPass;
}

namespace {

/// Arrays that a pipeline's create info points to; must stay in place until the call.
struct FixedState {
    std::vector<VkVertexInputBindingDescription> vertexBindings;
    std::vector<VkVertexInputAttributeDescription> vertexAttributes;
    std::vector<VkPipelineColorBlendAttachmentState> blends;
};

FixedState fixedState(const RenderPipelineDescriptor& descriptor) {
    FixedState state;
    for (std::uint32_t slot = 0; slot < descriptor.buffers.size(); ++slot) {
        const VertexBufferLayout& buffer = descriptor.buffers[slot];
        state.vertexBindings.push_back(
            {slot, static_cast<std::uint32_t>(buffer.arrayStride),
             buffer.stepMode == VertexStepMode::Vertex ? VK_VERTEX_INPUT_RATE_VERTEX : VK_VERTEX_INPUT_RATE_INSTANCE});
        for (const VertexAttribute& attribute : buffer.attributes) {
            state.vertexAttributes.push_back({attribute.shaderLocation, slot, toVulkan(attribute.format),
                                              static_cast<std::uint32_t>(attribute.offset)});
        }
    }
    for (const ColorTargetState& target : descriptor.targets) {
        VkPipelineColorBlendAttachmentState blend = {};
        blend.colorWriteMask =
            VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
        if (target.blend) {
            blend.blendEnable = VK_TRUE;
            blend.srcColorBlendFactor = toVulkan(target.blend->color.srcFactor);
            blend.dstColorBlendFactor = toVulkan(target.blend->color.dstFactor);
            blend.colorBlendOp = VK_BLEND_OP_ADD;
            blend.srcAlphaBlendFactor = toVulkan(target.blend->alpha.srcFactor);
            blend.dstAlphaBlendFactor = toVulkan(target.blend->alpha.dstFactor);
            blend.alphaBlendOp = VK_BLEND_OP_ADD;
        }
        state.blends.push_back(blend);
    }
    return state;
}

}  // namespace

RenderPipelineImpl::RenderPipelineImpl(DeviceImpl& owner, const RenderPipelineDescriptor& descriptor)
    : Object(owner, descriptor.label),
      external(descriptor.externalTarget != nullptr),
      vertexBufferCount(static_cast<std::uint32_t>(descriptor.buffers.size())) {
    const ShaderModuleImpl& vertex =
        resolveModule(descriptor.vertex, owner, ShaderStage::Vertex, label(), "vertex shader module");
    const ShaderModuleImpl& fragment =
        resolveModule(descriptor.fragment, owner, ShaderStage::Fragment, label(), "fragment shader module");
    require(!descriptor.targets.empty() && descriptor.targets.size() <= owner.limits().maxColorAttachments, "Pipeline ",
            quoted(label()), " has ", descriptor.targets.size(), " targets; 1 to ", owner.limits().maxColorAttachments,
            " are expected.");
    for (const ColorTargetState& target : descriptor.targets) {
        if (external) continue;
        require(target.format != TextureFormat::Undefined, "Pipeline ", quoted(label()),
                " has a target without format.");
        requireFormatSupport(owner, target.format, TextureUsage::RenderAttachment, label());
        targets.push_back(target.format);
    }
    if (descriptor.layout) {
        layout = internalReference(resolve(descriptor.layout, owner, "pipeline layout"));
        requireLayoutFits(*layout, vertex, label());
        requireLayoutFits(*layout, fragment, label());
    } else {
        layout = deriveLayout(owner, label(), {&vertex, &fragment});
    }
    create(descriptor, vertex, fragment);
}

void RenderPipelineImpl::create(const RenderPipelineDescriptor& descriptor, const ShaderModuleImpl& vertex,
                                const ShaderModuleImpl& fragment) {
    DeviceImpl& owner = device();
    const Specialization vertexConstants(descriptor.vertexConstants, vertex, label());
    const Specialization fragmentConstants(descriptor.fragmentConstants, fragment, label());
    const std::array stages = {stageInfo(vertex, VK_SHADER_STAGE_VERTEX_BIT, vertexConstants),
                               stageInfo(fragment, VK_SHADER_STAGE_FRAGMENT_BIT, fragmentConstants)};
    const FixedState fixed = fixedState(descriptor);

    VkPipelineVertexInputStateCreateInfo vertexInput = {};
    vertexInput.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    vertexInput.vertexBindingDescriptionCount = static_cast<std::uint32_t>(fixed.vertexBindings.size());
    vertexInput.pVertexBindingDescriptions = fixed.vertexBindings.data();
    vertexInput.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(fixed.vertexAttributes.size());
    vertexInput.pVertexAttributeDescriptions = fixed.vertexAttributes.data();
    VkPipelineInputAssemblyStateCreateInfo assembly = {};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = toVulkan(descriptor.topology);
    VkPipelineViewportStateCreateInfo viewport = {};
    viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport.viewportCount = 1;
    viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo raster = {};
    raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    raster.polygonMode = VK_POLYGON_MODE_FILL;
    raster.cullMode = descriptor.cullMode == CullMode::None    ? VK_CULL_MODE_NONE
                      : descriptor.cullMode == CullMode::Front ? VK_CULL_MODE_FRONT_BIT
                                                               : VK_CULL_MODE_BACK_BIT;
    raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    raster.lineWidth = 1;
    VkPipelineMultisampleStateCreateInfo multisample = {};
    multisample.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    multisample.rasterizationSamples = external ? descriptor.externalTarget->sampleCount : VK_SAMPLE_COUNT_1_BIT;
    VkPipelineDepthStencilStateCreateInfo depth = {};
    depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    VkPipelineColorBlendStateCreateInfo blend = {};
    blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blend.attachmentCount = static_cast<std::uint32_t>(fixed.blends.size());
    blend.pAttachments = fixed.blends.data();
    const std::array dynamicStates = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic = {};
    dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic.dynamicStateCount = static_cast<std::uint32_t>(dynamicStates.size());
    dynamic.pDynamicStates = dynamicStates.data();

    VkGraphicsPipelineCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.stageCount = static_cast<std::uint32_t>(stages.size());
    info.pStages = stages.data();
    info.pVertexInputState = &vertexInput;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &multisample;
    info.pDepthStencilState = external && descriptor.externalTarget->hasDepth ? &depth : nullptr;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = layout->vk;
    info.renderPass =
        external ? descriptor.externalTarget->renderPass : createRenderPass(owner, targets, nullptr, label());
    const VkResult result = vkCreateGraphicsPipelines(owner.vk(), owner.pipelineCache(), 1, &info, nullptr, &vk);
    if (!external) vkDestroyRenderPass(owner.vk(), info.renderPass, nullptr);
    owner.check(result, "vkCreateGraphicsPipelines", label());
    owner.labels().setName(VK_OBJECT_TYPE_PIPELINE, vk, label());
}

void RenderPipelineImpl::release() noexcept {
    if (vk == VK_NULL_HANDLE) return;
    vkDestroyPipeline(device().vk(), vk, nullptr);
    vk = VK_NULL_HANDLE;
}

}  // namespace gpu::detail
