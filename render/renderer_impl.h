// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/shading/drive_table.h"
#include "render/kernels/drive_buffers.h"
#include "render/kernels/kernels.h"
#include "render/kernels/measured_tables.h"
#include "render/kernels/user_kernels.h"
#include "render/passes/composite_pass.h"
#include "render/passes/reshade_pass.h"
#include "render/passes/silhouette_pass.h"
#include "render/renderer.h"
#include "render/scene_geometry.h"
#include "render/segment_state.h"
#include "render/slice_timer.h"

namespace render {

// What a unit of work costs before anything has been measured [s]: a slow processor's time, so that first slices are
// short everywhere.
constexpr double kPathGuess = 4e-6;       // one path
constexpr double kCompositeGuess = 5e-7;  // one pixel

/// At least 1.
inline std::uint32_t positive(int value) { return static_cast<std::uint32_t>(std::max(value, 1)); }

/// What a slice can advance.
enum class Task { None, Reshade, Filter, Irradiance, Gather };

/// The renderer's state, and what it does by part: renderer.cpp what to do next, renderer_uploads.cpp what the device
/// has to hold for it, renderer_slices.cpp re-shading, filter and composite, renderer_translucency.cpp light below
/// surfaces.
struct Renderer::Impl {
    Impl(gpu::Device d, core::LightSampling sampling)
        : lightSampling(sampling),
          device(std::move(d)),
          geometry(device),
          reshade(device, geometry.layout()),
          translucency(device, geometry.layout()),
          diffusion(device, geometry.layout()),
          filter(device, geometry.layout()),
          composite(device, geometry.layout()),
          silhouette(device, geometry.layout()),
          timer(device) {
        paths.dropped = makeBuffer(device, "dropped samples", gpu::BufferUsage::Storage, std::vector<kernel::uint>{0});
        dropped->staging = device.createBuffer({.label = "dropped samples, read back",
                                                .size = sizeof(kernel::uint),
                                                .usage = gpu::BufferUsage::MapRead | gpu::BufferUsage::CopyDst});
    }

    /// Count of dropped samples on its way from the device; outlives the renderer while a read is pending.
    struct DroppedReader {
        gpu::Buffer staging;
        bool pending = false;
        bool dirty = false;
        std::uint64_t value = 0;
    };

    core::LightSampling lightSampling;
    gpu::Device device;
    SceneGeometry geometry;
    ReshadePass reshade;
    TranslucencyPass translucency;
    DiffusionPass diffusion;
    FilterPass filter;
    CompositePass composite;
    SilhouettePass silhouette;
    SliceTimer timer;
    std::shared_ptr<DroppedReader> dropped = std::make_shared<DroppedReader>();

    core::Scene scene;
    std::shared_ptr<const core::Analysis> analysis;
    std::uint16_t highestLabel = 0;  ///< of the photograph
    std::vector<kernel::SegmentShading> shading;
    core::DriveTable drives;
    DriveBuffers driveBuffers;
    MeasuredTables measured;
    UserKernels userKernels;
    bool layersStale = false;
    /// What is being uploaded, kept alive until it is.
    struct {
        std::shared_ptr<const core::Photo> photo;
        std::shared_ptr<const core::Surface> front, back;
        std::shared_ptr<const core::DepthLayers> layers;
    } uploading;
    bool otherPhoto = false;  ///< the picture is of other layers
    bool environmentStale = false;
    bool shadingStale = false;
    bool resultStale = false;  ///< the photograph has to be copied in again
    bool waiting = false;      ///< the last `record` could only wait for other threads
    bool refining = true;
    double refinedFor = 0;  ///< [s] since something started anew, pauses left out
    std::chrono::steady_clock::time_point lastWork;
    PixelBounds changed;  ///< by the last `record`, in the result
    PathInputs paths;
    Targets targets;
    std::vector<SegmentState> segments;  ///< edited ones, by label

    // renderer.cpp
    void setScene(const core::Scene& next, std::shared_ptr<const core::Analysis> nextAnalysis);
    void updateSegment(SegmentState& state, const core::Segment& segment);
    bool record(gpu::CommandEncoder& encoder, double budgetSeconds);
    [[nodiscard]] std::pair<SegmentState*, Task> nextTask();
    [[nodiscard]] bool wantsFilter(const SegmentState& state) const;
    void countTime();
    [[nodiscard]] bool timeUp() const { return scene.render.timeLimit > 0 && refinedFor >= scene.render.timeLimit; }
    [[nodiscard]] bool mayRefine() const { return refining && !timeUp(); }

    // renderer_uploads.cpp
    void useKernels();
    [[nodiscard]] bool kernelsReady(double seconds);
    [[nodiscard]] bool layersReady(double seconds);
    [[nodiscard]] bool pixelsReady(double seconds);
    void uploadPixels(SegmentState& state, const SegmentPixels& found);
    void upload();
    void prepareTargets();
    void keepPicture(const gpu::CommandEncoder& encoder);

    // renderer_slices.cpp; seconds of the device that the slice may take, and will probably take
    double recordReshade(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds);
    double recordFilter(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds);
    void recordComposite(const gpu::CommandEncoder& encoder, SegmentState& state);
    void recordDroppedReadback(const gpu::CommandEncoder& encoder);

    // renderer_translucency.cpp
    void prepareTranslucency(SegmentState& state);
    bool awaitPoints(double seconds);
    double recordIrradiance(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds);
    void prepareGather(const gpu::CommandEncoder& encoder, SegmentState& state);
    double recordGather(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds);

    [[nodiscard]] PixelBounds whole() const {
        return {0, 0, static_cast<int>(geometry.width()), static_cast<int>(geometry.height())};
    }
    [[nodiscard]] std::uint32_t targetSamples() const { return positive(scene.render.samples); }
    [[nodiscard]] std::uint32_t rays() const { return positive(scene.render.irradianceSamples); }
};

}  // namespace render
