// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/reflectance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/parallel.h"

namespace core::steps {
namespace {

constexpr const char* kName = "Reflectance";
constexpr int kIncidentRays = 1 << 16;
constexpr float kMinRho = 0.02f;
/// Beyond this angle (cosine) a mirrored direction depends more on the error of the normal than on the normal.
constexpr float kMinCosine = 0.08f;

float luminance(const Vector3f& c) { return c.dot(Vector3f(0.2126f, 0.7152f, 0.0722f)); }

/// Where a ray from a pixel of the segment, or from its centre, ended.
struct Ending {
    enum Kind : std::uint8_t {
        None,     ///< not traced
        Itself,   ///< hit the segment it started from
        Missed,   ///< left the picture: sees the environment
        Distant,  ///< left towards a distant pixel
        Known,    ///< hit a surface whose colour in the photo is true for every viewer
        Guessed,  ///< hit a back side, a glossy segment or an outline
    };
    Kind kind = None;
    Vector3f direction{0, 0, 0};
    Vector3f color{0, 0, 0};  ///< of what was hit
};

struct Tracer {
    const Scene& scene;
    const Surface& front;
    const Surface& back;
    const std::vector<bool>& glossy;  ///< by label

    [[nodiscard]] Ending trace(const DepthLayers& layers, const Vector3f& origin, const Vector3f& direction,
                               std::uint16_t label) const {
        const auto hit = march(layers, origin, direction);
        if (!hit) {
            if (const auto color = distantColor(*scene.photo, front.depth, direction))
                return {Ending::Distant, direction, *color};
            return {Ending::Missed, direction, Vector3f::Zero()};
        }
        const LabelImage& labels = scene.photo->labels;
        const std::uint16_t hitLabel = labels(hit->x, hit->y);
        if (hitLabel == label) return {Ending::Itself, direction, Vector3f::Zero()};
        if (hit->back) return {Ending::Guessed, direction, back.color(hit->x, hit->y)};
        const bool known = !glossy[hitLabel] && isInterior(labels, front.depth, hit->x, hit->y);
        return {known ? Ending::Known : Ending::Guessed, direction, front.color(hit->x, hit->y)};
    }
};

/// Direction i of `count`, uniform on the sphere (spherical Fibonacci points).
Vector3f fibonacciDirection(int i, int count) {
    const double y = 1 - (2.0 * i + 1) / count;
    const double phi = 2 * std::numbers::pi * std::fmod(i * (std::numbers::phi - 1), 1.0);
    const double radius = std::sqrt(1 - y * y);
    return {static_cast<float>(radius * std::cos(phi)), static_cast<float>(y),
            static_cast<float>(radius * std::sin(phi))};
}

/// Ratio of means over the texels that both maps cover, without the extreme tenths.
struct CommonRatio {
    Vector3f rho{1, 1, 1};
    float solidAngle = 0;  ///< of all common texels
};

CommonRatio commonRatio(const DirectionalMap& reflected, const DirectionalMap& incident) {
    struct Texel {
        float ratio, solidAngle;
        std::size_t index;
    };
    std::vector<Texel> texels;
    CommonRatio result;
    const int width = reflected.radiance.width();
    const int height = reflected.radiance.height();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t i = reflected.radiance.index(x, y);
            if (reflected.coverage[i] <= 0 || incident.coverage[i] <= 0) continue;
            const float below = luminance(incident.radiance[i]);
            if (!(below > 0)) continue;
            const float solidAngle = DirectionalMap::texelSolidAngle(y, width, height);
            texels.push_back({luminance(reflected.radiance[i]) / below, solidAngle, i});
            result.solidAngle += solidAngle;
        }
    }
    std::ranges::sort(texels, [](const Texel& a, const Texel& b) {
        return a.ratio != b.ratio ? a.ratio < b.ratio : a.index < b.index;
    });
    Eigen::Vector3d above = Eigen::Vector3d::Zero();
    Eigen::Vector3d below = Eigen::Vector3d::Zero();
    const std::size_t trim = texels.size() / 10;
    for (std::size_t k = trim; k + trim < texels.size(); ++k) {
        above += (texels[k].solidAngle * reflected.radiance[texels[k].index]).cast<double>();
        below += (texels[k].solidAngle * incident.radiance[texels[k].index]).cast<double>();
    }
    for (int c = 0; c < 3; ++c)
        if (below[c] > 0) result.rho[c] = static_cast<float>(above[c] / below[c]);
    return result;
}

Vector3f meanColor(const ImageRgb& color) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Vector3f& c : color.pixels()) sum += c.cast<double>();
    return (sum / static_cast<double>(std::max<std::size_t>(1, color.size()))).cast<float>();
}

}  // namespace

bool isInterior(const LabelImage& labels, const ImageF& depth, int x, int y) {
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (labels.contains(x + dx, y + dy) &&
                (labels(x + dx, y + dy) != labels(x, y) || depth(x + dx, y + dy) <= 0))
                return false;
    return true;
}

std::optional<Vector3f> distantColor(const Photo& photo, const ImageF& depth, const Vector3f& d) {
    if (d.z() <= 1e-4f) return std::nullopt;
    const Vector2f uv = photo.camera.project(d);
    if (!(uv.x() >= 0 && uv.y() >= 0 && uv.x() < static_cast<float>(depth.width()) &&
          uv.y() < static_cast<float>(depth.height())))
        return std::nullopt;
    const int x = static_cast<int>(uv.x());
    const int y = static_cast<int>(uv.y());
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (depth.contains(x + dx, y + dy) && depth(x + dx, y + dy) > 0) return std::nullopt;
    return photo.color(x, y);
}

SegmentReflections estimateReflectance(const Scene& scene, const Surface& front, const Surface& back,
                                       const DepthLayers& layers, std::uint16_t label, const StepContext& context,
                                       float from, float to) {
    const Photo& photo = *scene.photo;
    const Camera& camera = photo.camera;
    const int mapHeight = std::clamp(scene.environment.height, 4, 2048);
    const int width = front.depth.width();
    const int height = front.depth.height();
    const auto part = [&](float fraction) { return from + fraction * (to - from); };
    std::vector<bool> glossy(65536, false);
    for (const Segment& segment : scene.segments) glossy[segment.label] = segment.glossy;
    const Tracer tracer{scene, front, back, glossy};

    // Outlines mix two objects; a segment that is nothing but outline is used whole.
    std::vector<std::array<int, 2>> pixels;
    std::vector<std::array<int, 2>> interior;
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (photo.labels(x, y) != label || front.depth(x, y) <= 0) continue;
            pixels.push_back({x, y});
            center += 0.5 * (front.position(x, y) + back.position(x, y)).cast<double>();
            if (isInterior(photo.labels, front.depth, x, y)) interior.push_back({x, y});
        }
    }
    SegmentReflections result{{}, DirectionalAccumulator(mapHeight)};
    Reflectance& estimate = result.estimate;
    estimate.label = label;
    DirectionalAccumulator reflected(mapHeight);
    DirectionalAccumulator incident(mapHeight);
    DirectionalAccumulator guessedIncident(mapHeight);
    DirectionalAccumulator pairReflected(mapHeight);
    DirectionalAccumulator pairIncident(mapHeight);

    if (!pixels.empty()) {
        center /= static_cast<double>(pixels.size());
        const auto& used = interior.empty() ? pixels : interior;
        constexpr int kChunk = 512;
        std::vector<Ending> endings(used.size());
        const auto chunks = [](std::size_t count) { return static_cast<int>((count + kChunk - 1) / kChunk); };
        parallelFor(
            context, kName, chunks(used.size()),
            [&](int chunk) {
                const std::size_t begin = static_cast<std::size_t>(chunk) * kChunk;
                for (std::size_t i = begin; i < std::min(used.size(), begin + kChunk); ++i) {
                    const auto [x, y] = used[i];
                    const Vector3f& p = front.position(x, y);
                    const Vector3f& n = front.normal(x, y);
                    const Vector3f view = p.normalized();
                    const float cosine = -view.dot(n);
                    if (cosine < kMinCosine) continue;
                    const Vector3f mirrored = (view + 2 * cosine * n).normalized();
                    endings[i] = tracer.trace(layers, p + marchBias(camera, p.z()) * n, mirrored, label);
                }
            },
            part(0), part(0.5f));
        for (std::size_t i = 0; i < used.size(); ++i) {
            const Ending& ending = endings[i];
            if (ending.kind == Ending::None || ending.kind == Ending::Itself) continue;
            const Vector3f& color = front.color(used[i][0], used[i][1]);
            reflected.add(ending.direction, color);
            if (ending.kind == Ending::Missed || ending.kind == Ending::Distant)
                result.missed.add(ending.direction, color);
            if (ending.kind == Ending::Known || ending.kind == Ending::Distant) {
                pairReflected.add(ending.direction, color);
                pairIncident.add(ending.direction, ending.color);
            }
        }

        // What arrives at the centre, with the segment itself taken away.
        DepthLayers others = layers;
        for (const auto& [x, y] : pixels) others.front(x, y) = {};
        std::vector<Ending> rays(kIncidentRays);
        const Vector3f origin = center.cast<float>();
        parallelFor(
            context, kName, kIncidentRays / kChunk,
            [&](int chunk) {
                for (int i = chunk * kChunk; i < (chunk + 1) * kChunk; ++i)
                    rays[static_cast<std::size_t>(i)] =
                        tracer.trace(others, origin, fibonacciDirection(i, kIncidentRays), label);
            },
            part(0.5f), part(0.7f));
        for (const Ending& ray : rays) {
            if (ray.kind == Ending::Known || ray.kind == Ending::Distant) incident.add(ray.direction, ray.color);
            if (ray.kind == Ending::Guessed) guessedIncident.add(ray.direction, ray.color);
        }
    }

    estimate.reflected = reflected.map();
    estimate.incident = incident.map();
    const CommonRatio pairs = commonRatio(pairReflected.map(), pairIncident.map());
    const CommonRatio maps = commonRatio(estimate.reflected, estimate.incident);

    // Guesses fill the gaps between what is known, but do not count as known.
    const DirectionalMap guesses = guessedIncident.map();
    DirectionalMap filled = estimate.incident;
    for (std::size_t i = 0; i < filled.radiance.size(); ++i) {
        if (filled.coverage[i] > 0 || guesses.coverage[i] <= 0) continue;
        filled.radiance[i] = guesses.radiance[i];
        filled.coverage[i] = guesses.coverage[i];
    }
    const Vector3f fallback = meanColor(photo.color);
    fillDirections(filled, fallback, kName, context, part(0.7f), part(0.85f));
    estimate.incident.radiance = std::move(filled.radiance);
    fillDirections(estimate.reflected, fallback, kName, context, part(0.85f), part(1));

    const CommonRatio& better = pairs.solidAngle >= kMinCommonSolidAngle ? pairs : maps;
    estimate.commonSolidAngle = better.solidAngle;
    estimate.reliable = better.solidAngle >= kMinCommonSolidAngle;
    if (estimate.reliable) {
        estimate.rho = better.rho;
    } else {
        const Vector3f below = estimate.incident.mean();
        const Vector3f above = estimate.reflected.mean();
        for (int c = 0; c < 3; ++c) estimate.rho[c] = below[c] > 0 ? above[c] / below[c] : 1.0f;
    }
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(estimate.rho[c])) estimate.rho[c] = 1;
        estimate.rho[c] = std::clamp(estimate.rho[c], kMinRho, 1.0f);
    }
    return result;
}

Step reflectanceStep() {
    Step step;
    step.name = kName;
    step.reads = {Item::Photo, Item::Front, Item::Back, Item::Layers};
    step.writes = Item::Reflectances;
    step.params = [](const Scene& scene, Hash& hash) {
        hash.add(scene.environment.height);
        for (const Segment& segment : scene.segments) {
            if (!segment.glossy) continue;
            hash.add(segment.label).add(segment.reflectance.has_value());
            if (segment.reflectance) hash.add(*segment.reflectance);
        }
    };
    step.run = [](Board& board, const StepContext& context) {
        const Scene& scene = *board.scene;
        std::vector<const Segment*> glossy;
        for (const Segment& segment : scene.segments)
            if (segment.glossy) glossy.push_back(&segment);
        // Which surfaces are glossy decides what counts as known for all of them.
        Hash hash;
        hash.add(board.layersKey).add(scene.environment.height);
        for (const Segment* segment : glossy) hash.add(segment->label);

        std::vector<std::shared_ptr<const Reflectance>> results;
        std::vector<std::shared_ptr<const SegmentReflections>> reflections;
        for (std::size_t i = 0; i < glossy.size(); ++i) {
            const std::uint16_t label = glossy[i]->label;
            CachedReflectance& cached = board.reflectanceCache[label];
            if (!cached.reflections || cached.key != hash.value()) {
                const auto count = static_cast<float>(glossy.size());
                cached.reflections = std::make_shared<SegmentReflections>(
                    estimateReflectance(scene, *board.front, board.back->surface, *board.layers, label, context,
                                        static_cast<float>(i) / count, static_cast<float>(i + 1) / count));
                cached.key = hash.value();
            }
            auto result = std::make_shared<Reflectance>(cached.reflections->estimate);
            if (glossy[i]->reflectance) result->rho = *glossy[i]->reflectance;
            results.push_back(std::move(result));
            reflections.push_back(cached.reflections);
        }
        std::erase_if(board.reflectanceCache, [&](const auto& entry) {
            return std::ranges::none_of(glossy, [&](const Segment* s) { return s->label == entry.first; });
        });
        board.reflectances = std::move(results);
        board.reflections = std::move(reflections);
    };
    return step;
}

}  // namespace core::steps
