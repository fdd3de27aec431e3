// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/passes/translucency_pass.h"

#include "core/shading/surface_samples.h"
#include "kernels/irradiance.h"
#include "render/kernels/kernels.h"
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
    irradiance_ = BrdfPipeline(device, "irradiance", irradiance_spv, {geometryLayout, irradianceLayout_},
                               sizeof(kernel::IrradianceBlock));
}

SurfacePoints TranslucencyPass::upload(const core::SurfaceSamples& samples) const {
    const auto count = static_cast<std::uint32_t>(samples.samples.size());
    std::vector<kernel::SurfacePoint> points(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const core::SurfaceSample& s = samples.samples[i];
        points[i].position = {s.position.x(), s.position.y(), s.position.z(), static_cast<float>(i)};
        points[i].normal = {s.normal.x(), s.normal.y(), s.normal.z(), 0};
    }
    return {
        .points = makeBuffer(device_, "surface points", gpu::BufferUsage::Storage, points),
        .sums = makeBuffer(device_, "surface irradiance", gpu::BufferUsage::Storage, std::vector<kernel::vec4>(count)),
        .count = count,
        .area = samples.area};
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

void TranslucencyPass::record(const gpu::CommandEncoder& encoder, SceneGeometry& geometry, const gpu::BindGroup& group,
                              const kernel::IrradianceBlock& block) const {
    recordList(encoder, "irradiance", irradiance_.pipeline(), geometry, group, block, block.pointCount);
}

}  // namespace render
