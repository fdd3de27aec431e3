// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sums/edited_segment.h"

#include <algorithm>

#include "core/material/translucency.h"
#include "core/shading/segment_shading.h"

namespace render {

bool EditedSegment::follow(const ShadedScene& shaded, const core::Segment& segment) {
    const core::RenderParams& params = shaded.scene.render;
    pixels_.follow({.layers = shaded.layers(),
                    .label = label_,
                    .glossy = segment.glossy,
                    .edited = core::editedLabels(shaded.shading)});
    bool restarted =
        reshade_.follow(cameraPathKey(shaded, segment), static_cast<std::uint32_t>(std::max(params.samples, 1)));
    filtered_.follow(reshade_, params.filter);
    blend_ = blendOf(shaded, segment);
    if (segment.edit->translucency)
        restarted = followTranslucency(shaded, *segment.edit->translucency) || restarted;
    else
        body_.reset();
    return restarted;
}

bool EditedSegment::followTranslucency(const ShadedScene& shaded, const core::Translucency& translucency) {
    const core::RenderParams& params = shaded.scene.render;
    if (!body_) body_.emplace();
    body_->surface.follow({.layers = shaded.layers(),
                           .label = label_,
                           .seed = params.seed,
                           .samples = params.surfaceSamples,
                           .quality = params.diffusionQuality});
    const bool relit = body_->light.follow({.paths = enteringPathKey(shaded),
                                            .raysPerSample = params.irradianceSamples,
                                            .eta = blend_.eta,
                                            .surface = body_->surface.version()});
    return body_->sum.follow(body_->light, translucency) || relit;
}

void EditedSegment::prepareSurface(RenderContext& context, const ShadedScene& shaded) {
    if (body_) body_->surface.prepare(context, shaded);
}

std::array<Offer, 2> EditedSegment::offers(bool timeUp) const {
    if (pixels_.pixels().count == 0) return {};
    return {surfaceOffer(timeUp), bodyOffer()};
}

Offer EditedSegment::surfaceOffer(bool timeUp) const {
    if (reshade_.samples() == 0) return {Work::Reshade, 0};
    if (filtered_.due(reshade_, timeUp)) return {Work::Filter, 1.5};
    if (reshade_.complete()) return {};
    return {Work::Reshade, kRefinement + static_cast<double>(reshade_.samples()) / reshade_.target()};
}

Offer EditedSegment::bodyOffer() const {
    if (!body_ || body_->surface.points().count == 0) return {};
    const SurfacePoints& points = body_->surface.points();
    const double lit = static_cast<double>(body_->light.litSamples()) / points.count;
    const double rank = body_->sum.samples() == 0 ? 1 : kRefinement + lit;
    if (body_->sum.due(body_->light, points)) return {Work::Diffusion, rank};
    if (body_->light.litSamples() < points.count) return {Work::Light, rank};
    return {};
}

double EditedSegment::record(Work work, const Slice& slice) {
    switch (work) {
        case Work::Reshade: {
            const auto advance = reshade_.record(slice, label_, pixels_.pixels(), filtered_.nextStop(reshade_));
            // A filtered picture stays on show until the next one is ready.
            if (!filtered_.shown()) composite_.add(advance.pixels);
            return advance.seconds;
        }
        case Work::Filter:
            return filtered_.record(slice, pixels_.pixels(), reshade_);
        case Work::Light:
            return body_->light.record(slice, label_, body_->surface.points());
        case Work::Diffusion:
            return body_->sum.record(slice, body_->surface, body_->light);
        case Work::None:
            break;
    }
    return 0;
}

Composite::Key EditedSegment::compositeKey(std::uint64_t backdrop) const {
    return {.blend = blend_,
            .filterEnabled = filtered_.enabled(),
            .backdrop = backdrop,
            .silhouette = pixels_.silhouetteVersion(),
            .filteredPicture = filtered_.version(),
            .diffusion = body_ ? body_->sum.version() : 0};
}

bool EditedSegment::compositeCurrent(std::uint64_t backdrop) const {
    return composite_.current(compositeKey(backdrop));
}

bool EditedSegment::compositeDue(std::uint64_t backdrop) const { return composite_.due(compositeKey(backdrop)); }

double EditedSegment::compositeCost(const RenderContext& context, std::uint64_t backdrop) const {
    return compositeCurrent(backdrop) ? 0 : Composite::cost(context, reshade_.reached());
}

core::PixelBox EditedSegment::recordComposite(const Slice& slice, std::uint64_t backdrop, const ShadedScene& shaded) {
    composite_.record(
        slice, compositeKey(backdrop), pixels_,
        {.reached = reshade_.reached(), .filtered = filtered_.shown(), .drives = shaded.shading[label_].drives});
    core::PixelBox changed = pixels_.pixels().bounds;
    if (reshade_.reached() >= pixels_.pixels().count) changed.unite(pixels_.silhouette().bounds);
    return changed;
}

bool EditedSegment::refined() const {
    if (pixels_.pixels().count == 0) return true;
    return reshade_.complete() && (!body_ || body_->light.litSamples() >= body_->surface.points().count);
}

bool EditedSegment::settled(std::uint64_t backdrop) const {
    if (!pixels_.found() || (body_ && !body_->surface.ready())) return false;
    return pixels_.pixels().count == 0 || compositeCurrent(backdrop);
}

Renderer::SegmentProgress EditedSegment::progress() const {
    return {.label = label_,
            .samples = static_cast<int>(reshade_.samples()),
            .irradianceSamples = body_ ? static_cast<int>(body_->light.litSamples()) : 0,
            .gatheredSamples = body_ ? static_cast<int>(body_->sum.samples()) : 0};
}

void EditedSegment::addShares(double& done, int& sums) const {
    done += std::min(reshade_.progress() / reshade_.target(), 1.0);
    ++sums;
    if (!body_) return;
    const double all = 2.0 * body_->surface.points().count;
    const double share = all > 0 ? (body_->light.litSamples() + body_->sum.samples()) / all : 1;
    if (pixels_.found() && body_->surface.ready()) done += std::min(share, 1.0);
    ++sums;
}

}  // namespace render
