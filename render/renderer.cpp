// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "core/base/clock.h"
#include "render/backdrop.h"
#include "render/render_context.h"
#include "render/scene_upload.h"
#include "render/shaded_scene.h"
#include "render/sums/edited_segment.h"

namespace render {
namespace {

/// Share of a budget that sums get even where the composite takes all of it. Otherwise large segments, whose composite
/// alone exceeds the budget, would advance by the minimum slice only.
constexpr double kMinShare = 0.1;

/// A slice ends when less than this share of its budget is left.
constexpr double kRest = 0.1;

/// Longest wait of a call that can only wait for other threads [s]; too short to be felt in a window.
constexpr double kBackgroundWait = 2e-3;

/// Time spent on refinement since something restarted, without pauses.
class RefinementClock {
  public:
    void restart() { seconds_ = 0; }
    /// Adds the time since the last call, unless that was a pause.
    void tick() {
        constexpr double kMinPause = 1;  // [s]
        const double since = core::secondsSince(last_);
        if (since < kMinPause) seconds_ += since;
        last_ = core::Clock::now();
    }
    [[nodiscard]] double seconds() const { return seconds_; }

  private:
    double seconds_ = 0;
    core::Clock::time_point last_;
};

}  // namespace

/// Decides what comes next. Each sum knows by itself when it is stale (render/sums).
struct Renderer::Impl {
    Impl(gpu::Device device, core::LightSampling lightSampling)
        : context(std::move(device)), sceneUpload(lightSampling) {}

    RenderContext context;
    SceneUpload sceneUpload;
    ShadedScene shaded;
    UserKernels userKernels;
    Backdrop backdrop;
    std::vector<EditedSegment> segments;  ///< by label
    RefinementClock clock;
    bool refining = true;
    bool waiting = false;    ///< the last `record` could only wait for other threads
    core::PixelBox changed;  ///< by the last `record`, in the result

    void setScene(const core::Scene& scene, std::shared_ptr<const core::Analysis> analysis);
    void requireFits(const ShadedScene& next) const;
    void followEdits();

    bool record(const gpu::CommandEncoder& encoder, double budgetSeconds);
    [[nodiscard]] bool inputsReady(const gpu::CommandEncoder& encoder, double budgetSeconds);
    [[nodiscard]] bool pixelsReady(double seconds);
    [[nodiscard]] bool kernelsReady(double seconds);
    void useKernels();
    void prepare();
    void showPhotograph(const gpu::CommandEncoder& encoder);
    bool recordBackdrop(const gpu::CommandEncoder& encoder, const Backdrop::Key& key);
    bool recordSums(const gpu::CommandEncoder& encoder, double budgetSeconds);
    bool recordComposites(const gpu::CommandEncoder& encoder);
    [[nodiscard]] bool awaitSurfaces(double seconds) const;

    [[nodiscard]] std::pair<EditedSegment*, Work> nextWork();
    [[nodiscard]] Progress progress();
    [[nodiscard]] Backdrop::Key backdropKey() const;
    [[nodiscard]] bool anyTranslucent() const;
    [[nodiscard]] bool timeUp() const {
        const double limit = shaded.scene.render.timeLimit;
        return limit > 0 && clock.seconds() >= limit;
    }
};

void Renderer::Impl::setScene(const core::Scene& scene, std::shared_ptr<const core::Analysis> analysis) {
    CORE_ASSERT(scene.photo && analysis && analysis->front && analysis->back, "a photo and its surfaces");
    context.geometry.requireFits(static_cast<std::uint32_t>(scene.photo->color.width()),
                                 static_cast<std::uint32_t>(scene.photo->color.height()));
    ShadedScene next = shadeScene(core::visibleScene(scene), std::move(analysis), shaded);
    requireFits(next);
    const bool otherLight = !shaded.analysis || next.analysis->environment != shaded.analysis->environment;
    if (otherLight || next.layers() != shaded.layers()) segments.clear();
    shaded = std::move(next);
    followEdits();
    userKernels.want(shaded.userBrdfs, anyTranslucent());
}

void Renderer::Impl::requireFits(const ShadedScene& next) const {
    context.geometry.requireBufferFits("varying parameters", next.drives.valueCount * sizeof(float));
    MeasuredTables::requireFits(context.device, next.measured);
}

void Renderer::Impl::followEdits() {
    std::vector<EditedSegment> edited;
    for (const core::Segment& segment : shaded.scene.segments) {
        if (!isEdited(segment)) continue;
        const auto old = std::ranges::find(segments, segment.label, &EditedSegment::label);
        edited.push_back(old != segments.end() ? std::move(*old) : EditedSegment(segment.label));
        if (edited.back().follow(shaded, segment)) clock.restart();
    }
    segments = std::move(edited);
}

bool Renderer::Impl::record(const gpu::CommandEncoder& encoder, double budgetSeconds) {
    changed = {};
    if (!shaded.analysis) return false;
    context.sizer.collect();
    waiting = !inputsReady(encoder, budgetSeconds);
    if (waiting) return true;
    clock.tick();
    prepare();
    context.geometry.record(encoder);
    bool worked = recordBackdrop(encoder, backdropKey());
    worked = recordSums(encoder, budgetSeconds) || worked;
    worked = recordComposites(encoder) || worked;
    if (!worked) worked = waiting = awaitSurfaces(std::min(budgetSeconds, kBackgroundWait));
    return context.dropped.record(encoder) || worked;
}

/// Uploads the picture, finds pixels and compiles kernels, on other threads where that takes long. True when all is
/// there; until then the picture stays as it is.
bool Renderer::Impl::inputsReady(const gpu::CommandEncoder& encoder, double budgetSeconds) {
    const double patience = std::min(budgetSeconds, kBackgroundWait);
    const bool layers = sceneUpload.layersReady(context, shaded, budgetSeconds);
    const bool pixels = pixelsReady(layers ? patience : 0);
    const bool kernels = kernelsReady(layers && pixels ? patience : 0);
    if (layers && pixels && kernels) return true;
    if (layers) showPhotograph(encoder);
    return false;
}

bool Renderer::Impl::pixelsReady(double seconds) {
    bool ready = true;
    for (EditedSegment& segment : segments) ready = segment.pixelsReady(context, ready ? seconds : 0) && ready;
    return ready;
}

bool Renderer::Impl::kernelsReady(double seconds) {
    if (!userKernels.ready(seconds)) return false;
    useKernels();
    if (context.device.compiling()) std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    return !context.device.compiling();
}

/// Chooses the kernels for the BRDFs in use; those that were never compiled begin to be.
void Renderer::Impl::useKernels() {
    if (segments.empty()) return;
    const std::uint32_t brdfs = shaded.brdfs();
    const bool driven = !shaded.drives.empty();
    const auto& user = userKernels.code();
    const auto part = [&](auto member) {
        using Code = const std::vector<std::uint32_t>;
        return user ? std::shared_ptr<Code>(user, &(*user.*member)) : nullptr;
    };
    context.reshade.useBrdfs(brdfs, driven, part(&UserKernels::Code::reshade));
    if (anyTranslucent()) context.translucency.useBrdfs(brdfs, driven, part(&UserKernels::Code::irradiance));
}

/// Makes and uploads what the next slices read and write.
void Renderer::Impl::prepare() {
    sceneUpload.follow(context, shaded);
    fitTargets(context.targets, context.device, context.geometry.width(), context.geometry.height(),
               {.filter = shaded.scene.render.filter && !segments.empty(), .translucency = anyTranslucent()});
    for (EditedSegment& segment : segments) segment.prepareSurface(context, shaded);
}

/// Shows the photograph until its edits can be rendered, unless edits of the same photograph are on show.
void Renderer::Impl::showPhotograph(const gpu::CommandEncoder& encoder) {
    if (backdrop.shows(shaded.layers()) || context.device.compiling()) return;
    sceneUpload.follow(context, shaded);
    fitTargets(context.targets, context.device, context.geometry.width(), context.geometry.height(), {});
    context.geometry.record(encoder);
    Backdrop::Key key = backdropKey();
    key.edited.clear();
    recordBackdrop(encoder, key);
}

bool Renderer::Impl::recordBackdrop(const gpu::CommandEncoder& encoder, const Backdrop::Key& key) {
    if (!backdrop.record(encoder, context.geometry.photo(), key)) return false;
    changed.add(core::Pixel{0, 0});
    changed.add(
        core::Pixel{static_cast<int>(context.geometry.width()) - 1, static_cast<int>(context.geometry.height()) - 1});
    return true;
}

/// Slices of the sums until the budget is used up, at least one.
bool Renderer::Impl::recordSums(const gpu::CommandEncoder& encoder, double budgetSeconds) {
    double left = budgetSeconds;
    for (const EditedSegment& segment : segments) left -= segment.compositeCost(context, backdrop.version());
    bool worked = false;
    do {
        const auto [segment, work] = nextWork();
        if (work == Work::None) break;
        left -= segment->record(work, {context, encoder, std::max(left, kMinShare * budgetSeconds)});
        worked = true;
    } while (left > kRest * budgetSeconds);
    return worked;
}

bool Renderer::Impl::recordComposites(const gpu::CommandEncoder& encoder) {
    bool worked = false;
    for (EditedSegment& segment : segments) {
        if (!segment.compositeDue(backdrop.version())) continue;
        changed.unite(segment.recordComposite({context, encoder, 0}, backdrop.version(), shaded));
        worked = true;
    }
    return worked;
}

/// True while surface samples of some segment are being made, after waiting a little for them.
bool Renderer::Impl::awaitSurfaces(double seconds) const {
    return std::ranges::any_of(segments, [&](const EditedSegment& s) { return s.awaitSurface(seconds); });
}

/// First a first picture of everything, then whatever has advanced least.
std::pair<EditedSegment*, Work> Renderer::Impl::nextWork() {
    EditedSegment* first = nullptr;
    Offer best;
    const bool over = timeUp();
    for (EditedSegment& segment : segments) {
        for (const Offer& offer : segment.offers(over)) {
            if (offer.rank >= best.rank || (offer.rank >= kRefinement && (over || !refining))) continue;
            first = &segment;
            best = offer;
        }
    }
    return {first, best.work};
}

Renderer::Progress Renderer::Impl::progress() {
    Progress progress;
    progress.target = progress.samples = shaded.scene.render.samples;
    progress.waiting = waiting;
    progress.droppedSamples = context.dropped.value();
    const bool idle = shaded.analysis && nextWork().second == Work::None && backdrop.current(backdropKey());
    const bool refined = std::ranges::all_of(segments, &EditedSegment::refined);
    progress.timeUp = idle && !refined && timeUp();
    progress.finished =
        idle && (refined || progress.timeUp) &&
        std::ranges::all_of(segments, [&](const EditedSegment& s) { return s.settled(backdrop.version()); });
    double done = 0;
    int sums = 0;
    for (const EditedSegment& segment : segments) {
        if (!segment.visible()) continue;
        progress.segments.push_back(segment.progress());
        progress.samples = std::min(progress.samples, progress.segments.back().samples);
        segment.addShares(done, sums);
    }
    progress.fraction = sums > 0 ? static_cast<float>(done / sums) : (progress.finished ? 1.0f : 0.0f);
    return progress;
}

Backdrop::Key Renderer::Impl::backdropKey() const {
    Backdrop::Key key{.layers = shaded.layers(),
                      .environment = shaded.analysis->environment,
                      .edited = {},
                      .result = context.targets.result};
    for (const core::Segment& segment : shaded.scene.segments)
        if (isEdited(segment)) key.edited.emplace_back(segment.label, segment.glossy);
    return key;
}

bool Renderer::Impl::anyTranslucent() const { return std::ranges::any_of(segments, &EditedSegment::translucent); }

Renderer::Renderer(gpu::Device device, core::LightSampling lightSampling)
    : impl_(std::make_unique<Impl>(std::move(device), lightSampling)) {}
Renderer::~Renderer() = default;

void Renderer::setScene(const core::Scene& scene, std::shared_ptr<const core::Analysis> analysis) {
    impl_->setScene(scene, std::move(analysis));
}

void Renderer::setRefining(bool refining) { impl_->refining = refining; }

bool Renderer::record(gpu::CommandEncoder& encoder, double budgetSeconds) {
    return impl_->record(encoder, budgetSeconds);
}

Renderer::Progress Renderer::progress() const { return impl_->progress(); }

gpu::Texture Renderer::result() const { return impl_->context.targets.result; }

core::PixelBox Renderer::changed() const { return impl_->changed; }

}  // namespace render
