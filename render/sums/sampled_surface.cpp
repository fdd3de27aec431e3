// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sums/sampled_surface.h"

#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/parallel.h"

namespace render {

void SampledSurface::follow(const Key& key) {
    if (key == key_) return;
    key_ = key;
    ++version_;
    points_ = {};
}

void SampledSurface::prepare(RenderContext& context, const ShadedScene& shaded) {
    if (pending_.valid() && pending_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        Made made = pending_.get();
        made_ = making_;
        if (made_ == version_) {
            samples_ = std::move(made.samples);
            points_ = context.translucency.upload(samples_);
            grids_ = context.diffusion.upload(std::move(made.grid), points_.sums, context.targets);
        }
    }
    if (made_ == version_ || pending_.valid()) return;
    making_ = version_;
    pending_ = core::inBackground([key = key_, analysis = shaded.analysis] { return make(key, *analysis); });
}

bool SampledSurface::await(double seconds) const {
    if (!pending_.valid()) return false;
    pending_.wait_for(std::chrono::duration<double>(seconds));
    return true;
}

SampledSurface::Made SampledSurface::make(const Key& key, const core::Analysis& analysis) {
    const core::LabelImage& labels = key.layers.photo->labels;
    Made made;
    made.samples = core::sampleSurface(analysis, labels, key.label, key.samples, key.seed);
    std::vector<core::Vector3f> positions;
    positions.reserve(made.samples.samples.size());
    for (const core::SurfaceSample& sample : made.samples.samples) positions.push_back(sample.position);
    made.grid = core::buildDiffusionGrid(positions, std::sqrt(made.samples.areaPerSample()), labels,
                                         analysis.front->depth, analysis.front->position, key.label, key.quality);
    return made;
}

}  // namespace render
