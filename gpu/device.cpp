// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/device.h"

#include "gpu/adapter.h"
#include "gpu/adopt.h"
#include "gpu/detail/bindings.h"
#include "gpu/detail/commands.h"
#include "gpu/detail/device_impl.h"
#include "gpu/detail/resources.h"
#include "gpu/instance.h"

namespace gpu {

namespace {

detail::DeviceImpl& deviceOf(const std::shared_ptr<detail::DeviceImpl>& impl) {
    detail::require(impl != nullptr, "The device is an empty handle.");
    return *impl;
}

/// Runs the callbacks that are ready even when the call fails, because the loss of a device is reported through them.
template <class F>
void runThenReady(detail::DeviceImpl& device, F&& call) {
    try {
        device.guarded(std::forward<F>(call));
    } catch (const Error&) {
        device.inFlight().runReady();
        throw;
    }
    device.inFlight().runReady();
}

/// Makes an object inside the error scopes; the handle is empty when a scope kept the error.
template <class H, class Impl, class Descriptor, class... Options>
H create(const std::shared_ptr<detail::DeviceImpl>& impl, const Descriptor& descriptor, Options... options) {
    return deviceOf(impl).guarded(
        [&] { return H(detail::makeHandle(impl, std::make_shared<Impl>(*impl, descriptor, options...))); });
}

}  // namespace

Device Device::adopt(const AdoptDescriptor& descriptor) {
    detail::require(descriptor.instance != VK_NULL_HANDLE && descriptor.physicalDevice != VK_NULL_HANDLE &&
                        descriptor.device != VK_NULL_HANDLE && descriptor.queue != VK_NULL_HANDLE,
                    "Adopting device ", detail::quoted(descriptor.label),
                    " needs an instance, a physical device, a device and a queue; at least one is null.");
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(descriptor.physicalDevice, &properties);
    detail::require(properties.apiVersion >= VK_API_VERSION_1_1, "Device \"", properties.deviceName,
                    "\" offers Vulkan ", VK_API_VERSION_MAJOR(properties.apiVersion), ".",
                    VK_API_VERSION_MINOR(properties.apiVersion), "; 1.1 is needed.");
    std::uint32_t familyCount = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(descriptor.physicalDevice, &familyCount, nullptr);
    std::vector<VkQueueFamilyProperties> families(familyCount);
    vkGetPhysicalDeviceQueueFamilyProperties(descriptor.physicalDevice, &familyCount, families.data());
    constexpr VkQueueFlags kNeeded = VK_QUEUE_COMPUTE_BIT | VK_QUEUE_GRAPHICS_BIT;
    detail::require(descriptor.queueFamilyIndex < familyCount &&
                        (families[descriptor.queueFamilyIndex].queueFlags & kNeeded) == kNeeded,
                    "Queue family ", descriptor.queueFamilyIndex, " of device \"", properties.deviceName,
                    "\" does not do both compute and graphics.");
    detail::DeviceImpl::Source source;
    source.instance = descriptor.instance;
    source.physicalDevice = descriptor.physicalDevice;
    source.device = descriptor.device;
    source.queue = descriptor.queue;
    source.queueFamily = descriptor.queueFamilyIndex;
    source.debugUtils = descriptor.debugUtils;
    source.label = descriptor.label;
    source.deviceLost = descriptor.deviceLost;
    const ValidationMode validation = validationModeFromEnvironment();
    if (descriptor.debugUtils && validation != ValidationMode::Off) {
        source.adoptedValidation = std::make_unique<detail::ValidationListener>(validation, ValidationCallback());
        source.adoptedValidation->attach(descriptor.instance);
    }
    return Device(std::make_shared<detail::DeviceImpl>(std::move(source)));
}

Buffer Device::createBuffer(const BufferDescriptor& descriptor) const {
    return deviceOf(impl_).guarded([&] {
        auto buffer = std::make_shared<detail::BufferImpl>(*impl_, descriptor, false);
        buffer->zero();
        if (descriptor.mappedAtCreation) buffer->startMappedAtCreation();
        return Buffer(detail::makeHandle(impl_, std::move(buffer)));
    });
}

Texture Device::createTexture(const TextureDescriptor& descriptor) const {
    return deviceOf(impl_).guarded([&] {
        auto texture = std::make_shared<detail::TextureImpl>(*impl_, descriptor);
        texture->zero();
        return Texture(detail::makeHandle(impl_, std::move(texture)));
    });
}

Sampler Device::createSampler(const SamplerDescriptor& descriptor) const {
    return create<Sampler, detail::SamplerImpl>(impl_, descriptor);
}

ShaderModule Device::createShaderModule(const ShaderModuleDescriptor& descriptor) const {
    return create<ShaderModule, detail::ShaderModuleImpl>(impl_, descriptor);
}

BindGroupLayout Device::createBindGroupLayout(const BindGroupLayoutDescriptor& descriptor) const {
    return create<BindGroupLayout, detail::BindGroupLayoutImpl>(impl_, descriptor);
}

BindGroup Device::createBindGroup(const BindGroupDescriptor& descriptor) const {
    return create<BindGroup, detail::BindGroupImpl>(impl_, descriptor);
}

PipelineLayout Device::createPipelineLayout(const PipelineLayoutDescriptor& descriptor) const {
    return deviceOf(impl_).guarded([&] {
        std::vector<std::shared_ptr<detail::BindGroupLayoutImpl>> groups;
        for (const BindGroupLayout& group : descriptor.bindGroupLayouts) {
            groups.push_back(detail::internalReference(detail::resolve(group, *impl_, "bind group layout")));
        }
        return PipelineLayout(
            detail::makeHandle(impl_, std::make_shared<detail::PipelineLayoutImpl>(
                                          *impl_, descriptor.label, std::move(groups), descriptor.immediateSize)));
    });
}

ComputePipeline Device::createComputePipeline(const ComputePipelineDescriptor& descriptor) const {
    return create<ComputePipeline, detail::ComputePipelineImpl>(impl_, descriptor,
                                                                detail::ComputePipelineImpl::Compile::Now);
}

ComputePipeline Device::createComputePipelineAsync(const ComputePipelineDescriptor& descriptor) const {
    return create<ComputePipeline, detail::ComputePipelineImpl>(impl_, descriptor,
                                                                detail::ComputePipelineImpl::Compile::InBackground);
}

bool Device::compiling() const { return deviceOf(impl_).compiler().busy(); }

RenderPipeline Device::createRenderPipeline(const RenderPipelineDescriptor& descriptor) const {
    return create<RenderPipeline, detail::RenderPipelineImpl>(impl_, descriptor);
}

QuerySet Device::createQuerySet(const QuerySetDescriptor& descriptor) const {
    return create<QuerySet, detail::QuerySetImpl>(impl_, descriptor);
}

CommandEncoder Device::createCommandEncoder(const CommandEncoderDescriptor& descriptor) const {
    return deviceOf(impl_).guarded([&] {
        return CommandEncoder(std::make_shared<detail::CommandEncoderImpl>(
            impl_, descriptor.label, std::make_shared<detail::CommandBufferImpl>(*impl_, descriptor.label)));
    });
}

CommandEncoder Device::beginAdoptedFrame(VkCommandBuffer_T* commandBuffer, std::uint32_t slot) const {
    detail::DeviceImpl& device = deviceOf(impl_);
    CommandEncoder encoder = device.guarded([&] {
        detail::require(device.adopted(), "Device ", detail::quoted(device.label()),
                        " is not adopted: record with createCommandEncoder.");
        detail::require(commandBuffer != nullptr, "The command buffer of an adopted frame is null.");
        device.inFlight().completeSlot(slot);
        device.inFlight().reclaim();
        const std::string label = detail::text("frame of slot ", slot);
        auto recording = std::make_shared<detail::CommandBufferImpl>(device, label, commandBuffer);
        device.inFlight().beginAdoptedFrame(slot, recording);
        return CommandEncoder(std::make_shared<detail::CommandEncoderImpl>(impl_, label, std::move(recording)));
    });
    device.inFlight().runReady();
    return encoder;
}

Queue Device::queue() const {
    deviceOf(impl_);
    return Queue(impl_);
}

const AdapterInfo& Device::adapterInfo() const { return deviceOf(impl_).info(); }
const Limits& Device::limits() const { return deviceOf(impl_).limits(); }
const std::string& Device::label() const { return deviceOf(impl_).label(); }

bool Device::supportsLinearFilter(TextureFormat format) const { return detail::formatFilters(deviceOf(impl_), format); }

bool Device::supportsUsage(TextureFormat format, TextureUsage usage) const {
    return detail::formatSupports(deviceOf(impl_), format, usage);
}

void Device::tick() const {
    detail::DeviceImpl& device = deviceOf(impl_);
    runThenReady(device, [&] {
        device.inFlight().flushPendingWrites();
        device.inFlight().reclaim();
    });
}

void Device::waitIdle() const {
    detail::DeviceImpl& device = deviceOf(impl_);
    runThenReady(device, [&] { device.inFlight().waitIdle(); });
}

std::uint64_t Device::allocatedBytes() const { return deviceOf(impl_).memory().allocatedBytes(); }
void Device::pushErrorScope(ErrorFilter filter) const { deviceOf(impl_).pushErrorScope(filter); }
std::optional<Error> Device::popErrorScope() const { return deviceOf(impl_).popErrorScope(); }
bool Device::isLost() const { return deviceOf(impl_).lost(); }
void Device::destroy() const { deviceOf(impl_).destroy(); }

}  // namespace gpu
