// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/renderer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <future>
#include <iterator>
#include <limits>
#include <optional>
#include <thread>
#include <utility>

#include "core/brdf.h"
#include "core/drives.h"
#include "core/reference_renderer.h"
#include "core/render/drive_buffers.h"
#include "core/render/kernels.h"
#include "core/render/measured_tables.h"
#include "core/render/passes/composite_pass.h"
#include "core/render/passes/reshade_pass.h"
#include "core/render/passes/silhouette_pass.h"
#include "core/render/scene_geometry.h"
#include "core/render/segment_state.h"
#include "core/render/slice_timer.h"
#include "core/render/user_kernels.h"
#include "core/translucency.h"
#include "shaders/shared/rng.h"

namespace render {
namespace {

// What a unit of work costs before anything has been measured [s]: a slow processor's time, so that first slices are
// short everywhere.
constexpr double kPathGuess = 4e-6;       // one path
constexpr double kAccessGuess = 1e-8;     // one access to the grids of light below a surface
constexpr double kFilterGuess = 1e-5;     // one pixel in one step of the filter
constexpr double kCompositeGuess = 5e-7;  // one pixel

constexpr std::uint32_t kMaxPathsPerDispatch = 16;  // per pixel: bounds what one invocation may take
// What starting this kernel costs a software driver is as much as these paths; smaller slices would mean only that.
constexpr std::uint64_t kMinIrradiancePaths = 4096;
constexpr std::uint64_t kMinAccesses = 200000;  // likewise

// Of a budget, whatever the composite takes of it. Without, sums of large segments, whose composite is dearer than a
// budget, would advance by the least slice each time.
constexpr double kLeastShare = 0.1;

// For how long a call that could only wait for other threads does so [s]: too short to be felt in a window.
constexpr double kBackgroundWait = 2e-3;

// Order of the pixels in a sweep: an ordered dither, so that a part of a sweep shows the change all over the segment.
constexpr int kSweepStep = 4;
constexpr std::array<std::pair<int, int>, kSweepStep * kSweepStep> kSweepOrder{{{0, 0},
                                                                                {2, 2},
                                                                                {2, 0},
                                                                                {0, 2},
                                                                                {1, 1},
                                                                                {3, 3},
                                                                                {3, 1},
                                                                                {1, 3},
                                                                                {1, 0},
                                                                                {3, 2},
                                                                                {3, 0},
                                                                                {1, 2},
                                                                                {0, 1},
                                                                                {2, 3},
                                                                                {2, 1},
                                                                                {0, 3}}};

enum class Task { None, Reshade, Filter, Irradiance, Gather };

gpu::Texture makeTarget(const gpu::Device& device, const char* label, std::uint32_t width, std::uint32_t height,
                        gpu::TextureFormat format = gpu::TextureFormat::RGBA32Float) {
    return device.createTexture({.label = label,
                                 .size = {width, height},
                                 .format = format,
                                 .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::StorageBinding |
                                          gpu::TextureUsage::CopySrc | gpu::TextureUsage::CopyDst});
}

/// Whether the composite of the same light is the same; not for weights that vary over the segment.
bool sameBlend(const core::Material& a, const core::Material& b) {
    if (a.blendNew != b.blendNew || a.blendOriginal != b.blendOriginal) return false;
    if (!a.translucency || !b.translucency) return !a.translucency && !b.translucency;
    return a.translucency->weight == b.translucency->weight && a.translucency->eta == b.translucency->eta;
}

std::uint16_t highestOf(const core::LabelImage& labels) {
    const auto pixels = labels.pixels();
    return pixels.empty() ? std::uint16_t{0} : *std::max_element(pixels.begin(), pixels.end());
}

/// By label, up to `highest`.
std::vector<kernel::SegmentShading> shadingTable(const core::Scene& scene, const core::Analysis& analysis,
                                                 std::uint16_t highest) {
    std::vector<kernel::SegmentShading> table = core::buildSegmentShading(scene, analysis);
    for (kernel::SegmentShading& entry : table)
        if (entry.blend.w == 0) entry.brdf = kernel::BrdfParams{};
    kernel::SegmentShading untouched{};
    untouched.blend = {1, 0, 0, 0};
    if (table.size() <= highest) table.resize(std::size_t{highest} + 1, untouched);
    return table;
}

std::uint32_t positive(int value) { return static_cast<std::uint32_t>(std::max(value, 1)); }

}  // namespace

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
    PixelBounds changed;       ///< by the last `record`, in the result
    PathInputs paths;
    Targets targets;
    std::vector<SegmentState> segments;  ///< edited ones, by label

    void setScene(const core::Scene& next, std::shared_ptr<const core::Analysis> nextAnalysis);
    void updateSegment(SegmentState& state, const core::Segment& segment);
    [[nodiscard]] bool layersReady(double seconds);
    void upload();
    void prepareTargets();
    void preparePixels(SegmentState& state);
    void prepareSilhouette(SegmentState& state);
    void prepareTranslucency(SegmentState& state);
    void prepareGather(const gpu::CommandEncoder& encoder, SegmentState& state);

    bool record(gpu::CommandEncoder& encoder, double budgetSeconds);
    [[nodiscard]] bool kernelsReady(double seconds);
    void useKernels();
    void keepPicture(const gpu::CommandEncoder& encoder);
    [[nodiscard]] std::pair<SegmentState*, Task> nextTask();
    [[nodiscard]] bool wantsFilter(const SegmentState& state) const;
    double recordReshade(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds);
    double recordFilter(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds);
    double recordIrradiance(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds);
    double recordGather(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds);
    void recordComposite(const gpu::CommandEncoder& encoder, SegmentState& state);
    bool awaitPoints(double seconds);
    void recordDroppedReadback(const gpu::CommandEncoder& encoder);

    [[nodiscard]] PixelBounds whole() const {
        return {0, 0, static_cast<int>(geometry.width()), static_cast<int>(geometry.height())};
    }
    [[nodiscard]] std::uint32_t targetSamples() const { return positive(scene.render.samples); }
    [[nodiscard]] std::uint32_t rays() const { return positive(scene.render.irradianceSamples); }
};

// ---- what to render -------------------------------------------------------------------------------------------------

void Renderer::Impl::setScene(const core::Scene& next, std::shared_ptr<const core::Analysis> nextAnalysis) {
    CORE_ASSERT(next.photo && nextAnalysis && nextAnalysis->front && nextAnalysis->back, "a photo and its surfaces");
    geometry.requireFits(static_cast<std::uint32_t>(next.photo->color.width()),
                         static_cast<std::uint32_t>(next.photo->color.height()));
    const std::uint16_t highest = next.photo == scene.photo ? highestLabel : highestOf(next.photo->labels);
    std::vector<kernel::SegmentShading> table = shadingTable(next, *nextAnalysis, highest);
    core::DriveTable nextDrives = core::buildDrives(next, *nextAnalysis, table);
    geometry.requireBufferFits("varying parameters", nextDrives.valueCount * sizeof(float));
    const MeasuredFiles files = placeMeasured(next, table);
    measured.requireFits(device, files);
    const UserFiles userFiles = placeUserBrdfs(next, table);

    const bool newLayers = !analysis || next.photo != scene.photo || nextAnalysis->front != analysis->front ||
                           nextAnalysis->back != analysis->back;
    const bool newEnvironment = !analysis || nextAnalysis->environment != analysis->environment;
    if (newLayers || newEnvironment) {
        layersStale = layersStale || newLayers;
        otherPhoto = otherPhoto || newLayers;
        environmentStale = environmentStale || newEnvironment;
        segments.clear();
        resultStale = true;
    }
    if (next.render.filter != scene.render.filter)
        for (SegmentState& state : segments) state.compositeStale = true;
    scene = next;
    highestLabel = highest;
    analysis = std::move(nextAnalysis);
    shading = std::move(table);
    drives = std::move(nextDrives);
    shadingStale = true;
    userKernels.want(userFiles, std::any_of(scene.segments.begin(), scene.segments.end(),
                                            [](const core::Segment& s) { return s.edit && s.edit->translucency; }));
    if (measured.use(files))
        for (SegmentState& state : segments) state.reshadeGroup = state.irradianceGroup = {};

    std::vector<SegmentState> kept;
    for (const core::Segment& segment : scene.segments) {
        if (!segment.edit || !core::usable(*segment.edit)) continue;
        const auto old = std::find_if(segments.begin(), segments.end(),
                                      [&](const SegmentState& state) { return state.label == segment.label; });
        SegmentState state;
        if (old != segments.end())
            state = std::move(*old);
        else
            state.label = segment.label;
        updateSegment(state, segment);
        kept.push_back(std::move(state));
    }
    if (kept.size() != segments.size()) resultStale = true;
    for (std::size_t i = 0; !resultStale && i < kept.size(); ++i) resultStale = kept[i].label != segments[i].label;
    segments = std::move(kept);
    if (!resultStale) return;
    for (SegmentState& state : segments) state.silhouette = {};  // who borders on whom
}

void Renderer::Impl::updateSegment(SegmentState& state, const core::Segment& segment) {
    const core::Material& material = *segment.edit;
    if (!sameBlend(state.material, material) || shading[segment.label].drives.w > 0) state.compositeStale = true;
    state.material = material;

    SumKey key;
    key.seed = scene.render.seed;
    key.bounces = std::max(scene.render.bounces, 1);
    SumKey lightKey = key;
    if (key.bounces == 1) {
        kernel::SegmentShading own{};
        own.brdf = shading[segment.label].brdf;
        key.shading = {own};
        key.drives = driveKeys(scene, shading, drives, &segment);
    } else {
        key.shading = shading;
        key.drives = driveKeys(scene, shading, drives, nullptr);
        lightKey.shading = key.shading;
        lightKey.drives = key.drives;
    }
    if (!key.same(state.reshadeKey) || state.samples > targetSamples()) {
        state.reshadeKey = std::move(key);
        state.restartReshade();
    }
    if (!material.translucency) {
        state.pointsStale = true;
        state.irradianceKey = {};
        return;
    }
    lightKey.surfaceSamples = scene.render.surfaceSamples;
    lightKey.irradianceSamples = scene.render.irradianceSamples;
    lightKey.quality = scene.render.diffusionQuality;
    lightKey.eta = core::profileFromTranslucency(*material.translucency).eta;
    if (!lightKey.same(state.irradianceKey)) {
        const SumKey& old = state.irradianceKey;
        if (lightKey.seed != old.seed || lightKey.surfaceSamples != old.surfaceSamples ||
            lightKey.quality != old.quality)
            state.pointsStale = true;
        state.irradianceKey = std::move(lightKey);
        state.restartLight();
    }
    core::Translucency scattering = *material.translucency;
    scattering.weight = 1;
    scattering.preset.clear();
    if (!(scattering == state.scattering)) {
        state.scattering = std::move(scattering);
        state.restartGather();
    }
}

// ---- uploads --------------------------------------------------------------------------------------------------------

/// Goes on uploading new layers; true when they are on the device.
bool Renderer::Impl::layersReady(double seconds) {
    if (layersStale) {
        uploading = {
            .photo = scene.photo, .front = analysis->front, .back = analysis->back, .layers = analysis->layers};
        if (!uploading.layers)
            uploading.layers = std::make_shared<core::DepthLayers>(
                core::buildDepthLayers(scene.photo->camera, scene.photo->labels, *analysis->front, *analysis->back));
        geometry.beginLayers(*uploading.layers, uploading.photo->color, *uploading.front, *uploading.back);
        layersStale = false;
    }
    if (!geometry.uploadRows(seconds)) return false;
    uploading = {};
    return true;
}

void Renderer::Impl::upload() {
    if (environmentStale) {
        geometry.setEnvironment(analysis->environment ? *analysis->environment : core::DirectionalMap(), lightSampling);
        environmentStale = false;
    }
    if (shadingStale) {
        const std::uint64_t bytes = shading.size() * sizeof(kernel::SegmentShading);
        if (paths.shading && paths.shading.size() == bytes) {
            device.queue().writeBuffer(paths.shading, 0, shading);
        } else {
            paths.shading = makeBuffer(device, "segment shading", gpu::BufferUsage::Storage, shading);
            for (SegmentState& state : segments) state.reshadeGroup = state.irradianceGroup = {};
        }
        if (driveBuffers.upload(device, drives))
            for (SegmentState& state : segments)
                state.reshadeGroup = state.irradianceGroup = state.compositeGroup = state.silhouetteGroup = {};
        paths.drives = driveBuffers.drives();
        paths.driveValues = driveBuffers.values();
        shadingStale = false;
    }
    paths.measured = measured.buffer(device);
    prepareTargets();
    for (SegmentState& state : segments) {
        if (!state.pixels.buffer) preparePixels(state);
        if (!state.reshadeGroup) state.reshadeGroup = reshade.bind(paths, state.pixels, targets);
        if (state.translucent()) prepareTranslucency(state);
        if (scene.render.filter && !state.filterBound) {
            state.filterGroups = filter.bind(state.pixels, targets);
            state.filterBound = true;
        }
        if (!state.silhouette.buffer) prepareSilhouette(state);
        if (!state.silhouetteGroup) state.silhouetteGroup = silhouette.bind(paths, state.silhouette, targets);
        if (!state.compositeGroup) state.compositeGroup = composite.bind(paths, state.pixels, targets);
    }
}

void Renderer::Impl::prepareTargets() {
    const std::uint32_t width = geometry.width();
    const std::uint32_t height = geometry.height();
    const auto fits = [&](const gpu::Texture& t) { return t && t.width() == width && t.height() == height; };
    if (!fits(targets.result)) {
        targets = {};
        targets.accumulation = makeTarget(device, "accumulation", width, height);
        targets.count = makeTarget(device, "sample count", width, height, gpu::TextureFormat::R32Float);
        targets.result = makeTarget(device, "result", width, height);
        targets.filtered = makeTarget(device, "filtered", 1, 1);
        targets.diffusion = makeTarget(device, "diffusion", 1, 1);
        resultStale = true;
        for (SegmentState& state : segments) state.reshadeGroup = state.compositeGroup = state.silhouetteGroup = {};
    }
    if (scene.render.filter && !segments.empty() && !fits(targets.filtered)) {
        targets.filtered = makeTarget(device, "filtered", width, height);
        targets.filterPing = makeTarget(device, "filter scratch 1", width, height);
        targets.filterPong = makeTarget(device, "filter scratch 2", width, height);
        for (SegmentState& state : segments) {
            state.compositeGroup = {};
            state.filterBound = false;
        }
    }
    const bool translucent =
        std::any_of(segments.begin(), segments.end(), [](const SegmentState& s) { return s.translucent(); });
    if (translucent && !fits(targets.diffusion)) {
        targets.diffusion = makeTarget(device, "diffusion", width, height);
        for (SegmentState& state : segments) {
            state.compositeGroup = {};
            state.pointsStale = true;
        }
    }
}

void Renderer::Impl::preparePixels(SegmentState& state) {
    const core::LabelImage& labels = scene.photo->labels;
    const core::ImageF& depth = analysis->front->depth;
    std::vector<std::uint32_t> pixels;
    for (const auto& [x0, y0] : kSweepOrder)
        for (int y = y0; y < labels.height(); y += kSweepStep)
            for (int x = x0; x < labels.width(); x += kSweepStep)
                if (labels(x, y) == state.label && depth(x, y) > 0) {
                    pixels.push_back(static_cast<std::uint32_t>(x) | static_cast<std::uint32_t>(y) << 16);
                    state.pixels.bounds.include(x, y);
                }
    state.pixels.count = static_cast<std::uint32_t>(pixels.size());
    state.pixels.buffer =
        makeBuffer(device, "pixels of segment " + std::to_string(state.label), gpu::BufferUsage::Storage, pixels);
}

void Renderer::Impl::prepareSilhouette(SegmentState& state) {
    // At its rim a mirror shows what is beside it, so its colours tell no mixture.
    if (scene.findSegment(state.label)->glossy) {
        state.silhouette = silhouette.upload({});
        state.silhouetteGroup = {};
        return;
    }
    state.silhouette = silhouette.upload(core::findSilhouette(
        scene.photo->color, scene.photo->labels, analysis->front->depth, state.label, core::editedLabels(shading)));
    state.silhouetteGroup = {};
}

void Renderer::Impl::prepareTranslucency(SegmentState& state) {
    const bool made = state.pendingPoints.valid() &&
                      state.pendingPoints.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (made) {
        SurfaceGrids grids = state.pendingPoints.get();
        if (!state.pointsStale) {
            state.surface = std::move(grids.surface);
            state.points = translucency.upload(state.surface);
            state.grids = diffusion.upload(std::move(grids.grid), state.points.sums, targets);
            state.irradianceGroup = {};
            state.restartLight();
        }
    }
    if (state.pointsStale && !state.pendingPoints.valid()) {
        state.pointsStale = false;
        state.points = {};
        state.pendingPoints = std::async(
            std::launch::async, [photo = scene.photo, from = analysis, label = state.label, params = scene.render] {
                return makeSurfaceGrids(*photo, *from, label, params);
            });
    }
    if (!state.irradianceGroup && state.points.count > 0)
        state.irradianceGroup = translucency.bindIrradiance(paths, state.points);
}

/// Before the first slice of a sum: what has to be done for it.
void Renderer::Impl::prepareGather(const gpu::CommandEncoder& encoder, SegmentState& state) {
    state.gatherTarget = state.gatherable();
    state.gatherSteps.clear();
    state.gatherStep = 0;
    state.gatherCursor = 0;
    if (state.gridPoints != state.gatherTarget) {
        diffusion.setAreas(state.grids, core::sampleAreas(state.surface, state.gatherTarget));
        state.gatherSteps = DiffusionPass::lightSteps(state.grids);
        state.gridPoints = 0;
        state.smoothedFrom = state.grids.grid.levels.size();
    }
    state.lightSteps = state.gatherSteps.size();
    const double spacing = state.grids.grid.spacing;
    const double area = std::max(state.points.area / state.gatherTarget, spacing * spacing);
    state.diffusionKernel = core::fitDiffusionKernel(
        core::blurred(core::profileFromTranslucency(state.scattering), area), state.grids.grid);
    std::ranges::copy(DiffusionPass::smoothSteps(state.grids, state.diffusionKernel.finest, state.smoothedFrom),
                      std::back_inserter(state.gatherSteps));
    state.smoothSteps = state.gatherSteps.size();
    std::ranges::copy(DiffusionPass::sumSteps(state.grids, state.diffusionKernel),
                      std::back_inserter(state.gatherSteps));
    if (!state.diffusionFresh) return;
    diffusion.recordClear(encoder, geometry, state.grids);
    state.diffusionFresh = false;
}

// ---- work -----------------------------------------------------------------------------------------------------------

/// The filter follows the samples at 1, 4, 16, ... and at the end: often enough to look refined, seldom enough to cost
/// little.
bool Renderer::Impl::wantsFilter(const SegmentState& state) const {
    if (!scene.render.filter || state.pixels.count == 0) return false;
    if (state.filterStep >= 0) return true;
    if (state.cursor != 0 || state.samples == state.filteredSamples) return false;
    if (state.samples == targetSamples()) return true;
    return state.samples >= 1 && state.samples >= 4 * state.filteredSamples;
}

/// First a first picture of everything, then whatever is least advanced.
std::pair<SegmentState*, Task> Renderer::Impl::nextTask() {
    SegmentState* best = nullptr;
    Task task = Task::None;
    double bestRank = std::numeric_limits<double>::max();
    const auto offer = [&](SegmentState& state, Task t, double rank) {
        if (rank >= bestRank) return;
        best = &state;
        task = t;
        bestRank = rank;
    };
    for (SegmentState& state : segments) {
        if (state.pixels.count == 0) continue;
        if (state.samples == 0) {
            offer(state, Task::Reshade, 0);
        } else if (wantsFilter(state)) {
            offer(state, Task::Filter, 1.5);
        } else if (state.samples < targetSamples()) {
            offer(state, Task::Reshade, 2 + static_cast<double>(state.samples) / targetSamples());
        }
        if (!state.translucent() || state.points.count == 0) continue;
        const double done = static_cast<double>(state.litPoints) / state.points.count;
        const double rank = state.gathered == 0 ? 1 : 2 + done;
        if (state.gatherTarget > 0 || state.gatherable() > state.gathered)
            offer(state, Task::Gather, rank);
        else if (state.litPoints < state.points.count)
            offer(state, Task::Irradiance, rank);
    }
    return {best, task};
}

double Renderer::Impl::recordReshade(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds) {
    const std::string kind = "reshade " + std::to_string(state.label);
    kernel::ReshadeBlock block{};
    block.seed = scene.render.seed;
    block.bounces = positive(scene.render.bounces);
    const std::uint64_t units = timer.units(kind, kPathGuess, seconds, kListGroupSize);
    const PixelRange range = state.nextPixels(units);
    block.firstPixel = range.first;
    block.firstSample = state.samples;
    block.pixelCount = range.count;
    block.sampleCount = 1;
    if (block.pixelCount == state.pixels.count) {
        // At least two slices' worth of whole sweeps; stops where the filter wants a look.
        std::uint32_t left = targetSamples() - state.samples;
        if (scene.render.filter) {
            const std::uint32_t milestone = state.samples == 0 ? 1 : 4 * state.filteredSamples;
            if (milestone > state.samples) left = std::min(left, milestone - state.samples);
        }
        const auto sweeps = static_cast<std::uint32_t>(std::min<std::uint64_t>(units / state.pixels.count, 1u << 20));
        block.sampleCount = std::clamp(sweeps, 1u, std::min(left, kMaxPathsPerDispatch));
    }
    const std::uint64_t paths_ = std::uint64_t{block.pixelCount} * block.sampleCount;
    {
        const auto region = timer.measure(encoder, kind, paths_);
        reshade.record(encoder, geometry, state.reshadeGroup, block);
    }
    state.cursor += range.count;
    if (range.first <= state.reached) state.reached = std::max(state.reached, range.first + range.count);
    if (state.cursor == state.pixels.count) {
        state.cursor = state.sweepStart = 0;
        state.samples += block.sampleCount;
    }
    // A filtered picture stays on show until the next one is ready.
    if (!scene.render.filter || state.filteredSamples == 0) state.advanced.push_back(range);
    dropped->dirty = true;
    return static_cast<double>(paths_) * timer.cost(kind, kPathGuess);
}

double Renderer::Impl::recordFilter(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds) {
    const std::string kind = state.filterStep <= 0 ? "filter start" : "filter";
    if (state.filterStep < 0) {
        state.filterStep = 0;
        state.filterCursor = 0;
    }
    const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(
        timer.units(kind, kFilterGuess, seconds, kListGroupSize), state.pixels.count - state.filterCursor));
    {
        const auto region = timer.measure(encoder, kind, count);
        filter.record(encoder, geometry, state.filterGroups, state.filterStep, state.filterCursor, count);
    }
    state.filterCursor += count;
    if (state.filterCursor == state.pixels.count) {
        state.filterCursor = 0;
        if (++state.filterStep == FilterPass::stepCount()) {
            state.filterStep = -1;
            state.filteredSamples = state.samples;
            state.compositeStale = true;
        }
    }
    return count * timer.cost(kind, kFilterGuess);
}

double Renderer::Impl::recordIrradiance(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds) {
    const std::string kind = "irradiance " + std::to_string(state.label);
    const std::uint64_t units = timer.units(kind, kPathGuess, seconds, kMinIrradiancePaths);
    kernel::IrradianceBlock block{};
    block.firstPoint = state.litPoints;
    block.firstRay = state.litRays;
    const std::uint32_t raysLeft = rays() - state.litRays;
    const std::uint32_t pointsLeft = state.points.count - state.litPoints;
    const std::uint32_t group = std::min(kListGroupSize, pointsLeft);
    if (state.litRays == 0 && units >= std::uint64_t{group} * raysLeft) {
        block.rayCount = raysLeft;
        block.pointCount = static_cast<std::uint32_t>(std::min<std::uint64_t>(units / raysLeft, pointsLeft));
    } else {
        block.pointCount = group;
        block.rayCount = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(units / group, 1, raysLeft));
    }
    block.label = state.label;
    block.seed = kernel::rng_stream(scene.render.seed, 2u * state.label + 1u);
    block.bounces = positive(scene.render.bounces);
    block.eta = state.irradianceKey.eta;
    const std::uint64_t paths_ = std::uint64_t{block.pointCount} * block.rayCount;
    {
        const auto region = timer.measure(encoder, kind, paths_);
        translucency.record(encoder, geometry, state.irradianceGroup, block);
    }
    state.litRays += block.rayCount;
    if (state.litRays == rays()) {
        state.litRays = 0;
        state.litPoints += block.pointCount;
    }
    dropped->dirty = true;
    return static_cast<double>(paths_) * timer.cost(kind, kPathGuess);
}

double Renderer::Impl::recordGather(const gpu::CommandEncoder& encoder, SegmentState& state, double seconds) {
    if (state.gatherTarget == 0) prepareGather(encoder, state);
    double spent = 0;
    if (state.gatherStep < state.gatherSteps.size()) {
        const DiffusionStep& step = state.gatherSteps[state.gatherStep];
        const std::string kind = nameOf(step.kernel);
        const std::uint64_t accesses = accessesPerItem(step.kernel);
        const double guess = kAccessGuess * static_cast<double>(accesses);
        const std::uint64_t units = timer.units(kind, guess, seconds, kMinAccesses / accesses);
        const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(units, step.count - state.gatherCursor));
        {
            const auto region = timer.measure(encoder, kind, count);
            diffusion.record(encoder, geometry, state.grids, step, state.gatherCursor, count, rays(),
                             state.diffusionKernel);
        }
        spent = count * timer.cost(kind, guess);
        state.gatherCursor += count;
        if (state.gatherCursor == step.count) {
            state.gatherCursor = 0;
            ++state.gatherStep;
        }
    }
    if (state.gatherStep >= state.lightSteps) state.gridPoints = state.gatherTarget;
    if (state.gatherStep >= state.smoothSteps)
        state.smoothedFrom = std::min(state.smoothedFrom, state.diffusionKernel.finest);
    if (state.gatherStep == state.gatherSteps.size()) {
        state.gathered = state.gatherTarget;
        state.gatherTarget = 0;
        state.compositeStale = true;
    }
    return spent;
}

void Renderer::Impl::recordComposite(const gpu::CommandEncoder& encoder, SegmentState& state) {
    if (state.compositeStale) state.advanced = {{0, state.reached}};
    state.compositeStale = false;
    const core::Material& material = state.material;
    kernel::CompositeBlock block{.firstPixel = 0,
                                 .pixelCount = 0,
                                 .filtered = scene.render.filter && state.filteredSamples > 0 ? 1u : 0u,
                                 .blendNew = material.blendNew,
                                 .blendOriginal = material.blendOriginal,
                                 .translucentWeight = state.translucent() ? material.translucency->weight : 0.0f,
                                 .eta = state.irradianceKey.eta,
                                 .translucent = state.translucent() ? 1u : 0u,
                                 .firstDrive = shading[state.label].drives.z,
                                 .driveCount = shading[state.label].drives.w,
                                 .pad0 = 0,
                                 .pad1 = 0};
    for (const PixelRange& range : std::exchange(state.advanced, {})) {
        if (range.count == 0) continue;
        block.firstPixel = range.first;
        block.pixelCount = range.count;
        // Of a few pixels it costs mostly its start, which tells nothing of a whole one.
        std::optional<gpu::PassTimer::Region> region;
        if (range.count == state.pixels.count) region.emplace(timer.measure(encoder, "composite", range.count));
        composite.record(encoder, geometry, state.compositeGroup, block);
    }
    changed.include(state.pixels.bounds);
    if (state.reached < state.pixels.count) return;
    changed.include(state.silhouette.bounds);
    silhouette.record(encoder, geometry, state.silhouetteGroup,
                      {.pixelCount = state.silhouette.count,
                       .blendOriginal = material.blendOriginal,
                       .firstDrive = block.firstDrive,
                       .driveCount = block.driveCount});
}

/// With nothing else to do: true when samples of some segment are still being made, after waiting a little for them.
bool Renderer::Impl::awaitPoints(double seconds) {
    for (SegmentState& state : segments) {
        if (!state.translucent() || !state.pendingPoints.valid()) continue;
        state.pendingPoints.wait_for(std::chrono::duration<double>(seconds));
        return true;
    }
    return false;
}

void Renderer::Impl::recordDroppedReadback(const gpu::CommandEncoder& encoder) {
    dropped->dirty = false;
    dropped->pending = true;
    encoder.copyBufferToBuffer(paths.dropped, 0, dropped->staging, 0, sizeof(kernel::uint));
    encoder.onCompleted([reader = dropped] {
        reader->staging.mapAsync(
            gpu::MapMode::Read, 0, gpu::kWholeSize, [reader](gpu::MapAsyncStatus status, std::string_view) {
                reader->pending = false;
                if (status != gpu::MapAsyncStatus::Success) return;
                reader->value = *static_cast<const kernel::uint*>(reader->staging.getConstMappedRange());
                reader->staging.unmap();
            });
    });
}

/// Chooses the kernels for the BRDFs in use; what has not been compiled yet starts being compiled.
void Renderer::Impl::useKernels() {
    if (segments.empty()) return;
    std::uint32_t brdfs = 0;
    for (const kernel::SegmentShading& entry : shading) brdfs |= 1u << entry.brdf.type;
    const auto& user = userKernels.code();
    const auto part = [&](auto member) {
        using Code = const std::vector<std::uint32_t>;
        return user ? std::shared_ptr<Code>(user, &(*user.*member)) : nullptr;
    };
    reshade.useBrdfs(brdfs, !drives.empty(), part(&UserKernels::Code::reshade));
    if (std::any_of(segments.begin(), segments.end(), [](const SegmentState& s) { return s.translucent(); }))
        translucency.useBrdfs(brdfs, !drives.empty(), part(&UserKernels::Code::irradiance));
}

/// Waits a little for what is compiled on other threads.
bool Renderer::Impl::kernelsReady(double seconds) {
    if (!userKernels.ready(seconds)) return false;
    useKernels();
    if (device.compiling()) std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    return !device.compiling();
}

/// Until the kernels of the edits are compiled, the picture stays, or is the photograph when there is none.
void Renderer::Impl::keepPicture(const gpu::CommandEncoder& encoder) {
    if ((targets.result && !otherPhoto) || device.compiling()) return;
    std::vector<SegmentState> kept = std::exchange(segments, {});
    upload();
    geometry.record(encoder);
    encoder.copyTextureToTexture({.texture = geometry.photo()}, {.texture = targets.result},
                                 {geometry.width(), geometry.height()});
    changed = whole();
    otherPhoto = false;
    segments = std::move(kept);
}

bool Renderer::Impl::record(gpu::CommandEncoder& encoder, double budgetSeconds) {
    changed = {};
    if (!analysis) return false;
    timer.collect();
    const double patience = std::min(budgetSeconds, kBackgroundWait);
    const bool layers = layersReady(budgetSeconds);
    waiting = !kernelsReady(layers ? patience : 0) || !layers;
    if (waiting) {
        if (layers) keepPicture(encoder);
        return true;
    }
    upload();
    bool worked = false;
    geometry.record(encoder);
    if (resultStale) {
        encoder.copyTextureToTexture({.texture = geometry.photo()}, {.texture = targets.result},
                                     {geometry.width(), geometry.height()});
        for (SegmentState& state : segments) state.compositeStale = true;
        resultStale = otherPhoto = false;
        changed = whole();
        worked = true;
    }

    double left = budgetSeconds;
    for (const SegmentState& state : segments)
        if (state.compositeStale) left -= state.reached * timer.cost("composite", kCompositeGuess);
    do {
        const auto [state, task] = nextTask();
        if (task == Task::None) break;
        const double share = std::max(left, kLeastShare * budgetSeconds);
        switch (task) {
            case Task::Reshade:
                left -= recordReshade(encoder, *state, share);
                break;
            case Task::Filter:
                left -= recordFilter(encoder, *state, share);
                break;
            case Task::Irradiance:
                left -= recordIrradiance(encoder, *state, share);
                break;
            case Task::Gather:
                left -= recordGather(encoder, *state, share);
                break;
            case Task::None:
                break;
        }
        worked = true;
    } while (left > 0.1 * budgetSeconds);

    for (SegmentState& state : segments) {
        if (!state.compositeStale && state.advanced.empty()) continue;
        recordComposite(encoder, state);
        worked = true;
    }
    if (!worked) worked = waiting = awaitPoints(patience);
    if (dropped->pending) return worked || dropped->dirty;
    if (dropped->dirty) recordDroppedReadback(encoder);
    return worked;
}

// ---- Renderer -------------------------------------------------------------------------------------------------------

Renderer::Renderer(gpu::Device device, core::LightSampling lightSampling)
    : impl_(std::make_unique<Impl>(std::move(device), lightSampling)) {}
Renderer::~Renderer() = default;

void Renderer::setScene(const core::Scene& scene, std::shared_ptr<const core::Analysis> analysis) {
    impl_->setScene(scene, std::move(analysis));
}

bool Renderer::record(gpu::CommandEncoder& encoder, double budgetSeconds) {
    return impl_->record(encoder, budgetSeconds);
}

Renderer::Progress Renderer::progress() const {
    Progress progress;
    progress.target = impl_->scene.render.samples;
    progress.samples = progress.target;
    progress.waiting = impl_->waiting;
    progress.droppedSamples = impl_->dropped->value;
    progress.finished = impl_->analysis && impl_->nextTask().second == Task::None && !impl_->resultStale;
    double sum = 0;
    int works = 0;
    const auto add = [&](double done, double total) {
        sum += total > 0 ? std::min(done / total, 1.0) : 1.0;
        ++works;
    };
    for (const SegmentState& state : impl_->segments) {
        const bool prepared = static_cast<bool>(state.pixels.buffer);
        const bool making = state.translucent() && (state.pointsStale || state.pendingPoints.valid());
        if (!prepared || making) progress.finished = false;
        if (state.compositeStale && state.pixels.count > 0) progress.finished = false;
        if (prepared && state.pixels.count == 0) continue;
        progress.segments.push_back({.label = state.label,
                                     .samples = static_cast<int>(state.samples),
                                     .irradianceSamples = state.translucent() ? static_cast<int>(state.litPoints) : 0,
                                     .gatheredSamples = state.translucent() ? static_cast<int>(state.gathered) : 0});
        progress.samples = std::min(progress.samples, static_cast<int>(state.samples));
        const double sweep = prepared ? static_cast<double>(state.cursor) / state.pixels.count : 0;
        add(state.samples + sweep, impl_->targetSamples());
        if (state.translucent())
            add(prepared ? state.litPoints + state.gathered : 0,
                making ? std::numeric_limits<double>::infinity() : 2.0 * state.points.count);
    }
    progress.fraction = works > 0 ? static_cast<float>(sum / works) : (progress.finished ? 1.0f : 0.0f);
    return progress;
}

gpu::Texture Renderer::result() const { return impl_->targets.result; }

PixelBounds Renderer::changed() const { return impl_->changed; }

}  // namespace render
