// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "gpu/handle.h"
#include "gpu/types.h"

namespace gpu {

struct TextureDescriptor {
    std::string label = {};
    Extent3D size = {};  ///< texels of level 0
    TextureFormat format = TextureFormat::Undefined;
    TextureUsage usage = TextureUsage::None;
    std::uint32_t mipLevelCount = 1;
};

struct TextureViewDescriptor {
    std::string label = {};
    std::uint32_t baseMipLevel = 0;
    std::uint32_t mipLevelCount = kAllMipLevels;
};

/// Some levels of a texture, for a shader or an attachment. A storage or attachment view has one level.
class TextureView : public Handle<detail::TextureViewImpl> {
  public:
    using Handle::Handle;

    [[nodiscard]] std::uint32_t baseMipLevel() const;
    [[nodiscard]] std::uint32_t mipLevelCount() const;
    [[nodiscard]] std::uint32_t width() const;   ///< texels of the base level
    [[nodiscard]] std::uint32_t height() const;  ///< texels of the base level
    [[nodiscard]] TextureFormat format() const;
};

/// A two-dimensional image with mip levels, zero when new.
class Texture : public Handle<detail::TextureImpl> {
  public:
    using Handle::Handle;

    [[nodiscard]] std::uint32_t width() const;
    [[nodiscard]] std::uint32_t height() const;
    [[nodiscard]] std::uint32_t mipLevelCount() const;
    [[nodiscard]] TextureFormat format() const;
    [[nodiscard]] TextureUsage usage() const;
    [[nodiscard]] const std::string& label() const;

    [[nodiscard]] TextureView createView(const TextureViewDescriptor& descriptor = {}) const;
    /// A view of one level.
    [[nodiscard]] TextureView mipView(std::uint32_t level) const {
        return createView({.label = {}, .baseMipLevel = level, .mipLevelCount = 1});
    }
};

/// Location in a texture for a copy.
struct TexelCopyTextureInfo {
    Texture texture = {};
    std::uint32_t mipLevel = 0;
    Origin3D origin = {};
};

/// Layout of texels in a buffer or in memory.
struct TexelCopyBufferLayout {
    std::uint64_t offset = 0;       ///< bytes; a multiple of the texel size and of 4
    std::uint32_t bytesPerRow = 0;  ///< a multiple of the texel size; 0 = tightly packed
};

}  // namespace gpu
