// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/analysis/relax_membrane_pass.h"

#include <vector>

#include "gpu/readback.h"
#include "kernels/relax_membrane.h"
#include "render/analysis/slice_buffers.h"
#include "render/kernels/kernels.h"
#include "shaders/shared/relax_membrane_block.h"

namespace render {

RelaxMembranePass::RelaxMembranePass(const gpu::Device& device) : device_(device) {
    using enum gpu::BindingType;
    layout_ = makeLayout(device, "relax_membrane",
                         {{RELAX_MEMBRANE_ROWS, ReadOnlyStorageBuffer}, {RELAX_MEMBRANE_VALUES, StorageBuffer}});
    pipeline_ =
        makePipeline(device, "relax_membrane", relax_membrane_spv, {layout_}, sizeof(kernel::RelaxMembraneBlock));
}

void RelaxMembranePass::run(const core::ImageF& coverage, std::span<const core::analysis::MembraneRow> rows,
                            core::ImageRgb& values, SliceRunner& slices, const core::Progress& progress) const {
    std::vector<kernel::vec4> packed(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        packed[i] = {values[i].x(), values[i].y(), values[i].z(), coverage[i] > 0 ? 1.0f : 0.0f};
    std::vector<kernel::vec4> coefficients;
    for (const core::analysis::MembraneRow& row : rows)
        coefficients.emplace_back(row.up, row.down, row.side, row.scale);
    const gpu::Buffer state = uploadBytes(device_, "membrane", packed.data(), packed.size() * sizeof(kernel::vec4));
    const gpu::BindGroup group = device_.createBindGroup(
        {.label = "relax_membrane",
         .layout = layout_,
         .entries = {{.binding = RELAX_MEMBRANE_ROWS,
                      .buffer = makeBuffer(device_, "membrane rows", gpu::BufferUsage::Storage, coefficients)},
                     {.binding = RELAX_MEMBRANE_VALUES, .buffer = state}}});
    // A unit is a texel of a sweep, so that maps of all sizes share one measured cost; slices are whole sweeps.
    const std::uint64_t texels = values.size();
    const auto sweeps = static_cast<std::uint64_t>(core::analysis::kMembraneSweeps);
    std::uint64_t done = 0;
    slices.run(progress, "relax_membrane", texels * sweeps, texels, texels * sweeps,
               [&](std::uint64_t first, std::uint64_t count) {
                   const std::uint64_t last = (first + count + texels - 1) / texels;
                   slices.submit("relax_membrane", [&](const gpu::CommandEncoder& encoder) {
                       const gpu::ComputePassEncoder pass = encoder.beginComputePass({.label = "relax_membrane"});
                       pass.setPipeline(pipeline_);
                       pass.setBindGroup(0, group);
                       for (; done < last; ++done) {
                           for (kernel::uint parity = 0; parity < 2; ++parity) {
                               const kernel::RelaxMembraneBlock block{
                                   .width = static_cast<kernel::uint>(values.width()),
                                   .height = static_cast<kernel::uint>(values.height()),
                                   .parity = parity,
                                   .overRelaxation = core::analysis::kMembraneOverRelaxation};
                               pass.setImmediates(0, block);
                               dispatchList(device_, pass, texels / 2);
                           }
                       }
                       pass.end();
                   });
               });
    gpu::readBufferBytes(device_, state, 0, packed.data(), packed.size() * sizeof(kernel::vec4));
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!(coverage[i] > 0)) values[i] = {packed[i].x, packed[i].y, packed[i].z};
}

}  // namespace render
