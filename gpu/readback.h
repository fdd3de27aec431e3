// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/device.h"
#include "gpu/texture.h"

namespace gpu {

/// Blocking reads for tests, analysis and export: they submit a copy and wait for it. Not for frames of a window.

/// Bytes of a range of a buffer (usage CopySrc).
void readBufferBytes(const Device& device, const Buffer& buffer, std::uint64_t offset, void* destination,
                     std::size_t size);

/// `count` values from byte `offset`.
template <class T>
requires std::is_trivially_copyable_v<T>
[[nodiscard]] std::vector<T> readBuffer(const Device& device, const Buffer& buffer, std::uint64_t offset,
                                        std::size_t count) {
    std::vector<T> values(count);
    readBufferBytes(device, buffer, offset, values.data(), count * sizeof(T));
    return values;
}

/// One level of a texture (usage CopySrc), rows tightly packed from the top.
[[nodiscard]] std::vector<std::byte> readTexture(const Device& device, const Texture& texture,
                                                 std::uint32_t mipLevel = 0);

/// Same as values, for example floats: 4 per texel for rgba32float. Throws Error(Validation) when sizeof(T) does not
/// divide the texel size.
template <class T>
requires std::is_trivially_copyable_v<T>
[[nodiscard]] std::vector<T> readTexture(const Device& device, const Texture& texture, std::uint32_t mipLevel = 0);

namespace detail {
void readTextureInto(const Device& device, const Texture& texture, std::uint32_t mipLevel, void* destination);
[[nodiscard]] std::size_t textureLevelBytes(const Texture& texture, std::uint32_t mipLevel, std::size_t elementSize);
}  // namespace detail

template <class T>
requires std::is_trivially_copyable_v<T> std::vector<T> readTexture(const Device& device, const Texture& texture,
                                                                    std::uint32_t mipLevel) {
    std::vector<T> values(detail::textureLevelBytes(texture, mipLevel, sizeof(T)) / sizeof(T));
    detail::readTextureInto(device, texture, mipLevel, values.data());
    return values;
}

}  // namespace gpu
