// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/passes/segment_targets.h"

namespace render {

void fitTargets(Targets& targets, const gpu::Device& device, std::uint32_t width, std::uint32_t height,
                const TargetUses& uses) {
    const auto make = [&](const char* label, std::uint32_t w, std::uint32_t h,
                          gpu::TextureFormat format = gpu::TextureFormat::RGBA32Float) {
        return device.createTexture({.label = label,
                                     .size = {w, h},
                                     .format = format,
                                     .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::StorageBinding |
                                              gpu::TextureUsage::CopySrc | gpu::TextureUsage::CopyDst});
    };
    const auto fits = [&](const gpu::Texture& t) { return t && t.width() == width && t.height() == height; };
    if (!fits(targets.result)) {
        targets = {};
        targets.accumulation = make("accumulation", width, height);
        targets.count = make("sample count", width, height, gpu::TextureFormat::R32Float);
        targets.result = make("result", width, height);
        targets.filtered = make("filtered", 1, 1);
        targets.diffusion = make("diffusion", 1, 1);
    }
    if (uses.filter && !fits(targets.filtered)) {
        targets.filtered = make("filtered", width, height);
        targets.filterPing = make("filter scratch 1", width, height);
        targets.filterPong = make("filter scratch 2", width, height);
    }
    if (uses.translucency && !fits(targets.diffusion)) targets.diffusion = make("diffusion", width, height);
}

}  // namespace render
