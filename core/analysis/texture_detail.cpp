// SPDX-License-Identifier: GPL-3.0-or-later
// The photograph's texture apart from its shading, for the segments that a drive asks it of.
//
// Shading follows the surface's direction, texture does not: the shading's luminance is that of the surroundings,
// smoothed over neighbours that face the same way. An à-trous B3-spline pyramid like the one of
// core/shading/image_filter.h, w = h(Δx) h(Δy) · [label q = label p] · max(0, n_p·n_q)^8, over an eighth of the
// segment's size. The detail is the photograph's luminance over that, with its mean over the segment divided out.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/analysis/segment/segment_pixels.h"
#include "core/analysis/step.h"
#include "core/base/color.h"
#include "core/base/parallel.h"
#include "core/material/drive_parameters.h"

namespace core::analysis {

namespace {

constexpr std::array<float, 5> kSpline{1.0f / 16, 4.0f / 16, 6.0f / 16, 4.0f / 16, 1.0f / 16};
constexpr float kGreatestDetail = 4;  // highlights are not texture
constexpr float kBlackLevel = 0.01f;  // of the segment's mean luminance: there, noise is all there is

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

void separate(const Photo& photo, const Surface& front, const Region& region, ImageF& detail,
              const Progress& progress) {
    const auto inside = [&](int x, int y) {
        return photo.labels.contains(x, y) && photo.labels(x, y) == region.label && front.depth(x, y) > 0;
    };
    const int width = region.box.width();
    const int height = region.box.height();
    ImageF shading(width, height);
    double sum = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (!inside(region.box.x0 + x, region.box.y0 + y)) continue;
            shading(x, y) = luminance(photo.color(region.box.x0 + x, region.box.y0 + y));
            sum += static_cast<double>(shading(x, y));
        }
    const auto black = static_cast<float>(kBlackLevel * sum / region.count);
    const double radius = std::sqrt(region.count) / 8;
    const int levels = std::clamp(static_cast<int>(std::lround(std::log2(radius * 1.7))), 1, 9);
    for (int level = 0; level < levels; ++level) {
        const int step = 1 << level;
        const ImageF before = shading;
        const auto row = [&](int y) {
            for (int x = 0; x < width; ++x) {
                const int px = region.box.x0 + x;
                const int py = region.box.y0 + y;
                if (!inside(px, py)) continue;
                const Vector3f& normal = front.normal(px, py);
                float value = 0;
                float weights = 0;
                for (int dy = -2; dy <= 2; ++dy)
                    for (int dx = -2; dx <= 2; ++dx) {
                        const int qx = px + dx * step;
                        const int qy = py + dy * step;
                        if (!inside(qx, qy)) continue;
                        float w = kSpline[static_cast<std::size_t>(dx) + 2] * kSpline[static_cast<std::size_t>(dy) + 2];
                        if (dx != 0 || dy != 0) w *= power8(std::max(normal.dot(front.normal(qx, qy)), 0.0f));
                        value += w * before(x + dx * step, y + dy * step);
                        weights += w;
                    }
                shading(x, y) = value / weights;
            }
        };
        const float share = 1 / static_cast<float>(levels);
        parallelFor(progress.part(share * static_cast<float>(level), share * static_cast<float>(level + 1)), height,
                    row);
    }
    double total = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int px = region.box.x0 + x;
            const int py = region.box.y0 + y;
            if (!inside(px, py)) continue;
            const float l = luminance(photo.color(px, py));
            detail(px, py) = black > 0 ? std::min((l + black) / (shading(x, y) + black), kGreatestDetail) : 1.0f;
            total += static_cast<double>(detail(px, py));
        }
    const auto scale = static_cast<float>(region.count / total);
    for (int y = region.box.y0; y <= region.box.y1; ++y)
        for (int x = region.box.x0; x <= region.box.x1; ++x)
            if (inside(x, y)) detail(x, y) *= scale;
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
        const float share = 1 / static_cast<float>(std::max<std::size_t>(regions.size(), 1));
        for (std::size_t i = 0; i < regions.size(); ++i)
            separate(photo, *board.front, regions[i], *detail,
                     context.progress.part(share * static_cast<float>(i), share * static_cast<float>(i + 1)));
        board.textureDetail = std::move(detail);
    };
    return step;
}

}  // namespace core::analysis
