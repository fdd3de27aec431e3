// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/passes/translucency_pass.h"

#include <numeric>

#include "core/render/kernels.h"
#include "kernels/dipole_gather.h"
#include "kernels/irradiance.h"
#include "shaders/brdf/measured.h"

namespace render {

TranslucencyPass::TranslucencyPass(const gpu::Device& device, const gpu::BindGroupLayout& geometryLayout)
    : device_(device) {
    using enum gpu::BindingType;
    irradianceLayout_ = makeLayout(device, "irradiance",
                                   {{IRRADIANCE_SHADING, ReadOnlyStorageBuffer},
                                    {IRRADIANCE_DROPPED, StorageBuffer},
                                    {IRRADIANCE_POINTS, ReadOnlyStorageBuffer},
                                    {IRRADIANCE_SUMS, StorageBuffer},
                                    {IRRADIANCE_DRIVES, ReadOnlyStorageBuffer},
                                    {IRRADIANCE_DRIVE_VALUES, ReadOnlyStorageBuffer},
                                    {MEASURED_TABLES, ReadOnlyStorageBuffer}});
    gatherLayout_ = makeLayout(device, "dipole_gather",
                               {{DIPOLE_GATHER_PARAMS, UniformBuffer},
                                {DIPOLE_GATHER_PIXELS, ReadOnlyStorageBuffer},
                                {DIPOLE_GATHER_POINTS, ReadOnlyStorageBuffer},
                                {DIPOLE_GATHER_SUMS, ReadOnlyStorageBuffer},
                                {DIPOLE_GATHER_DIFFUSION, ReadWriteStorageTexture}});
    irradiance_ = BrdfPipeline(device, "irradiance", irradiance_spv, {geometryLayout, irradianceLayout_},
                               sizeof(kernel::IrradianceBlock));
    gather_ = makePipeline(device, "dipole_gather", dipole_gather_spv, {geometryLayout, gatherLayout_},
                           sizeof(kernel::DipoleGatherBlock));
}

SurfacePoints TranslucencyPass::upload(const core::SurfaceSamples& samples) const {
    // Samples lie along a curve over the surface. Steps of about the golden ratio through that curve, coprime with the
    // number of samples, visit each once and spread evenly at any time: a partial sum is a coarse picture, not a part.
    const auto count = static_cast<std::uint32_t>(samples.samples.size());
    std::uint32_t step = static_cast<std::uint32_t>(static_cast<double>(count) * 0.6180339887498949) + 1;
    while (std::gcd(step, std::max(count, 1u)) != 1) ++step;
    std::vector<kernel::SurfacePoint> points(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto id = static_cast<std::uint32_t>(std::uint64_t{i} * step % count);
        const core::SurfaceSample& s = samples.samples[id];
        points[i].position = {s.position.x(), s.position.y(), s.position.z(), static_cast<float>(id)};
        points[i].normal = {s.normal.x(), s.normal.y(), s.normal.z(), 0};
    }
    return {
        .points = makeBuffer(device_, "surface points", gpu::BufferUsage::Storage, points),
        .sums = makeBuffer(device_, "surface irradiance", gpu::BufferUsage::Storage, std::vector<kernel::vec4>(count)),
        .count = count,
        .area = static_cast<float>(samples.area),
        .smoothing = core::smoothedFor(samples, {}).zr.w};
}

gpu::BindGroup TranslucencyPass::bindIrradiance(const PathInputs& inputs, const SurfacePoints& points) const {
    return device_.createBindGroup({.label = "irradiance",
                                    .layout = irradianceLayout_,
                                    .entries = {{.binding = IRRADIANCE_SHADING, .buffer = inputs.shading},
                                                {.binding = IRRADIANCE_DROPPED, .buffer = inputs.dropped},
                                                {.binding = IRRADIANCE_POINTS, .buffer = points.points},
                                                {.binding = IRRADIANCE_SUMS, .buffer = points.sums},
                                                {.binding = IRRADIANCE_DRIVES, .buffer = inputs.drives},
                                                {.binding = IRRADIANCE_DRIVE_VALUES, .buffer = inputs.driveValues},
                                                {.binding = MEASURED_TABLES, .buffer = inputs.measured}}});
}

gpu::BindGroup TranslucencyPass::bindGather(const gpu::Buffer& dipole, const PixelList& pixels,
                                            const SurfacePoints& points, const Targets& targets) const {
    return device_.createBindGroup(
        {.label = "dipole_gather",
         .layout = gatherLayout_,
         .entries = {{.binding = DIPOLE_GATHER_PARAMS, .buffer = dipole},
                     {.binding = DIPOLE_GATHER_PIXELS, .buffer = pixels.buffer},
                     {.binding = DIPOLE_GATHER_POINTS, .buffer = points.points},
                     {.binding = DIPOLE_GATHER_SUMS, .buffer = points.sums},
                     {.binding = DIPOLE_GATHER_DIFFUSION, .textureView = targets.diffusion.createView()}}});
}

void TranslucencyPass::record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const gpu::BindGroup& group,
                              const kernel::IrradianceBlock& block) const {
    recordList(encoder, "irradiance", irradiance_.pipeline(), geometry, group, block, block.pointCount);
}

void TranslucencyPass::record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const gpu::BindGroup& group,
                              const kernel::DipoleGatherBlock& block) const {
    recordList(encoder, "dipole_gather", gather_, geometry, group, block, block.pixelCount);
}

}  // namespace render
