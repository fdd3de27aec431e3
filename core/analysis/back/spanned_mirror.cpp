// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/back/spanned_mirror.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/analysis/depth/membrane.h"
#include "core/base/statistics.h"

namespace core::analysis {
namespace {

/// Maximum cosine between normal and view at which the front counts as turning away at the outline. There it continues
/// like a circle, z ∝ √distance, between the last pixel centre and the outline. Flat faces end at the pixel.
constexpr float kTurningAway = 0.5f;
/// √0.5 / (√2.5 − √0.5): extrapolates the difference of two pixels, 0.5 and 2.5 pixels inside, to the outline.
constexpr float kToOutline = 0.81f;
/// Maximum depth difference [pixel widths] of those two; more is a discontinuity.
constexpr float kMaxStep = 20;
/// Minimum inverse depth of the back, relative to that of the front.
constexpr float kMinBackRatio = 0.2f;
/// Height above the support up to which an object rounds off to its foot, relative to its thickness: two fifths of its
/// own radius.
constexpr float kRoundedOff = 0.2f;
/// Weight of a bound in the fit of the plane, relative to a fixed cell.
constexpr double kBoundWeight = 0.03;

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
    if (fall <= 0 || fall > kMaxStep * segment.footprint(z)) return 1 / z;
    return 1 / (z + kToOutline * fall);
}

/// Distances of the fixed cells from a plane.
std::vector<double> planeResiduals(const Image<Cell>& cells, const Eigen::Vector3d& plane) {
    std::vector<double> residuals;
    for (int y = 0; y < cells.height(); ++y)
        for (int x = 0; x < cells.width(); ++x)
            if (cells(x, y).kind == Kind::Fixed)
                residuals.push_back(
                    std::abs(static_cast<double>(cells(x, y).value) - plane.dot(Eigen::Vector3d(1, x, y))));
    return residuals;
}

/// Plane w = a + b·u + c·v through the fixed cells, with two rounds of lower weights for outliers. Bounds determine
/// what the fixed cells leave open, for instance if all of them lie on a line.
Eigen::Vector3d fitCellPlane(const Image<Cell>& cells) {
    Eigen::Vector3d plane = Eigen::Vector3d::Zero();
    double scale = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 3; ++round) {
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        for (int y = 0; y < cells.height(); ++y) {
            for (int x = 0; x < cells.width(); ++x) {
                const Cell& cell = cells(x, y);
                const bool fixed = cell.kind == Kind::Fixed;
                if (!fixed && !std::isfinite(cell.most)) continue;
                const Eigen::Vector3d row(1, x, y);
                const auto w = static_cast<double>(fixed ? cell.value : cell.most);
                const double off = round == 0 ? 0 : (w - plane.dot(row)) / scale;
                const double weight = (fixed ? 1 : kBoundWeight) / (1 + off * off);
                normal += weight * row * row.transpose();
                right += weight * w * row;
            }
        }
        // A little stiffness keeps the slopes finite when all pixels lie on a line.
        const double stiffness = 1e-6 * normal(0, 0);
        normal(1, 1) += stiffness;
        normal(2, 2) += stiffness;
        plane = normal.ldlt().solve(right);
        scale = std::max(2 * median(planeResiduals(cells, plane)), 1e-9);
    }
    return plane;
}

/// The cells of the segment's box: fixed at the inverse depth of the outline where the object is known to end, bounded
/// by that of its last pixel where it meets its support facing the camera.
struct OutlineCells {
    Image<Cell> cells;
    std::size_t known = 0, unknown = 0;  ///< outline pixels
};

OutlineCells findOutline(const SegmentPixels& segment) {
    const PixelBox& box = segment.box;
    OutlineCells outline{Image<Cell>(box.width(), box.height())};
    for (const Pixel& pixel : segment.pixels) {
        Cell& cell = outline.cells(pixel.x - box.x0, pixel.y - box.y0);
        cell.kind = Kind::Free;
        float sum = 0;
        int count = 0;
        bool hidden = false;
        const bool away = turnsAway(segment, pixel);
        for (const Pixel& step : kNeighbors) {
            const Beyond there = beyond(segment, pixel, step);
            hidden = hidden || there == Beyond::Unknown;
            if (there != Beyond::Outline) continue;
            if (!away && touchesSupport(segment, pixel, step)) {
                cell.most = 1 / segment.front.depth(pixel.x, pixel.y);
                continue;
            }
            sum += outlineInverseDepth(segment, pixel, step);
            ++count;
        }
        if (hidden) ++outline.unknown;
        if (hidden || count == 0) continue;
        cell.value = sum / static_cast<float>(count);
        cell.kind = Kind::Fixed;
        ++outline.known;
    }
    return outline;
}

/// The inverse depth of the surface spanned into the fixed cells.
ImageF spanSurface(Image<Cell> cells, const Progress& progress) {
    const Eigen::Vector3d plane = fitCellPlane(cells);
    const auto planeAt = [&](int x, int y) { return static_cast<float>(plane.dot(Eigen::Vector3d(1, x, y))); };
    for (int y = 0; y < cells.height(); ++y) {
        for (int x = 0; x < cells.width(); ++x) {
            Cell& cell = cells(x, y);
            if (cell.kind == Kind::Fixed) cell.value -= planeAt(x, y);
            cell.most -= planeAt(x, y);
        }
    }
    solveMembrane(cells, progress);
    ImageF mirror(cells.width(), cells.height());
    for (int y = 0; y < cells.height(); ++y)
        for (int x = 0; x < cells.width(); ++x) mirror(x, y) = cells(x, y).value + planeAt(x, y);
    return mirror;
}

/// Inverse depth of the back of a pixel from that of mirror and front.
float mirroredAt(float mirror, float front) { return std::max(2 * mirror - front, kMinBackRatio * front); }

/// Median thickness [m] down to the support.
float medianThickness(const SegmentPixels& segment, const ImageF& mirror, const SupportPlane& support) {
    std::vector<float> thickness;
    thickness.reserve(segment.pixels.size());
    for (const auto& [x, y] : segment.pixels) {
        const float z = segment.front.depth(x, y);
        const float back = 1 / mirroredAt(mirror(x - segment.box.x0, y - segment.box.y0), 1 / z);
        thickness.push_back(std::min(back, support.depthAlong(segment.camera.pixelRay(x, y))) - z);
    }
    return median(thickness);
}

/// Frees the cells less than `height` [m] above the support; their fixed values become bounds. Returns the number of
/// cells that remain fixed.
std::size_t freeNearSupport(const SegmentPixels& segment, const SupportPlane& support, float height,
                            Image<Cell>& cells) {
    std::size_t fixed = 0;
    for (const auto& [x, y] : segment.pixels) {
        Cell& cell = cells(x - segment.box.x0, y - segment.box.y0);
        if (cell.kind != Kind::Fixed) continue;
        if (support.offset - support.normal.dot(segment.front.position(x, y)) < height)
            cell = {0, Kind::Free, cell.value};
        else
            ++fixed;
    }
    return fixed;
}

/// Frees the foot of the segment and spans the surface again, if that leaves part of the outline fixed.
void spanAboveFoot(const SegmentPixels& segment, const SupportPlane& support, OutlineCells& outline, ImageF& mirrors,
                   const Progress& progress) {
    const float height = kRoundedOff * medianThickness(segment, mirrors, support);
    Image<Cell> freed = outline.cells;
    const std::size_t held = freeNearSupport(segment, support, height, freed);
    if (held == 0 || held == outline.known) return;
    outline.cells = std::move(freed);
    mirrors = spanSurface(outline.cells, progress);
}

}  // namespace

SpannedMirror mirrorAtSpannedSurface(const SegmentPixels& segment, const std::optional<SupportPlane>& support,
                                     float shift, const Progress& progress) {
    const PixelBox& box = segment.box;
    OutlineCells outline = findOutline(segment);
    SpannedMirror result;
    if (outline.known == 0) return result;
    result.outline = static_cast<float>(outline.known) / static_cast<float>(outline.known + outline.unknown);
    ImageF mirrors = spanSurface(outline.cells, progress.part(0, support ? 0.5f : 1.0f));
    if (support) spanAboveFoot(segment, *support, outline, mirrors, progress.part(0.5f, 1));

    result.samples = BackSamples(box.width(), box.height());
    std::size_t behind = 0;
    for (const auto& [px, py] : segment.pixels) {
        const int x = px - box.x0;
        const int y = py - box.y0;
        const float front = 1 / segment.front.depth(px, py);
        float mirror = mirrors(x, y);
        if (shift != 0) mirror = 1 / std::max(1 / std::max(mirror, kMinBackRatio * front) + shift, 1e-4f);
        const Cell& cell = outline.cells(x, y);
        if (cell.kind == Kind::Free && !std::isfinite(cell.most) && mirror > front) ++behind;
        result.samples(x, y) = {mirroredAt(mirror, front), Vector3f::Zero(), segment.front.color(px, py)};
    }
    result.error = static_cast<float>(behind) / static_cast<float>(segment.pixels.size());
    return result;
}

}  // namespace core::analysis
