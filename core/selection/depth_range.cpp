// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/depth_range.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/selection/mask_operations.h"

namespace core {

namespace {

/// Side of the square in which the first plane is fitted, in parts of the picture's shorter side, and its least [px].
constexpr double kFirstWindow = 0.02;
constexpr int kLeastWindow = 3;
/// Times the plane is fitted again to what lies on it.
constexpr int kRefits = 4;
constexpr std::size_t kLeastPixels = 6;
constexpr int kDepthRowsPerCheckpoint = 64;

/// 1/z as a linear function of the pixel's place.
using InversePlane = Eigen::Vector3d;

double valueAt(const InversePlane& plane, int x, int y) { return plane.x() * x + plane.y() * y + plane.z(); }

/// Least squares over pixels in [x0, x1) × [y0, y1) that `counts`.
std::optional<InversePlane> fitInversePlane(const ImageF& depth, PixelBox box,
                                            const std::function<bool(int, int)>& counts) {
    // Places relative to the middle keep the sums well conditioned.
    const double cx = 0.5 * (box.x0 + box.x1), cy = 0.5 * (box.y0 + box.y1);
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    std::size_t count = 0;
    for (int y = box.y0; y <= box.y1; ++y)
        for (int x = box.x0; x <= box.x1; ++x) {
            const float z = depth(x, y);
            if (!(z > 0) || !counts(x, y)) continue;
            const Eigen::Vector3d row(x - cx, y - cy, 1);
            normal += row * row.transpose();
            right += row / static_cast<double>(z);
            ++count;
        }
    if (count < kLeastPixels) return std::nullopt;
    const Eigen::LDLT<Eigen::Matrix3d> factors(normal);
    if (factors.info() != Eigen::Success || factors.vectorD().minCoeff() <= 1e-9 * factors.vectorD().maxCoeff())
        return std::nullopt;
    const Eigen::Vector3d local = factors.solve(right);
    return InversePlane(local.x(), local.y(), local.z() - local.x() * cx - local.y() * cy);
}

BinaryMask within(const ImageF& depth, const std::function<double(int, int)>& expected, float tolerance,
                  const Progress& progress) {
    BinaryMask mask(depth.width(), depth.height());
    for (int y = 0; y < depth.height(); ++y) {
        if (y % kDepthRowsPerCheckpoint == 0)
            progress.checkpoint(static_cast<float>(y) / static_cast<float>(depth.height()));
        for (int x = 0; x < depth.width(); ++x) {
            const auto z = static_cast<double>(depth(x, y));
            if (!(z > 0)) continue;
            mask(x, y) = std::abs(z * expected(x, y) - 1) <= static_cast<double>(tolerance) ? 1 : 0;
        }
    }
    return mask;
}

}  // namespace

BinaryMask selectByDepth(const ImageF& depth, Pixel seed, const DepthSelection& wanted, const Progress& progress) {
    if (!depth.contains(seed.x, seed.y))
        throw Error(ErrorKind::Usage,
                    Message("messages", "The point %1, %2 lies outside the photograph of %3 pixels.")
                        .with(seed.x, seed.y, std::to_string(depth.width()) + "x" + std::to_string(depth.height())));
    BinaryMask mask(depth.width(), depth.height());
    const auto z = static_cast<double>(depth(seed.x, seed.y));
    if (!(z > 0)) return mask;
    const auto piece = [&](const BinaryMask& all) { return piecesUnder(all, {seed}); };
    if (wanted.shape == DepthShape::Range) {
        mask = within(
            depth, [&](int, int) { return 1 / z; }, wanted.tolerance, progress);
        return wanted.connected ? piece(mask) : mask;
    }
    const int reach = std::max(
        kLeastWindow, static_cast<int>(std::lround(kFirstWindow / 2 * std::min(depth.width(), depth.height()))));
    const PixelBox window{std::max(0, seed.x - reach), std::max(0, seed.y - reach),
                          std::min(depth.width() - 1, seed.x + reach), std::min(depth.height() - 1, seed.y + reach)};
    const auto near = [&](int x, int y) {
        // A step in the window belongs to something else.
        constexpr double kSameSurface = 0.1;
        return std::abs(static_cast<double>(depth(x, y)) / z - 1) < kSameSurface;
    };
    std::optional<InversePlane> plane = fitInversePlane(depth, window, near);
    const PixelBox whole{0, 0, depth.width() - 1, depth.height() - 1};
    for (int i = 0; i < kRefits && plane; ++i) {
        const Progress part = progress.part(static_cast<float>(i) / kRefits, static_cast<float>(i + 1) / kRefits);
        mask = within(
            depth, [&](int x, int y) { return valueAt(*plane, x, y); }, wanted.tolerance, part);
        const BinaryMask connected = piece(mask);
        if (connected(seed.x, seed.y) == 0 || i + 1 == kRefits) return wanted.connected ? connected : mask;
        plane = fitInversePlane(depth, whole, [&](int x, int y) { return connected(x, y) != 0; });
    }
    return BinaryMask(depth.width(), depth.height());
}

}  // namespace core
