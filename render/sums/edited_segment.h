// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "render/renderer.h"
#include "render/sums/composite.h"
#include "render/sums/diffusion_sum.h"
#include "render/sums/filtered_picture.h"
#include "render/sums/pixel_set.h"
#include "render/sums/reshade_sum.h"

namespace render {

/// What a slice can advance.
enum class Work { None, Reshade, Filter, Light, Diffusion };

/// Work on a segment that can be recorded; the lowest rank comes first.
struct Offer {
    Work work = Work::None;
    double rank = std::numeric_limits<double>::infinity();
};

/// Rank from which on work refines what is already on show.
inline constexpr double kRefinement = 2;

/// All sums of one edited segment, and how they depend on each other.
class EditedSegment {
  public:
    explicit EditedSegment(std::uint16_t label) : label_(label) {}

    /// Restarts what the scene has invalidated; true if that was anything.
    bool follow(const ShadedScene& shaded, const core::Segment& segment);
    /// As PixelSet::ready.
    [[nodiscard]] bool pixelsReady(RenderContext& context, double seconds) { return pixels_.ready(context, seconds); }
    /// Has surface samples made where the segment needs them.
    void prepareSurface(RenderContext& context, const ShadedScene& shaded);
    /// As SampledSurface::await.
    [[nodiscard]] bool awaitSurface(double seconds) const { return body_ && body_->surface.await(seconds); }

    /// Next work on the surface's sum and on the light below the surface. `timeUp`: there will be no more samples.
    [[nodiscard]] std::array<Offer, 2> offers(bool timeUp) const;
    /// Records a slice of `work`; returns the device time that it will probably take [s].
    double record(Work work, const Slice& slice);

    /// `backdrop`: version of what is composited over.
    [[nodiscard]] bool compositeCurrent(std::uint64_t backdrop) const;
    [[nodiscard]] bool compositeDue(std::uint64_t backdrop) const;
    /// Device time that a composite takes where nothing of it is current [s].
    [[nodiscard]] double compositeCost(const RenderContext& context, std::uint64_t backdrop) const;
    /// Composites what is stale; returns the pixels that may have changed.
    core::PixelBox recordComposite(const Slice& slice, std::uint64_t backdrop, const ShadedScene& shaded);

    [[nodiscard]] std::uint16_t label() const { return label_; }
    [[nodiscard]] bool translucent() const { return body_.has_value(); }
    /// All samples are in the sums.
    [[nodiscard]] bool refined() const;
    /// Nothing is being found or made on other threads, and the composite is current.
    [[nodiscard]] bool settled(std::uint64_t backdrop) const;
    /// False where no pixel of the segment has a depth.
    [[nodiscard]] bool visible() const { return !pixels_.found() || pixels_.pixels().count > 0; }
    [[nodiscard]] Renderer::SegmentProgress progress() const;
    /// Adds the done share of each sum, in [0, 1], and their number.
    void addShares(double& done, int& sums) const;

  private:
    /// Light below the surface of a translucent body.
    struct Body {
        SampledSurface surface;
        SurfaceLight light;
        DiffusionSum sum;
    };
    bool followTranslucency(const ShadedScene& shaded, const core::Translucency& translucency);
    [[nodiscard]] Offer surfaceOffer(bool timeUp) const;
    [[nodiscard]] Offer bodyOffer() const;
    [[nodiscard]] Composite::Key compositeKey(std::uint64_t backdrop) const;

    std::uint16_t label_;
    PixelSet pixels_;
    ReshadeSum reshade_;
    FilteredPicture filtered_;
    std::optional<Body> body_;  ///< of a translucent segment
    Blend blend_;
    Composite composite_;
};

}  // namespace render
