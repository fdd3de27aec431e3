// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/back/back_side.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>

#include "core/analysis/back/flat_faces.h"
#include "core/analysis/back/spanned_mirror.h"
#include "core/analysis/depth/normals.h"
#include "core/analysis/kernels.h"
#include "core/analysis/segment/support_planes.h"
#include "core/base/parallel.h"

namespace core::analysis {
namespace {

constexpr float kInventing = 0.7f;            ///< part of the step that inventing takes
constexpr float kUnlabelledThickness = 0.1f;  ///< of the distance
constexpr std::size_t kMinMirrorPoints = 16;
constexpr float kMaxMirrorError = 0.6f;
constexpr float kMinMirrorCover = 0.2f;

/// A back that one method invented.
struct Candidate {
    BackSideMethod method = BackSideMethod::Offset;
    std::optional<BackSamples> samples;  ///< nullopt: it failed
    float error = 0;                     ///< BackSideInfo::mirrorError
    Message failure;                     ///< why, a full sentence
};

Candidate mirrorAtPlane(const SegmentPixels& segment, BackSideMethod method, float shift) {
    Candidate result{method, {}, 0, {}};
    MirrorPlane plane;
    if (method == BackSideMethod::ParallelMirror) {
        plane = parallelMirrorPlane(segment);
    } else {
        std::vector<Vector3f> points;
        points.reserve(segment.pixels.size());
        for (const auto& [x, y] : segment.pixels) points.push_back(segment.front.position(x, y));
        const auto axis = mirrorAxis(points);
        if (!axis) {
            result.failure = Message("messages", "Its points lie on a line, which has no mirror plane.");
            return result;
        }
        plane = fitMirrorPlane(segment, *axis);
        if (plane.error > kMaxMirrorError) {
            result.error = plane.error;
            result.failure = Message("messages", "No mirror plane keeps most of it inside its silhouette.");
            return result;
        }
    }
    result.error = plane.error;
    plane.offset += shift;
    BackSamples image = drawMirrorImage(segment, plane);
    if (static_cast<float>(coveredCount(image)) < kMinMirrorCover * static_cast<float>(segment.pixels.size())) {
        result.failure = Message("messages", "Its mirror image covers too little of its silhouette.");
        return result;
    }
    closeGaps(image);
    result.samples = std::move(image);
    return result;
}

Candidate flatFaces(FlatFaces solid) {
    Candidate result{BackSideMethod::FlatFaces, {}, solid.error, {}};
    if (solid.faces > 0 && coveredCount(solid.samples) > 0) {
        closeGaps(solid.samples);
        result.samples = std::move(solid.samples);
    } else {
        result.failure = Message("messages", "No flat face of it ends at its outline.");
    }
    return result;
}

/// How far the step is, for work inside one segment, which cannot tell.
struct Reporter {
    const Progress& whole;
    std::atomic<int>& done;
    int count;

    [[nodiscard]] float share() const {
        return kInventing * static_cast<float>(done.load(std::memory_order_relaxed)) / static_cast<float>(count);
    }
    [[nodiscard]] Progress progress() const { return whole.part(share(), share()); }
    void checkpoint() const { whole.checkpoint(share()); }
};

Candidate invent(const SegmentPixels& segment, const std::optional<SupportPlane>& support, BackSideMethod method,
                 const BackSideParams& params, const Reporter& reporter) {
    reporter.checkpoint();
    Candidate result{method, {}, 0, {}};
    if (method == BackSideMethod::Offset) return result;
    if (segment.supports[segment.label]) {
        result.failure = Message(
            "messages", "It runs out of the picture like a table or a wall, so it is a slab of constant thickness.");
    } else if (segment.pixels.size() < kMinMirrorPoints) {
        result.failure = Message("messages", "It has too few pixels with depth to tell its shape.");
    } else if (method == BackSideMethod::SpannedMirror) {
        SpannedMirror mirror = mirrorAtSpannedSurface(segment, support, params.planeShift, reporter.progress());
        result.error = mirror.error;
        if (mirror.outline > 0)
            result.samples = std::move(mirror.samples);
        else
            result.failure =
                Message("messages", "Nothing of its outline is seen, so no mirror can be spanned into it.");
    } else if (method == BackSideMethod::FlatFaces) {
        return flatFaces(continueFlatFaces(segment));
    } else {
        return mirrorAtPlane(segment, method, params.planeShift);
    }
    return result;
}

/// The back with the lowest penalty of the two methods that close at the outline; a mirror plane when neither can be
/// made.
Candidate chooseAutomatically(const SegmentPixels& segment, const std::optional<SupportPlane>& support,
                              const BackSideParams& params, const Reporter& reporter) {
    Candidate best = invent(segment, support, BackSideMethod::SpannedMirror, params, reporter);
    if (!best.samples) {
        for (const BackSideMethod method : {BackSideMethod::PcaMirror, BackSideMethod::ParallelMirror}) {
            Candidate other = invent(segment, support, method, params, reporter);
            if (other.samples && (!best.samples || other.error < best.error)) best = std::move(other);
        }
        return best;
    }
    reporter.checkpoint();
    // Opposite assumptions on how the front ends at the outline: where one holds, the other fails.
    FlatFaces solid = continueFlatFaces(segment);
    best.error = std::max(best.error, solid.outline);
    if (solid.error >= best.error) return best;
    return flatFaces(std::move(solid));
}

/// Writes one segment's back; `normals` gets those of the mirror image.
void writeBack(const SegmentPixels& segment, const Candidate& candidate, const BackSideParams& params,
               const std::optional<SupportPlane>& support, Surface& back, ImageV3& normals) {
    const float minThickness = std::max(params.minThickness, 1e-5f);
    for (const Pixel& pixel : segment.pixels) {
        const auto& [x, y] = pixel;
        const float front = segment.front.depth(x, y);
        float z = front + params.offset;
        if (candidate.samples) {
            const BackSample& sample = (*candidate.samples)(x - segment.box.x0, y - segment.box.y0);
            const float invented = sample.w > 0 ? 1 / sample.w : front;
            z = front + params.thicknessScale * (invented - front);
            if (z > front + minThickness) {
                back.color(x, y) = sample.color;
                if (params.thicknessScale == 1) normals(x, y) = sample.normal;
            }
        }
        if (support) {
            const float ground = support->depthAlong(segment.camera.pixelRay(x, y));
            if (ground < z) {
                z = ground;
                normals(x, y) = support->normal;
            }
        }
        if (z < front + minThickness) {
            z = front + minThickness;
            normals(x, y).setZero();
        }
        back.depth(x, y) = z;
    }
}

}  // namespace

BackLayer inventBackSide(const Camera& camera, const LabelImage& labels, const Surface& front,
                         std::span<const Segment> segments, const ImageF* userDepth, float relativeNoise,
                         const StepContext& context) {
    const int width = front.depth.width();
    const int height = front.depth.height();
    BackLayer result;
    Surface& back = result.surface;
    back.depth = ImageF(width, height, 0.0f);
    back.color = front.color;
    ImageV3 mirroredNormals(width, height, Vector3f::Zero());

    const std::vector<bool> supports = findSupports(labels);
    std::vector<std::vector<Pixel>> pixelsOf(65536);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (front.depth(x, y) > 0) pixelsOf[labels(x, y)].push_back({x, y});

    for (const auto& [x, y] : pixelsOf[0]) back.depth(x, y) = front.depth(x, y) * (1 + kUnlabelledThickness);

    std::vector<std::size_t> present;
    for (std::size_t label = 1; label < pixelsOf.size(); ++label)
        if (!pixelsOf[label].empty()) present.push_back(label);
    result.segments.resize(present.size());
    std::atomic<int> done{0};
    const Reporter reporter{context.progress, done, static_cast<int>(present.size())};
    const auto inventOne = [&](int index) {
        const auto label = static_cast<std::uint16_t>(present[static_cast<std::size_t>(index)]);
        SegmentPixels segment{camera, labels, front, supports, label, std::move(pixelsOf[label]), {}};
        for (const Pixel& pixel : segment.pixels) segment.box.add(pixel);
        const auto found = std::ranges::find(segments, label, &Segment::label);
        const BackSideParams params = found == segments.end() ? BackSideParams{} : found->backSide;
        const auto support = supports[label] ? std::nullopt : fitSupportPlane(segment);
        const Candidate candidate = params.method == BackSideMethod::Automatic
                                        ? chooseAutomatically(segment, support, params, reporter)
                                        : invent(segment, support, params.method, params, reporter);
        reporter.checkpoint();
        writeBack(segment, candidate, params, support, back, mirroredNormals);
        result.segments[static_cast<std::size_t>(index)] = {
            label, candidate.samples ? candidate.method : BackSideMethod::Offset, candidate.failure, candidate.error,
            support.has_value()};
        done.fetch_add(1, std::memory_order_relaxed);
    };
    tbb::parallel_for(0, static_cast<int>(present.size()), inventOne);

    if (userDepth != nullptr && userDepth->sameSize(front.depth)) {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const float z = (*userDepth)(x, y);
                if (front.depth(x, y) <= 0 || !(z > 0) || !std::isfinite(z)) continue;
                const auto found = std::ranges::find(segments, labels(x, y), &Segment::label);
                const float minThickness =
                    found == segments.end() ? BackSideParams{}.minThickness : found->backSide.minThickness;
                back.depth(x, y) = std::max(z, front.depth(x, y) + std::max(minThickness, 1e-5f));
                mirroredNormals(x, y).setZero();
            }
        }
    }

    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            Vector3f& n = mirroredNormals(x, y);
            n.normalize();
            if (!(n.dot(camera.pixelRay(x, y)) > 0.02f)) n.setZero();
        }
    }
    context.kernels.computeSurface({camera, labels, Side::Back, relativeNoise, &mirroredNormals}, back,
                                   context.progress.part(kInventing, 1));
    return result;
}

Step backSideStep() {
    Step step;
    step.task = Task::InventBackSides;
    step.reads = {Item::Photo, Item::Depth, Item::Front, Item::UserBackDepth};
    step.writes = Item::Back;
    step.params = [](const Scene& scene, Hash& hash) {
        for (const Segment& segment : scene.segments) {
            const BackSideParams& p = segment.backSide;
            hash.add(segment.label).add(p.method).add(p.minThickness);
            hash.add(p.offset).add(p.planeShift).add(p.thicknessScale);
        }
    };
    step.run = [](Board& board, const StepContext& context) {
        const Photo& photo = *board.scene->photo;
        if (board.scene->backDepth && !board.scene->backDepth->sameSize(photo.depth))
            throw Error(
                ErrorKind::Input,
                Message("messages", "The back-side depth \"%1\" has %2x%3 pixels, but the photograph has %4x%5.")
                    .with(board.scene->backDepthPath, board.scene->backDepth->width(), board.scene->backDepth->height(),
                          photo.depth.width(), photo.depth.height()));
        board.back = std::make_shared<BackLayer>(inventBackSide(photo.camera, photo.labels, *board.front,
                                                                board.scene->segments, board.scene->backDepth.get(),
                                                                board.depth->relativeNoise, context));
    };
    return step;
}

}  // namespace core::analysis
