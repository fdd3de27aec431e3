// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/analysis/march_rays.h"

#include <algorithm>
#include <thread>

#include "core/base/clock.h"
#include "gpu/adapter.h"
#include "gpu/pass_timer.h"
#include "gpu/readback.h"
#include "kernels/march_constant.h"
#include "kernels/march_rays.h"
#include "render/kernels/kernels.h"
#include "shaders/shared/march_block.h"

namespace render {
namespace {

/// Rays per workgroup, marched one after the other. With more rays fewer lanes wait for the last ones, as long as there
/// are workgroups for the whole device. The limit keeps a workgroup short and below the 65535 iterations after which
/// software drivers end loops.
std::uint32_t shareOf(std::uint32_t rayCount, bool software) {
    return std::clamp(rayCount / (software ? 256 : 4096), 2 * kListGroupSize, 16 * kListGroupSize);
}

}  // namespace

RayMarcher::RayMarcher(const gpu::Device& device, SceneGeometry& geometry) : device_(device), geometry_(geometry) {
    using enum gpu::BindingType;
    layout_ = makeLayout(device, "march_rays", {{MARCH_RAYS, ReadOnlyStorageBuffer}, {MARCH_HITS, StorageBuffer}});
    const auto pipeline = [&](const char* label, std::span<const std::uint32_t> code) {
        return makePipeline(device, label, code, {geometry.layout(), layout_}, sizeof(kernel::MarchBlock));
    };
    pyramid_ = pipeline("march_rays", march_rays_spv);
    constantSteps_ = pipeline("march_constant", march_constant_spv);
}

std::vector<RayHit> RayMarcher::march(std::span<const Ray> rays, MarchMethod method, const ConstantStepParams& steps,
                                      float without) {
    if (rays.empty()) return {};
    std::vector<kernel::vec4> packed;
    packed.reserve(2 * rays.size());
    for (const Ray& ray : rays) {
        packed.emplace_back(ray.origin.x(), ray.origin.y(), ray.origin.z(), 0.0f);
        packed.emplace_back(ray.direction.x(), ray.direction.y(), ray.direction.z(), 0.0f);
    }
    const gpu::Buffer rayBuffer = makeBuffer(device_, "rays", gpu::BufferUsage::Storage, packed);
    const gpu::Buffer hitBuffer =
        device_.createBuffer({.label = "hits",
                              .size = rays.size() * sizeof(kernel::vec4),
                              .usage = gpu::BufferUsage::Storage | gpu::BufferUsage::CopySrc});
    const gpu::BindGroup group = device_.createBindGroup(
        {.label = "march_rays",
         .layout = layout_,
         .entries = {{.binding = MARCH_RAYS, .buffer = rayBuffer}, {.binding = MARCH_HITS, .buffer = hitBuffer}}});
    const auto rayCount = static_cast<std::uint32_t>(rays.size());
    const bool software = device_.adapterInfo().type == gpu::AdapterType::CPU;
    const std::uint32_t share = method == MarchMethod::Pyramid ? shareOf(rayCount, software) : kListGroupSize;
    // Software drivers give each thread an equal run of workgroups. With neighbouring shares in different runs, all
    // threads have equal work and read what others have just read.
    const std::uint32_t workers = software ? std::max(std::thread::hardware_concurrency(), 1u) : 1;
    const std::uint32_t groupsPerWorker = ((rayCount + share - 1) / share + workers - 1) / workers;
    const kernel::MarchBlock block{.rayCount = rayCount,
                                   .share = share,
                                   .stepSize = steps.stepSize,
                                   .maxDistance = steps.maxDistance,
                                   .without = without,
                                   .workers = workers,
                                   .groupsPerWorker = groupsPerWorker,
                                   .pad0 = 0};

    gpu::PassTimer timer(device_);
    const gpu::CommandEncoder encoder = device_.createCommandEncoder({.label = "march_rays"});
    {
        const auto region = timer.measure(encoder, "march_rays");
        const gpu::ComputePassEncoder pass = encoder.beginComputePass({.label = "march_rays"});
        pass.setPipeline(method == MarchMethod::Pyramid ? pyramid_ : constantSteps_);
        pass.setBindGroup(0, geometry_.bindGroup());
        pass.setBindGroup(1, group);
        pass.setImmediates(0, block);
        const ListGroups groups = listGroups(workers * groupsPerWorker * kListGroupSize, device_.limits());
        pass.dispatchWorkgroups(groups.x, groups.y);
        pass.end();
    }
    device_.waitIdle();
    const auto start = core::Clock::now();
    device_.queue().submit(encoder.finish());
    device_.waitIdle();
    seconds_ = core::secondsSince(start);
    for (const gpu::PassTimer::Timing& timing : timer.takeResults()) seconds_ = timing.seconds;

    const auto values = gpu::readBuffer<kernel::vec4>(device_, hitBuffer, 0, rays.size());
    std::vector<RayHit> hits(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const kernel::vec4& v = values[i];
        if (!(v.x > 0)) continue;
        hits[i] = {true, v.z > 0.5f, static_cast<int>(v.x) - 1, static_cast<int>(v.y), v.w};
    }
    return hits;
}

}  // namespace render
