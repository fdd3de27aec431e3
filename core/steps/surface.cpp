// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/surface.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.h"

namespace core::steps {
namespace {

constexpr const char* kName = "Surface";
constexpr float kMinCosine = 0.02f;

/// Smallest window whose fitted plane is tilted by noise by less than 0.02 rad: Var(g) = σ²/Σx².
int windowRadius(const Camera& camera, float relativeNoise) {
    constexpr float kSquareSums[] = {6, 50, 196};
    for (int radius = 1; radius <= 2; ++radius)
        if (relativeNoise * camera.fx / std::sqrt(kSquareSums[radius - 1]) < 0.02f) return radius;
    return 3;
}

struct NormalFit {
    const Camera& camera;
    const ImageF& depth;
    const LabelImage& labels;
    int radius;
    float relativeNoise;

    [[nodiscard]] std::optional<double> inverseDepth(int x, int y, std::uint16_t label) const {
        if (!depth.contains(x, y) || labels(x, y) != label) return std::nullopt;
        const float z = depth(x, y);
        if (z <= 0) return std::nullopt;
        return 1.0 / z;
    }

    /// Slope along (dx, dy) from the side where inverse depth continues more linearly; the mean of both where neither
    /// is clearly better.
    [[nodiscard]] double guessSlope(int x, int y, int dx, int dy) const {
        const std::uint16_t label = labels(x, y);
        const double w = 1.0 / depth(x, y);
        const double floor = w * (2 * relativeNoise + 1e-7);
        struct OneSide {
            double slope = 0, error = 0;
        };
        const auto side = [&](int sign) -> std::optional<OneSide> {
            const auto first = inverseDepth(x + sign * dx, y + sign * dy, label);
            if (!first) return std::nullopt;
            const auto second = inverseDepth(x + 2 * sign * dx, y + 2 * sign * dy, label);
            const double error = second ? std::abs(w - 2 * *first + *second) : std::abs(*first - w);
            return OneSide{sign * (*first - w), error + floor};
        };
        const auto left = side(-1);
        const auto right = side(1);
        if (!left && !right) return 0;
        if (!left) return right->slope;
        if (!right) return left->slope;
        if (left->error > 6 * right->error) return right->slope;
        if (right->error > 6 * left->error) return left->slope;
        return 0.5 * (left->slope + right->slope);
    }

    /// Normal of the fitted plane towards +z, not normalised: N with N·P = 1 on the plane.
    [[nodiscard]] Eigen::Vector3d fit(int x, int y) const {
        const std::uint16_t label = labels(x, y);
        const double w = 1.0 / depth(x, y);
        const double footprint = w / std::min(camera.fx, camera.fy);
        double a = w;
        double gu = guessSlope(x, y, 1, 0);
        double gv = guessSlope(x, y, 0, 1);
        const double spread = 2.0 * radius * radius;
        for (int iteration = 0; iteration < 3; ++iteration) {
            Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
            Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
            for (int dy = -radius; dy <= radius; ++dy) {
                for (int dx = -radius; dx <= radius; ++dx) {
                    const auto value = inverseDepth(x + dx, y + dy, label);
                    if (!value) continue;
                    const double squared = dx * dx + dy * dy;
                    const double tolerance = 3 * w * relativeNoise + footprint * std::sqrt(squared) + 1e-7 * w;
                    const double residual = (*value - (a + gu * dx + gv * dy)) / tolerance;
                    const double weight = std::exp(-squared / spread - residual * residual);
                    const Eigen::Vector3d row(1, dx, dy);
                    normal += weight * row * row.transpose();
                    rhs += (weight * (*value - w)) * row;
                }
            }
            // A thin line of pixels says nothing about the slope across it: keep the guess there.
            const double regularization = 1e-4 * normal(0, 0) + 1e-12;
            normal(1, 1) += regularization;
            normal(2, 2) += regularization;
            rhs += regularization * Eigen::Vector3d(0, gu, gv);
            const Eigen::Vector3d solution = normal.ldlt().solve(rhs);
            if (!solution.allFinite()) break;
            a = w + solution[0];
            gu = solution[1];
            gv = solution[2];
        }
        a = std::clamp(a, 0.5 * w, 2 * w);
        const double u = x + 0.5 - camera.cx;
        const double v = y + 0.5 - camera.cy;
        return {gu * camera.fx, gv * camera.fy, a - gu * u - gv * v};
    }
};

}  // namespace

ImageV3 computeNormals(const Camera& camera, const ImageF& depth, const LabelImage& labels, Side side,
                       float relativeNoise, const char* stepName, const StepContext& context, float from, float to) {
    ImageV3 normals(depth.width(), depth.height(), Vector3f::Zero());
    const NormalFit fit{camera, depth, labels, windowRadius(camera, relativeNoise), relativeNoise};
    const double sign = side == Side::Front ? -1 : 1;
    parallelFor(
        context, stepName, depth.height(),
        [&](int y) {
            for (int x = 0; x < depth.width(); ++x)
                if (depth(x, y) > 0) normals(x, y) = (sign * fit.fit(x, y).normalized()).cast<float>();
        },
        from, to);
    return normals;
}

float patchArea(const Camera& camera, const Vector3f& position, const Vector3f& normal) {
    const float z = position.z();
    const float cosine = std::max(std::abs(normal.dot(position)), kMinCosine * position.norm());
    return cosine > 0 ? z * z * z / (camera.fx * camera.fy * cosine) : 0.0f;
}

void completeSurface(const Camera& camera, Surface& surface) {
    const int width = surface.depth.width();
    const int height = surface.depth.height();
    surface.position = ImageV3(width, height, Vector3f::Zero());
    surface.area = ImageF(width, height, 0.0f);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (surface.depth(x, y) <= 0) continue;
            surface.position(x, y) = camera.backProject(x, y, surface.depth(x, y));
            surface.area(x, y) = patchArea(camera, surface.position(x, y), surface.normal(x, y));
        }
    }
}

Step surfaceStep() {
    Step step;
    step.name = kName;
    step.reads = {Item::Photo, Item::Depth};
    step.writes = Item::Front;
    step.params = [](const Scene&, Hash&) {};
    step.run = [](Board& board, const StepContext& context) {
        const Photo& photo = *board.scene->photo;
        auto surface = std::make_shared<Surface>();
        surface->depth = board.depth->depth;
        surface->color = photo.color;
        surface->normal = computeNormals(photo.camera, surface->depth, photo.labels, Side::Front,
                                         board.depth->relativeNoise, kName, context);
        completeSurface(photo.camera, *surface);
        board.front = std::move(surface);
    };
    return step;
}

}  // namespace core::steps
