// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/analysis/gpu_analysis_kernels.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "gpu/adapter.h"
#include "gpu/instance.h"
#include "render/analysis/depth_filter_pass.h"
#include "render/analysis/fill_shepard_pass.h"
#include "render/analysis/fit_surface_pass.h"
#include "render/analysis/march_rays.h"
#include "render/analysis/relax_membrane_pass.h"
#include "render/scene_geometry.h"
#include "render/slice_runner.h"

namespace render {
namespace {

constexpr std::uint64_t kMinRays = 1 << 12;  // in a first slice
constexpr std::uint64_t kMaxRays = 1 << 18;  // in any slice

/// A `T` that is made at its first use.
template <class T>
class Lazy {
  public:
    explicit Lazy(const gpu::Device& device) : device_(device) {}
    T& get() {
        if (!value_) value_.emplace(device_);
        return *value_;
    }

  private:
    gpu::Device device_;
    std::optional<T> value_;
};

/// A scene on the device and the kernel that marches rays through it.
struct Marching {
    explicit Marching(const gpu::Device& device) : geometry(device), marcher(device, geometry) {}
    SceneGeometry geometry;
    RayMarcher marcher;
};

/// Layers of a single empty pixel, uploaded in place of a picture that is no longer needed.
core::DepthLayers emptyLayers() {
    core::DepthLayers layers;
    layers.camera.width = layers.camera.height = 1;
    layers.front = layers.back = core::Image<core::DepthLayers::Patch>(1, 1);
    layers.labels = core::LabelImage(1, 1);
    return layers;
}

}  // namespace

struct GpuAnalysisKernels::Impl {
    explicit Impl(const gpu::Device& d)
        : device(d), slices(d), filter(d), surface(d), membrane(d), shepard(d), marching(d) {}

    /// Result of `onDevice`, or of `onCpu` when the device fails.
    template <class OnDevice, class OnCpu>
    auto attempt(const char* what, const OnDevice& onDevice, const OnCpu& onCpu) {
        if (!failed) {
            try {
                return onDevice();
            } catch (const gpu::Error& error) {
                failed = error.kind() != gpu::ErrorKind::OutOfMemory;
                core::Message note = core::Message("messages", "%1 was done on the CPU, because the device fails: %2")
                                         .with(core::Message("messages", what), error.what());
                if (std::ranges::find(notes, note) == notes.end()) notes.push_back(std::move(note));
            }
        }
        return onCpu();
    }

    class Filter;
    class Marcher;

    gpu::Device device;
    SliceRunner slices;
    Lazy<DepthFilterPass> filter;
    Lazy<FitSurfacePass> surface;
    Lazy<RelaxMembranePass> membrane;
    Lazy<FillShepardPass> shepard;
    Lazy<Marching> marching;
    bool failed = false;  ///< the device is no longer used
    core::Notes notes;
};

class GpuAnalysisKernels::Impl::Filter : public DepthFilter {
  public:
    Filter(std::shared_ptr<Impl> impl, const core::Image<std::uint32_t>& color, const core::LabelImage& labels)
        : impl_(std::move(impl)), color_(color), labels_(labels) {}

    [[nodiscard]] core::ImageF run(const core::analysis::FilterPass& pass, const core::ImageF& inverseDepth,
                                   const core::Progress& progress) override {
        const auto onDevice = [&] {
            const DepthFilterPass& kernel = impl_->filter.get();
            if (!images_) images_ = kernel.upload(color_, labels_);
            return kernel.run(*images_, pass, inverseDepth, impl_->slices, progress);
        };
        const auto onCpu = [&] { return core::analysis::runFilterPass(pass, inverseDepth, color_, labels_, progress); };
        return impl_->attempt(MESSAGE_TEXT("messages", "The depth filter"), onDevice, onCpu);
    }

  private:
    std::shared_ptr<Impl> impl_;
    const core::Image<std::uint32_t>& color_;
    const core::LabelImage& labels_;
    std::optional<DepthFilterPass::Images> images_;
};

class GpuAnalysisKernels::Impl::Marcher : public RayMarcher {
  public:
    Marcher(std::shared_ptr<Impl> impl, const core::DepthLayers& layers) : impl_(std::move(impl)), layers_(layers) {}
    ~Marcher() override {
        if (uploaded_ && !impl_->failed)
            impl_->attempt(
                MESSAGE_TEXT("messages", "The ray march"), [&] { release(); }, [] {});
    }
    Marcher(const Marcher&) = delete;
    Marcher& operator=(const Marcher&) = delete;

    [[nodiscard]] std::vector<std::optional<core::MarchHit>> march(std::span<const core::MarchRay> rays,
                                                                   std::uint16_t without,
                                                                   const core::Progress& progress) override {
        const auto onDevice = [&] {
            Marching& marching = impl_->marching.get();
            if (!std::exchange(uploaded_, true)) {
                marching.geometry.setPatches(layers_);
                impl_->slices.submit("build pyramid",
                                     [&](const gpu::CommandEncoder& encoder) { marching.geometry.record(encoder); });
            }
            std::vector<std::optional<core::MarchHit>> hits(rays.size());
            impl_->slices.run(
                progress, "march_rays", rays.size(), kMinRays, kMaxRays, [&](std::uint64_t first, std::uint64_t count) {
                    const std::vector<RayHit> found =
                        marching.marcher.march(rays.subspan(first, count), MarchMethod::Pyramid, {},
                                               without == 0 ? -1.0f : static_cast<float>(without));
                    for (std::uint64_t i = 0; i < count; ++i)
                        if (found[i].found)
                            hits[first + i] = core::MarchHit{found[i].x, found[i].y, found[i].back, found[i].distance};
                });
            return hits;
        };
        const auto onCpu = [&] {
            if (!cpu_) cpu_ = core::cpuAnalysisKernels().rayMarcher(layers_);
            return cpu_->march(rays, without, progress);
        };
        return impl_->attempt(MESSAGE_TEXT("messages", "The ray march"), onDevice, onCpu);
    }

  private:
    /// Replaces the picture by the smallest one, because its layers take much of the device's memory.
    void release() { impl_->marching.get().geometry.setPatches(emptyLayers()); }

    std::shared_ptr<Impl> impl_;
    const core::DepthLayers& layers_;
    bool uploaded_ = false;
    std::unique_ptr<RayMarcher> cpu_;
};

GpuAnalysisKernels::GpuAnalysisKernels(const gpu::Device& device) : impl_(std::make_shared<Impl>(device)) {}
GpuAnalysisKernels::~GpuAnalysisKernels() = default;

std::unique_ptr<core::AnalysisKernels::DepthFilter> GpuAnalysisKernels::depthFilter(
    const core::Image<std::uint32_t>& color, const core::LabelImage& labels) {
    return std::make_unique<Impl::Filter>(impl_, color, labels);
}

void GpuAnalysisKernels::computeSurface(const core::analysis::SurfaceInput& input, core::Surface& surface,
                                        const core::Progress& progress) {
    impl_->attempt(
        MESSAGE_TEXT("messages", "The fit of the surface"),
        [&] { impl_->surface.get().run(input, surface, impl_->slices, progress); },
        [&] { core::analysis::computeSurface(input, surface, progress); });
}

std::unique_ptr<core::AnalysisKernels::RayMarcher> GpuAnalysisKernels::rayMarcher(const core::DepthLayers& layers) {
    return std::make_unique<Impl::Marcher>(impl_, layers);
}

void GpuAnalysisKernels::relaxMembrane(const core::ImageF& coverage, std::span<const core::analysis::MembraneRow> rows,
                                       core::ImageRgb& values, const core::Progress& progress) {
    impl_->attempt(
        MESSAGE_TEXT("messages", "The filling of directions"),
        [&] { impl_->membrane.get().run(coverage, rows, values, impl_->slices, progress); },
        [&] { core::analysis::relaxMembrane(coverage, rows, values, progress); });
}

void GpuAnalysisKernels::fillShepard(const core::analysis::DirectionTree& tree, core::DirectionalMap& map,
                                     const core::Progress& progress) {
    impl_->attempt(
        MESSAGE_TEXT("messages", "The filling of directions"),
        [&] { impl_->shepard.get().run(tree, map, impl_->slices, progress); },
        [&] { core::analysis::fillShepard(tree, map, progress); });
}

core::Notes GpuAnalysisKernels::takeNotes() { return std::exchange(impl_->notes, {}); }

AnalysisTwin parseAnalysisTwin(const std::string& text, const std::string& origin) {
    if (text == "auto") return AnalysisTwin::Automatic;
    if (text == "cpu") return AnalysisTwin::Cpu;
    if (text == "gpu") return AnalysisTwin::Gpu;
    throw core::Error(core::ErrorKind::Usage, origin + " is \"" + text + "\", expected auto, cpu or gpu.");
}

AnalysisTwin analysisTwinFromEnvironment() {
    const char* value = std::getenv("PATINA_ANALYSIS");
    if (value == nullptr || *value == 0) return AnalysisTwin::Automatic;
    return parseAnalysisTwin(value, "Environment variable PATINA_ANALYSIS");
}

std::unique_ptr<core::AnalysisKernels> createAnalysisKernels(AnalysisTwin twin, const std::string& deviceWish) {
    if (twin == AnalysisTwin::Cpu) return nullptr;
    try {
        const gpu::Adapter adapter = gpu::Instance::create().requestAdapter({.device = deviceWish});
        if (twin == AnalysisTwin::Automatic && adapter.info().type == gpu::AdapterType::CPU) return nullptr;
        return std::make_unique<GpuAnalysisKernels>(adapter.requestDevice({.label = "analysis"}));
    } catch (const gpu::Error&) {
        if (twin == AnalysisTwin::Gpu) throw;
        return nullptr;
    }
}

}  // namespace render
