// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/step.h"

namespace core::analysis {

Step depthLayersStep() {
    Step step;
    step.task = Task::BuildDepthLayers;
    step.reads = {Item::Photo, Item::Front, Item::Back};
    step.writes = Item::Layers;
    step.params = [](const Scene&, Hash&) {};
    step.run = [](Board& board, const StepContext& context) {
        const Photo& photo = *board.scene->photo;
        board.layers = std::make_shared<DepthLayers>(
            buildDepthLayers(photo.camera, photo.labels, *board.front, board.back->surface, context.progress));
    };
    return step;
}

}  // namespace core::analysis
