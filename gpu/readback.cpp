// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/readback.h"

#include <algorithm>
#include <cstring>

#include "gpu/detail/resources.h"
#include "gpu/detail/text.h"

namespace gpu {

namespace {

/// Submits the commands of `record`, which fill a readable buffer of `size` bytes, waits, and copies the bytes out.
template <class F>
void readThrough(const Device& device, std::size_t size, void* destination, F&& record) {
    const Buffer staging =
        device.createBuffer({.label = "readback", .size = size, .usage = BufferUsage::MapRead | BufferUsage::CopyDst});
    const CommandEncoder encoder = device.createCommandEncoder({.label = "readback"});
    record(encoder, staging);
    device.queue().submit(encoder.finish());
    bool mapped = false;
    staging.mapAsync(MapMode::Read, 0, size,
                     [&](MapAsyncStatus status, std::string_view) { mapped = status == MapAsyncStatus::Success; });
    device.waitIdle();
    if (!mapped) {
        throw Error(ErrorKind::Internal, "Reading back fails: the copy could not be mapped.");
    }
    std::memcpy(destination, staging.getConstMappedRange(), size);
    staging.unmap();
}

}  // namespace

void readBufferBytes(const Device& device, const Buffer& buffer, std::uint64_t offset, void* destination,
                     std::size_t size) {
    if (size == 0) return;
    readThrough(device, size, destination, [&](const CommandEncoder& encoder, const Buffer& staging) {
        encoder.copyBufferToBuffer(buffer, offset, staging, 0, size);
    });
}

std::size_t detail::textureLevelBytes(const Texture& texture, std::uint32_t mipLevel, std::size_t elementSize) {
    require(static_cast<bool>(texture), "The texture is an empty handle.");
    const std::size_t texel = texelSize(texture.format());
    require(texel % elementSize == 0, "Texture ", quoted(texture.label()), " has ", texel, " bytes a texel, which ",
            elementSize, " does not divide.");
    require(mipLevel < texture.mipLevelCount(), "Texture ", quoted(texture.label()), " has no level ", mipLevel,
            "; it has ", texture.mipLevelCount(), ".");
    return texel * std::max(1u, texture.width() >> mipLevel) * std::max(1u, texture.height() >> mipLevel);
}

void detail::readTextureInto(const Device& device, const Texture& texture, std::uint32_t mipLevel, void* destination) {
    const std::size_t size = textureLevelBytes(texture, mipLevel, 1);
    const Extent3D extent = {std::max(1u, texture.width() >> mipLevel), std::max(1u, texture.height() >> mipLevel), 1};
    readThrough(device, size, destination, [&](const CommandEncoder& encoder, const Buffer& staging) {
        encoder.copyTextureToBuffer({.texture = texture, .mipLevel = mipLevel, .origin = {}},
                                    {.buffer = staging, .layout = {}}, extent);
    });
}

std::vector<std::byte> readTexture(const Device& device, const Texture& texture, std::uint32_t mipLevel) {
    return readTexture<std::byte>(device, texture, mipLevel);
}

}  // namespace gpu
