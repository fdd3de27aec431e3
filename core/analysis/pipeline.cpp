// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/pipeline.h"

#include <array>
#include <map>
#include <set>

#include "core/analysis/step.h"

namespace core {
namespace {

using analysis::Board;
using analysis::Hash;
using analysis::Item;
using analysis::Step;

/// The steps of docs/method.md, in order. A new step is a file in its room and a line here.
const std::vector<Step>& analysisSteps() {
    static const std::vector<Step> kSteps = {
        analysis::recoverDepthStep(),    // Photo → Depth
        analysis::computeNormalsStep(),  // Photo, Depth → Front
        analysis::backSideStep(),        // Photo, Depth, Front, user's depth → Back
        analysis::depthLayersStep(),     // Photo, Front, Back → Layers
        analysis::reflectanceStep(),     // Photo, Front, Back, Layers → Reflectances
        analysis::environmentStep(),     // Photo, Depth, Reflectances, user's map → Environment
        analysis::textureDetailStep(),   // Photo, Front → TextureDetail
    };
    return kSteps;
}

}  // namespace

struct AnalysisPipeline::Cache {
    Board board;
    std::map<Item, std::uint64_t> itemKeys;  ///< content of what is on the board
    AnalysisPipeline::RunCounts runs;

    /// Content of an input image by its address; holding the image keeps the address from being reused.
    struct Input {
        std::shared_ptr<const void> image;
        std::uint64_t key = 0;
    };
    std::map<Item, Input> inputs;

    template <class T, class AddContent>
    void setInput(Item item, const std::shared_ptr<const T>& image, const AddContent& addContent) {
        Input& input = inputs[item];
        if (input.image != image || input.key == 0) {
            Hash hash;
            if (image) addContent(hash, *image);
            input = {image, hash.value()};
        }
        itemKeys[item] = input.key;
    }
};

AnalysisPipeline::AnalysisPipeline() : cache_(std::make_unique<Cache>()) {}
AnalysisPipeline::~AnalysisPipeline() = default;

const AnalysisPipeline::RunCounts& AnalysisPipeline::runCounts() const { return cache_->runs; }

std::shared_ptr<const Analysis> AnalysisPipeline::run(const Scene& whole, const Progress& progress,
                                                      AnalysisKernels& kernels) {
    const Scene scene = visibleScene(whole);
    if (!scene.photo || scene.photo->color.empty())
        throw Error(ErrorKind::Input,
                    Message("messages", "There is no photograph to analyse. Load a colour picture with depth first."));
    CORE_ASSERT(scene.photo->color.sameSize(scene.photo->depth) && scene.photo->color.sameSize(scene.photo->labels),
                "images of one size");
    Cache& cache = *cache_;
    const auto addImage = [](Hash& hash, const auto& image) { hash.add(image); };
    cache.setInput(Item::Photo, scene.photo, [](Hash& hash, const Photo& photo) {
        const Camera& c = photo.camera;
        hash.add(c.width).add(c.height).add(c.fx).add(c.fy).add(c.cx).add(c.cy);
        hash.add(photo.color.image())
            .add(photo.depth.image())
            .add(photo.labels)
            .add(photo.depthSampleSpacing)
            .add(photo.clipLevel);
    });
    cache.setInput(Item::UserBackDepth, scene.backDepth, addImage);
    cache.setInput(Item::UserEnvironment, scene.environment.image, addImage);

    // Keys identify what a result is made from, not the kernels that compute it: these agree within rounding
    // (core/analysis/kernels.h), so a result stays valid when the next run uses others.
    Board& board = cache.board;
    board.scene = &scene;
    for (const Step& step : analysisSteps()) {
        const StepContext context{progress.of(step.task), kernels};
        Hash hash;
        hash.add(step.task);
        for (const Item item : step.reads) hash.add(cache.itemKeys[item]);
        step.params(scene, hash);
        std::uint64_t& written = cache.itemKeys[step.writes];
        if (written != hash.value()) {
            context.progress.checkpoint(0);
            step.run(board, context);
            written = hash.value();
            ++cache.runs[step.task];
        }
        if (step.writes == Item::Layers) board.layersKey = written;
        context.progress.checkpoint(1);
    }
    board.scene = nullptr;

    auto analysis = std::make_shared<Analysis>();
    analysis->smoothing = board.depth->smoothing;
    analysis->front = board.front;
    analysis->back = std::shared_ptr<const Surface>(board.back, &board.back->surface);
    analysis->layers = board.layers;
    analysis->backSides = board.back->segments;
    analysis->reflectances = board.reflectances;
    analysis->environment = board.environment;
    analysis->textureDetail = board.textureDetail;
    return analysis;
}

}  // namespace core
