// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/back_side.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "core/steps/surface.h"

namespace core::steps {
namespace {

constexpr const char* kName = "Back side";
constexpr float kUnlabelledThickness = 0.1f;  ///< of the distance
constexpr std::size_t kMinMirrorPoints = 16;
constexpr float kMaxMirrorError = 0.6f;
constexpr double kSilhouetteQuantile = 0.8;
constexpr float kMinMirrorCover = 0.2f;

struct Pixel {
    int x, y;
};

struct Box {
    int x0 = std::numeric_limits<int>::max(), y0 = std::numeric_limits<int>::max(), x1 = -1, y1 = -1;
    void add(Pixel p) {
        x0 = std::min(x0, p.x);
        y0 = std::min(y0, p.y);
        x1 = std::max(x1, p.x);
        y1 = std::max(y1, p.y);
    }
    [[nodiscard]] int width() const { return x1 - x0 + 1; }
    [[nodiscard]] int height() const { return y1 - y0 + 1; }
};

/// What the mirror image leaves in a pixel.
struct BackSample {
    float w = 0;  ///< 1/z; 0 = not covered
    Vector3f normal{0, 0, 0};
    Vector3f color{0, 0, 0};
};

struct Vertex {
    float u = 0, v = 0;
    BackSample sample;
};

float edgeFunction(const Vertex& a, const Vertex& b, float u, float v) {
    return (b.u - a.u) * (v - a.v) - (b.v - a.v) * (u - a.u);
}

/// The mirror image of a segment in the window of its own silhouette. Where several sheets of it cover a pixel the
/// farthest stays: that is where the ray of the pixel leaves the object.
class MirrorImage {
  public:
    MirrorImage(const LabelImage& labels, std::uint16_t label, const Box& box)
        : labels_(&labels), label_(label), box_(box), samples_(box.width(), box.height()) {}

    void drawTriangle(const Vertex& a, const Vertex& b, const Vertex& c) {
        const float area = edgeFunction(a, b, c.u, c.v);
        if (area == 0 || !std::isfinite(area)) return;
        const auto [lowU, highU] = std::minmax({a.u, b.u, c.u});
        const auto [lowV, highV] = std::minmax({a.v, b.v, c.v});
        const auto first = [](float low, int bound) {
            return static_cast<int>(std::max(std::ceil(low - 0.5f), static_cast<float>(bound)));
        };
        const auto last = [](float high, int bound) {
            return static_cast<int>(std::min(std::floor(high - 0.5f), static_cast<float>(bound)));
        };
        for (int y = first(lowV, box_.y0); y <= last(highV, box_.y1); ++y) {
            for (int x = first(lowU, box_.x0); x <= last(highU, box_.x1); ++x) {
                if ((*labels_)(x, y) != label_) continue;
                const float u = static_cast<float>(x) + 0.5f;
                const float v = static_cast<float>(y) + 0.5f;
                const float ka = edgeFunction(b, c, u, v) / area;
                const float kb = edgeFunction(c, a, u, v) / area;
                const float kc = 1 - ka - kb;
                if (ka < 0 || kb < 0 || kc < 0) continue;
                const float w = ka * a.sample.w + kb * b.sample.w + kc * c.sample.w;
                BackSample& target = samples_(x - box_.x0, y - box_.y0);
                if (target.w > 0 && target.w <= w) continue;
                target.w = w;
                target.normal = ka * a.sample.normal + kb * b.sample.normal + kc * c.sample.normal;
                target.color = ka * a.sample.color + kb * b.sample.color + kc * c.sample.color;
            }
        }
    }

    [[nodiscard]] std::size_t coveredCount() const {
        return static_cast<std::size_t>(
            std::ranges::count_if(samples_.pixels(), [](const BackSample& s) { return s.w > 0; }));
    }

    /// Depth and colour everywhere, the gaps closed by pull-push: averages of ever coarser neighbourhoods. Normals stay
    /// zero in the gaps.
    void closeGaps() { pullPush(samples_); }

    [[nodiscard]] const BackSample& at(Pixel p) const { return samples_(p.x - box_.x0, p.y - box_.y0); }

  private:
    static void pullPush(Image<BackSample>& fine) {
        if (std::ranges::all_of(fine.pixels(), [](const BackSample& s) { return s.w > 0; })) return;
        if (fine.width() == 1 && fine.height() == 1) return;
        Image<BackSample> coarse((fine.width() + 1) / 2, (fine.height() + 1) / 2);
        for (int y = 0; y < coarse.height(); ++y) {
            for (int x = 0; x < coarse.width(); ++x) {
                BackSample& sum = coarse(x, y);
                float count = 0;
                for (int k = 0; k < 4; ++k) {
                    const int fx = 2 * x + (k & 1);
                    const int fy = 2 * y + (k >> 1);
                    if (!fine.contains(fx, fy) || fine(fx, fy).w <= 0) continue;
                    sum.w += fine(fx, fy).w;
                    sum.color += fine(fx, fy).color;
                    ++count;
                }
                if (count == 0) continue;
                sum.w /= count;
                sum.color /= count;
            }
        }
        pullPush(coarse);
        for (int y = 0; y < fine.height(); ++y) {
            for (int x = 0; x < fine.width(); ++x) {
                BackSample& target = fine(x, y);
                if (target.w > 0) continue;
                // Bilinear between coarse centres.
                const float cx = 0.5f * (static_cast<float>(x) + 0.5f) - 0.5f;
                const float cy = 0.5f * (static_cast<float>(y) + 0.5f) - 0.5f;
                const int x0 = static_cast<int>(std::floor(cx));
                const int y0 = static_cast<int>(std::floor(cy));
                float weight = 0;
                for (int k = 0; k < 4; ++k) {
                    const int sx = std::clamp(x0 + (k & 1), 0, coarse.width() - 1);
                    const int sy = std::clamp(y0 + (k >> 1), 0, coarse.height() - 1);
                    const BackSample& sample = coarse(sx, sy);
                    if (sample.w <= 0) continue;
                    const float kx = (k & 1) != 0 ? cx - static_cast<float>(x0) : 1 - cx + static_cast<float>(x0);
                    const float ky = (k >> 1) != 0 ? cy - static_cast<float>(y0) : 1 - cy + static_cast<float>(y0);
                    target.w += kx * ky * sample.w;
                    target.color += kx * ky * sample.color;
                    weight += kx * ky;
                }
                if (weight <= 0) continue;
                target.w /= weight;
                target.color /= weight;
            }
        }
    }

    const LabelImage* labels_;
    std::uint16_t label_;
    Box box_;
    Image<BackSample> samples_;
};

/// Offset of ParallelMirror: see the header.
float parallelPlaneDepth(const LabelImage& labels, const Surface& front, std::uint16_t label,
                         const std::vector<Pixel>& pixels) {
    std::vector<float> silhouette;
    for (const auto& [x, y] : pixels) {
        bool edge = false;
        for (const auto& [dx, dy] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
            edge = edge || !labels.contains(x + dx, y + dy) || labels(x + dx, y + dy) != label;
        if (edge) silhouette.push_back(front.depth(x, y));
    }
    const auto rank = static_cast<std::ptrdiff_t>(kSilhouetteQuantile * static_cast<double>(silhouette.size() - 1));
    std::nth_element(silhouette.begin(), silhouette.begin() + rank, silhouette.end());
    return silhouette[static_cast<std::size_t>(rank)];
}

MirrorImage drawMirrorImage(const Camera& camera, const LabelImage& labels, const Surface& front, std::uint16_t label,
                            const std::vector<Pixel>& pixels, const MirrorPlane& plane) {
    Box box;
    for (const Pixel& pixel : pixels) box.add(pixel);
    MirrorImage image(labels, label, box);
    const auto vertex = [&](int x, int y) -> std::optional<Vertex> {
        if (!labels.contains(x, y) || labels(x, y) != label || front.depth(x, y) <= 0) return std::nullopt;
        const Vector3f& p = front.position(x, y);
        if (plane.normal.dot(p) > plane.offset) return std::nullopt;
        const Vector3f mirrored = plane.mirrored(p);
        if (mirrored.z() <= 1e-4f * p.z()) return std::nullopt;
        const Vector2f uv = camera.project(mirrored);
        return Vertex{
            uv.x(), uv.y(), {1 / mirrored.z(), plane.mirroredDirection(front.normal(x, y)), front.color(x, y)}};
    };
    // Pixels on either side of a discontinuity are not one surface.
    const auto connected = [&](Pixel a, Pixel b) {
        const float za = front.depth(a.x, a.y);
        const float zb = front.depth(b.x, b.y);
        return std::abs(za - zb) < 12 * std::min(za, zb) / std::min(camera.fx, camera.fy);
    };
    for (const auto& [x, y] : pixels) {
        const auto a = vertex(x, y);
        const auto b = vertex(x + 1, y);
        const auto c = vertex(x, y + 1);
        const auto d = vertex(x + 1, y + 1);
        if (b && c && connected({x + 1, y}, {x, y + 1})) {
            if (a && connected({x, y}, {x + 1, y}) && connected({x, y}, {x, y + 1})) image.drawTriangle(*a, *b, *c);
            if (d && connected({x + 1, y + 1}, {x + 1, y}) && connected({x + 1, y + 1}, {x, y + 1}))
                image.drawTriangle(*d, *b, *c);
        }
        // The triangle whose corner lies at the lower left of a quad without one at the upper left, and its like, close
        // outlines.
        if (a && d && connected({x, y}, {x + 1, y + 1})) {
            if (!c && b && connected({x, y}, {x + 1, y}) && connected({x + 1, y + 1}, {x + 1, y}))
                image.drawTriangle(*a, *b, *d);
            if (!b && c && connected({x, y}, {x, y + 1}) && connected({x + 1, y + 1}, {x, y + 1}))
                image.drawTriangle(*a, *c, *d);
        }
    }
    return image;
}

}  // namespace

std::optional<Vector3f> mirrorAxis(std::span<const Vector3f> points) {
    if (points.size() < 3) return std::nullopt;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Vector3f& p : points) mean += p.cast<double>();
    mean /= static_cast<double>(points.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const Vector3f& p : points) {
        const Eigen::Vector3d d = p.cast<double>() - mean;
        covariance += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    // Ascending eigenvalues: on a line the two smaller ones vanish and their axes are arbitrary.
    if (solver.info() != Eigen::Success || solver.eigenvalues()[1] <= 1e-9 * solver.eigenvalues()[2])
        return std::nullopt;
    Eigen::Index best = 0;
    solver.eigenvectors().row(2).cwiseAbs().maxCoeff(&best);
    const Eigen::Vector3d axis = solver.eigenvectors().col(best);
    return (axis.z() < 0 ? -axis : axis).cast<float>();
}

MirrorPlane fitMirrorPlane(const Camera& camera, const LabelImage& labels, const ImageF& depth,
                           const std::vector<bool>& supports, std::uint16_t label, std::span<const Vector3f> points,
                           const Vector3f& axis) {
    CORE_ASSERT(!points.empty(), "points to mirror");
    const std::size_t stride = points.size() / 20000 + 1;
    float nearest = std::numeric_limits<float>::max();
    float farthest = std::numeric_limits<float>::lowest();
    for (const Vector3f& p : points) {
        nearest = std::min(nearest, axis.dot(p));
        farthest = std::max(farthest, axis.dot(p));
    }
    struct Errors {
        float behind = 0, outside = 0;
    };
    const auto errors = [&](float offset) {
        const MirrorPlane plane{axis, offset, 0};
        std::size_t count = 0, behind = 0, outside = 0;
        for (std::size_t i = 0; i < points.size(); i += stride) {
            ++count;
            if (axis.dot(points[i]) > offset) {
                ++behind;
                continue;
            }
            const Vector3f mirrored = plane.mirrored(points[i]);
            bool inside = false;
            if (mirrored.z() > 0) {
                const Vector2f uv = camera.project(mirrored);
                const auto x = static_cast<int>(std::floor(std::clamp(uv.x(), -1.0f, 1e6f)));
                const auto y = static_cast<int>(std::floor(std::clamp(uv.y(), -1.0f, 1e6f)));
                if (labels.contains(x, y)) {
                    const std::uint16_t there = labels(x, y);
                    const bool hidden =
                        there != 0 && !supports[there] && depth(x, y) > 0 && depth(x, y) < points[i].z();
                    inside = there == label || hidden;
                }
            }
            if (!inside) ++outside;
        }
        const auto total = static_cast<float>(count);
        return Errors{static_cast<float>(behind) / total, static_cast<float>(outside) / total};
    };

    MirrorPlane best{axis, farthest, 2};
    float low = nearest;
    float high = farthest;
    float offset = farthest;
    for (int iteration = 0; iteration < 24; ++iteration) {
        const auto [behind, outside] = errors(offset);
        if (const float error = std::max(behind, outside); error < best.error) best = {axis, offset, error};
        if (behind < outside) {
            high = offset;
        } else {
            low = offset;
        }
        if (low >= farthest) break;
        offset = 0.5f * (low + high);
    }
    return best;
}

std::vector<bool> findSupports(const LabelImage& labels) {
    struct Outline {
        std::size_t length = 0;
        std::array<std::size_t, 4> sides{};
    };
    std::vector<Outline> outlines(65536);
    const int width = labels.width();
    const int height = labels.height();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::uint16_t label = labels(x, y);
            if (label == 0) continue;
            const std::array<bool, 4> border{x == 0, x == width - 1, y == 0, y == height - 1};
            const std::array<std::array<int, 2>, 4> neighbors{{{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}};
            for (std::size_t k = 0; k < 4; ++k) {
                if (border[k]) ++outlines[label].sides[k];
                if (border[k] || labels(neighbors[k][0], neighbors[k][1]) != label) ++outlines[label].length;
            }
        }
    }
    std::vector<bool> supports(outlines.size(), false);
    for (std::size_t label = 1; label < outlines.size(); ++label) {
        const auto& [length, sides] = outlines[label];
        const std::size_t touching = sides[0] + sides[1] + sides[2] + sides[3];
        const bool opposite = (sides[0] > 0 && sides[1] > 0) || (sides[2] > 0 && sides[3] > 0);
        supports[label] = touching > 0 && (touching * 5 >= length * 2 || (opposite && touching * 10 >= length));
    }
    return supports;
}

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

    for (std::size_t label = 1; label < pixelsOf.size(); ++label) {
        const std::vector<Pixel>& pixels = pixelsOf[label];
        if (pixels.empty()) continue;
        context.checkpoint(kName, 0.7f * static_cast<float>(label) / static_cast<float>(segments.size() + 1));
        const auto value = static_cast<std::uint16_t>(label);
        const auto found = std::ranges::find(segments, value, &Segment::label);
        const BackSideParams params = found == segments.end() ? BackSideParams{} : found->backSide;
        const float minThickness = std::max(params.minThickness, 1e-5f);
        const BackSideMethod method =
            params.method == BackSideMethod::Automatic ? BackSideMethod::PcaMirror : params.method;
        BackSideInfo info{value, method, {}, 0};

        std::optional<MirrorImage> image;
        if (method != BackSideMethod::Offset) {
            std::vector<Vector3f> points;
            points.reserve(pixels.size());
            for (const auto& [x, y] : pixels) points.push_back(front.position(x, y));
            std::optional<MirrorPlane> plane;
            if (supports[label]) {
                info.note = "It runs out of the picture like a table or a wall, so it is a slab of constant thickness.";
            } else if (points.size() < kMinMirrorPoints) {
                info.note = "It has too few pixels with depth for a mirror plane.";
            } else if (method == BackSideMethod::ParallelMirror) {
                plane = MirrorPlane{{0, 0, 1}, parallelPlaneDepth(labels, front, value, pixels), 0};
            } else if (const auto axis = mirrorAxis(points)) {
                plane = fitMirrorPlane(camera, labels, front.depth, supports, value, points, *axis);
                info.mirrorError = plane->error;
                if (plane->error > kMaxMirrorError) {
                    info.note = "No mirror plane keeps most of it inside its silhouette.";
                    plane.reset();
                }
            } else {
                info.note = "Its points lie on a line, which has no mirror plane.";
            }
            if (plane) {
                image = drawMirrorImage(camera, labels, front, value, pixels, *plane);
                if (static_cast<float>(image->coveredCount()) < kMinMirrorCover * static_cast<float>(pixels.size())) {
                    info.note = "Its mirror image covers too little of its silhouette.";
                    image.reset();
                }
            }
            if (!image) info.used = BackSideMethod::Offset;
        }

        if (image) {
            for (const Pixel& p : pixels) mirroredNormals(p.x, p.y) = image->at(p).normal;
            image->closeGaps();
        }
        for (const auto& [x, y] : pixels) {
            const float z = front.depth(x, y);
            if (!image) {
                back.depth(x, y) = z + std::max(params.offset, minThickness);
                continue;
            }
            const BackSample& sample = image->at({x, y});
            const float mirrored = sample.w > 0 ? 1 / sample.w : 0;
            if (mirrored > z + minThickness) {
                back.depth(x, y) = mirrored;
                back.color(x, y) = sample.color;
            } else {
                back.depth(x, y) = z + minThickness;
                mirroredNormals(x, y).setZero();
            }
        }
        result.segments.push_back(std::move(info));
    }

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

    back.normal = computeNormals(camera, back.depth, labels, Side::Back, relativeNoise, kName, context, 0.7f, 1.0f);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Vector3f n = mirroredNormals(x, y).normalized();
            if (n.dot(camera.pixelRay(x, y)) > 0.02f) back.normal(x, y) = n;
        }
    }
    completeSurface(camera, back);
    return result;
}

Step backSideStep() {
    Step step;
    step.name = kName;
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
            throw Error(ErrorKind::Input, "The back-side depth \"" + board.scene->backDepthPath + "\" has " +
                                              std::to_string(board.scene->backDepth->width()) + "x" +
                                              std::to_string(board.scene->backDepth->height()) +
                                              " pixels, but the photograph has " + std::to_string(photo.depth.width()) +
                                              "x" + std::to_string(photo.depth.height()) + ".");
        board.back = std::make_shared<BackLayer>(inventBackSide(photo.camera, photo.labels, *board.front,
                                                                board.scene->segments, board.scene->backDepth.get(),
                                                                board.depth->relativeNoise, context));
    };
    return step;
}

}  // namespace core::steps
