// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/march.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// value + slope·s.
struct Linear {
    double value, slope;
    [[nodiscard]] double at(double s) const { return value + slope * s; }

    /// Cuts [a, b] to where this is ≥ 0, considering s in [s0, s1] only; a > b when nothing is left. True when the
    /// beginning moved.
    bool clip(double s0, double s1, double& a, double& b) const {
        const double first = at(s0);
        if (slope >= 0 && first >= 0) return false;
        if (slope < 0) {
            if (first < 0) {
                b = -kInfinity;
            } else if (s1 == kInfinity || at(s1) < 0) {
                b = std::min(b, -value / slope);
            }
            return false;
        }
        if (slope == 0 || (s1 != kInfinity && at(s1) < 0)) {
            b = -kInfinity;
            return false;
        }
        const double root = -value / slope;
        if (root <= a) return false;
        a = root;
        return true;
    }
};

}  // namespace

/// A ray as a straight line over the image: (u, v, w)(s) = start + slope·s for s in [begin, end]; depth_layers.h.
struct ImageRay {
    double u0, v0, w0;
    double slopeU, slopeV, slopeW;
    double inverseU, inverseV;
    double begin = 0, end = 0;
    int stepX, stepY;

    ImageRay(const DepthLayers& layers, const Eigen::Vector3d& p, const Eigen::Vector3d& d)
        : u0(layers.camera.fx * p.x() / p.z() + layers.camera.cx),
          v0(layers.camera.fy * p.y() / p.z() + layers.camera.cy),
          w0(1 / p.z()),
          slopeU(layers.camera.fx * (d.x() - d.z() * p.x() / p.z())),
          slopeV(layers.camera.fy * (d.y() - d.z() * p.y() / p.z())),
          slopeW(-d.z() / p.z()),
          inverseU(slopeU != 0 ? 1 / slopeU : 0),
          inverseV(slopeV != 0 ? 1 / slopeV : 0),
          end(d.z() > 0 ? 1 / d.z() : kInfinity),
          stepX(slopeU > 0 ? 1 : -1),
          stepY(slopeV > 0 ? 1 : -1) {
        if (slopeW > 0) end = std::min(end, (layers.maxW - w0) / slopeW);
        if (slopeW < 0) end = std::min(end, (layers.minW - w0) / slopeW);
        clip(u0, slopeU, layers.front.width());
        clip(v0, slopeV, layers.front.height());
    }

    [[nodiscard]] bool overImage() const { return begin <= end; }
    [[nodiscard]] int pixelX(double s) const { return static_cast<int>(std::floor(u0 + slopeU * s)); }
    [[nodiscard]] int pixelY(double s) const { return static_cast<int>(std::floor(v0 + slopeV * s)); }
    /// Parameter at which the ray leaves column `x`, or row `y`, of cells of `size` pixels.
    [[nodiscard]] double leavesColumn(int x, int size) const {
        return slopeU != 0 ? ((slopeU > 0 ? x + 1 : x) * static_cast<double>(size) - u0) * inverseU : kInfinity;
    }
    [[nodiscard]] double leavesRow(int y, int size) const {
        return slopeV != 0 ? ((slopeV > 0 ? y + 1 : y) * static_cast<double>(size) - v0) * inverseV : kInfinity;
    }

  private:
    void clip(double start, double slope, double size) {
        if (slope == 0) {
            if (!(start >= 0 && start < size)) end = -1;
            return;
        }
        const double a = -start / slope;
        const double b = (size - start) / slope;
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
};

/// Outcome of one pixel for the part [s0, s1] of a ray over it.
struct Crossing {
    std::optional<MarchHit> hit;
    bool leavesInside = false;  ///< an escaping ray is still inside the solid where it leaves the pixel
};

namespace {

Crossing crossPixel(const DepthLayers& layers, const ImageRay& ray, int x, int y, double s0, double s1, bool escaping) {
    const DepthLayers::Patch& front = layers.front(x, y);
    if (!(front.w > 0)) return {};
    const DepthLayers::Patch& back = layers.back(x, y);
    const double du = ray.u0 - (x + 0.5);
    const double dv = ray.v0 - (y + 0.5);
    // Distances below the front and above the back plane: linear in s, both ≥ 0 inside the solid.
    const Linear room{front.w + front.gu * du + front.gv * dv - ray.w0,
                      front.gu * ray.slopeU + front.gv * ray.slopeV - ray.slopeW};
    const Linear depth{ray.w0 - (back.w + back.gu * du + back.gv * dv),
                       ray.slopeW - (back.gu * ray.slopeU + back.gv * ray.slopeV)};
    double a = s0;
    double b = s1;
    const bool throughFront = room.clip(s0, s1, a, b);
    const bool throughBack = depth.clip(s0, s1, a, b);
    if (a > b) return {};
    if (escaping && a <= s0) return {std::nullopt, b >= s1};
    const bool sideWall = !throughFront && !throughBack;
    const bool isBack = sideWall ? room.at(a) > depth.at(a) : throughBack;
    return {MarchHit{x, y, isBack, static_cast<float>(a / (ray.w0 + ray.slopeW * a))}, false};
}

}  // namespace

std::optional<MarchHit> march(const DepthLayers& layers, const Vector3f& origin, const Vector3f& direction) {
    if (!(origin.z() > 0)) return std::nullopt;
    const ImageRay ray(layers, origin.cast<double>(), direction.cast<double>());
    if (!ray.overImage()) return std::nullopt;
    const int width = layers.front.width();
    const int height = layers.front.height();
    int x = std::clamp(ray.pixelX(ray.begin), 0, width - 1);
    int y = std::clamp(ray.pixelY(ray.begin), 0, height - 1);
    bool escaping = ray.begin <= 0;
    double s0 = ray.begin;
    while (true) {
        const double nextU = ray.leavesColumn(x, 1);
        const double nextV = ray.leavesRow(y, 1);
        const double s1 = std::max(s0, std::min({nextU, nextV, ray.end}));
        const Crossing crossing = crossPixel(layers, ray, x, y, s0, s1, escaping);
        if (crossing.hit) return crossing.hit;
        escaping = escaping && crossing.leavesInside;
        if (s1 >= ray.end || s1 == kInfinity) return std::nullopt;
        if (nextU <= nextV) x += ray.stepX;
        if (nextV <= nextU) y += ray.stepY;
        if (x < 0 || y < 0 || x >= width || y >= height) return std::nullopt;
        s0 = s1;
    }
}

MarchPyramid::MarchPyramid(const DepthLayers& layers, std::uint16_t without) : layers_(layers), without_(without) {
    const auto empty = Range{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
    const auto extend = [](Range& cell, const Range& part) {
        cell.low = std::min(cell.low, part.low);
        cell.high = std::max(cell.high, part.high);
    };
    const Image<DepthLayers::Patch>& front = layers.front;
    levels_.emplace_back((front.width() + 1) / 2, (front.height() + 1) / 2, empty);
    for (int y = 0; y < front.height(); ++y) {
        for (int x = 0; x < front.width(); ++x) {
            const DepthLayers::Patch& near = front(x, y);
            if (!(near.w > 0) || (without != 0 && layers.labels(x, y) == without)) continue;
            const DepthLayers::Patch& far = layers.back(x, y);
            // Float sums may round a corner inwards.
            const float above = (near.w + 0.5f * (std::abs(near.gu) + std::abs(near.gv))) * (1 + 1e-5f);
            const float below = (far.w - 0.5f * (std::abs(far.gu) + std::abs(far.gv))) * (1 - 1e-5f);
            extend(levels_[0](x / 2, y / 2), {std::min(below, far.w), above});
        }
    }
    while (levels_.back().width() > 1 || levels_.back().height() > 1) {
        const Image<Range>& fine = levels_.back();
        Image<Range> coarse((fine.width() + 1) / 2, (fine.height() + 1) / 2, empty);
        for (int y = 0; y < fine.height(); ++y)
            for (int x = 0; x < fine.width(); ++x) extend(coarse(x / 2, y / 2), fine(x, y));
        levels_.push_back(std::move(coarse));
    }
}

bool MarchPyramid::mayTouch(const ImageRay& ray, int level, int x, int y, double s0, double s1) const {
    const Range& range = levels_[static_cast<std::size_t>(level) - 1](x, y);
    const double w0 = ray.w0 + ray.slopeW * s0;
    const double w1 = ray.slopeW != 0 ? ray.w0 + ray.slopeW * s1 : ray.w0;
    return std::max(w0, w1) >= range.low && std::min(w0, w1) <= range.high;
}

Crossing MarchPyramid::cross(const ImageRay& ray, int x, int y, double s0, double s1, bool escaping) const {
    if (without_ != 0 && layers_.labels(x, y) == without_) return {};
    return crossPixel(layers_, ray, x, y, s0, s1, escaping);
}

std::optional<MarchHit> MarchPyramid::march(const Vector3f& origin, const Vector3f& direction) const {
    if (!(origin.z() > 0)) return std::nullopt;
    const ImageRay ray(layers_, origin.cast<double>(), direction.cast<double>());
    if (!ray.overImage()) return std::nullopt;
    const int width = layers_.front.width();
    const int height = layers_.front.height();
    const int top = static_cast<int>(levels_.size());
    int level = 0;  // cells of 2^level pixels; 0 = pixels
    int x = std::clamp(ray.pixelX(ray.begin), 0, width - 1);
    int y = std::clamp(ray.pixelY(ray.begin), 0, height - 1);
    bool escaping = ray.begin <= 0;
    double s0 = ray.begin;
    while (true) {
        const double nextU = ray.leavesColumn(x, 1 << level);
        const double nextV = ray.leavesRow(y, 1 << level);
        const double s1 = std::max(s0, std::min({nextU, nextV, ray.end}));
        if (level > 0 && mayTouch(ray, level, x, y, s0, s1)) {
            --level;
            const int lastX = std::min(2 * x + 1, (width - 1) >> level);
            const int lastY = std::min(2 * y + 1, (height - 1) >> level);
            x = std::clamp(ray.pixelX(s0) >> level, 2 * x, lastX);
            y = std::clamp(ray.pixelY(s0) >> level, 2 * y, lastY);
            continue;
        }
        if (level == 0) {
            const Crossing crossing = cross(ray, x, y, s0, s1, escaping);
            if (crossing.hit) return crossing.hit;
            escaping = escaping && crossing.leavesInside;
        }
        if (s1 >= ray.end || s1 == kInfinity) return std::nullopt;
        const int oldX = x;
        const int oldY = y;
        if (nextU <= nextV) x += ray.stepX;
        if (nextV <= nextU) y += ray.stepY;
        if (x < 0 || y < 0 || x > (width - 1) >> level || y > (height - 1) >> level) return std::nullopt;
        s0 = s1;
        if (!escaping && level < top && ((oldX ^ x) > 1 || (oldY ^ y) > 1)) {
            ++level;
            x >>= 1;
            y >>= 1;
        }
    }
}

}  // namespace core
