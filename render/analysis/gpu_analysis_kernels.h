// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/analysis/kernels.h"
#include "gpu/device.h"

namespace render {

/// core::AnalysisKernels on a device of its own, twins of those on the CPU. Results differ by rounding: a device may
/// fuse, reorder and approximate operations, and a comparison of nearly equal numbers may then go the other way.
/// tests/gpu/analysis_kernels_test.cpp states the bounds.
///
/// When a call fails on the device (no memory, device lost), the CPU repeats it, with a note. After a lack of memory
/// later calls try the device again; after any other failure the CPU does the rest.
class GpuAnalysisKernels : public core::AnalysisKernels {
  public:
    /// Compiles each kernel at its first use. The device belongs to the thread that runs the analysis.
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

/// Which processor runs the expensive stages of the analysis. Automatic: the device, unless it is a software device,
/// which is the same cores with more overhead.
enum class AnalysisTwin { Automatic, Cpu, Gpu };

/// "auto", "cpu" or "gpu"; throws core::Error(Usage) that names `origin` for anything else.
[[nodiscard]] AnalysisTwin parseAnalysisTwin(const std::string& text, const std::string& origin);
/// PATINA_ANALYSIS, Automatic when unset or empty; throws as `parseAnalysisTwin`.
[[nodiscard]] AnalysisTwin analysisTwinFromEnvironment();

/// Kernels for this choice on a device of their own, which gpu::Instance::requestAdapter chooses; nullptr = the CPU's.
/// Throws gpu::Error only for Gpu; Automatic takes the CPU when there is no device.
[[nodiscard]] std::unique_ptr<core::AnalysisKernels> createAnalysisKernels(AnalysisTwin twin,
                                                                           const std::string& deviceWish);

}  // namespace render
