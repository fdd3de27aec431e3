// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/directional_map.h"
#include "core/base/image.h"
#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/geometry/depth_layers.h"
#include "core/geometry/march.h"
#include "core/geometry/surface.h"

namespace core {

namespace analysis {
class DirectionTree;  // core/analysis/light/shepard.h
struct FilterPass;    // core/analysis/depth/filter_depth.h
struct MembraneRow;   // core/analysis/light/sphere_membrane.h
struct SurfaceInput;  // core/analysis/depth/normals.h
}  // namespace analysis

/// The expensive, data-parallel parts of the analysis, one virtual function each, so that a device can run them. Steps
/// reach them through their StepContext. The CPU's versions (`cpuAnalysisKernels`) are specified by the headers of the
/// steps; they are independent of any device and serve as the reference for other implementations, which must
/// - return the CPU's result within rounding, and the same bytes every time,
/// - call `checkpoint` every few hundredths of a second, and let Error(Cancelled) through,
/// - never fail because of the device: without memory or device they continue on the CPU and leave a note.
/// One analysis at a time, on one thread.
class AnalysisKernels {
  public:
    AnalysisKernels() = default;
    virtual ~AnalysisKernels() = default;
    AnalysisKernels(const AnalysisKernels&) = delete;
    AnalysisKernels& operator=(const AnalysisKernels&) = delete;

    /// Passes of the depth filter over one picture.
    class DepthFilter {
      public:
        virtual ~DepthFilter() = default;
        /// analysis::runFilterPass.
        [[nodiscard]] virtual ImageF run(const analysis::FilterPass& pass, const ImageF& inverseDepth,
                                         const Progress& progress) = 0;
    };
    /// `color` (analysis::encodeColor) and `labels` must outlive the result.
    [[nodiscard]] virtual std::unique_ptr<DepthFilter> depthFilter(const Image<std::uint32_t>& color,
                                                                   const LabelImage& labels) = 0;

    /// analysis::computeSurface.
    virtual void computeSurface(const analysis::SurfaceInput& input, Surface& surface, const Progress& progress) = 0;

    /// Rays through one set of depth layers.
    class RayMarcher {
      public:
        virtual ~RayMarcher() = default;
        /// Results of MarchPyramid(layers, without).march for every ray in order. A ray whose direction is zero hits
        /// nothing.
        [[nodiscard]] virtual std::vector<std::optional<MarchHit>> march(std::span<const MarchRay> rays,
                                                                         std::uint16_t without,
                                                                         const Progress& progress) = 0;
    };
    /// `layers` must outlive the result; one at a time.
    [[nodiscard]] virtual std::unique_ptr<RayMarcher> rayMarcher(const DepthLayers& layers) = 0;

    /// analysis::relaxMembrane.
    virtual void relaxMembrane(const ImageF& coverage, std::span<const analysis::MembraneRow> rows, ImageRgb& values,
                               const Progress& progress) = 0;

    /// analysis::fillShepard.
    virtual void fillShepard(const analysis::DirectionTree& tree, DirectionalMap& map, const Progress& progress) = 0;

    /// Full sentences about what did not go as requested since the last call, such as a fallback to the CPU.
    [[nodiscard]] virtual Notes takeNotes() { return {}; }
};

/// Everything on the CPU, on all cores. Stateless: any number of analyses may use it at once.
[[nodiscard]] AnalysisKernels& cpuAnalysisKernels();

}  // namespace core
