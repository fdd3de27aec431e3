// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/segment/segment_pixels.h"

#include <cmath>

namespace core::analysis {
namespace {

// Depth steps [pixel widths].
/// An object ends beside another one that lies at least this much farther; a nearer one hides or touches it.
constexpr float kBehind = 1;
/// A support within this distance touches the object: at a grazing angle its depth changes even along the outline.
constexpr float kTouchingSupport = 15;

}  // namespace

Beyond beyond(const SegmentPixels& segment, Pixel pixel, Pixel step) {
    const int x = pixel.x + step.x;
    const int y = pixel.y + step.y;
    if (!segment.labels.contains(x, y)) return Beyond::Unknown;
    const std::uint16_t there = segment.labels(x, y);
    const float z = segment.front.depth(x, y);
    if (there == segment.label) return z > 0 ? Beyond::Inside : Beyond::Unknown;
    if (z <= 0) return Beyond::Outline;
    const float own = segment.front.depth(pixel.x, pixel.y);
    const float nearest = segment.supports[there] ? -kTouchingSupport : kBehind;
    return z < own + nearest * segment.footprint(own) ? Beyond::Unknown : Beyond::Outline;
}

bool touchesSupport(const SegmentPixels& segment, Pixel pixel, Pixel step) {
    const int x = pixel.x + step.x;
    const int y = pixel.y + step.y;
    if (!segment.labels.contains(x, y) || !segment.supports[segment.labels(x, y)]) return false;
    const float z = segment.front.depth(x, y);
    const float own = segment.front.depth(pixel.x, pixel.y);
    return z > 0 && std::abs(z - own) < kTouchingSupport * segment.footprint(own);
}

}  // namespace core::analysis
