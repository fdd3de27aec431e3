// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sums/composite.h"

#include <utility>

#include "core/material/translucency.h"

namespace render {
namespace {

/// Assumed cost of one pixel before any was measured [s].
constexpr double kCompositeGuess = 5e-7;

}  // namespace

Blend blendOf(const ShadedScene& shaded, const core::Segment& segment) {
    const core::Material& material = *segment.edit;
    Blend blend{.blendNew = material.blendNew,
                .blendOriginal = material.blendOriginal,
                .translucent = material.translucency.has_value(),
                .drives = blendDriveKeys(shaded, segment)};
    if (material.translucency) {
        blend.translucentWeight = material.translucency->weight;
        blend.eta = core::profileFromTranslucency(*material.translucency).eta;
    }
    return blend;
}

double Composite::cost(const RenderContext& context, std::uint32_t pixels) {
    return pixels * context.sizer.cost("composite", kCompositeGuess);
}

void Composite::record(const Slice& slice, const Key& key, const PixelSet& set, const Source& source) {
    RenderContext& context = slice.context;
    const PixelList& pixels = set.pixels();
    std::vector<PixelRange> stale = std::exchange(advanced_, {});
    if (!current(key)) stale = {{0, source.reached}};
    shown_ = key;
    kernel::CompositeBlock block{.firstPixel = 0,
                                 .pixelCount = 0,
                                 .filtered = source.filtered ? 1u : 0u,
                                 .blendNew = key.blend.blendNew,
                                 .blendOriginal = key.blend.blendOriginal,
                                 .translucentWeight = key.blend.translucentWeight,
                                 .eta = key.blend.eta,
                                 .translucent = key.blend.translucent ? 1u : 0u,
                                 .firstDrive = source.drives.z,
                                 .driveCount = source.drives.w,
                                 .pad0 = 0,
                                 .pad1 = 0};
    const auto& group = group_.of([&](const auto&... from) { return context.composite.bind(from...); }, context.paths,
                                  pixels, context.targets);
    for (const PixelRange& range : stale) {
        if (range.count == 0) continue;
        block.firstPixel = range.first;
        block.pixelCount = range.count;
        // Timing a partial composite mostly measures launch overhead, so only full ones are timed.
        std::optional<gpu::PassTimer::Region> region;
        if (range.count == pixels.count) region.emplace(context.sizer.measure(slice.encoder, "composite", range.count));
        context.composite.record(slice.encoder, context.geometry, group, block);
    }
    if (source.reached < pixels.count) return;
    // The silhouette replaces what these pixels show, so it needs their composite anew: on its own result it would take
    // the background's share once more with every slice.
    const auto& mixedGroup = mixedGroup_.of([&](const auto&... from) { return context.composite.bind(from...); },
                                            context.paths, set.mixedInside(), context.targets);
    block.firstPixel = 0;
    block.pixelCount = set.mixedInside().count;
    if (block.pixelCount > 0) context.composite.record(slice.encoder, context.geometry, mixedGroup, block);
    const auto& silhouetteGroup =
        silhouetteGroup_.of([&](const auto&... from) { return context.silhouette.bind(from...); }, context.paths,
                            set.silhouette(), context.targets);
    context.silhouette.record(slice.encoder, context.geometry, silhouetteGroup,
                              {.pixelCount = set.silhouette().count,
                               .blendOriginal = key.blend.blendOriginal,
                               .firstDrive = source.drives.z,
                               .driveCount = source.drives.w});
}

}  // namespace render
