// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/enclosed_parts.h"

#include <algorithm>
#include <cmath>

#include "core/base/pixel.h"
#include "core/base/statistics.h"

namespace core {

namespace {

/// Largest part of a selection that an enclosed area is, and the largest that is taken without any depth to judge by.
constexpr float kMaxEnclosed = 0.1f;
constexpr float kMaxUnseen = 0.02f;
/// Relative difference of 1/z at which an enclosed area is at another depth.
constexpr float kOtherDepth = 0.03f;
/// Width of the rim of an enclosed area whose depth is compared [working px].
constexpr int kRim = 8;

/// A 4-connected area outside a selection.
struct Gap {
    std::vector<Pixel> pixels;
    PixelBox box;
    bool open = false;  ///< reaches the edge of what is looked at
};

/// The gap around `start`, within `limits`.
Gap gapAt(const Pixel& start, const PixelBox& limits, const BinaryMask& mask, BinaryMask& seen) {
    Gap gap{{start}, {}, false};
    seen(start.x - limits.x0, start.y - limits.y0) = 1;
    for (std::size_t i = 0; i < gap.pixels.size(); ++i) {
        const Pixel p = gap.pixels[i];
        gap.box.add(p);
        for (const Pixel& step : kNeighbors) {
            const Pixel q{p.x + step.x, p.y + step.y};
            if (q.x < limits.x0 || q.y < limits.y0 || q.x > limits.x1 || q.y > limits.y1) {
                gap.open = true;
                continue;
            }
            std::uint8_t& visited = seen(q.x - limits.x0, q.y - limits.y0);
            if (mask(q.x, q.y) != 0 || visited != 0) continue;
            visited = 1;
            gap.pixels.push_back(q);
        }
    }
    return gap;
}

/// Whether depth shows a gap to be at another distance than the selection around it.
bool standsApart(const SelectionPicture& picture, const Gap& gap, const BinaryMask& mask) {
    const ImageF& w = picture.inverseDepth;
    std::vector<float> inside, around;
    for (const Pixel& p : gap.pixels)
        if (w(p.x, p.y) > 0) inside.push_back(w(p.x, p.y));
    if (4 * inside.size() < gap.pixels.size()) return picture.quality.edgeOffset == 0;
    for (int y = std::max(0, gap.box.y0 - kRim); y <= std::min(mask.height() - 1, gap.box.y1 + kRim); ++y)
        for (int x = std::max(0, gap.box.x0 - kRim); x <= std::min(mask.width() - 1, gap.box.x1 + kRim); ++x)
            if (mask(x, y) != 0 && w(x, y) > 0) around.push_back(w(x, y));
    if (around.empty()) return true;
    const auto near = static_cast<float>(quantile(around, 0.5));
    const float step = kOtherDepth + 4 * picture.quality.noise;
    return std::abs(static_cast<float>(quantile(inside, 0.5)) - near) > step * near;
}

}  // namespace

void takeEnclosed(const SelectionPicture& picture, const std::vector<Pixel>& excluded, BinaryMask& mask) {
    PixelBox box;
    std::size_t selected = 0;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            if (mask(x, y) != 0) box.add({x, y}), ++selected;
    if (box.empty()) return;
    const float share = picture.quality.present ? kMaxEnclosed : kMaxUnseen;
    const auto most = static_cast<std::size_t>(share * static_cast<float>(selected));
    BinaryMask seen(box.width(), box.height());
    std::vector<Pixel> taken;
    for (int y = box.y0; y <= box.y1; ++y)
        for (int x = box.x0; x <= box.x1; ++x) {
            if (mask(x, y) != 0 || seen(x - box.x0, y - box.y0) != 0) continue;
            const Gap gap = gapAt({x, y}, box, mask, seen);
            if (gap.open || gap.pixels.size() > most) continue;
            const bool kept = std::ranges::any_of(gap.pixels, [&](const Pixel& p) {
                return std::ranges::any_of(excluded, [&](const Pixel& q) { return p.x == q.x && p.y == q.y; });
            });
            if (kept || (picture.quality.present && standsApart(picture, gap, mask))) continue;
            taken.insert(taken.end(), gap.pixels.begin(), gap.pixels.end());
        }
    for (const Pixel& p : taken) mask(p.x, p.y) = 1;
}

}  // namespace core
