// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/kernels/measured_tables.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/material/brdf_file.h"
#include "render/kernels/kernels.h"
#include "shaders/brdf/registry.h"

namespace render {

MeasuredFiles placeMeasured(const core::Scene& scene, std::span<kernel::SegmentShading> shading) {
    MeasuredFiles files;
    for (const core::Segment& segment : scene.segments) {
        if (!segment.edit || !core::usable(*segment.edit) || !segment.edit->brdfFile) continue;
        const auto& measured = segment.edit->brdfFile->measured;
        if (!measured) continue;
        const auto found = std::find(files.begin(), files.end(), measured);
        shading[segment.label].brdf.file = static_cast<std::uint32_t>(found - files.begin()) * kernel::kMeasuredSize;
        if (found == files.end()) files.push_back(measured);
    }
    return files;
}

void MeasuredTables::requireFits(const gpu::Device& device, const MeasuredFiles& files) {
    const std::uint64_t bytes = sizeof(float) * std::uint64_t{kernel::kMeasuredSize};
    const std::uint64_t most = device.limits().maxStorageBufferBindingSize / bytes;
    if (files.size() > most)
        throw core::Error(
            core::ErrorKind::Input,
            core::Message("messages",
                          "The edits use %1 measured BRDFs; this graphics device has room for %2 at a time.")
                .with(files.size(), most));
}

const gpu::Buffer& MeasuredTables::upload(const gpu::Device& device, const MeasuredFiles& files) {
    if (buffer_ && files == files_) return buffer_;
    files_ = files;
    buffer_ = {};
    buffer_ = device.createBuffer(
        {.label = "measured BRDFs",
         .size = std::max<std::uint64_t>(files_.size() * std::uint64_t{kernel::kMeasuredSize} * sizeof(float), 16),
         .usage = gpu::BufferUsage::Storage | gpu::BufferUsage::CopyDst});
    for (std::size_t i = 0; i < files_.size(); ++i)
        device.queue().writeBuffer(buffer_, i * std::uint64_t{kernel::kMeasuredSize} * sizeof(float),
                                   files_[i]->table.data(), files_[i]->table.size() * sizeof(float));
    return buffer_;
}

}  // namespace render
