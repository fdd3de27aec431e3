// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/image.h"
#include "gpu/device.h"
#include "render/kernels/kernels.h"

namespace render {

// Buffers and dispatches that the kernels of the analysis share.

/// Pixels of a first slice, whose cost is not known yet.
inline constexpr std::uint64_t kMinPixels = 1 << 13;
/// Pixels of any slice; bounds the memory of its result on the device.
inline constexpr std::uint64_t kMaxPixels = 1 << 20;

/// A storage buffer with these bytes, rounded up to whole words. Throws gpu::Error(OutOfMemory) where the device could
/// not bind it.
[[nodiscard]] gpu::Buffer uploadBytes(const gpu::Device& device, const char* label, const void* data,
                                      std::uint64_t size);

static_assert(sizeof(core::Vector3f) == 3 * sizeof(float), "kernels read vectors as three floats");
template <class T>
[[nodiscard]] gpu::Buffer uploadImage(const gpu::Device& device, const char* label, const core::Image<T>& image) {
    return uploadBytes(device, label, image.data(), image.size() * sizeof(T));
}

/// Buffer that a slice writes, of `size` bytes.
[[nodiscard]] gpu::Buffer resultBuffer(const gpu::Device& device, const char* label, std::uint64_t size);

void dispatchList(const gpu::Device& device, const gpu::ComputePassEncoder& pass, std::uint64_t count);

/// One dispatch over `block.count` items.
template <class Block>
void recordSlice(const gpu::CommandEncoder& encoder, const gpu::Device& device, const char* label,
                 const gpu::ComputePipeline& pipeline, const gpu::BindGroup& group, const Block& block) {
    const gpu::ComputePassEncoder pass = encoder.beginComputePass({.label = label});
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, group);
    pass.setImmediates(0, block);
    dispatchList(device, pass, block.count);
    pass.end();
}

}  // namespace render
