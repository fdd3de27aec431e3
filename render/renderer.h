// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/base/progress.h"
#include "core/scene/scene.h"
#include "core/shading/environment_sampler.h"
#include "gpu/command_encoder.h"
#include "gpu/device.h"
#include "gpu/texture.h"
#include "render/passes/segment_targets.h"

namespace render {

/// Progressive renderer of the edits: re-shading (docs/method.md#re-shading), translucency (#translucency), filter and
/// composite.
///
/// It records, its caller submits: the window to the device that draws its frames, headless a loop to a device of its
/// own. One thread. The same seed and scene give the same pixels on any schedule of slices.
class Renderer {
  public:
    /// `lightSampling` changes the noise of a picture, not what it tends to.
    explicit Renderer(gpu::Device device, core::LightSampling lightSampling = core::LightSampling::Both);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// What to render from now on. Compares with what it has: a new analysis uploads geometry, a changed edit restarts
    /// that segment's accumulation, changed blend weights restart nothing. With more than one bounce, paths that start
    /// on one segment may meet the others (and itself) and see their materials and weights, so then any change of a
    /// material restarts all. Uploads happen in the next `record`s. Throws core::Error(Usage) for an unknown BRDF and
    /// gpu::Error(OutOfMemory) for a picture the device has no room for; the renderer then keeps what it had.
    void setScene(const core::Scene& scene, std::shared_ptr<const core::Analysis> analysis);

    /// Writes the next slice of work, sized for `budgetSeconds` of device time by what earlier slices took, and the
    /// composite of all that is accumulated so far. Returns false when there was nothing left to do.
    bool record(gpu::CommandEncoder& encoder, double budgetSeconds);

    /// False: after the first picture of a change nothing is refined, until it is true again, as it is at first.
    void setRefining(bool refining);

    struct SegmentProgress {
        std::uint16_t label = 0;
        int samples = 0;            ///< completed samples per pixel
        int irradianceSamples = 0;  ///< surface samples lit; 0 without translucency
        int gatheredSamples = 0;    ///< surface samples gathered on every pixel
    };
    struct Progress {
        int samples = 0;  ///< completed samples per pixel, the least over all edited segments
        int target = 0;
        bool finished = false;
        bool timeUp = false;               ///< finished by the time limit, before the target
        bool waiting = false;              ///< the last `record` changed nothing: kernels or samples are made on other
                                           ///< threads, or a new picture is being uploaded
        float fraction = 0;                ///< of all work, [0, 1]
        std::uint64_t droppedSamples = 0;  ///< NaN or Inf paths left out, as far as the device has reported; must be 0
        std::vector<SegmentProgress> segments;  ///< the edited segments, by label
    };
    [[nodiscard]] Progress progress() const;

    /// The edited photograph so far: rgba32float, scene-linear, the photo's size, usages TextureBinding and CopySrc.
    /// An empty handle until the kernels are compiled, which `record` does not wait for; another texture when the
    /// photo's size changes.
    [[nodiscard]] gpu::Texture result() const;
    /// Where the last `record` changes the result.
    [[nodiscard]] PixelBounds changed() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The edited photograph so far, once `renderer` has recorded; waits for the device.
[[nodiscard]] core::ImageRgb readResult(const gpu::Device& device, const Renderer& renderer);

/// Renders to the end on `device` and returns the edited photograph; `reached`, if given, gets how far that was.
[[nodiscard]] core::ImageRgb renderImage(gpu::Device device, const core::Scene& scene,
                                         const std::shared_ptr<const core::Analysis>& analysis,
                                         const core::Progress& progress = {}, Renderer::Progress* reached = nullptr);

}  // namespace render
