// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/kernels.h"

#include "core/analysis/depth/filter_depth.h"
#include "core/analysis/depth/normals.h"
#include "core/analysis/light/shepard.h"
#include "core/analysis/light/sphere_membrane.h"
#include "core/base/parallel.h"

namespace core {
namespace {

class CpuDepthFilter : public AnalysisKernels::DepthFilter {
  public:
    CpuDepthFilter(const Image<std::uint32_t>& color, const LabelImage& labels) : color_(color), labels_(labels) {}
    [[nodiscard]] ImageF run(const analysis::FilterPass& pass, const ImageF& inverseDepth,
                             const Progress& progress) override {
        return analysis::runFilterPass(pass, inverseDepth, color_, labels_, progress);
    }

  private:
    const Image<std::uint32_t>& color_;
    const LabelImage& labels_;
};

class CpuRayMarcher : public AnalysisKernels::RayMarcher {
  public:
    explicit CpuRayMarcher(const DepthLayers& layers) : layers_(layers), everything_(layers) {}

    [[nodiscard]] std::vector<std::optional<MarchHit>> march(std::span<const MarchRay> rays, std::uint16_t without,
                                                             const Progress& progress) override {
        std::optional<MarchPyramid> others;
        if (without != 0) others.emplace(layers_, without);
        const MarchPyramid& pyramid = others ? *others : everything_;
        std::vector<std::optional<MarchHit>> hits(rays.size());
        constexpr std::size_t kChunk = 512;
        const auto marchChunk = [&](int chunk) {
            const std::size_t begin = static_cast<std::size_t>(chunk) * kChunk;
            for (std::size_t i = begin; i < std::min(rays.size(), begin + kChunk); ++i)
                if (!rays[i].direction.isZero(0)) hits[i] = pyramid.march(rays[i].origin, rays[i].direction);
        };
        parallelFor(progress, static_cast<int>((rays.size() + kChunk - 1) / kChunk), marchChunk);
        return hits;
    }

  private:
    const DepthLayers& layers_;
    MarchPyramid everything_;
};

class CpuAnalysisKernels : public AnalysisKernels {
  public:
    [[nodiscard]] std::unique_ptr<DepthFilter> depthFilter(const Image<std::uint32_t>& color,
                                                           const LabelImage& labels) override {
        return std::make_unique<CpuDepthFilter>(color, labels);
    }
    void computeSurface(const analysis::SurfaceInput& input, Surface& surface, const Progress& progress) override {
        analysis::computeSurface(input, surface, progress);
    }
    [[nodiscard]] std::unique_ptr<RayMarcher> rayMarcher(const DepthLayers& layers) override {
        return std::make_unique<CpuRayMarcher>(layers);
    }
    void relaxMembrane(const ImageF& coverage, std::span<const analysis::MembraneRow> rows, ImageRgb& values,
                       const Progress& progress) override {
        analysis::relaxMembrane(coverage, rows, values, progress);
    }
    void fillShepard(const analysis::DirectionTree& tree, DirectionalMap& map, const Progress& progress) override {
        analysis::fillShepard(tree, map, progress);
    }
};

}  // namespace

AnalysisKernels& cpuAnalysisKernels() {
    static CpuAnalysisKernels kernels;
    return kernels;
}

}  // namespace core
