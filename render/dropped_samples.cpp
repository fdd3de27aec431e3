// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/dropped_samples.h"

#include <vector>

#include "render/kernels/kernels.h"
#include "shaders/shared/interop.h"

namespace render {

DroppedSamples::DroppedSamples(const gpu::Device& device)
    : count_(makeBuffer(device, "dropped samples", gpu::BufferUsage::Storage, std::vector<kernel::uint>{0})) {
    reader_->staging = device.createBuffer({.label = "dropped samples, read back",
                                            .size = sizeof(kernel::uint),
                                            .usage = gpu::BufferUsage::MapRead | gpu::BufferUsage::CopyDst});
}

bool DroppedSamples::record(const gpu::CommandEncoder& encoder) {
    if (reader_->pending || !reader_->unread) return reader_->unread;
    reader_->unread = false;
    reader_->pending = true;
    encoder.copyBufferToBuffer(count_, 0, reader_->staging, 0, sizeof(kernel::uint));
    encoder.onCompleted([reader = reader_] {
        reader->staging.mapAsync(
            gpu::MapMode::Read, 0, gpu::kWholeSize, [reader](gpu::MapAsyncStatus status, std::string_view) {
                reader->pending = false;
                if (status != gpu::MapAsyncStatus::Success) return;
                reader->value = *static_cast<const kernel::uint*>(reader->staging.getConstMappedRange());
                reader->staging.unmap();
            });
    });
    return false;
}

}  // namespace render
