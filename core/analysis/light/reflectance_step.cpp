// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/analysis/light/reflectance.h"
#include "core/analysis/step.h"

namespace core::analysis {
namespace {

/// What the reflections of all segments depend on. Which surfaces are glossy decides which colours count as known, for
/// every one of them. A segment's own ρ and lobe width replace the estimate afterwards and stay out of the key.
std::uint64_t reflectionsKey(const Board& board, std::span<const Segment* const> glossy) {
    Hash hash;
    addParams(hash.add(board.layersKey), Stage::Reflectance, *board.scene);
    for (const Segment* segment : glossy) hash.add(segment->label);
    return hash.value();
}

/// Estimates the segments whose cached reflections have another key, and forgets segments that are no longer glossy.
void updateCache(Board& board, std::span<const Segment* const> glossy, const StepContext& context) {
    const Scene& scene = *board.scene;
    const std::uint64_t key = reflectionsKey(board, glossy);
    std::erase_if(board.reflectanceCache, [&](const auto& entry) {
        return std::ranges::none_of(glossy, [&](const Segment* s) { return s->label == entry.first; });
    });
    std::vector<std::uint16_t> stale;
    for (const Segment* segment : glossy)
        if (const CachedReflectance& cached = board.reflectanceCache[segment->label];
            !cached.reflections || cached.key != key)
            stale.push_back(segment->label);
    if (stale.empty()) return;

    LabelTable<bool> isGlossy(false);
    for (const Segment* segment : glossy) isGlossy[segment->label] = true;
    const auto marcher = context.kernels.rayMarcher(*board.layers);
    const ContinuedSupports continued(scene.photo->camera, scene.photo->labels, *board.front);
    for (std::size_t i = 0; i < stale.size(); ++i) {
        const auto count = static_cast<float>(stale.size());
        const StepContext part = context.part(static_cast<float>(i) / count, static_cast<float>(i + 1) / count);
        const ReflectanceInput in{
            scene,    *board.front, board.back->surface,     *marcher, board.depth->distant, continued,
            isGlossy, stale[i],     scene.environment.height};
        board.reflectanceCache[stale[i]] = {key, std::make_shared<SegmentReflections>(estimateReflectance(in, part))};
    }
}

}  // namespace

Step reflectanceStep() {
    Step step;
    step.task = Task::EstimateReflectance;
    step.reads = {Item::Photo, Item::Depth, Item::Front, Item::Back, Item::Layers};
    step.writes = Item::Reflectances;
    step.params = [](const Scene& scene, Hash& hash) {
        addParams(hash, Stage::Reflectance, scene);
        for (const Segment& segment : scene.segments)
            if (segment.glossy) addParams(hash.add(segment.label), Stage::Reflectance, segment);
    };
    step.run = [](Board& board, const StepContext& context) {
        std::vector<const Segment*> glossy;
        for (const Segment& segment : board.scene->segments)
            if (segment.glossy) glossy.push_back(&segment);
        updateCache(board, glossy, context);
        std::vector<std::shared_ptr<const Reflectance>> reflectances;
        std::vector<std::shared_ptr<const SegmentReflections>> reflections;
        for (const Segment* segment : glossy) {
            reflections.push_back(board.reflectanceCache[segment->label].reflections);
            auto reflectance = std::make_shared<Reflectance>(reflections.back()->estimate);
            if (segment->reflectance) reflectance->rho = *segment->reflectance;
            if (segment->lobeWidth) reflectance->alpha = *segment->lobeWidth;
            reflectances.push_back(std::move(reflectance));
        }
        board.reflectances = std::move(reflectances);
        board.reflections = std::move(reflections);
    };
    return step;
}

}  // namespace core::analysis
