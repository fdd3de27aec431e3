// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/analysis/kernels.h"
#include "gpu/device.h"

namespace render {

/// core::AnalysisKernels on a device of its own, the twins of the CPU's. Differences between the two
/// are those of rounding: a device may fuse, reorder and approximate what the CPU does in one order, and a comparison
/// may tip over where two sides are all but equal. tests/gpu/analysis_kernels_test.cpp states how much.
///
/// When a call of the device fails (no memory, device lost), the piece is done by the CPU, with a note; without memory
/// the next piece tries the device again, after anything else the CPU does all.
class GpuAnalysisKernels : public core::AnalysisKernels {
  public:
    /// Nothing is compiled before it is needed. The device belongs to the thread that runs the analysis.
    explicit GpuAnalysisKernels(const gpu::Device& device);
    ~GpuAnalysisKernels() override;

    [[nodiscard]] std::unique_ptr<DepthFilter> depthFilter(const core::Image<std::uint32_t>& color,
                                                           const core::LabelImage& labels) override;
    void computeSurface(const core::analysis::SurfaceInput& input, core::Surface& surface,
                        const core::Progress& progress) override;
    [[nodiscard]] std::unique_ptr<RayMarcher> rayMarcher(const core::DepthLayers& layers) override;
    void relaxMembrane(const core::ImageF& coverage, std::span<const core::analysis::MembraneRow> rows,
                       core::ImageRgb& values, const core::Progress& progress) override;
    void fillShepard(const core::analysis::DirectionTree& tree, core::DirectionalMap& map,
                     const core::Progress& progress) override;
    [[nodiscard]] core::Notes takeNotes() override;

  private:
    struct Impl;
    std::shared_ptr<Impl> impl_;
};

/// Who computes the dear pieces of the analysis. Automatic: the device when it is a real one; on a software device the
/// "GPU" is the same cores with more overhead, so the CPU's own code is the better one.
enum class AnalysisTwin { Automatic, Cpu, Gpu };

/// "auto", "cpu" or "gpu"; throws core::Error(Usage) that names `origin` for anything else.
[[nodiscard]] AnalysisTwin parseAnalysisTwin(const std::string& text, const std::string& origin);
/// PATINA_ANALYSIS, Automatic when unset or empty; throws as `parseAnalysisTwin`.
[[nodiscard]] AnalysisTwin analysisTwinFromEnvironment();

/// Kernels for this choice on a device of their own, chosen as gpu::Instance::requestAdapter does; nullptr = the CPU's.
/// Throws gpu::Error only for Gpu; Automatic takes the CPU when there is no device.
[[nodiscard]] std::unique_ptr<core::AnalysisKernels> createAnalysisKernels(AnalysisTwin twin,
                                                                           const std::string& deviceWish);

}  // namespace render
