// SPDX-License-Identifier: GPL-3.0-or-later
// What the device has to hold before a slice can be recorded.
#include <thread>

#include "core/base/parallel.h"
#include "core/shading/segment_shading.h"
#include "render/renderer_impl.h"

namespace render {
namespace {

gpu::Texture makeTarget(const gpu::Device& device, const char* label, std::uint32_t width, std::uint32_t height,
                        gpu::TextureFormat format = gpu::TextureFormat::RGBA32Float) {
    return device.createTexture({.label = label,
                                 .size = {width, height},
                                 .format = format,
                                 .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::StorageBinding |
                                          gpu::TextureUsage::CopySrc | gpu::TextureUsage::CopyDst});
}

}  // namespace

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
        if (!state.reshadeGroup) state.reshadeGroup = reshade.bind(paths, state.pixels, targets);
        if (state.translucent()) prepareTranslucency(state);
        if (scene.render.filter && !state.filterBound) {
            state.filterGroups = filter.bind(state.pixels, targets);
            state.filterBound = true;
        }
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

/// Goes on finding the pixels of segments, after waiting a little for them; true when all are on the device.
bool Renderer::Impl::pixelsReady(double seconds) {
    bool ready = true;
    for (SegmentState& state : segments) {
        if (state.pixelsStale && !state.pendingPixels.valid()) {
            state.pixelsStale = false;
            state.pendingPixels = core::inBackground([photo = scene.photo, front = analysis->front, label = state.label,
                                                      edited = core::editedLabels(shading), glossy = state.glossy] {
                return findSegmentPixels(*photo, front->depth, label, edited, core::coverageFrom(glossy));
            });
        }
        if (!state.pendingPixels.valid()) continue;
        const std::chrono::duration<double> patience(ready ? seconds : 0);
        if (state.pendingPixels.wait_for(patience) == std::future_status::ready)
            uploadPixels(state, state.pendingPixels.get());
        ready = ready && !state.pendingPixels.valid() && !state.pixelsStale;
    }
    return ready;
}

void Renderer::Impl::uploadPixels(SegmentState& state, const SegmentPixels& found) {
    if (!state.pixels.buffer) {
        state.pixels = {.buffer = makeBuffer(device, "pixels of segment " + std::to_string(state.label),
                                             gpu::BufferUsage::Storage, found.list),
                        .count = static_cast<std::uint32_t>(found.list.size()),
                        .bounds = found.bounds};
    }
    state.silhouette = silhouette.upload(found.outline);
    state.silhouetteGroup = {};
    state.compositeStale = true;
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

}  // namespace render
