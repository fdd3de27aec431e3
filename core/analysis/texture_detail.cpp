// SPDX-License-Identifier: GPL-3.0-or-later
// Separates the photograph's texture from its shading, for the segments that are driven by luminance.
//
// Shading depends on the surface's orientation, texture does not: shading is estimated as the luminance smoothed over
// neighbours that face the same way. An à-trous B3-spline pyramid like the one of core/shading/image_filter.h,
// w = h(Δx) h(Δy) · [label q = label p] · max(0, n_p·n_q)^8, over an eighth of the segment's size. The detail is the
// photograph's luminance over that, divided by its mean over the segment.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/analysis/step.h"
#include "core/base/color.h"
#include "core/base/parallel.h"
#include "core/base/pixel.h"
#include "core/base/staged_progress.h"
#include "core/material/drive_parameters.h"

namespace core::analysis {

namespace {

constexpr std::array<float, 5> kSpline{1.0f / 16, 4.0f / 16, 6.0f / 16, 4.0f / 16, 1.0f / 16};
/// Largest detail: highlights are not texture.
constexpr float kMaxDetail = 4;
/// Fraction of the segment's mean luminance below which there is only noise.
constexpr float kBlackLevel = 0.01f;

struct Region {
    std::uint16_t label;
    PixelBox box;
    double count = 0;
};

std::vector<Region> regionsOf(const Scene& scene, const Surface& front) {
    std::vector<Region> regions;
    const LabelImage& labels = scene.photo->labels;
    for (const Segment& segment : scene.segments) {
        if (!segment.edit || !drivenByLuminance(*segment.edit)) continue;
        Region region{.label = segment.label, .box = {}};
        for (int y = 0; y < labels.height(); ++y)
            for (int x = 0; x < labels.width(); ++x) {
                if (labels(x, y) != segment.label || !(front.depth(x, y) > 0)) continue;
                region.box.add({x, y});
                region.count += 1;
            }
        if (region.count > 0) regions.push_back(region);
    }
    return regions;
}

float power8(float v) {
    v *= v;
    v *= v;
    return v * v;
}

/// The pixels of one region, in coordinates of its box.
struct RegionPixels {
    const Photo& photo;
    const Surface& front;
    const Region& region;

    [[nodiscard]] bool contains(int x, int y) const {
        const int px = region.box.x0 + x;
        const int py = region.box.y0 + y;
        return photo.labels.contains(px, py) && photo.labels(px, py) == region.label && front.depth(px, py) > 0;
    }
    [[nodiscard]] const Vector3f& normal(int x, int y) const {
        return front.normal(region.box.x0 + x, region.box.y0 + y);
    }
    [[nodiscard]] float luminanceAt(int x, int y) const {
        return luminance(photo.color(region.box.x0 + x, region.box.y0 + y));
    }
    /// Calls `body(x, y)` for every pixel, row by row.
    template <class Body>
    void forEach(const Body& body) const {
        for (int y = 0; y < region.box.height(); ++y)
            for (int x = 0; x < region.box.width(); ++x)
                if (contains(x, y)) body(x, y);
    }
};

/// One pass of the pyramid: weighted mean over a 5×5 kernel whose taps lie `step` pixels apart.
void smoothShading(ImageF& shading, const RegionPixels& pixels, int step, const Progress& progress) {
    const ImageF before = shading;
    parallelFor(progress, shading.height(), [&](int y) {
        for (int x = 0; x < shading.width(); ++x) {
            if (!pixels.contains(x, y)) continue;
            const Vector3f& normal = pixels.normal(x, y);
            float value = 0;
            float weights = 0;
            for (int dy = -2; dy <= 2; ++dy)
                for (int dx = -2; dx <= 2; ++dx) {
                    const int qx = x + dx * step;
                    const int qy = y + dy * step;
                    if (!pixels.contains(qx, qy)) continue;
                    float w = kSpline[static_cast<std::size_t>(dx) + 2] * kSpline[static_cast<std::size_t>(dy) + 2];
                    if (dx != 0 || dy != 0) w *= power8(std::max(normal.dot(pixels.normal(qx, qy)), 0.0f));
                    value += w * before(qx, qy);
                    weights += w;
                }
            shading(x, y) = value / weights;
        }
    });
}

void separate(const Photo& photo, const Surface& front, const Region& region, ImageF& detail,
              const Progress& progress) {
    const RegionPixels pixels{photo, front, region};
    ImageF shading(region.box.width(), region.box.height());
    double sum = 0;
    pixels.forEach([&](int x, int y) {
        shading(x, y) = pixels.luminanceAt(x, y);
        sum += static_cast<double>(shading(x, y));
    });
    const auto black = static_cast<float>(kBlackLevel * sum / region.count);
    const double radius = std::sqrt(region.count) / 8;
    const int levels = std::clamp(static_cast<int>(std::lround(std::log2(radius * 1.7))), 1, 9);
    StagedProgress stages(progress, levels);
    for (int level = 0; level < levels; ++level) smoothShading(shading, pixels, 1 << level, stages.next(1));
    double total = 0;
    const auto detailAt = [&](int x, int y) -> float& { return detail(region.box.x0 + x, region.box.y0 + y); };
    pixels.forEach([&](int x, int y) {
        const float l = pixels.luminanceAt(x, y);
        detailAt(x, y) = black > 0 ? std::min((l + black) / (shading(x, y) + black), kMaxDetail) : 1.0f;
        total += static_cast<double>(detailAt(x, y));
    });
    const auto scale = static_cast<float>(region.count / total);
    pixels.forEach([&](int x, int y) { detailAt(x, y) *= scale; });
}

}  // namespace

Step textureDetailStep() {
    Step step;
    step.task = Task::SeparateTexture;
    step.reads = {Item::Photo, Item::Front};
    step.writes = Item::TextureDetail;
    step.params = [](const Scene& scene, Hash& hash) {
        for (const Segment& segment : scene.segments)
            if (segment.edit && drivenByLuminance(*segment.edit)) hash.add(segment.label);
    };
    step.run = [](Board& board, const StepContext& context) {
        const Photo& photo = *board.scene->photo;
        const std::vector<Region> regions = regionsOf(*board.scene, *board.front);
        std::shared_ptr<ImageF> detail;
        if (!regions.empty()) detail = std::make_shared<ImageF>(photo.labels.width(), photo.labels.height(), 1.0f);
        double pixels = 0;
        for (const Region& region : regions) pixels += region.count;
        StagedProgress stages(context.progress, pixels);
        for (const Region& region : regions) separate(photo, *board.front, region, *detail, stages.next(region.count));
        board.textureDetail = std::move(detail);
    };
    return step;
}

}  // namespace core::analysis
