// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scene_upload.h"

#include "core/geometry/depth_layers.h"

namespace render {

bool SceneUpload::layersReady(RenderContext& context, const ShadedScene& shaded, double seconds) {
    if (const PictureLayers wanted = shaded.layers(); layers_ != wanted) {
        std::shared_ptr<const core::DepthLayers> layers = shaded.analysis->layers;
        if (!layers)
            layers = std::make_shared<core::DepthLayers>(
                core::buildDepthLayers(wanted.photo->camera, wanted.photo->labels, *wanted.front, *wanted.back));
        layers_ = {};
        context.geometry.beginLayers(*layers, wanted.photo->color, *wanted.front, *wanted.back);
        layers_ = wanted;
        uploading_ = std::move(layers);
    }
    if (!context.geometry.uploadRows(seconds)) return false;
    uploading_ = {};
    return true;
}

void SceneUpload::follow(RenderContext& context, const ShadedScene& shaded) {
    if (environment_ != shaded.analysis->environment) {
        const auto& environment = shaded.analysis->environment;
        context.geometry.setEnvironment(environment ? *environment : core::DirectionalMap(), lightSampling_);
        environment_ = environment;
    }
    if (revision_ == shaded.revision) return;
    uploadMaterials(context, shaded);
    revision_ = shaded.revision;
}

void SceneUpload::uploadMaterials(RenderContext& context, const ShadedScene& shaded) {
    PathInputs& paths = context.paths;
    const std::uint64_t bytes = shaded.shading.size() * sizeof(kernel::SegmentShading);
    if (paths.shading && paths.shading.size() == bytes)
        context.device.queue().writeBuffer(paths.shading, 0, shaded.shading);
    else
        paths.shading = makeBuffer(context.device, "segment shading", gpu::BufferUsage::Storage, shaded.shading);
    drives_.upload(context.device, shaded.drives);
    paths.drives = drives_.drives();
    paths.driveValues = drives_.values();
    paths.measured = measured_.upload(context.device, shaded.measured);
}

}  // namespace render
