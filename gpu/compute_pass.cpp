// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/detail/commands.h"
#include "gpu/detail/device_impl.h"

namespace gpu {

namespace detail {

ComputePassImpl::ComputePassImpl(std::shared_ptr<CommandEncoderImpl> owner, const ComputePassDescriptor& descriptor)
    : encoder(std::move(owner)),
      label(descriptor.label),
      bindings(*encoder->device()),
      timestampWrites_(descriptor.timestampWrites) {
    if (timestampWrites_) {
        QuerySetImpl& querySet = resolve(timestampWrites_->querySet, *encoder->device(), "query set");
        require(timestampWrites_->endOfPassWriteIndex < querySet.count, "Query set ", quoted(querySet.label()), " has ",
                querySet.count, " queries; there is no query ", timestampWrites_->endOfPassWriteIndex, ".");
        encoder->writeTimestamp(querySet, timestampWrites_->beginningOfPassWriteIndex,
                                VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT);
    }
    encoder->device()->labels().begin(encoder->commands().vk, label);
    encoder->passOpen = true;
}

ComputePassImpl::~ComputePassImpl() {
    if (!open_) return;
    // Left by an exception: recorded commands stay, the encoder remains usable.
    for (; debugGroups >= 0; --debugGroups) encoder->device()->labels().end(encoder->commands().vk);
    encoder->passOpen = false;
}

void ComputePassImpl::requireOpen() const {
    require(open_, "Compute pass ", quoted(label), " has ended.");
    encoder->requireOpen();
}

void ComputePassImpl::prepareDispatch(const ResourceUse* indirect) {
    requireOpen();
    require(pipeline != nullptr, "Compute pass ", quoted(label), " dispatches without a pipeline.");
    bindings.requireComplete(pipeline->label());
    scope_.clear();
    bindings.collectUses(scope_);
    if (indirect != nullptr) scope_.add(*indirect);
    scope_.requireNoConflict(text("a dispatch of pipeline ", quoted(pipeline->label())));
    scope_.record(encoder->commands());
    const VkCommandBuffer commandBuffer = encoder->commands().vk;
    vkCmdBindPipeline(commandBuffer, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline->compiled());
    bindings.snapshot().record(commandBuffer, VK_PIPELINE_BIND_POINT_COMPUTE);
}

void ComputePassImpl::end() {
    requireOpen();
    require(debugGroups == 0, "Compute pass ", quoted(label), " cannot end: ", debugGroups, " debug groups are open.");
    open_ = false;
    encoder->passOpen = false;
    encoder->device()->labels().end(encoder->commands().vk);
    if (timestampWrites_) {
        encoder->writeTimestamp(*timestampWrites_->querySet.impl(), timestampWrites_->endOfPassWriteIndex,
                                VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT);
    }
}

}  // namespace detail

namespace {

/// Runs a call of a pass inside the error scopes.
template <class F>
void record(const std::shared_ptr<detail::ComputePassImpl>& pass, F&& call) {
    detail::require(pass != nullptr, "The compute pass is an empty handle.");
    pass->encoder->guardedCall([&] {
        pass->requireOpen();
        call(*pass);
    });
}

}  // namespace

ComputePassEncoder CommandEncoder::beginComputePass(const ComputePassDescriptor& descriptor) const {
    detail::require(impl_ != nullptr, "The command encoder is an empty handle.");
    return impl_->record(
        [&] { return ComputePassEncoder(std::make_shared<detail::ComputePassImpl>(impl_, descriptor)); });
}

void ComputePassEncoder::setPipeline(const ComputePipeline& pipeline) const {
    record(impl_, [&](detail::ComputePassImpl& pass) {
        detail::ComputePipelineImpl& resolved = detail::resolve(pipeline, *pass.encoder->device(), "compute pipeline");
        static_cast<void>(resolved.compiled());
        pass.encoder->commands().keep(resolved);
        pass.pipeline = detail::internalReference(resolved);
        pass.bindings.setPipelineLayout(resolved.layout);
    });
}

void ComputePassEncoder::setBindGroup(std::uint32_t index, const BindGroup& group,
                                      std::span<const std::uint32_t> dynamicOffsets) const {
    record(impl_, [&](detail::ComputePassImpl& pass) {
        pass.bindings.setBindGroup(index, group, dynamicOffsets, pass.encoder->commands());
    });
}

void ComputePassEncoder::setImmediates(std::uint32_t rangeOffset, const void* data, std::size_t size) const {
    record(impl_,
           [&](detail::ComputePassImpl& pass) { pass.bindings.setImmediates(rangeOffset, data, size, pass.label); });
}

void ComputePassEncoder::dispatchWorkgroups(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    record(impl_, [&](detail::ComputePassImpl& pass) {
        const std::uint32_t limit = pass.encoder->device()->limits().maxComputeWorkgroupsPerDimension;
        detail::require(x <= limit && y <= limit && z <= limit, "Compute pass ", detail::quoted(pass.label),
                        " dispatches ", x, "x", y, "x", z, " workgroups; this device allows ", limit,
                        " in each dimension.");
        if (x == 0 || y == 0 || z == 0) return;
        pass.prepareDispatch(nullptr);
        vkCmdDispatch(pass.encoder->commands().vk, x, y, z);
    });
}

void ComputePassEncoder::dispatchWorkgroupsIndirect(const Buffer& handle, std::uint64_t offset) const {
    record(impl_, [&](detail::ComputePassImpl& pass) {
        detail::BufferImpl& buffer = detail::resolve(handle, *pass.encoder->device(), "indirect buffer");
        detail::require(has(buffer.usage, BufferUsage::Indirect), "Buffer ", detail::quoted(buffer.label()),
                        " has usage ", toString(buffer.usage), "; dispatching from it needs Indirect.");
        constexpr std::uint64_t kCounts = 3 * sizeof(std::uint32_t);
        detail::require(offset % 4 == 0 && offset <= buffer.size && buffer.size - offset >= kCounts,
                        "Workgroup counts at byte ", offset, " of buffer ", detail::quoted(buffer.label()), " (",
                        buffer.size, " bytes): a multiple of 4 with ", kCounts, " bytes behind it is expected.");
        detail::ResourceUse use;
        use.buffer = &buffer;
        use.access = detail::kIndirectRead;
        pass.prepareDispatch(&use);
        vkCmdDispatchIndirect(pass.encoder->commands().vk, buffer.vk, offset);
    });
}

void ComputePassEncoder::writeTimestamp(const QuerySet& querySet, std::uint32_t index) const {
    record(impl_, [&](detail::ComputePassImpl& pass) {
        pass.encoder->writeTimestamp(detail::resolve(querySet, *pass.encoder->device(), "query set"), index,
                                     VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT);
    });
}

void ComputePassEncoder::pushDebugGroup(const std::string& label) const {
    record(impl_, [&](detail::ComputePassImpl& pass) {
        pass.encoder->device()->labels().begin(pass.encoder->commands().vk, label);
        ++pass.debugGroups;
    });
}

void ComputePassEncoder::popDebugGroup() const {
    record(impl_, [&](detail::ComputePassImpl& pass) {
        detail::require(pass.debugGroups > 0, "Compute pass ", detail::quoted(pass.label), " has no open debug group.");
        --pass.debugGroups;
        pass.encoder->device()->labels().end(pass.encoder->commands().vk);
    });
}

void ComputePassEncoder::insertDebugMarker(const std::string& label) const {
    record(impl_, [&](detail::ComputePassImpl& pass) {
        pass.encoder->device()->labels().insert(pass.encoder->commands().vk, label);
    });
}

void ComputePassEncoder::end() const {
    record(impl_, [&](detail::ComputePassImpl& pass) { pass.end(); });
}

}  // namespace gpu
