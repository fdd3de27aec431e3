// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/kernels/drive_buffers.h"

#include <algorithm>
#include <tuple>

#include "core/shading/drive_table.h"
#include "render/kernels/kernels.h"

namespace render {
namespace {

bool samePlace(const core::DrivePlane& a, const core::DrivePlane& b) {
    return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height && a.offset == b.offset;
}

}  // namespace

void DriveBuffers::upload(const gpu::Device& device, const core::DriveTable& table) {
    if (!drives_ || drives_.size() < table.drives.size() * sizeof(kernel::Drive))
        drives_ = makeBuffer(device, "drives", gpu::BufferUsage::Storage, table.drives);
    else if (!table.empty())
        device.queue().writeBuffer(drives_, 0, table.drives);
    const bool inPlace =
        values_ && std::equal(table.planes.begin(), table.planes.end(), planes_.begin(), planes_.end(), samePlace);
    if (inPlace)
        writeChangedRows(device, table);
    else
        values_ = makeBuffer(device, "drive values", gpu::BufferUsage::Storage, table.values());
    planes_ = table.planes;
}

void DriveBuffers::writeChangedRows(const gpu::Device& device, const core::DriveTable& table) {
    for (std::size_t i = 0; i < table.planes.size(); ++i) {
        const core::DrivePlane& plane = table.planes[i];
        const core::DrivePlane& old = planes_[i];
        if (plane.mask == old.mask && plane.detail == old.detail) continue;
        int first = plane.y;
        int last = plane.y + plane.height;
        if (plane.mask && old.mask) std::tie(first, last) = plane.mask->changedRows(*old.mask);
        first = std::max(first - plane.y, 0);
        last = std::min(last - plane.y, plane.height);
        if (first >= last) continue;
        const auto width = static_cast<std::size_t>(plane.width);
        std::vector<float> rows(width * static_cast<std::size_t>(last - first));
        plane.copyRows(first, last - first, rows);
        device.queue().writeBuffer(values_, (plane.offset + width * static_cast<std::size_t>(first)) * sizeof(float),
                                   rows);
    }
}

}  // namespace render
