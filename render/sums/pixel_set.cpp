// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sums/pixel_set.h"

#include <array>
#include <chrono>
#include <string>
#include <utility>

#include "core/base/parallel.h"
#include "render/kernels/kernels.h"

namespace render {
namespace {

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

}  // namespace

bool PixelSet::ready(RenderContext& context, double seconds) {
    if (found_ != wanted_ && !pending_.valid()) {
        finding_ = wanted_;
        pending_ = core::inBackground([key = wanted_] { return find(key); });
    }
    if (pending_.valid() && pending_.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready) {
        upload(context, pending_.get());
        found_ = std::exchange(finding_, {});
    }
    return found_ == wanted_;
}

PixelSet::Found PixelSet::find(const Key& key) {
    const core::LabelImage& labels = key.layers.photo->labels;
    const core::ImageF& depth = key.layers.front->depth;
    Found found;
    for (const auto& [x0, y0] : kSweepOrder)
        for (int y = y0; y < labels.height(); y += kSweepStep)
            for (int x = x0; x < labels.width(); x += kSweepStep)
                if (labels(x, y) == key.label && depth(x, y) > 0) {
                    found.list.push_back(static_cast<std::uint32_t>(x) | static_cast<std::uint32_t>(y) << 16);
                    found.bounds.add({x, y});
                }
    found.silhouette = core::findSilhouette(key.layers.photo->color, labels, depth, key.label, key.edited,
                                            core::coverageFrom(key.glossy));
    return found;
}

void PixelSet::upload(RenderContext& context, const Found& found) {
    if (!pixels_.buffer || found_.layers != finding_.layers || found_.label != finding_.label)
        pixels_ = {.buffer = makeBuffer(context.device, "pixels of segment " + std::to_string(finding_.label),
                                        gpu::BufferUsage::Storage, found.list),
                   .count = static_cast<std::uint32_t>(found.list.size()),
                   .bounds = found.bounds};
    silhouette_ = context.silhouette.upload(found.silhouette);
    std::vector<std::uint32_t> inside;
    for (const core::SilhouettePixel& p : found.silhouette)
        if (p.x == p.sourceX && p.y == p.sourceY)
            inside.push_back(static_cast<std::uint32_t>(p.x) | static_cast<std::uint32_t>(p.y) << 16);
    mixedInside_ = {.buffer = makeBuffer(context.device, "mixed pixels of segment " + std::to_string(finding_.label),
                                         gpu::BufferUsage::Storage, inside),
                    .count = static_cast<std::uint32_t>(inside.size()),
                    .bounds = silhouette_.bounds};
    ++silhouetteVersion_;
}

}  // namespace render
