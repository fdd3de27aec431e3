// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/directional_map.h"
#include "gpu/command_encoder.h"
#include "gpu/texture.h"
#include "render/shaded_scene.h"

namespace render {

/// The photograph in the result, over which edits are composited. Copied there again exactly when its key changes, so
/// that nothing remains of edits that no longer exist.
class Backdrop {
  public:
    struct Key {
        PictureLayers layers;
        std::shared_ptr<const core::DirectionalMap> environment;
        std::vector<std::pair<std::uint16_t, bool>> edited;  ///< labels in order; true: glossy, which moves the outline
        gpu::Texture result;
        bool operator==(const Key&) const = default;
    };

    [[nodiscard]] bool current(const Key& key) const { return key == key_; }
    /// Whether it is the photograph of these layers, whatever is composited over it.
    [[nodiscard]] bool shows(const PictureLayers& layers) const { return version_ > 0 && key_.layers == layers; }
    /// Copies `photo` into the result unless that is there already; true if it was not.
    bool record(const gpu::CommandEncoder& encoder, const gpu::Texture& photo, const Key& key);
    /// Number of copies made; everything composited has to be composited again after each.
    [[nodiscard]] std::uint64_t version() const { return version_; }

  private:
    Key key_;
    std::uint64_t version_ = 0;
};

}  // namespace render
