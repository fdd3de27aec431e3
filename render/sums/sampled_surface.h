// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <future>
#include <memory>

#include "core/shading/surface_samples.h"
#include "render/render_context.h"
#include "render/shaded_scene.h"

namespace render {

/// Samples of a translucent segment's surface and the grids over them, made on another thread; made again when the key
/// changes.
class SampledSurface {
  public:
    struct Key {
        PictureLayers layers;
        std::uint16_t label = 0;
        std::uint32_t seed = 0;
        int samples = 0;
        core::DiffusionQuality quality = core::DiffusionQuality::Standard;
        bool operator==(const Key&) const = default;
    };

    /// Drops the surface or does nothing.
    void follow(const Key& key);
    /// Begins to make what is missing and takes over what is finished.
    void prepare(RenderContext& context, const ShadedScene& shaded);
    /// True while samples are being made, after waiting for them for up to `seconds`.
    [[nodiscard]] bool await(double seconds) const;

    [[nodiscard]] bool ready() const { return made_ == version_ && !pending_.valid(); }
    /// None until it is ready.
    [[nodiscard]] const SurfacePoints& points() const { return points_; }
    [[nodiscard]] const core::SurfaceSamples& samples() const { return samples_; }
    [[nodiscard]] DiffusionGrids& grids() { return grids_; }
    /// Number of times that the key has changed.
    [[nodiscard]] std::uint64_t version() const { return version_; }

  private:
    struct Made {
        core::SurfaceSamples samples;
        core::DiffusionGrid grid;
    };
    static Made make(const Key& key, const core::Analysis& analysis);

    Key key_;
    std::uint64_t version_ = 0;
    std::uint64_t making_ = 0;   ///< version that was begun last
    std::uint64_t made_ = 0;     ///< version that was completed last
    std::future<Made> pending_;  ///< valid while one is being made
    core::SurfaceSamples samples_;
    SurfacePoints points_;
    DiffusionGrids grids_;
};

}  // namespace render
