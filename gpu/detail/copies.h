// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "gpu/detail/resources.h"
#include "gpu/texture.h"

namespace gpu::detail {

/// Throws unless the buffer has the usage and the range; `action` completes "needs usage X for ...".
void requireBufferRange(const BufferImpl& buffer, BufferUsage usage, std::uint64_t offset, std::uint64_t size,
                        const char* action);
void requireTextureRegion(const TextureImpl& texture, TextureUsage usage, const TexelCopyTextureInfo& place,
                          const Extent3D& size, const char* action);

}  // namespace gpu::detail
