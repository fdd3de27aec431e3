// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/base/pixel.h"
#include "core/base/progress.h"
#include "core/scene/scene.h"
#include "core/shading/environment_sampler.h"
#include "gpu/command_encoder.h"
#include "gpu/device.h"
#include "gpu/texture.h"

namespace render {

/// Progressive renderer of the edits: re-shading (docs/method.md#re-shading), translucency (#translucency), filter and
/// composite.
///
/// The renderer records and its caller submits: the window to the device that draws its frames, the command line to a
/// device of its own. One thread. The same seed and scene give the same pixels on any schedule of slices.
class Renderer {
  public:
    /// `lightSampling` changes the noise of a picture, not its expected value.
    explicit Renderer(gpu::Device device, core::LightSampling lightSampling = core::LightSampling::Both);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Sets the scene to render. Compared with the previous scene, a new analysis uploads geometry, a changed edit
    /// restarts that segment's sum, and changed blend weights restart nothing. With more than one bounce, paths that
    /// start on one segment may meet all segments and see their materials and weights, so any change of a material
    /// restarts all sums. Uploads happen in the next calls of `record`. Throws core::Error(Usage) for an unknown BRDF
    /// and gpu::Error(OutOfMemory) for a picture that exceeds the device; the renderer then keeps the previous scene.
    void setScene(const core::Scene& scene, std::shared_ptr<const core::Analysis> analysis);

    /// Records the next slice of work, sized for `budgetSeconds` of device time by the cost of earlier slices, and the
    /// composite of all sums so far. Returns false when there was nothing left to do.
    bool record(gpu::CommandEncoder& encoder, double budgetSeconds);

    /// Pauses (false) or resumes refinement after the first picture of a change; initially true.
    void setRefining(bool refining);

    struct SegmentProgress {
        std::uint16_t label = 0;
        int samples = 0;            ///< completed samples per pixel
        int irradianceSamples = 0;  ///< surface samples lit; 0 without translucency
        int gatheredSamples = 0;    ///< surface samples gathered on every pixel
    };
    struct Progress {
        int samples = 0;  ///< completed samples per pixel, minimum over all edited segments
        int target = 0;
        bool finished = false;
        bool timeUp = false;               ///< finished by the time limit, before the target
        bool waiting = false;              ///< the last `record` changed nothing, because kernels or samples are being
                                           ///< made on other threads or a new picture is being uploaded
        float fraction = 0;                ///< of all work, [0, 1]
        std::uint64_t droppedSamples = 0;  ///< NaN or Inf paths left out, as reported by the device so far; must be 0
        std::vector<SegmentProgress> segments;  ///< the edited segments, by label
    };
    [[nodiscard]] Progress progress() const;

    /// The edited photograph so far: rgba32float, scene-linear, the photo's size, usages TextureBinding and CopySrc.
    /// Empty until the kernels are compiled, for which `record` does not wait; replaced when the photo's size changes.
    [[nodiscard]] gpu::Texture result() const;
    /// Pixels of the result that the last `record` changes.
    [[nodiscard]] core::PixelBox changed() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The edited photograph so far; waits for the device. `renderer` must have a result.
[[nodiscard]] core::ImageRgb readResult(const gpu::Device& device, const Renderer& renderer);

/// Renders all samples on `device` and returns the edited photograph; sets `reached`, if given, to the final progress.
[[nodiscard]] core::ImageRgb renderImage(gpu::Device device, const core::Scene& scene,
                                         const std::shared_ptr<const core::Analysis>& analysis,
                                         const core::Progress& progress = {}, Renderer::Progress* reached = nullptr);

}  // namespace render
