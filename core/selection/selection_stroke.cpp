// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/selection_stroke.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace core {

namespace {

/// Distance between dabs, in radii.
constexpr float kSpacing = 0.3f;
/// Largest difference of the square root of colour, in which steps look about equally large, that looks alike.
constexpr float kAlike = 0.09f;
/// Steepest surface (tangent of its angle to the picture), and relative deviation of depth that is noise.
constexpr float kSteepest = 3;
constexpr float kDepthNoise = 0.01f;
/// Pixels under the brush from which its mean colour is taken, about.
constexpr int kMeanPixels = 400;

Vector3f perceived(const Vector3f& color) { return color.cwiseMax(0.0f).cwiseMin(1.0f).cwiseSqrt(); }

}  // namespace

SelectionStroke::SelectionStroke(BinaryMask before, const SelectionBrush& brush, const ImageRgb& color,
                                 const ImageF& depth, float focal)
    : mask_(std::move(before)), brush_(brush), color_(&color), depth_(&depth), focal_(focal) {
    CORE_ASSERT(brush.radius > 0 && focal > 0, "a brush and a camera");
    CORE_ASSERT(mask_.sameSize(color) && mask_.sameSize(depth), "images of one photograph");
}

PixelBox SelectionStroke::moveTo(float x, float y) {
    const Vector2f target(x, y);
    // A pointer so far away, or nowhere, has not been everywhere in between.
    const float far = 4 * static_cast<float>(mask_.width() + mask_.height()) + brush_.radius;
    if (!(std::abs(x) < far && std::abs(y) < far)) {
        last_.reset();
        return {};
    }
    PixelBox changed;
    if (!last_) {
        changed = dab(target);
    } else {
        const Vector2f way = target - *last_;
        const float spacing = std::max(1.0f, kSpacing * brush_.radius);
        const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / spacing)));
        for (int i = 1; i <= steps; ++i)
            changed.unite(dab(*last_ + way * (static_cast<float>(i) / static_cast<float>(steps))));
    }
    last_ = target;
    return changed;
}

std::optional<Vector3f> SelectionStroke::meanUnder(Vector2f center, const PixelBox& box) const {
    const float core = std::max(1.0f, brush_.hardness * brush_.radius);
    const int step = std::max(1, static_cast<int>(2 * core / std::sqrt(static_cast<float>(kMeanPixels))));
    Vector3f sum = Vector3f::Zero();
    int count = 0;
    for (int y = box.y0; y <= box.y1; ++y)
        for (int x = box.x0; x <= box.x1; ++x) {
            if ((x - box.x0) % step != 0 || (y - box.y0) % step != 0) continue;
            const Vector2f p(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            if ((p - center).norm() > core) continue;
            sum += perceived((*color_)(x, y));
            ++count;
        }
    if (count == 0) return std::nullopt;
    return sum / static_cast<float>(count);
}

bool SelectionStroke::onSurface(int x, int y, float distance, float centerDepth) const {
    const float z = (*depth_)(x, y);
    if (!(z > 0)) return !(centerDepth > 0);
    return centerDepth > 0 && std::abs(z / centerDepth - 1) <= kSteepest * distance / focal_ + kDepthNoise;
}

PixelBox SelectionStroke::dab(Vector2f center) {
    const float r = brush_.radius;
    PixelBox box{std::max(0, static_cast<int>(std::floor(center.x() - r))),
                 std::max(0, static_cast<int>(std::floor(center.y() - r))),
                 std::min(mask_.width() - 1, static_cast<int>(std::ceil(center.x() + r))),
                 std::min(mask_.height() - 1, static_cast<int>(std::ceil(center.y() + r)))};
    if (box.empty()) return {};
    const int cx = static_cast<int>(std::floor(center.x())), cy = static_cast<int>(std::floor(center.y()));
    const bool stops = brush_.stopAtDepthEdges && depth_->contains(cx, cy);
    const float centerDepth = stops ? (*depth_)(cx, cy) : 0;
    std::optional<Vector3f> mean;
    if (brush_.hardness < 1) mean = meanUnder(center, box);
    const std::uint8_t value = brush_.erase ? 0 : 1;
    for (int y = box.y0; y <= box.y1; ++y)
        for (int x = box.x0; x <= box.x1; ++x) {
            const float distance =
                (Vector2f(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f) - center).norm();
            // A brush of less than a pixel still paints the pixel it is in.
            if (distance > r && (x != cx || y != cy)) continue;
            if (stops && !onSurface(x, y, distance, centerDepth)) continue;
            const bool rim = distance > brush_.hardness * r && (x != cx || y != cy);
            if (mean && rim && (perceived((*color_)(x, y)) - *mean).norm() > kAlike) continue;
            mask_(x, y) = value;
        }
    return box;
}

}  // namespace core
