// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/analysis/slice_buffers.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "gpu/adapter.h"

namespace render {

gpu::Buffer uploadBytes(const gpu::Device& device, const char* label, const void* data, std::uint64_t size) {
    const gpu::Limits& limits = device.limits();
    const std::uint64_t words = std::max<std::uint64_t>((size + 3) / 4, 4);
    if (4 * words > std::min(limits.maxStorageBufferBindingSize, limits.maxBufferSize))
        throw gpu::Error(gpu::ErrorKind::OutOfMemory,
                         "The buffer \"" + std::string(label) + "\" of the analysis needs " +
                             std::to_string(4 * words) + " bytes, but the device \"" + device.adapterInfo().name +
                             "\" binds at most " +
                             std::to_string(std::min(limits.maxStorageBufferBindingSize, limits.maxBufferSize)) + ".");
    const gpu::Buffer buffer = device.createBuffer(
        {.label = label,
         .size = 4 * words,
         .usage = gpu::BufferUsage::Storage | gpu::BufferUsage::CopyDst | gpu::BufferUsage::CopySrc});
    const std::uint64_t whole = size / 4 * 4;
    if (whole > 0) device.queue().writeBuffer(buffer, 0, data, whole);
    if (whole < size) {
        std::uint32_t rest = 0;
        std::memcpy(&rest, static_cast<const char*>(data) + whole, size - whole);
        device.queue().writeBuffer(buffer, whole, &rest, sizeof(rest));
    }
    return buffer;
}

gpu::Buffer resultBuffer(const gpu::Device& device, const char* label, std::uint64_t size) {
    return device.createBuffer({.label = label,
                                .size = std::max<std::uint64_t>(size, 16),
                                .usage = gpu::BufferUsage::Storage | gpu::BufferUsage::CopySrc});
}

void dispatchList(const gpu::Device& device, const gpu::ComputePassEncoder& pass, std::uint64_t count) {
    const ListGroups groups = listGroups(static_cast<std::uint32_t>(count), device.limits());
    pass.dispatchWorkgroups(groups.x, groups.y);
}

}  // namespace render
