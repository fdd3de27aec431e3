// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/spanned_mirror.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/steps/membrane.h"

namespace core::steps {
namespace {

/// Steepest angle [cosine to the view] at which the front still counts as turning away at the outline: it goes on like
/// a circle there, z ∝ √distance, between the last pixel centre and the outline. Flat faces end where they end.
constexpr float kTurningAway = 0.5f;
/// √0.5 / (√2.5 − √0.5): carries the difference of two pixels, 0.5 and 2.5 pixels inside, to the outline.
constexpr float kToOutline = 0.81f;
constexpr float kLargestStep = 20;     ///< [pixel widths] between those two: more is a discontinuity
constexpr float kFarthestBack = 0.2f;  ///< back no farther than this part of the front's inverse depth

using Cell = MembraneCell;
using Kind = MembraneCell::Kind;

/// Whether the surface turns away from the camera at a pixel.
bool turnsAway(const SegmentPixels& segment, Pixel pixel) {
    const Vector3f view = segment.camera.pixelRay(pixel.x, pixel.y).normalized();
    return -segment.front.normal(pixel.x, pixel.y).dot(view) <= kTurningAway;
}

/// Inverse depth of the outline beside an outline pixel.
float outlineInverseDepth(const SegmentPixels& segment, Pixel pixel, Pixel step) {
    const auto& [x, y] = pixel;
    const float z = segment.front.depth(x, y);
    const int ix = x - 2 * step.x;
    const int iy = y - 2 * step.y;
    if (!turnsAway(segment, pixel) || !segment.contains(ix, iy)) return 1 / z;
    const float fall = z - segment.front.depth(ix, iy);
    if (fall <= 0 || fall > kLargestStep * segment.footprint(z)) return 1 / z;
    return 1 / (z + kToOutline * fall);
}

/// Plane w = a + b·u + c·v through the fixed cells, with two rounds of less weight for those far off.
Eigen::Vector3d fitPlane(const Image<Cell>& cells) {
    Eigen::Vector3d plane = Eigen::Vector3d::Zero();
    double scale = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 3; ++round) {
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        for (int y = 0; y < cells.height(); ++y) {
            for (int x = 0; x < cells.width(); ++x) {
                if (cells(x, y).kind != Kind::Fixed) continue;
                const Eigen::Vector3d row(1, x, y);
                const auto w = static_cast<double>(cells(x, y).value);
                const double off = round == 0 ? 0 : (w - plane.dot(row)) / scale;
                const double weight = 1 / (1 + off * off);
                normal += weight * row * row.transpose();
                right += weight * w * row;
            }
        }
        // A little stiffness keeps the slopes finite when all pixels lie on a line.
        const double stiffness = 1e-6 * normal(0, 0);
        normal(1, 1) += stiffness;
        normal(2, 2) += stiffness;
        plane = normal.ldlt().solve(right);
        std::vector<double> offsets;
        for (int y = 0; y < cells.height(); ++y)
            for (int x = 0; x < cells.width(); ++x)
                if (cells(x, y).kind == Kind::Fixed)
                    offsets.push_back(
                        std::abs(static_cast<double>(cells(x, y).value) - plane.dot(Eigen::Vector3d(1, x, y))));
        const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
        std::nth_element(offsets.begin(), middle, offsets.end());
        scale = std::max(2 * *middle, 1e-9);
    }
    return plane;
}

}  // namespace

SpannedMirror mirrorAtSpannedSurface(const SegmentPixels& segment, float shift, const char* stepName, float progress,
                                     const StepContext& context) {
    const PixelBox& box = segment.box;
    Image<Cell> cells(box.width(), box.height());
    std::size_t known = 0, unknown = 0;
    for (const Pixel& pixel : segment.pixels) {
        Cell& cell = cells(pixel.x - box.x0, pixel.y - box.y0);
        cell.kind = Kind::Free;
        float sum = 0;
        int count = 0;
        bool hidden = false;
        const bool away = turnsAway(segment, pixel);
        for (const Pixel& step : kNeighbors) {
            const Beyond there = beyond(segment, pixel, step);
            hidden = hidden || there == Beyond::Unknown;
            if (there != Beyond::Outline || (!away && touchesSupport(segment, pixel, step))) continue;
            sum += outlineInverseDepth(segment, pixel, step);
            ++count;
        }
        if (hidden) ++unknown;
        if (hidden || count == 0) continue;
        cell = {sum / static_cast<float>(count), Kind::Fixed};
        ++known;
    }
    SpannedMirror result;
    if (known == 0) return result;
    result.outline = static_cast<float>(known) / static_cast<float>(known + unknown);

    const Eigen::Vector3d plane = fitPlane(cells);
    const auto planeAt = [&](int x, int y) { return static_cast<float>(plane.dot(Eigen::Vector3d(1, x, y))); };
    for (int y = 0; y < cells.height(); ++y)
        for (int x = 0; x < cells.width(); ++x)
            if (cells(x, y).kind == Kind::Fixed) cells(x, y).value -= planeAt(x, y);
    solveMembrane(cells, stepName, progress, context);

    result.samples = BackSamples(box.width(), box.height());
    std::size_t behind = 0;
    for (const auto& [px, py] : segment.pixels) {
        const int x = px - box.x0;
        const int y = py - box.y0;
        const float front = 1 / segment.front.depth(px, py);
        float mirror = cells(x, y).value + planeAt(x, y);
        if (shift != 0) mirror = 1 / std::max(1 / std::max(mirror, kFarthestBack * front) + shift, 1e-4f);
        const float back = 2 * mirror - front;
        if (cells(x, y).kind == Kind::Free && mirror > front) ++behind;
        result.samples(x, y) = {std::max(back, kFarthestBack * front), Vector3f::Zero(), segment.front.color(px, py)};
    }
    result.error = static_cast<float>(behind) / static_cast<float>(segment.pixels.size());
    return result;
}

}  // namespace core::steps
