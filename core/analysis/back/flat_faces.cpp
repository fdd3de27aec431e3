// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/back/flat_faces.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/statistics.h"

namespace core::analysis {
namespace {

/// Minimum cosine to the view: faces seen at a smaller angle turn away at the edge.
constexpr float kFacing = 0.1f;
/// Minimum cosine between normals of one visible face.
constexpr float kFlat = 0.985f;
/// Minimum cosine between normals of one hidden face.
constexpr float kSamePlane = 0.97f;
/// Maximum distance from a hidden face [pixel widths].
constexpr float kTolerance = 2.5f;
/// Minimum share of the known outline that belongs to one hidden face.
constexpr double kMinVotes = 0.04;
/// Minimum number of pixels of an edge.
constexpr std::size_t kMinEdge = 6;
/// Maximum second eigenvalue of the points of a straight edge, relative to the first.
constexpr double kStraightEdge = 0.05;
/// Maximum number of outline pixels whose hidden face is fitted.
constexpr std::size_t kMaxCandidates = 400;

/// Half-space n·p ≤ offset that the object lies in.
struct HiddenFace {
    Vector3f normal{0, 0, 0};
    float offset = 0;
};

/// Maximum distance [m] of an outline pixel from the face behind it. Larger for faces seen at a small angle, along
/// which half a pixel across the edge is a long way.
float tolerance(const SegmentPixels& segment, Pixel pixel) {
    const Vector3f& p = segment.front.position(pixel.x, pixel.y);
    const float facing = -segment.front.normal(pixel.x, pixel.y).dot(p.normalized());
    return kTolerance * segment.footprint(p.z()) * std::max(1.0f, 0.5f / std::max(facing, kFacing));
}

/// Extent [m] along the hidden face's normal of the visible face beside it, at an outline pixel: up to the border of
/// the pixel, between the last centre inside and the first outside.
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

/// The surroundings of an outline pixel.
struct NearbyFace {
    std::vector<Vector3f> edge;  ///< outline points of the pixel's own face
    Vector3f inside{0, 0, 0};    ///< towards the inside of that face, any length
    bool flat = false;           ///< the face makes up at least a third of the surroundings
};

NearbyFace faceAround(const SegmentPixels& segment, const Image<std::uint8_t>& outline, Pixel pixel, int radius) {
    const Vector3f& p = segment.front.position(pixel.x, pixel.y);
    const Vector3f& normal = segment.front.normal(pixel.x, pixel.y);
    NearbyFace face;
    int total = 0, flat = 0;
    for (int y = pixel.y - radius; y <= pixel.y + radius; ++y) {
        for (int x = pixel.x - radius; x <= pixel.x + radius; ++x) {
            if (!segment.contains(x, y)) continue;
            ++total;
            if (segment.front.normal(x, y).dot(normal) < kFlat) continue;
            ++flat;
            face.inside += segment.front.position(x, y) - p;
            if (outline(x - segment.box.x0, y - segment.box.y0) != 0) face.edge.push_back(segment.front.position(x, y));
        }
    }
    face.flat = flat * 3 >= total;
    return face;
}

/// A straight line through points.
struct Line {
    Vector3f mean;
    Vector3f direction;  ///< unit
};

/// nullopt if the points do not lie on one line.
std::optional<Line> fitLine(const std::vector<Vector3f>& points) {
    Vector3f mean = Vector3f::Zero();
    for (const Vector3f& q : points) mean += q;
    mean /= static_cast<float>(points.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const Vector3f& q : points) {
        const Eigen::Vector3d d = (q - mean).cast<double>();
        covariance += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    if (solver.eigenvalues()[1] > kStraightEdge * solver.eigenvalues()[2]) return std::nullopt;
    return Line{mean, solver.eigenvectors().col(2).cast<float>()};
}

/// The hidden face behind one outline pixel, if a flat face ends there in a straight edge.
std::optional<HiddenFace> faceBehind(const SegmentPixels& segment, const Image<std::uint8_t>& outline, Pixel pixel,
                                     int radius) {
    const Vector3f view = segment.front.position(pixel.x, pixel.y).normalized();
    const Vector3f& normal = segment.front.normal(pixel.x, pixel.y);
    if (-normal.dot(view) < kFacing) return std::nullopt;
    const NearbyFace face = faceAround(segment, outline, pixel, radius);
    if (!face.flat || face.edge.size() < kMinEdge) return std::nullopt;
    const auto edge = fitLine(face.edge);
    if (!edge) return std::nullopt;
    Vector3f hidden = edge->direction.cross(normal);
    if (hidden.norm() < 0.5f) return std::nullopt;
    hidden.normalize();
    if (hidden.dot(face.inside) > 0) hidden = -hidden;
    return HiddenFace{hidden, hidden.dot(edge->mean)};
}

/// Pixels at which the object is known to end.
std::vector<Pixel> knownOutline(const SegmentPixels& segment) {
    std::vector<Pixel> outline;
    for (const Pixel& pixel : segment.pixels) {
        const auto anySide = [&](Beyond what) {
            return std::ranges::any_of(kNeighbors, [&](Pixel step) { return beyond(segment, pixel, step) == what; });
        };
        if (anySide(Beyond::Outline) && !anySide(Beyond::Unknown)) outline.push_back(pixel);
    }
    return outline;
}

/// An outline pixel and the hidden face behind it.
struct EdgePixel {
    Pixel pixel;
    HiddenFace face;
    bool taken = false;  ///< belongs to a hidden face already found
};

/// Every `stride`-th outline pixel behind which a hidden face begins.
std::vector<EdgePixel> edgePixels(const SegmentPixels& segment, const std::vector<Pixel>& outline, std::size_t stride) {
    const PixelBox& box = segment.box;
    Image<std::uint8_t> isOutline(box.width(), box.height(), 0);
    for (const Pixel& pixel : outline) isOutline(pixel.x - box.x0, pixel.y - box.y0) = 1;
    const int radius = std::clamp(std::min(box.width(), box.height()) / 10, 3, 14);
    std::vector<EdgePixel> result;
    for (std::size_t i = 0; i < outline.size(); i += stride)
        if (const auto face = faceBehind(segment, isOutline, outline[i], radius)) result.push_back({outline[i], *face});
    return result;
}

/// True if an outline pixel that no face has yet may belong to this one.
bool votesFor(const SegmentPixels& segment, const EdgePixel& candidate, const HiddenFace& face) {
    const Vector3f& p = segment.front.position(candidate.pixel.x, candidate.pixel.y);
    return !candidate.taken && candidate.face.normal.dot(face.normal) > kSamePlane &&
           std::abs(face.normal.dot(p) - face.offset) < tolerance(segment, candidate.pixel);
}

/// The face with the most votes, which are then taken; nullopt with less than `minVotes`.
std::optional<HiddenFace> takeLargestFace(const SegmentPixels& segment, std::vector<EdgePixel>& candidates,
                                          std::size_t minVotes) {
    const EdgePixel* best = nullptr;
    std::size_t mostVotes = 0;
    for (const EdgePixel& seed : candidates) {
        if (seed.taken) continue;
        const auto votes = static_cast<std::size_t>(
            std::ranges::count_if(candidates, [&](const EdgePixel& c) { return votesFor(segment, c, seed.face); }));
        if (votes <= mostVotes) continue;
        mostVotes = votes;
        best = &seed;
    }
    if (best == nullptr || mostVotes < minVotes) return std::nullopt;
    const HiddenFace seed = best->face;
    HiddenFace face;
    for (const EdgePixel& c : candidates)
        if (votesFor(segment, c, seed)) face.normal += c.face.normal;
    face.normal.normalize();
    std::vector<float> offsets;
    for (EdgePixel& c : candidates) {
        if (!votesFor(segment, c, seed)) continue;
        c.taken = true;
        offsets.push_back(reachAt(segment, c.pixel, face));
    }
    face.offset = median(offsets);
    return face;
}

/// True if a point of the front lies clearly outside a face.
bool isOutside(const SegmentPixels& segment, const Vector3f& point, const HiddenFace& face) {
    return face.normal.dot(point) > face.offset + 2 * kTolerance * segment.footprint(point.z());
}

/// Where the ray of a pixel leaves the object: at the nearest hidden face that it passes outwards.
BackSample exitSample(const std::vector<HiddenFace>& faces, const Vector3f& ray, const Vector3f& color) {
    BackSample sample;
    for (const HiddenFace& face : faces) {
        const float slope = face.normal.dot(ray);
        if (slope <= 1e-4f || face.offset <= 0 || slope / face.offset <= sample.w) continue;
        sample = {slope / face.offset, face.normal, color};
    }
    return sample;
}

}  // namespace

FlatFaces continueFlatFaces(const SegmentPixels& segment) {
    FlatFaces result;
    const std::vector<Pixel> outline = knownOutline(segment);
    if (outline.size() < kMinEdge) return result;
    const std::size_t stride = outline.size() / kMaxCandidates + 1;
    std::vector<EdgePixel> candidates = edgePixels(segment, outline, stride);
    const auto minVotes = static_cast<std::size_t>(
        std::max(3.0, kMinVotes * static_cast<double>(outline.size()) / static_cast<double>(stride)));
    std::vector<HiddenFace> faces;
    while (const auto face = takeLargestFace(segment, candidates, minVotes)) faces.push_back(*face);
    result.faces = static_cast<int>(faces.size());
    if (faces.empty()) return result;

    const auto ending = std::ranges::count_if(candidates, &EdgePixel::taken);
    result.outline =
        static_cast<float>(ending * static_cast<std::ptrdiff_t>(stride)) / static_cast<float>(outline.size());
    result.outline = std::min(result.outline, 1.0f);
    result.samples = BackSamples(segment.box.width(), segment.box.height());
    std::size_t outside = 0;
    for (const auto& [x, y] : segment.pixels) {
        const Vector3f& p = segment.front.position(x, y);
        if (std::ranges::any_of(faces, [&](const HiddenFace& face) { return isOutside(segment, p, face); })) ++outside;
        result.samples(x - segment.box.x0, y - segment.box.y0) =
            exitSample(faces, segment.camera.pixelRay(x, y), segment.front.color(x, y));
    }
    result.error =
        std::max(1 - result.outline, static_cast<float>(outside) / static_cast<float>(segment.pixels.size()));
    return result;
}

}  // namespace core::analysis
