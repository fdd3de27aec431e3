// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/back/back_side.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <optional>

#include "core/analysis/back/flat_faces.h"
#include "core/analysis/back/spanned_mirror.h"
#include "core/analysis/depth/normals.h"
#include "core/analysis/kernels.h"
#include "core/analysis/segment/support_planes.h"
#include "core/base/label_table.h"

namespace core::analysis {
namespace {

// Shares of the step's time.
/// Sorting the pixels by segment.
constexpr float kSortingEnd = 0.15f;
/// Inventing; normals and patch areas take the rest.
constexpr float kInventingEnd = 0.5f;
/// Thickness of what has no label, relative to its distance.
constexpr float kUnlabelledThickness = 0.1f;
constexpr std::size_t kMinMirrorPoints = 16;
constexpr float kMaxMirrorError = 0.6f;
/// Minimum share of the silhouette that a mirror image covers.
constexpr float kMinMirrorCover = 0.2f;
/// Lower bound [m] of BackSideParams::minThickness.
constexpr float kMinThickness = 1e-5f;
/// Minimum cosine between a back's normal and its pixel's ray.
constexpr float kMinBackCosine = 0.02f;

/// A back that one method invented.
struct Candidate {
    BackSideMethod method = BackSideMethod::Offset;
    std::optional<BackSamples> samples;  ///< nullopt: it failed
    float error = 0;                     ///< BackSideInfo::mirrorError
    Message failure;                     ///< reason, a full sentence
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
        result.failure = Message("messages", "None of its flat faces ends at its outline.");
    }
    return result;
}

Candidate invent(const SegmentPixels& segment, const std::optional<SupportPlane>& support, BackSideMethod method,
                 const BackSideParams& params, const Progress& progress) {
    progress.checkpoint(0);
    Candidate result{method, {}, 0, {}};
    if (method == BackSideMethod::Offset) return result;
    if (segment.supports[segment.label]) {
        result.failure = Message(
            "messages", "It runs out of the picture like a table or a wall, so it is a slab of constant thickness.");
    } else if (segment.pixels.size() < kMinMirrorPoints) {
        result.failure = Message("messages", "It has too few pixels with depth to estimate its shape.");
    } else if (method == BackSideMethod::SpannedMirror) {
        SpannedMirror mirror = mirrorAtSpannedSurface(segment, support, params.planeShift, progress);
        result.error = mirror.error;
        if (mirror.outline > 0)
            result.samples = std::move(mirror.samples);
        else
            result.failure =
                Message("messages", "None of its outline is visible, so no mirror can be spanned into it.");
    } else if (method == BackSideMethod::FlatFaces) {
        return flatFaces(continueFlatFaces(segment));
    } else {
        return mirrorAtPlane(segment, method, params.planeShift);
    }
    return result;
}

/// The back with the lower penalty of the two methods that close at the outline; a mirror plane if neither works.
Candidate chooseAutomatically(const SegmentPixels& segment, const std::optional<SupportPlane>& support,
                              const BackSideParams& params, const Progress& progress) {
    Candidate best = invent(segment, support, BackSideMethod::SpannedMirror, params, progress.part(0, 0.6f));
    if (!best.samples) {
        for (const BackSideMethod method : {BackSideMethod::PcaMirror, BackSideMethod::ParallelMirror}) {
            Candidate other = invent(segment, support, method, params, progress.part(0.6f, 0.6f));
            if (other.samples && (!best.samples || other.error < best.error)) best = std::move(other);
        }
        return best;
    }
    progress.checkpoint(0.6f);
    // The two make opposite assumptions on how the front ends at the outline: where one holds, the other fails.
    FlatFaces solid = continueFlatFaces(segment);
    best.error = std::max(best.error, solid.outline);
    if (solid.error >= best.error) return best;
    return flatFaces(std::move(solid));
}

/// Writes one segment's back; `normals` gets those of the mirror image and of the support.
void writeBack(const SegmentPixels& segment, const Candidate& candidate, const BackSideParams& params,
               const std::optional<SupportPlane>& support, Surface& back, ImageV3& normals) {
    const float minThickness = std::max(params.minThickness, kMinThickness);
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

/// Sums the progress of segments that are worked on in parallel.
class ParallelProgress {
  public:
    explicit ParallelProgress(const Progress& whole) : whole_(whole) {}
    /// Progress of one piece of the work, on one thread; `share` of the whole. Cancelled together with the whole.
    [[nodiscard]] Progress piece(float share) {
        return Progress([this, share, reported = std::make_shared<float>(0.0f)](Task, float fraction) {
            const float more = share * std::max(fraction - *reported, 0.0f);
            *reported = std::max(fraction, *reported);
            whole_.checkpoint(done_.fetch_add(more, std::memory_order_relaxed) + more);
        });
    }

  private:
    const Progress& whole_;
    std::atomic<float> done_{0};
};

/// What all segments' backs are made from.
struct BackSideScene {
    const Camera& camera;
    const LabelImage& labels;
    const Surface& front;
    std::span<const Segment> segments;

    [[nodiscard]] BackSideParams paramsOf(std::uint16_t label) const {
        const auto found = std::ranges::find(segments, label, &Segment::label);
        return found == segments.end() ? BackSideParams{} : found->backSide;
    }
};

LabelTable<std::vector<Pixel>> pixelsByLabel(const LabelImage& labels, const ImageF& depth) {
    LabelTable<std::vector<Pixel>> pixels;
    for (int y = 0; y < depth.height(); ++y)
        for (int x = 0; x < depth.width(); ++x)
            if (depth(x, y) > 0) pixels[labels(x, y)].push_back({x, y});
    return pixels;
}

BackSideInfo inventSegment(const BackSideScene& scene, const SegmentPixels& segment, Surface& back, ImageV3& normals,
                           const Progress& progress) {
    const BackSideParams params = scene.paramsOf(segment.label);
    const auto support = segment.supports[segment.label] ? std::nullopt : fitSupportPlane(segment);
    const Candidate candidate = params.method == BackSideMethod::Automatic
                                    ? chooseAutomatically(segment, support, params, progress)
                                    : invent(segment, support, params.method, params, progress);
    progress.checkpoint(1);
    writeBack(segment, candidate, params, support, back, normals);
    return {segment.label, candidate.samples ? candidate.method : BackSideMethod::Offset, candidate.failure,
            candidate.error, support.has_value()};
}

/// All labelled segments, in label order; takes their pixels out of the table.
std::vector<BackSideInfo> inventSegments(const BackSideScene& scene, LabelTable<std::vector<Pixel>>& pixelsOf,
                                         Surface& back, ImageV3& normals, const Progress& progress) {
    const auto supports = findSupports(scene.labels);
    std::vector<std::uint16_t> present;
    float work = 0;
    // A support becomes a slab, which costs next to nothing.
    const auto workOf = [&](std::uint16_t label) {
        return supports[label] ? 0.0f : static_cast<float>(pixelsOf[label].size());
    };
    for (std::size_t label = 1; label < pixelsOf.size(); ++label) {
        if (pixelsOf[label].empty()) continue;
        present.push_back(static_cast<std::uint16_t>(label));
        work += workOf(present.back());
    }
    std::vector<BackSideInfo> infos(present.size());
    ParallelProgress pieces(progress);
    // Few, large pieces of very different size: one task each.
    tbb::parallel_for(std::size_t{0}, present.size(), [&](std::size_t i) {
        const std::uint16_t label = present[i];
        const Progress piece = pieces.piece(workOf(label) / std::max(work, 1.0f));
        SegmentPixels segment{scene.camera, scene.labels, scene.front, supports, label, std::move(pixelsOf[label]), {}};
        for (const Pixel& pixel : segment.pixels) segment.box.add(pixel);
        infos[i] = inventSegment(scene, segment, back, normals, piece);
    });
    return infos;
}

/// Replaces the back by the user's depth, where that is given.
void applyUserDepth(const BackSideScene& scene, const ImageF& userDepth, Surface& back, ImageV3& normals) {
    LabelTable<float> minThickness(BackSideParams{}.minThickness);
    for (const Segment& segment : scene.segments) minThickness[segment.label] = segment.backSide.minThickness;
    const ImageF& front = scene.front.depth;
    for (std::size_t i = 0; i < userDepth.size(); ++i) {
        const float z = userDepth[i];
        if (front[i] <= 0 || !(z > 0) || !std::isfinite(z)) continue;
        back.depth[i] = std::max(z, front[i] + std::max(minThickness[scene.labels[i]], kMinThickness));
        normals[i].setZero();
    }
}

/// Unit length, or zero for normals that do not face away from the camera.
void normalize(const Camera& camera, ImageV3& normals) {
    for (int y = 0; y < normals.height(); ++y) {
        for (int x = 0; x < normals.width(); ++x) {
            Vector3f& n = normals(x, y);
            n.normalize();
            if (!(n.dot(camera.pixelRay(x, y)) > kMinBackCosine)) n.setZero();
        }
    }
}

/// Throws when the user's back side has another size than the photograph.
void requireFit(const Scene& scene, const ImageF& backDepth) {
    const ImageF& depth = scene.photo->depth;
    if (backDepth.sameSize(depth)) return;
    const auto size = [](const ImageF& image) {
        return std::to_string(image.width()) + "x" + std::to_string(image.height());
    };
    throw Error(ErrorKind::Input,
                Message("messages", "The back-side depth \"%1\" has %2 pixels, but the photograph has %3.")
                    .with(scene.backDepthPath, size(backDepth), size(depth)));
}

}  // namespace

BackLayer inventBackSide(const Camera& camera, const LabelImage& labels, const Surface& front,
                         std::span<const Segment> segments, const ImageF* userDepth, float relativeNoise,
                         const StepContext& context) {
    const BackSideScene scene{camera, labels, front, segments};
    BackLayer result;
    Surface& back = result.surface;
    back.depth = ImageF(front.depth.width(), front.depth.height(), 0.0f);
    back.color = front.color;
    ImageV3 normals(front.depth.width(), front.depth.height(), Vector3f::Zero());
    auto pixels = pixelsByLabel(labels, front.depth);
    for (const auto& [x, y] : pixels[0]) back.depth(x, y) = front.depth(x, y) * (1 + kUnlabelledThickness);
    result.segments = inventSegments(scene, pixels, back, normals, context.progress.part(kSortingEnd, kInventingEnd));
    if (userDepth != nullptr && userDepth->sameSize(front.depth)) applyUserDepth(scene, *userDepth, back, normals);
    normalize(camera, normals);
    context.kernels.computeSurface({camera, labels, Side::Back, relativeNoise, &normals}, back,
                                   context.progress.part(kInventingEnd, 1));
    return result;
}

Step backSideStep() {
    Step step;
    step.task = Task::InventBackSides;
    step.reads = {Item::Photo, Item::Depth, Item::Front, Item::UserBackDepth};
    step.writes = Item::Back;
    step.params = [](const Scene& scene, Hash& hash) {
        addParams(hash, Stage::BackSide, scene);
        for (const Segment& segment : scene.segments) addParams(hash.add(segment.label), Stage::BackSide, segment);
    };
    step.run = [](Board& board, const StepContext& context) {
        const Scene& scene = *board.scene;
        const Photo& photo = *scene.photo;
        if (scene.backDepth) requireFit(scene, *scene.backDepth);
        board.back =
            std::make_shared<BackLayer>(inventBackSide(photo.camera, photo.labels, *board.front, scene.segments,
                                                       scene.backDepth.get(), board.depth->relativeNoise, context));
    };
    return step;
}

}  // namespace core::analysis
