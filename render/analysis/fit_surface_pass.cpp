// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/analysis/fit_surface_pass.h"

#include <algorithm>
#include <vector>

#include "core/analysis/depth/depth_noise.h"
#include "gpu/readback.h"
#include "kernels/fit_surface.h"
#include "render/analysis/slice_buffers.h"
#include "render/kernels/kernels.h"
#include "shaders/shared/fit_surface_block.h"

namespace render {

FitSurfacePass::FitSurfacePass(const gpu::Device& device) : device_(device) {
    using enum gpu::BindingType;
    layout_ = makeLayout(device, "fit_surface",
                         {{FIT_SURFACE_DEPTH, ReadOnlyStorageBuffer},
                          {FIT_SURFACE_LABELS, ReadOnlyStorageBuffer},
                          {FIT_SURFACE_TAPS, ReadOnlyStorageBuffer},
                          {FIT_SURFACE_KNOWN, ReadOnlyStorageBuffer},
                          {FIT_SURFACE_RESULT, StorageBuffer}});
    pipeline_ = makePipeline(device, "fit_surface", fit_surface_spv, {layout_}, sizeof(kernel::FitSurfaceBlock));
}

void FitSurfacePass::run(const core::analysis::SurfaceInput& input, core::Surface& surface, SliceRunner& slices,
                         const core::Progress& progress) const {
    constexpr std::uint64_t kValues = 7;
    const core::Camera& camera = input.camera;
    const core::ImageF inverseDepth = core::analysis::inverseOf(surface.depth);
    std::vector<float> taps;
    for (const core::analysis::NormalTap& tap : core::analysis::normalTaps(camera, input.relativeNoise))
        taps.insert(taps.end(), {static_cast<float>(tap.dx), static_cast<float>(tap.dy), tap.weight, tap.inverseLimit});
    const core::ImageV3 none;
    const core::ImageV3& known = input.known != nullptr ? *input.known : none;

    const std::uint64_t most = std::min<std::uint64_t>(kMaxPixels, surface.depth.size());
    const gpu::Buffer resultSlice = resultBuffer(device_, "surface", most * kValues * sizeof(float));
    const gpu::BindGroup group = device_.createBindGroup(
        {.label = "fit_surface",
         .layout = layout_,
         .entries = {{.binding = FIT_SURFACE_DEPTH, .buffer = uploadImage(device_, "surface depth", inverseDepth)},
                     {.binding = FIT_SURFACE_LABELS, .buffer = uploadImage(device_, "surface labels", input.labels)},
                     {.binding = FIT_SURFACE_TAPS,
                      .buffer = makeBuffer(device_, "surface taps", gpu::BufferUsage::Storage, taps)},
                     {.binding = FIT_SURFACE_KNOWN, .buffer = uploadImage(device_, "known normals", known)},
                     {.binding = FIT_SURFACE_RESULT, .buffer = resultSlice}}});
    surface.normal = core::ImageV3(surface.depth.width(), surface.depth.height());
    surface.position = surface.normal;
    surface.area = core::ImageF(surface.depth.width(), surface.depth.height());
    std::vector<float> values;
    slices.run(
        progress, "fit_surface", surface.depth.size(), kMinPixels, most, [&](std::uint64_t first, std::uint64_t count) {
            const kernel::FitSurfaceBlock block{.camera = {camera.fx, camera.fy, camera.cx, camera.cy},
                                                .width = static_cast<kernel::uint>(surface.depth.width()),
                                                .height = static_cast<kernel::uint>(surface.depth.height()),
                                                .first = static_cast<kernel::uint>(first),
                                                .count = static_cast<kernel::uint>(count),
                                                .tapCount = static_cast<kernel::uint>(taps.size() / 4),
                                                .hasKnown = input.known != nullptr ? 1u : 0u,
                                                .relativeNoise = input.relativeNoise,
                                                .sign = input.side == core::analysis::Side::Front ? -1.0f : 1.0f};
            slices.submit("fit_surface", [&](const gpu::CommandEncoder& encoder) {
                recordSlice(encoder, device_, "fit_surface", pipeline_, group, block);
            });
            values.resize(count * kValues);
            gpu::readBufferBytes(device_, resultSlice, 0, values.data(), values.size() * sizeof(float));
            for (std::uint64_t i = 0; i < count; ++i) {
                const float* value = &values[i * kValues];
                surface.normal[first + i] = {value[0], value[1], value[2]};
                surface.position[first + i] = {value[3], value[4], value[5]};
                surface.area[first + i] = value[6];
            }
        });
}

}  // namespace render
