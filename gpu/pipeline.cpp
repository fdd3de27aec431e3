// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/pipeline.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "gpu/detail/bindings.h"
#include "gpu/detail/device_impl.h"

namespace gpu {

namespace detail {

std::shared_ptr<PipelineLayoutImpl> deriveLayout(DeviceImpl& device, const std::string& label,
                                                 const std::vector<const ShaderModuleImpl*>& modules) {
    std::vector<std::vector<BindGroupLayoutEntry>> groups;
    std::uint32_t immediateSize = 0;
    for (const ShaderModuleImpl* module : modules) {
        const Reflection& reflection = module->reflection;
        for (const ReflectedBinding& reflected : reflection.bindings) {
            require(reflected.set < device.limits().maxBindGroups, "Shader module ", quoted(module->label()),
                    " uses set ", reflected.set, "; this device allows ", device.limits().maxBindGroups, " sets.");
            if (groups.size() <= reflected.set) groups.resize(reflected.set + 1);
            std::vector<BindGroupLayoutEntry>& entries = groups[reflected.set];
            const auto same = std::find_if(entries.begin(), entries.end(), [&](const BindGroupLayoutEntry& entry) {
                return entry.binding == reflected.binding;
            });
            if (same == entries.end()) {
                entries.push_back({.binding = reflected.binding,
                                   .visibility = reflection.stage,
                                   .type = reflected.type,
                                   .hasDynamicOffset = false,
                                   .minBindingSize = reflected.minBindingSize,
                                   .storageFormat = reflected.storageFormat,
                                   .sampleType = reflected.sampleType});
                continue;
            }
            require(same->type == reflected.type, "Pipeline ", quoted(label), ": its shaders disagree about set ",
                    reflected.set, " binding ", reflected.binding, ", ", toString(same->type), " and ",
                    toString(reflected.type), ".");
            same->visibility |= reflection.stage;
            same->minBindingSize = std::max(same->minBindingSize, reflected.minBindingSize);
        }
        immediateSize = std::max(immediateSize, (reflection.immediateSize + 3) / 4 * 4);
    }
    std::vector<std::shared_ptr<BindGroupLayoutImpl>> layouts;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        BindGroupLayoutDescriptor descriptor{.label = text(label, " group ", i), .entries = std::move(groups[i])};
        layouts.push_back(std::make_shared<BindGroupLayoutImpl>(device, descriptor));
    }
    return std::make_shared<PipelineLayoutImpl>(device, label, std::move(layouts), immediateSize);
}

void requireLayoutFits(const PipelineLayoutImpl& layout, const ShaderModuleImpl& module, const std::string& pipeline) {
    for (const ReflectedBinding& needed : module.reflection.bindings) {
        const BindGroupLayoutEntry* entry =
            needed.set < layout.groups.size() ? layout.groups[needed.set]->find(needed.binding) : nullptr;
        const std::string where = text("Pipeline ", quoted(pipeline), ": set ", needed.set, " binding ", needed.binding,
                                       " (", needed.name, ")");
        require(entry != nullptr, where, " is used by shader module ", quoted(module.label()),
                " but is not in pipeline layout ", quoted(layout.label()), ".");
        const bool readsWritable =
            needed.type == BindingType::ReadOnlyStorageBuffer && entry->type == BindingType::StorageBuffer;
        require(entry->type == needed.type || readsWritable, where, " is a ", toString(needed.type),
                " in the shader and a ", toString(entry->type), " in pipeline layout ", quoted(layout.label()), ".");
        require(has(entry->visibility, module.reflection.stage), where,
                " is not visible to its stage in pipeline layout ", quoted(layout.label()), ".");
        require(entry->minBindingSize == 0 || entry->minBindingSize >= needed.minBindingSize, where, " needs ",
                needed.minBindingSize, " bytes; pipeline layout ", quoted(layout.label()), " promises ",
                entry->minBindingSize, ".");
    }
    require(module.reflection.immediateSize <= layout.immediateSize, "Pipeline ", quoted(pipeline), ": shader module ",
            quoted(module.label()), " declares ", module.reflection.immediateSize,
            " bytes of immediates; pipeline layout ", quoted(layout.label()), " has ", layout.immediateSize, ".");
}

namespace {

/// The constant a key names: by its constant_id when the key is a number, otherwise by its name.
const ReflectedConstant* findConstant(const std::vector<ReflectedConstant>& known, const std::string& key) {
    std::uint32_t id = 0;
    const char* end = key.data() + key.size();
    const auto parsed = std::from_chars(key.data(), end, id);
    const bool byId = parsed.ec == std::errc() && parsed.ptr == end;
    const auto found = std::find_if(known.begin(), known.end(), [&](const ReflectedConstant& reflected) {
        return byId ? reflected.id == id : reflected.name == key;
    });
    return found == known.end() ? nullptr : &*found;
}

/// The 32 bits of a value of this kind; nullopt when the kind cannot hold it.
std::optional<std::uint32_t> constantBits(ConstantKind kind, double value) {
    if (!std::isfinite(value)) return std::nullopt;
    const auto wholeWithin = [value](double min, double max) {
        return value == std::trunc(value) && value >= min && value <= max;
    };
    switch (kind) {
        case ConstantKind::Bool:
            if (value != 0 && value != 1) return std::nullopt;
            return value != 0 ? VK_TRUE : VK_FALSE;
        case ConstantKind::Int:
            if (!wholeWithin(std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max())) break;
            return static_cast<std::uint32_t>(static_cast<std::int32_t>(value));
        case ConstantKind::Uint:
            if (!wholeWithin(0, std::numeric_limits<std::uint32_t>::max())) break;
            return static_cast<std::uint32_t>(value);
        case ConstantKind::Float:
            if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max())) break;
            return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    }
    return std::nullopt;
}

}  // namespace

Specialization::Specialization(const std::vector<ConstantEntry>& constants, const ShaderModuleImpl& module,
                               const std::string& pipeline) {
    for (const ConstantEntry& constant : constants) {
        const ReflectedConstant* found = findConstant(module.reflection.constants, constant.key);
        require(found != nullptr, "Pipeline ", quoted(pipeline), " sets constant \"", constant.key,
                "\", which shader module ", quoted(module.label()), " does not have.");
        require(!values_.contains(found->id), "Pipeline ", quoted(pipeline), " sets constant \"", constant.key,
                "\" twice.");
        const std::optional<std::uint32_t> bits = constantBits(found->kind, constant.value);
        require(bits.has_value(), "Pipeline ", quoted(pipeline), " sets constant \"", constant.key, "\" to ",
                constant.value, ", which its type cannot hold.");
        values_[found->id] = *bits;
    }
    for (const auto& [id, bits] : values_) {
        entries_.push_back(
            {id, static_cast<std::uint32_t>(data_.size() * sizeof(std::uint32_t)), sizeof(std::uint32_t)});
        data_.push_back(bits);
    }
    info_ = {static_cast<std::uint32_t>(entries_.size()), entries_.data(), data_.size() * sizeof(std::uint32_t),
             data_.data()};
}

VkPipelineShaderStageCreateInfo stageInfo(const ShaderModuleImpl& module, VkShaderStageFlagBits stage,
                                          const Specialization& specialization) {
    VkPipelineShaderStageCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = stage;
    info.module = module.vk;
    info.pName = "main";
    info.pSpecializationInfo = specialization.info();
    return info;
}

ShaderModuleImpl& resolveModule(const ShaderModule& handle, const DeviceImpl& device, ShaderStage stage,
                                const std::string& pipeline, const char* what) {
    ShaderModuleImpl& module = resolve(handle, device, what);
    require(module.reflection.stage == stage, "Pipeline ", quoted(pipeline), ": shader module ", quoted(module.label()),
            " is not a ", what, ".");
    return module;
}

ComputePipelineImpl::ComputePipelineImpl(DeviceImpl& owner, const ComputePipelineDescriptor& descriptor, Compile when)
    : Object(owner, descriptor.label) {
    ShaderModuleImpl& module =
        resolveModule(descriptor.module, owner, ShaderStage::Compute, label(), "compute shader module");
    if (descriptor.layout) {
        layout = internalReference(resolve(descriptor.layout, owner, "pipeline layout"));
        requireLayoutFits(*layout, module, label());
    } else {
        layout = deriveLayout(owner, label(), {&module});
    }
    source_.reset(new Source{internalReference(module), Specialization(descriptor.constants, module, label())});
    const Specialization& specialization = source_->specialization;
    for (std::size_t i = 0; i < 3; ++i) {
        workgroupSize[i] = module.reflection.workgroupSize[i];
        const auto& constant = module.reflection.workgroupSizeConstants[i];
        if (!constant) continue;
        const auto value = specialization.values().find(*constant);
        if (value != specialization.values().end()) workgroupSize[i] = value->second;
    }
    const auto [x, y, z] = workgroupSize;
    const Limits& limits = owner.limits();
    require(x > 0 && y > 0 && z > 0 && x <= limits.maxComputeWorkgroupSizeX && y <= limits.maxComputeWorkgroupSizeY &&
                z <= limits.maxComputeWorkgroupSizeZ &&
                std::uint64_t{x} * y * z <= limits.maxComputeInvocationsPerWorkgroup,
            "Pipeline ", quoted(label()), " has workgroups of ", x, "x", y, "x", z, "; this device allows ",
            limits.maxComputeWorkgroupSizeX, "x", limits.maxComputeWorkgroupSizeY, "x", limits.maxComputeWorkgroupSizeZ,
            " and ", limits.maxComputeInvocationsPerWorkgroup, " invocations.");
    VkComputePipelineCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage = stageInfo(module, VK_SHADER_STAGE_COMPUTE_BIT, specialization);
    info.layout = layout->vk;
    const auto compile = [device = owner.vk(), cache = owner.pipelineCache(), info, pipeline = &vk_] {
        return vkCreateComputePipelines(device, cache, 1, &info, nullptr, pipeline);
    };
    if (when == Compile::InBackground) {
        compiling_ = owner.compiler().start(compile);
        return;
    }
    result_ = compile();
    finish();
    owner.check(result_, "vkCreateComputePipelines", label());
}

void ComputePipelineImpl::finish() {
    source_.reset();
    if (vk_ != VK_NULL_HANDLE) device().labels().setName(VK_OBJECT_TYPE_PIPELINE, vk_, label());
}

VkPipeline ComputePipelineImpl::compiled() {
    if (compiling_.valid()) {
        result_ = compiling_.get();
        finish();
    }
    device().check(result_, "vkCreateComputePipelines", label());
    return vk_;
}

void ComputePipelineImpl::release() noexcept {
    if (compiling_.valid()) compiling_.wait();
    if (vk_ == VK_NULL_HANDLE) return;
    vkDestroyPipeline(device().vk(), vk_, nullptr);
    vk_ = VK_NULL_HANDLE;
}

namespace {

BindGroupLayout layoutHandle(const PipelineLayoutImpl& layout, std::uint32_t index, const std::string& pipeline) {
    require(index < layout.groups.size(), "Pipeline ", quoted(pipeline), " has ", layout.groups.size(),
            " bind groups; there is no group ", index, ".");
    return BindGroupLayout(makeHandle(layout.device().shared_from_this(), layout.groups[index]));
}

}  // namespace

}  // namespace detail

const std::string& ComputePipeline::label() const {
    detail::require(impl_ != nullptr, "The compute pipeline is an empty handle.");
    return impl_->label();
}

BindGroupLayout ComputePipeline::getBindGroupLayout(std::uint32_t index) const {
    detail::require(impl_ != nullptr, "The compute pipeline is an empty handle.");
    return detail::layoutHandle(*impl_->layout, index, impl_->label());
}

std::array<std::uint32_t, 3> ComputePipeline::workgroupSize() const {
    detail::require(impl_ != nullptr, "The compute pipeline is an empty handle.");
    return impl_->workgroupSize;
}

const std::string& RenderPipeline::label() const {
    detail::require(impl_ != nullptr, "The render pipeline is an empty handle.");
    return impl_->label();
}

BindGroupLayout RenderPipeline::getBindGroupLayout(std::uint32_t index) const {
    detail::require(impl_ != nullptr, "The render pipeline is an empty handle.");
    return detail::layoutHandle(*impl_->layout, index, impl_->label());
}

}  // namespace gpu
