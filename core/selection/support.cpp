// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/support.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/disjoint_sets.h"

namespace core {

namespace {

constexpr int kMaxPlanes = 3;
constexpr int kPlaneTrials = 240;
constexpr int kFits = 4;
/// Least share of the area with depth that a support has.
constexpr float kMinSupportShare = 1.0f / 12;
/// Largest share of the other area that may lie behind it.
constexpr float kMaxBehind = 0.25f;
/// Cosine between the normals of a plane and of what lies on it, for exact depth.
constexpr float kNormalCosine = 0.94f;

/// Noise below which depth is exact, and share of the picture from which an area without depth is far away otherwise.
constexpr float kExactNoise = 0.0015f;
constexpr float kDistantShare = 0.03f;

struct FacingPlane {
    Vector3f normal{0, 0, -1};  ///< unit length, facing the camera
    float offset = 0;           ///< normal · p for its points [m]
};

struct Sample {
    Vector3f point, normal;
    float area;
};

/// Surface of each superpixel; area 0 where most of it has no depth.
std::vector<Sample> samplesOf(const Superpixels& superpixels, const Camera& camera) {
    std::vector<Sample> samples;
    for (const Superpixel& s : superpixels.superpixels) {
        const bool valid = 2 * s.depthArea > s.area && s.inverseDepth > 0;
        const Vector3f point = valid ? Vector3f(camera.ray(s.x, s.y) / s.inverseDepth) : Vector3f(0, 0, 0);
        samples.push_back({point, s.normal.normalized(), valid ? s.depthArea : 0.0f});
    }
    return samples;
}

class PlaneFinder {
  public:
    PlaneFinder(const std::vector<Sample>& samples, const DepthQuality& quality)
        : samples_(samples),
          tolerance_(0.004f + 3 * quality.noise),
          cosine_(kNormalCosine - std::min(0.2f, 8 * quality.noise)) {}

    [[nodiscard]] bool on(const FacingPlane& plane, const Sample& sample) const {
        return sample.area > 0 && sample.normal.dot(plane.normal) > cosine_ &&
               std::abs(plane.normal.dot(sample.point) - plane.offset) < tolerance_ * sample.point.z();
    }
    /// Area on the plane among the samples that are still free.
    [[nodiscard]] float areaOn(const FacingPlane& plane, const std::vector<int>& planeOf) const {
        float area = 0;
        for (std::size_t i = 0; i < samples_.size(); ++i)
            if (planeOf[i] < 0 && on(plane, samples_[i])) area += samples_[i].area;
        return area;
    }
    /// Least-squares plane through what lies on `plane`.
    [[nodiscard]] FacingPlane refit(const FacingPlane& plane, const std::vector<int>& planeOf) const {
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
        double sum = 0;
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            if (planeOf[i] >= 0 || !on(plane, samples_[i])) continue;
            const Eigen::Vector3d p = samples_[i].point.cast<double>();
            const double weight = static_cast<double>(samples_[i].area) / (p.z() * p.z());
            sum += weight;
            mean += weight * p;
            moments += weight * p * p.transpose();
        }
        if (!(sum > 0)) return plane;
        mean /= sum;
        moments = moments / sum - mean * mean.transpose();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
        Vector3f normal = solver.eigenvectors().col(0).cast<float>();
        if (normal.dot(plane.normal) < 0) normal = -normal;
        return {normal, normal.dot(mean.cast<float>())};
    }
    /// Whether little of the rest lies behind the plane.
    [[nodiscard]] bool holdsTheRest(const FacingPlane& plane) const {
        float behind = 0, rest = 0;
        for (const Sample& sample : samples_) {
            if (!(sample.area > 0) || on(plane, sample)) continue;
            rest += sample.area;
            if (plane.normal.dot(sample.point) - plane.offset < -2 * tolerance_ * sample.point.z())
                behind += sample.area;
        }
        return behind <= kMaxBehind * rest;
    }

  private:
    const std::vector<Sample>& samples_;
    float tolerance_;
    float cosine_;
};

/// Marks superpixels that are without depth because they are far away: with exact depth all, otherwise large areas.
void markDistant(const Superpixels& superpixels, const DepthQuality& quality, std::vector<int>& supportOf) {
    const std::size_t count = superpixels.superpixels.size();
    DisjointSets regions(count);
    const auto empty = [&](std::uint32_t i) {
        return 4 * superpixels.superpixels[i].depthArea < superpixels.superpixels[i].area;
    };
    for (const SuperpixelBorder& border : superpixels.borders)
        if (empty(border.a) && empty(border.b)) regions.join(border.a, border.b);
    std::vector<float> area(count);
    float pictureArea = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        area[regions.find(i)] += superpixels.superpixels[i].area;
        pictureArea += superpixels.superpixels[i].area;
    }
    const bool exact = quality.noise < kExactNoise && quality.edgeOffset == 0;
    const float least = exact ? 0.0f : kDistantShare * pictureArea;
    for (std::uint32_t i = 0; i < count; ++i)
        if (empty(i) && area[regions.find(i)] >= least) supportOf[i] = kDistant;
}

}  // namespace

std::vector<int> findSupports(const Superpixels& superpixels, const Camera& camera, const DepthQuality& quality,
                              const Progress& progress) {
    std::vector<int> supportOf(superpixels.superpixels.size(), kNoSupport);
    int count = 0;
    const std::vector<Sample> samples = samplesOf(superpixels, camera);
    float total = 0;
    std::vector<std::size_t> valid;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        total += samples[i].area;
        if (samples[i].area > 0) valid.push_back(i);
    }
    if (valid.empty()) return supportOf;
    markDistant(superpixels, quality, supportOf);
    const PlaneFinder finder(samples, quality);
    std::vector<int> used(samples.size(), -1);  // round in which a plane took it
    std::uint32_t random = 12345;
    for (int round = 0; round < 2 * kMaxPlanes && count < kMaxPlanes; ++round) {
        FacingPlane best{};
        float bestArea = 0;
        for (int trial = 0; trial < kPlaneTrials; ++trial) {
            if (trial % 16 == 0)
                progress.checkpoint((static_cast<float>(round) + static_cast<float>(trial) / kPlaneTrials) /
                                    (2 * kMaxPlanes));
            random = random * 1664525U + 1013904223U;
            const std::size_t i = valid[(random >> 8U) % valid.size()];
            if (used[i] >= 0 || !(samples[i].normal.norm() > 0.5f)) continue;
            const FacingPlane plane{samples[i].normal, samples[i].normal.dot(samples[i].point)};
            const float area = finder.areaOn(plane, used);
            if (area > bestArea) bestArea = area, best = plane;
        }
        for (int fit = 0; fit < kFits && bestArea > 0; ++fit) best = finder.refit(best, used);
        if (!(finder.areaOn(best, used) >= kMinSupportShare * total)) break;
        const bool support = finder.holdsTheRest(best);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (used[i] >= 0 || !finder.on(best, samples[i])) continue;
            used[i] = round;
            if (support) supportOf[i] = count;
        }
        if (support) ++count;
    }
    return supportOf;
}

}  // namespace core
