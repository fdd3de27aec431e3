// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"

#include <limits>

#include "core/material/brdf.h"
#include "core/shading/drive_table.h"
#include "core/shading/segment_shading.h"
#include "render/renderer_impl.h"

namespace render {
namespace {

// Of a budget, whatever the composite takes of it. Without, sums of large segments, whose composite is dearer than a
// budget, would advance by the least slice each time.
constexpr double kLeastShare = 0.1;

// For how long a call that could only wait for other threads does so [s]: too short to be felt in a window.
constexpr double kBackgroundWait = 2e-3;

constexpr double kRefinement = 2;    // rank of tasks from which on they refine what is on show
constexpr double kLongestSlice = 1;  // between two calls [s]; longer is a pause

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

}  // namespace

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
    for (SegmentState& state : segments) state.pixelsStale = true;  // who borders on whom
}

void Renderer::Impl::updateSegment(SegmentState& state, const core::Segment& segment) {
    const core::Material& material = *segment.edit;
    if (!sameBlend(state.material, material) || shading[segment.label].drives.w > 0) state.compositeStale = true;
    state.material = material;
    if (segment.glossy != state.glossy) {
        state.glossy = segment.glossy;
        resultStale = true;
    }

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
        refinedFor = 0;
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
        refinedFor = 0;
    }
    core::Translucency scattering = *material.translucency;
    scattering.weight = 1;
    scattering.preset.clear();
    if (!(scattering == state.scattering)) {
        state.scattering = std::move(scattering);
        state.restartGather();
        refinedFor = 0;
    }
}

/// The filter follows the samples at 1, 4, 16, ... and at the end: often enough to look refined, seldom enough to cost
/// little.
bool Renderer::Impl::wantsFilter(const SegmentState& state) const {
    if (!scene.render.filter || state.pixels.count == 0) return false;
    if (state.filterStep >= 0) return true;
    if (state.samples == state.filteredSamples) return false;
    if (timeUp()) return true;  // amid a sweep, too
    if (state.cursor != 0) return false;
    if (state.samples == targetSamples()) return true;
    return state.samples >= 1 && state.samples >= 4 * state.filteredSamples;
}

/// Counts the time in which one slice followed the other; a pause is none of it.
void Renderer::Impl::countTime() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> since = now - lastWork;
    if (since.count() < kLongestSlice) refinedFor += since.count();
    lastWork = now;
}

/// First a first picture of everything, then whatever is least advanced.
std::pair<SegmentState*, Task> Renderer::Impl::nextTask() {
    SegmentState* best = nullptr;
    Task task = Task::None;
    double bestRank = std::numeric_limits<double>::max();
    const auto offer = [&](SegmentState& state, Task t, double rank) {
        if (rank >= bestRank || (rank >= kRefinement && !mayRefine())) return;
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
            offer(state, Task::Reshade, kRefinement + static_cast<double>(state.samples) / targetSamples());
        }
        if (!state.translucent() || state.points.count == 0) continue;
        const double done = static_cast<double>(state.litPoints) / state.points.count;
        const double rank = state.gathered == 0 ? 1 : kRefinement + done;
        if (state.gatherTarget > 0 || state.gatherable() > state.gathered)
            offer(state, Task::Gather, rank);
        else if (state.litPoints < state.points.count)
            offer(state, Task::Irradiance, rank);
    }
    return {best, task};
}

bool Renderer::Impl::record(gpu::CommandEncoder& encoder, double budgetSeconds) {
    changed = {};
    if (!analysis) return false;
    timer.collect();
    const double patience = std::min(budgetSeconds, kBackgroundWait);
    const bool layers = layersReady(budgetSeconds);
    const bool pixels = pixelsReady(layers ? patience : 0);
    waiting = !kernelsReady(layers && pixels ? patience : 0) || !layers || !pixels;
    if (waiting) {
        if (layers) keepPicture(encoder);
        return true;
    }
    countTime();
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

Renderer::Renderer(gpu::Device device, core::LightSampling lightSampling)
    : impl_(std::make_unique<Impl>(std::move(device), lightSampling)) {}
Renderer::~Renderer() = default;

void Renderer::setScene(const core::Scene& scene, std::shared_ptr<const core::Analysis> analysis) {
    impl_->setScene(scene, std::move(analysis));
}

void Renderer::setRefining(bool refining) { impl_->refining = refining; }

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
    const bool refined = std::none_of(impl_->segments.begin(), impl_->segments.end(), [&](const SegmentState& state) {
        return state.pixels.count > 0 && (state.samples < impl_->targetSamples() ||
                                          (state.translucent() && state.litPoints < state.points.count));
    });
    progress.timeUp = progress.finished && !refined && impl_->timeUp();
    if (!refined && !progress.timeUp) progress.finished = false;
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
