// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/backdrop.h"

namespace render {

bool Backdrop::record(const gpu::CommandEncoder& encoder, const gpu::Texture& photo, const Key& key) {
    if (current(key)) return false;
    encoder.copyTextureToTexture({.texture = photo}, {.texture = key.result}, {photo.width(), photo.height()});
    key_ = key;
    ++version_;
    return true;
}

}  // namespace render
