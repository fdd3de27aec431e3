// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/adopt.h"
#include "gpu/detail/commands.h"
#include "gpu/detail/device_impl.h"
#include "gpu/detail/vulkan_map.h"

namespace gpu {

namespace detail {

namespace {

/// A Vulkan render pass and framebuffer made for one pass of an encoder.
class Framebuffer final : public Object {
  public:
    Framebuffer(DeviceImpl& owner, const std::string& name, const RenderPassDescriptor& descriptor,
                const std::vector<TextureFormat>& formats, const std::vector<VkImageView>& views, std::uint32_t width,
                std::uint32_t height)
        : Object(owner, name) {
        renderPass = createRenderPass(owner, formats, &descriptor.colorAttachments, name);
        VkFramebufferCreateInfo info = {};
        info.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
        info.renderPass = renderPass;
        info.attachmentCount = static_cast<std::uint32_t>(views.size());
        info.pAttachments = views.data();
        info.width = width;
        info.height = height;
        info.layers = 1;
        try {
            owner.check(vkCreateFramebuffer(owner.vk(), &info, nullptr, &vk), "vkCreateFramebuffer", name);
        } catch (...) {
            release();
            throw;
        }
    }
    ~Framebuffer() override { release(); }
    void release() noexcept override {
        if (vk != VK_NULL_HANDLE) vkDestroyFramebuffer(device().vk(), vk, nullptr);
        if (renderPass != VK_NULL_HANDLE) vkDestroyRenderPass(device().vk(), renderPass, nullptr);
        vk = VK_NULL_HANDLE;
        renderPass = VK_NULL_HANDLE;
    }

    VkRenderPass renderPass = VK_NULL_HANDLE;
    VkFramebuffer vk = VK_NULL_HANDLE;
};

RenderPassImpl::Target ownTarget(CommandEncoderImpl& encoder, const RenderPassDescriptor& descriptor) {
    DeviceImpl& device = *encoder.device();
    const std::size_t count = descriptor.colorAttachments.size();
    require(count > 0 && count <= device.limits().maxColorAttachments, "Render pass ", quoted(descriptor.label),
            " has ", count, " colour attachments; 1 to ", device.limits().maxColorAttachments, " are expected.");
    RenderPassImpl::Target target;
    std::vector<VkImageView> views;
    for (std::uint32_t i = 0; i < count; ++i) {
        const RenderPassColorAttachment& attachment = descriptor.colorAttachments[i];
        TextureViewImpl& view = resolve(attachment.view, device, "colour attachment");
        TextureImpl& texture = *view.texture;
        require(has(texture.usage, TextureUsage::RenderAttachment), "Texture ", quoted(texture.label()), " has usage ",
                toString(texture.usage), "; drawing to it needs RenderAttachment.");
        require(view.mipLevelCount == 1, "Render pass ", quoted(descriptor.label), " draws to a view of texture ",
                quoted(texture.label()), " with ", view.mipLevelCount, " levels; 1 is expected.");
        const std::uint32_t width = texture.mipWidth(view.baseMipLevel);
        const std::uint32_t height = texture.mipHeight(view.baseMipLevel);
        require(i == 0 || (width == target.width && height == target.height), "Render pass ", quoted(descriptor.label),
                ": colour attachment ", i, " is ", width, "x", height, ", the first is ", target.width, "x",
                target.height, ".");
        target.width = width;
        target.height = height;
        target.formats.push_back(texture.format);
        views.push_back(view.vk);
        VkClearValue clear = {};
        const Color& c = attachment.clearValue;
        if (sampleTypeOf(texture.format) == TextureSampleType::Uint) {
            clear.color.uint32[0] = static_cast<std::uint32_t>(c.r);
            clear.color.uint32[1] = static_cast<std::uint32_t>(c.g);
            clear.color.uint32[2] = static_cast<std::uint32_t>(c.b);
            clear.color.uint32[3] = static_cast<std::uint32_t>(c.a);
        } else {
            clear.color.float32[0] = static_cast<float>(c.r);
            clear.color.float32[1] = static_cast<float>(c.g);
            clear.color.float32[2] = static_cast<float>(c.b);
            clear.color.float32[3] = static_cast<float>(c.a);
        }
        target.clearValues.push_back(clear);
        ResourceUse use;
        use.texture = &texture;
        use.mipLevel = view.baseMipLevel;
        use.access = kAttachmentWrite;
        use.binding = i;
        target.attachments.add(use);
        encoder.commands().keep(view);
    }
    const auto framebuffer = std::make_shared<Framebuffer>(device, descriptor.label, descriptor, target.formats, views,
                                                           target.width, target.height);
    encoder.commands().keep(*framebuffer);
    target.renderPass = framebuffer->renderPass;
    target.framebuffer = framebuffer->vk;
    return target;
}

}  // namespace

RenderPassImpl::RenderPassImpl(std::shared_ptr<CommandEncoderImpl> owner, std::string name, Target where,
                               std::optional<PassTimestampWrites> timestampWrites)
    : encoder(std::move(owner)),
      label(std::move(name)),
      bindings(*encoder->device()),
      target(std::move(where)),
      scope(target.attachments),
      timestampWrites_(std::move(timestampWrites)) {
    if (timestampWrites_) {
        QuerySetImpl& querySet = resolve(timestampWrites_->querySet, *encoder->device(), "query set");
        require(timestampWrites_->beginningOfPassWriteIndex < querySet.count &&
                    timestampWrites_->endOfPassWriteIndex < querySet.count,
                "Query set ", quoted(querySet.label()), " has ", querySet.count, " queries; render pass ",
                quoted(label), " writes ", timestampWrites_->beginningOfPassWriteIndex, " and ",
                timestampWrites_->endOfPassWriteIndex, ".");
    }
    const VkViewport viewport = {0, 0, static_cast<float>(target.width), static_cast<float>(target.height), 0, 1};
    const VkRect2D scissor = {{0, 0}, {target.width, target.height}};
    recorded.emplace_back([viewport, scissor](VkCommandBuffer commandBuffer) {
        vkCmdSetViewport(commandBuffer, 0, 1, &viewport);
        vkCmdSetScissor(commandBuffer, 0, 1, &scissor);
    });
    encoder->passOpen = true;
}

RenderPassImpl::~RenderPassImpl() {
    if (open_) encoder->passOpen = false;
}

void RenderPassImpl::requireOpen() const {
    require(open_, "Render pass ", quoted(label), " has ended.");
    encoder->requireOpen();
}

void RenderPassImpl::prepareDraw(bool indexed) {
    require(pipeline != nullptr, "Render pass ", quoted(label), " draws without a pipeline.");
    bindings.requireComplete(pipeline->label());
    for (std::uint32_t slot = 0; slot < pipeline->vertexBufferCount; ++slot) {
        require(vertexBuffers.contains(slot), "Pipeline ", quoted(pipeline->label()), " needs a vertex buffer in slot ",
                slot, "; none is set.");
    }
    require(!indexed || indexBuffer, "Render pass ", quoted(label), " draws indexed without an index buffer.");
    UsageScope withThis = scope;
    bindings.collectUses(withThis);
    withThis.requireNoConflict(text("render pass ", quoted(label)));
    scope = std::move(withThis);
    recorded.emplace_back(
        [pipelineHandle = pipeline->vk, snapshot = bindings.snapshot()](VkCommandBuffer commandBuffer) {
            vkCmdBindPipeline(commandBuffer, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelineHandle);
            snapshot.record(commandBuffer, VK_PIPELINE_BIND_POINT_GRAPHICS);
        });
}

void RenderPassImpl::end() {
    requireOpen();
    open_ = false;
    encoder->passOpen = false;
    CommandBufferImpl& commands = encoder->commands();
    const auto timestamp = [&](std::uint32_t index) {
        encoder->writeTimestamp(*timestampWrites_->querySet.impl(), index, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT);
    };
    if (timestampWrites_) timestamp(timestampWrites_->beginningOfPassWriteIndex);
    encoder->device()->labels().begin(commands.vk, label);
    scope.record(commands);
    VkRenderPassBeginInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
    info.renderPass = target.renderPass;
    info.framebuffer = target.framebuffer;
    info.renderArea = {{0, 0}, {target.width, target.height}};
    info.clearValueCount = static_cast<std::uint32_t>(target.clearValues.size());
    info.pClearValues = target.clearValues.data();
    vkCmdBeginRenderPass(commands.vk, &info, VK_SUBPASS_CONTENTS_INLINE);
    for (const auto& command : recorded) command(commands.vk);
    vkCmdEndRenderPass(commands.vk);
    encoder->device()->labels().end(commands.vk);
    if (timestampWrites_) timestamp(timestampWrites_->endOfPassWriteIndex);
    recorded.clear();
}

}  // namespace detail

namespace {

template <class F>
void record(const std::shared_ptr<detail::RenderPassImpl>& pass, F&& call) {
    detail::require(pass != nullptr, "The render pass is an empty handle.");
    pass->encoder->guardedCall([&] {
        pass->requireOpen();
        call(*pass);
    });
}

}  // namespace

RenderPassEncoder CommandEncoder::beginRenderPass(const RenderPassDescriptor& descriptor) const {
    detail::require(impl_ != nullptr, "The command encoder is an empty handle.");
    return impl_->record([&] {
        return RenderPassEncoder(std::make_shared<detail::RenderPassImpl>(
            impl_, descriptor.label, detail::ownTarget(*impl_, descriptor), descriptor.timestampWrites));
    });
}

RenderPassEncoder CommandEncoder::beginRenderPass(const ExternalRenderPassDescriptor& descriptor) const {
    detail::require(impl_ != nullptr, "The command encoder is an empty handle.");
    return impl_->record([&] {
        detail::require(descriptor.renderPass != VK_NULL_HANDLE && descriptor.framebuffer != VK_NULL_HANDLE &&
                            descriptor.width > 0 && descriptor.height > 0,
                        "Render pass ", detail::quoted(descriptor.label),
                        " needs a render pass, a framebuffer and a size.");
        detail::RenderPassImpl::Target target;
        target.renderPass = descriptor.renderPass;
        target.framebuffer = descriptor.framebuffer;
        target.width = descriptor.width;
        target.height = descriptor.height;
        target.clearValues = descriptor.clearValues;
        target.external = true;
        return RenderPassEncoder(std::make_shared<detail::RenderPassImpl>(impl_, descriptor.label, std::move(target),
                                                                          descriptor.timestampWrites));
    });
}

void RenderPassEncoder::setPipeline(const RenderPipeline& handle) const {
    record(impl_, [&](detail::RenderPassImpl& pass) {
        detail::RenderPipelineImpl& pipeline = detail::resolve(handle, *pass.encoder->device(), "render pipeline");
        detail::require(pipeline.external == pass.target.external && pipeline.targets == pass.target.formats,
                        "Pipeline ", detail::quoted(pipeline.label()), " is made for other targets than render pass ",
                        detail::quoted(pass.label), " has.");
        pass.encoder->commands().keep(pipeline);
        pass.pipeline = detail::internalReference(pipeline);
        pass.bindings.setPipelineLayout(pipeline.layout);
    });
}

void RenderPassEncoder::setBindGroup(std::uint32_t index, const BindGroup& group,
                                     std::span<const std::uint32_t> dynamicOffsets) const {
    record(impl_, [&](detail::RenderPassImpl& pass) {
        pass.bindings.setBindGroup(index, group, dynamicOffsets, pass.encoder->commands());
    });
}

void RenderPassEncoder::setImmediates(std::uint32_t rangeOffset, const void* data, std::size_t size) const {
    record(impl_,
           [&](detail::RenderPassImpl& pass) { pass.bindings.setImmediates(rangeOffset, data, size, pass.label); });
}

void RenderPassEncoder::setVertexBuffer(std::uint32_t slot, const Buffer& handle, std::uint64_t offset) const {
    record(impl_, [&](detail::RenderPassImpl& pass) {
        detail::BufferImpl& buffer = detail::resolve(handle, *pass.encoder->device(), "vertex buffer");
        detail::require(has(buffer.usage, BufferUsage::Vertex) && offset < buffer.size, "Buffer ",
                        detail::quoted(buffer.label()), " (usage ", toString(buffer.usage), ", ", buffer.size,
                        " bytes) cannot be a vertex buffer from byte ", offset, ".");
        detail::ResourceUse use;
        use.buffer = &buffer;
        use.access = detail::kVertexRead;
        pass.scope.add(use);
        pass.encoder->commands().keep(buffer);
        pass.vertexBuffers.insert(slot);
        pass.recorded.emplace_back([slot, vk = buffer.vk, offset](VkCommandBuffer commandBuffer) {
            vkCmdBindVertexBuffers(commandBuffer, slot, 1, &vk, &offset);
        });
    });
}

void RenderPassEncoder::setIndexBuffer(const Buffer& handle, IndexFormat format, std::uint64_t offset) const {
    record(impl_, [&](detail::RenderPassImpl& pass) {
        detail::BufferImpl& buffer = detail::resolve(handle, *pass.encoder->device(), "index buffer");
        const std::uint64_t size = format == IndexFormat::Uint16 ? 2 : 4;
        detail::require(has(buffer.usage, BufferUsage::Index) && offset < buffer.size && offset % size == 0, "Buffer ",
                        detail::quoted(buffer.label()), " (usage ", toString(buffer.usage), ", ", buffer.size,
                        " bytes) cannot be an index buffer from byte ", offset, ".");
        detail::ResourceUse use;
        use.buffer = &buffer;
        use.access = detail::kIndexRead;
        pass.scope.add(use);
        pass.encoder->commands().keep(buffer);
        pass.indexBuffer = true;
        const VkIndexType type = format == IndexFormat::Uint16 ? VK_INDEX_TYPE_UINT16 : VK_INDEX_TYPE_UINT32;
        pass.recorded.emplace_back([vk = buffer.vk, offset, type](VkCommandBuffer commandBuffer) {
            vkCmdBindIndexBuffer(commandBuffer, vk, offset, type);
        });
    });
}

void RenderPassEncoder::setViewport(float x, float y, float width, float height, float minDepth, float maxDepth) const {
    record(impl_, [&](detail::RenderPassImpl& pass) {
        detail::require(width > 0 && height > 0 && minDepth >= 0 && maxDepth <= 1 && minDepth <= maxDepth,
                        "Render pass ", detail::quoted(pass.label), " sets a viewport of ", width, "x", height,
                        " with depths ", minDepth, " to ", maxDepth,
                        "; a positive size and depths in [0, 1] are expected.");
        const VkViewport viewport = {x, y, width, height, minDepth, maxDepth};
        pass.recorded.emplace_back(
            [viewport](VkCommandBuffer commandBuffer) { vkCmdSetViewport(commandBuffer, 0, 1, &viewport); });
    });
}

void RenderPassEncoder::setScissorRect(std::uint32_t x, std::uint32_t y, std::uint32_t width,
                                       std::uint32_t height) const {
    record(impl_, [&](detail::RenderPassImpl& pass) {
        detail::require(x <= pass.target.width && width <= pass.target.width - x && y <= pass.target.height &&
                            height <= pass.target.height - y,
                        "Render pass ", detail::quoted(pass.label), " sets a scissor of ", width, "x", height, " at (",
                        x, ", ", y, "), outside its ", pass.target.width, "x", pass.target.height, " pixels.");
        const VkRect2D scissor = {{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)}, {width, height}};
        pass.recorded.emplace_back(
            [scissor](VkCommandBuffer commandBuffer) { vkCmdSetScissor(commandBuffer, 0, 1, &scissor); });
    });
}

void RenderPassEncoder::draw(std::uint32_t vertexCount, std::uint32_t instanceCount, std::uint32_t firstVertex,
                             std::uint32_t firstInstance) const {
    record(impl_, [&](detail::RenderPassImpl& pass) {
        pass.prepareDraw(false);
        pass.recorded.emplace_back([=](VkCommandBuffer commandBuffer) {
            vkCmdDraw(commandBuffer, vertexCount, instanceCount, firstVertex, firstInstance);
        });
    });
}

void RenderPassEncoder::drawIndexed(std::uint32_t indexCount, std::uint32_t instanceCount, std::uint32_t firstIndex,
                                    std::int32_t baseVertex, std::uint32_t firstInstance) const {
    record(impl_, [&](detail::RenderPassImpl& pass) {
        pass.prepareDraw(true);
        pass.recorded.emplace_back([=](VkCommandBuffer commandBuffer) {
            vkCmdDrawIndexed(commandBuffer, indexCount, instanceCount, firstIndex, baseVertex, firstInstance);
        });
    });
}

void RenderPassEncoder::end() const {
    record(impl_, [&](detail::RenderPassImpl& pass) { pass.end(); });
}

}  // namespace gpu
