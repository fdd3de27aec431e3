// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/back/flat_faces.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace core::analysis {
namespace {

constexpr float kFacing = 0.1f;         ///< cosine to the view: flatter faces than this do not turn away at the edge
constexpr float kFlat = 0.985f;         ///< cosine between normals of one face
constexpr float kSamePlane = 0.97f;     ///< cosine between normals of one hidden face
constexpr float kTolerance = 2.5f;      ///< [pixel widths] off a hidden face
constexpr double kMinSupport = 0.04;    ///< of the known outline, for a hidden face
constexpr std::size_t kMinEdge = 6;     ///< [px]
constexpr double kStraightEdge = 0.05;  ///< second to first eigenvalue of the edge's points
constexpr std::size_t kMaxCandidates = 400;

/// Half-space n·p ≤ offset that the object lies in.
struct HiddenFace {
    Vector3f normal{0, 0, 0};
    float offset = 0;
};

/// How far [m] an outline pixel may lie off the face behind it: half a pixel across the edge is much along a face seen
/// at a small angle.
float tolerance(const SegmentPixels& segment, Pixel pixel) {
    const Vector3f& p = segment.front.position(pixel.x, pixel.y);
    const float facing = -segment.front.normal(pixel.x, pixel.y).dot(p.normalized());
    return kTolerance * segment.footprint(p.z()) * std::max(1.0f, 0.5f / std::max(facing, kFacing));
}

/// How far [m] along the face's normal the visible face beside it reaches at an outline pixel: to the border of the
/// pixel, between the last centre inside and the first outside.
float reachAt(const SegmentPixels& segment, Pixel pixel, const HiddenFace& face) {
    const Vector3f& p = segment.front.position(pixel.x, pixel.y);
    const Vector3f& normal = segment.front.normal(pixel.x, pixel.y);
    const Camera& camera = segment.camera;
    float reach = face.normal.dot(p);
    for (const Pixel& step : kNeighbors) {
        if (beyond(segment, pixel, step) != Beyond::Outline) continue;
        const Vector3f ray =
            camera.pixelRay(pixel.x, pixel.y) +
            Vector3f(0.5f * static_cast<float>(step.x) / camera.fx, 0.5f * static_cast<float>(step.y) / camera.fy, 0);
        const float slope = normal.dot(ray);
        if (slope < 0) reach = std::max(reach, face.normal.dot(ray) * normal.dot(p) / slope);
    }
    return reach;
}

/// The hidden face behind one outline pixel, when a flat face ends there in a straight edge.
std::optional<HiddenFace> faceBehind(const SegmentPixels& segment, const Image<std::uint8_t>& outline, Pixel pixel,
                                     int radius) {
    const Vector3f& p = segment.front.position(pixel.x, pixel.y);
    const Vector3f view = p.normalized();
    const Vector3f& normal = segment.front.normal(pixel.x, pixel.y);
    if (-normal.dot(view) < kFacing) return std::nullopt;

    // The edge near by, and the inside of its own face.
    std::vector<Vector3f> edge;
    Vector3f inside = Vector3f::Zero();
    int total = 0, flat = 0;
    for (int y = pixel.y - radius; y <= pixel.y + radius; ++y) {
        for (int x = pixel.x - radius; x <= pixel.x + radius; ++x) {
            if (!segment.contains(x, y)) continue;
            ++total;
            if (segment.front.normal(x, y).dot(normal) < kFlat) continue;
            ++flat;
            inside += segment.front.position(x, y) - p;
            if (outline(x - segment.box.x0, y - segment.box.y0) != 0) edge.push_back(segment.front.position(x, y));
        }
    }
    if (flat * 3 < total || edge.size() < kMinEdge) return std::nullopt;
    Vector3f mean = Vector3f::Zero();
    for (const Vector3f& q : edge) mean += q;
    mean /= static_cast<float>(edge.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const Vector3f& q : edge) {
        const Eigen::Vector3d d = (q - mean).cast<double>();
        covariance += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    if (solver.eigenvalues()[1] > kStraightEdge * solver.eigenvalues()[2]) return std::nullopt;
    Vector3f hidden = solver.eigenvectors().col(2).cast<float>().cross(normal);
    if (hidden.norm() < 0.5f) return std::nullopt;
    hidden.normalize();
    if (hidden.dot(inside) > 0) hidden = -hidden;
    return HiddenFace{hidden, hidden.dot(mean)};
}

}  // namespace

FlatFaces continueFlatFaces(const SegmentPixels& segment) {
    const PixelBox& box = segment.box;
    Image<std::uint8_t> outline(box.width(), box.height(), 0);
    std::vector<Pixel> edge;
    for (const Pixel& pixel : segment.pixels) {
        const bool ends = std::ranges::any_of(
            kNeighbors, [&](Pixel step) { return beyond(segment, pixel, step) == Beyond::Outline; });
        const bool hidden = std::ranges::any_of(
            kNeighbors, [&](Pixel step) { return beyond(segment, pixel, step) == Beyond::Unknown; });
        if (!ends || hidden) continue;
        outline(pixel.x - box.x0, pixel.y - box.y0) = 1;
        edge.push_back(pixel);
    }
    FlatFaces result;
    if (edge.size() < kMinEdge) return result;

    const int radius = std::clamp(static_cast<int>(std::min(box.width(), box.height()) / 10), 3, 14);
    struct Candidate {
        Pixel pixel;
        HiddenFace face;
        bool taken = false;
    };
    std::vector<Candidate> candidates;
    const std::size_t stride = edge.size() / kMaxCandidates + 1;
    for (std::size_t i = 0; i < edge.size(); i += stride)
        if (const auto face = faceBehind(segment, outline, edge[i], radius)) candidates.push_back({edge[i], *face});

    const auto minSupport = static_cast<std::size_t>(
        std::max(3.0, kMinSupport * static_cast<double>(edge.size()) / static_cast<double>(stride)));
    const auto agrees = [&](const HiddenFace& face, const Candidate& candidate) {
        const Vector3f& p = segment.front.position(candidate.pixel.x, candidate.pixel.y);
        return candidate.face.normal.dot(face.normal) > kSamePlane &&
               std::abs(face.normal.dot(p) - face.offset) < tolerance(segment, candidate.pixel);
    };
    std::vector<HiddenFace> faces;
    while (true) {
        const Candidate* best = nullptr;
        std::size_t bestCount = 0;
        for (const Candidate& seed : candidates) {
            if (seed.taken) continue;
            const auto count = static_cast<std::size_t>(std::ranges::count_if(
                candidates, [&](const Candidate& c) { return !c.taken && agrees(seed.face, c); }));
            if (count > bestCount) {
                bestCount = count;
                best = &seed;
            }
        }
        if (best == nullptr || bestCount < minSupport) break;
        const HiddenFace seed = best->face;
        HiddenFace face;
        for (const Candidate& c : candidates)
            if (!c.taken && agrees(seed, c)) face.normal += c.face.normal;
        face.normal.normalize();
        std::vector<float> offsets;
        for (Candidate& c : candidates) {
            if (c.taken || !agrees(seed, c)) continue;
            c.taken = true;
            offsets.push_back(reachAt(segment, c.pixel, face));
        }
        const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
        std::nth_element(offsets.begin(), middle, offsets.end());
        face.offset = *middle;
        faces.push_back(face);
    }
    result.faces = static_cast<int>(faces.size());
    if (faces.empty()) return result;

    const auto ending = std::ranges::count_if(candidates, &Candidate::taken);
    result.outline = static_cast<float>(ending * static_cast<std::ptrdiff_t>(stride)) / static_cast<float>(edge.size());
    result.outline = std::min(result.outline, 1.0f);
    result.samples = BackSamples(box.width(), box.height());
    std::size_t outside = 0;
    for (const auto& [x, y] : segment.pixels) {
        const Vector3f ray = segment.camera.pixelRay(x, y);
        const Vector3f& p = segment.front.position(x, y);
        float w = 0;
        bool beyondFace = false;
        const HiddenFace* exit = nullptr;
        for (const HiddenFace& face : faces) {
            beyondFace = beyondFace || face.normal.dot(p) > face.offset + 2 * kTolerance * segment.footprint(p.z());
            const float slope = face.normal.dot(ray);
            if (slope <= 1e-4f || face.offset <= 0 || slope / face.offset <= w) continue;
            w = slope / face.offset;
            exit = &face;
        }
        if (beyondFace) ++outside;
        if (exit == nullptr) continue;
        result.samples(x - box.x0, y - box.y0) = {w, exit->normal, segment.front.color(x, y)};
    }
    result.error =
        std::max(1 - result.outline, static_cast<float>(outside) / static_cast<float>(segment.pixels.size()));
    return result;
}

}  // namespace core::analysis
