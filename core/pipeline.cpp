// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline.h"

#include <array>
#include <map>
#include <set>

#include "core/drives.h"
#include "core/steps/step.h"

namespace core {
namespace {

using steps::Board;
using steps::Hash;
using steps::Item;
using steps::Step;

/// The graph of DESIGN section 3, in order. A new step is a file in core/steps and a line here.
const std::vector<Step>& analysisSteps() {
    static const std::vector<Step> kSteps = {
        steps::filterDepthStep(),    // Photo                          → Depth         3.1
        steps::surfaceStep(),        // Photo, Depth                   → Front         3.1
        steps::backSideStep(),       // Photo, Depth, Front, user depth → Back          3.2
        steps::depthLayersStep(),    // Photo, Front, Back             → Layers
        steps::reflectanceStep(),    // Photo, Front, Back, Layers     → Reflectances  3.3
        steps::environmentStep(),    // Photo, Depth, Reflectances, user map → Environment   3.4
        steps::textureDetailStep(),  // Photo, Front               → TextureDetail
    };
    return kSteps;
}

bool sameLight(const EnvironmentParams& a, const EnvironmentParams& b) {
    return a.image == b.image && a.path == b.path && a.rotation == b.rotation && a.scale == b.scale && a.use == b.use &&
           a.fill == b.fill;
}

/// Weights are applied when the picture is put together; everything else in a material is part of its light transport.
std::optional<Material> withoutWeights(const std::optional<Material>& material) {
    if (!material) return std::nullopt;
    Material result = *material;
    result.blendNew = 1;
    result.blendOriginal = 0;
    if (result.translucency) {
        result.translucency->weight = 1;
        result.translucency->preset.clear();
    }
    return result;
}

Stage firstChangedSegmentStage(const Scene& before, const Scene& after) {
    if (before.segments.size() != after.segments.size()) return Stage::BackSide;
    Stage first = Stage::Display;
    bool translucent = false;
    for (const Scene* scene : {&before, &after})
        for (const Segment& segment : scene->segments)
            translucent = translucent || (segment.edit && segment.edit->translucency);
    const auto touch = [&](bool changed, Stage stage) {
        if (changed) first = std::min(first, stage);
    };
    for (std::size_t i = 0; i < before.segments.size(); ++i) {
        const Segment& a = before.segments[i];
        const Segment& b = after.segments[i];
        touch(a.smoothing != b.smoothing, Stage::Geometry);
        touch(a.label != b.label || a.backSide != b.backSide, Stage::BackSide);
        touch(a.glossy != b.glossy || a.reflectance != b.reflectance || a.lobeWidth != b.lobeWidth, Stage::Reflectance);
        const auto detail = [](const Segment& s) { return s.edit && drivenByLuminance(*s.edit); };
        touch(detail(a) != detail(b), Stage::Environment);
        // Light that reaches a translucent segment may come by way of any other edited one.
        touch(withoutWeights(a.edit) != withoutWeights(b.edit), translucent ? Stage::Irradiance : Stage::Reshade);
        touch(a.edit != b.edit, Stage::Composite);
    }
    return first;
}

}  // namespace

Stage firstChangedStage(const Scene& before, const Scene& after) {
    if (before.photo != after.photo) return Stage::Input;
    if (before.depthFilter != after.depthFilter) return Stage::Geometry;
    Stage first = firstChangedSegmentStage(before, after);
    const auto touch = [&](bool changed, Stage stage) {
        if (changed) first = std::min(first, stage);
    };
    touch(before.backDepth != after.backDepth, Stage::BackSide);
    touch(before.environment.height != after.environment.height, Stage::Reflectance);
    touch(!sameLight(before.environment, after.environment), Stage::Environment);
    const RenderParams& a = before.render;
    const RenderParams& b = after.render;
    touch(a.seed != b.seed || a.bounces != b.bounces || a.surfaceSamples != b.surfaceSamples ||
              a.irradianceSamples != b.irradianceSamples || a.diffusionQuality != b.diffusionQuality,
          Stage::Irradiance);
    touch(a.samples != b.samples || a.timeLimit != b.timeLimit, Stage::Reshade);
    touch(a.filter != b.filter, Stage::Composite);
    return first;
}

struct AnalysisPipeline::Cache {
    Board board;
    std::map<Item, std::uint64_t> itemKeys;  ///< content of what is on the board
    AnalysisPipeline::RunCounts runs;

    /// Content of an input image by its address, held so that the address cannot come to mean another image.
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

std::shared_ptr<const Analysis> AnalysisPipeline::run(const Scene& scene, const StepContext& context) {
    if (!scene.photo || scene.photo->color.empty())
        throw Error(ErrorKind::Input, "There is no photograph to analyse. Load a colour picture with depth first.");
    CORE_ASSERT(scene.photo->color.sameSize(scene.photo->depth) && scene.photo->color.sameSize(scene.photo->labels),
                "images of one size");
    Cache& cache = *cache_;
    const auto addImage = [](Hash& hash, const auto& image) { hash.add(image); };
    cache.setInput(Item::Photo, scene.photo, [](Hash& hash, const Photo& photo) {
        const Camera& c = photo.camera;
        hash.add(c.width).add(c.height).add(c.fx).add(c.fy).add(c.cx).add(c.cy);
        hash.add(photo.color).add(photo.depth).add(photo.labels).add(photo.depthStep).add(photo.clipLevel);
    });
    cache.setInput(Item::UserBackDepth, scene.backDepth, addImage);
    cache.setInput(Item::UserEnvironment, scene.environment.image, addImage);

    // Keys say what a result is made from, not who computes it: the kernels of the context are twins that agree within
    // rounding (core/analysis_kernels.h), so a result of one stays valid when the next run is given another.
    Board& board = cache.board;
    board.scene = &scene;
    for (const Step& step : analysisSteps()) {
        Hash hash;
        hash.add(std::string(step.name));
        for (const Item item : step.reads) hash.add(cache.itemKeys[item]);
        step.params(scene, hash);
        std::uint64_t& written = cache.itemKeys[step.writes];
        if (written != hash.value()) {
            context.checkpoint(step.name, 0);
            step.run(board, context);
            written = hash.value();
            ++cache.runs[step.name];
        }
        if (step.writes == Item::Layers) board.layersKey = written;
        context.checkpoint(step.name, 1);
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
