// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/detail/copies.h"

namespace gpu::detail {

void requireBufferRange(const BufferImpl& buffer, BufferUsage usage, std::uint64_t offset, std::uint64_t size,
                        const char* action) {
    require(has(buffer.usage, usage), "Buffer ", quoted(buffer.label()), " has usage ", toString(buffer.usage), "; ",
            action, " needs ", toString(usage), ".");
    require(offset <= buffer.size && size <= buffer.size - offset, size, " bytes at byte ", offset, " of buffer ",
            quoted(buffer.label()), " go past its ", buffer.size, " bytes.");
}

void requireTextureRegion(const TextureImpl& texture, TextureUsage usage, const TexelCopyTextureInfo& place,
                          const Extent3D& size, const char* action) {
    require(has(texture.usage, usage), "Texture ", quoted(texture.label()), " has usage ", toString(texture.usage),
            "; ", action, " needs ", toString(usage), ".");
    require(place.mipLevel < texture.mipLevelCount, "Texture ", quoted(texture.label()), " has no level ",
            place.mipLevel, "; it has ", texture.mipLevelCount, ".");
    const std::uint32_t width = texture.mipWidth(place.mipLevel);
    const std::uint32_t height = texture.mipHeight(place.mipLevel);
    require(place.origin.z == 0 && size.depthOrArrayLayers == 1 && place.origin.x <= width &&
                size.width <= width - place.origin.x && place.origin.y <= height &&
                size.height <= height - place.origin.y,
            "A region of ", size.width, "x", size.height, "x", size.depthOrArrayLayers, " texels at (", place.origin.x,
            ", ", place.origin.y, ", ", place.origin.z, ") goes past level ", place.mipLevel, " of texture ",
            quoted(texture.label()), " (", width, "x", height, ").");
}

}  // namespace gpu::detail
