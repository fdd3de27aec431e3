// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/readback.h"
#include "render/renderer.h"

namespace render {

core::ImageRgb readResult(const gpu::Device& device, const Renderer& renderer) {
    const gpu::Texture result = renderer.result();
    core::ImageRgb image(static_cast<int>(result.width()), static_cast<int>(result.height()));
    const std::vector<float> texels = gpu::readTexture<float>(device, result);
    for (std::size_t i = 0; i < image.size(); ++i)
        image[i] = core::Vector3f(texels[4 * i], texels[4 * i + 1], texels[4 * i + 2]);
    return image;
}

core::ImageRgb renderImage(gpu::Device device, const core::Scene& scene,
                           const std::shared_ptr<const core::Analysis>& analysis, const core::Progress& progress,
                           Renderer::Progress* reached) {
    // Long enough to keep the device busy between submissions, short enough for prompt cancellation.
    constexpr double kSubmissionSeconds = 0.12;
    Renderer renderer(device);
    renderer.setScene(scene, analysis);
    progress.checkpoint(0);
    while (true) {
        gpu::CommandEncoder encoder = device.createCommandEncoder({.label = "render"});
        const bool worked = renderer.record(encoder, kSubmissionSeconds);
        device.queue().submit(encoder.finish());
        device.waitIdle();
        progress.checkpoint(renderer.progress().fraction);
        if (!worked) break;
    }
    if (reached != nullptr) *reached = renderer.progress();
    return readResult(device, renderer);
}

}  // namespace render
