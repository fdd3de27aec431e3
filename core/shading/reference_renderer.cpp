// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shading/reference_renderer.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/color.h"
#include "core/base/kernel_types.h"
#include "core/base/parallel.h"
#include "core/material/brdf_file.h"
#include "core/material/diffusion_profile.h"
#include "core/shading/diffusion_grid.h"
#include "core/shading/segment_shading.h"
#include "core/shading/silhouette.h"
#include "shaders/shared/diffusion.h"
#include "shaders/shared/rng.h"
#include "shaders/shared/shading_point.h"

namespace core {

/// A surface point on a path.
struct ReferenceRenderer::Vertex {
    kernel::vec3 p;  ///< [m]
    kernel::vec3 n;  ///< shading normal, n·wo > 0
    kernel::vec3 wo;
    kernel::SegmentShading shading;
    kernel::uint role;  ///< shaders/shared/path.h
    float eta = 1;      ///< of the boundary, for kPathEnter
};

/// Where a path's random numbers come from.
struct ReferenceRenderer::Path {
    std::uint32_t pixel, sample, seed;
};

ReferenceRenderer::ReferenceRenderer(const Scene& scene, std::shared_ptr<const Analysis> analysis,
                                     LightSampling lightSampling)
    : scene_(visibleScene(scene)),
      analysis_(std::move(analysis)),
      layers_(analysis_->layers ? analysis_->layers
                                : std::make_shared<DepthLayers>(buildDepthLayers(
                                      scene.photo->camera, scene.photo->labels, *analysis_->front, *analysis_->back))),
      shading_(buildSegmentShading(scene_, *analysis_)),
      drives_(buildDrives(scene_, *analysis_, shading_)),
      driveValues_(drives_.values()) {
    for (const Segment& segment : scene_.segments)
        if (segment.edit && segment.edit->brdfFile && segment.edit->brdfFile->user)
            throw Error(ErrorKind::Usage,
                        "\"" + segment.edit->brdfFile->path + "\" is GLSL, which only a graphics device can run.");
    if (lightSampling == LightSampling::Both && analysis_->environment)
        sampler_ = EnvironmentSampler(*analysis_->environment);
}

const kernel::SegmentShading& ReferenceRenderer::shadingOf(std::uint16_t label) const {
    return shading_[label < shading_.size() ? label : 0];
}

kernel::vec3 ReferenceRenderer::driven(kernel::uint drive, int x, int y) const {
    const kernel::Drive& d = drives_.drives[drive];
    return kernel::drive_value(
        d, driveValues_[kernel::drive_index(d, static_cast<kernel::uint>(x), static_cast<kernel::uint>(y))]);
}

kernel::SegmentShading ReferenceRenderer::shadingAt(int x, int y) const {
    kernel::SegmentShading shading = shadingOf(layers_->labels(x, y));
    for (kernel::uint i = 0; i < shading.drives.y; ++i) {
        const kernel::uint drive = shading.drives.x + i;
        shading = kernel::drive_apply(shading, drives_.drives[drive].slot, driven(drive, x, y));
    }
    return shading;
}

float ReferenceRenderer::weightAt(float weight, kernel::uint slot, int x, int y) const {
    const kernel::uvec4 range = shadingOf(layers_->labels(x, y)).drives;
    for (kernel::uint i = range.z; i < range.z + range.w; ++i)
        if (drives_.drives[i].slot == slot) weight = driven(i, x, y).x;
    return weight;
}

Vector3f ReferenceRenderer::environment(kernel::vec3 direction) const {
    if (!analysis_->environment) return Vector3f::Zero();
    return analysis_->environment->lookup(fromKernel(direction));
}

kernel::vec3 ReferenceRenderer::leave(const Vertex& vertex, const Path& path, std::uint32_t b,
                                      kernel::vec3& direction) const {
    const kernel::SegmentShading& shading = vertex.shading;
    const kernel::vec3 wo = kernel::to_local(vertex.n, vertex.wo);
    const kernel::vec2 u = b == 0 ? kernel::rng_lattice(path.pixel, path.sample, 0, path.seed)
                                  : kernel::rng_vec2(path.pixel, path.sample, 2 * b, path.seed);
    kernel::vec3 weight;
    const kernel::vec3 wi = kernel::path_scatter(shading, vertex.role, vertex.eta, wo, u, weight);
    direction = kernel::normalize(kernel::from_local(vertex.n, wi));
    if (sampler_.empty()) return weight;

    const kernel::vec3 w = kernel::rng_light(path.pixel, path.sample, b, path.seed);
    const EnvironmentSampler::Sample found = sampler_.sample(w.x, w.y);
    const kernel::vec3 towards = kernel::to_local(vertex.n, toKernel(found.direction));
    const auto expected = [&](kernel::vec3 d) { return luminance(environment(d)) + sampler_.meanLuminance(); };
    kernel::PathCandidate own{.weight = weight,
                              .pdf = wi.z > 0 ? kernel::path_pdf(shading, vertex.role, wo, wi) : 0,
                              .otherPdf = sampler_.pdf(fromKernel(direction)),
                              .expectedLight = expected(direction)};
    kernel::PathCandidate bright{
        .weight = {}, .pdf = 0, .otherPdf = 0, .expectedLight = expected(toKernel(found.direction))};
    if (towards.z > 0 && found.pdf > 0) {
        bright.weight = kernel::path_value(shading, vertex.role, vertex.eta, wo, towards) / found.pdf;
        bright.pdf = found.pdf;
        bright.otherPdf = kernel::path_pdf(shading, vertex.role, wo, towards);
    }
    kernel::uint chosen = 0;
    weight = kernel::path_choose(own, bright, w.z, chosen);
    if (chosen == 1) direction = toKernel(found.direction);
    return weight;
}

Eigen::Vector2i ReferenceRenderer::shownPixel(const MarchHit& hit, kernel::vec3 p, kernel::vec2 u) const {
    const Camera& camera = layers_->camera;
    const auto along = [](float position, float chance, int own, int size) {
        const int q = static_cast<int>(std::floor(position + chance - 0.5f));
        return std::clamp(q, std::max(own - 1, 0), std::min(own + 1, size - 1));
    };
    const int x = along(camera.fx * p.x / p.z + camera.cx, u.x, hit.x, camera.width);
    const int y = along(camera.fy * p.y / p.z + camera.cy, u.y, hit.y, camera.height);
    const Image<DepthLayers::Patch>& patches = hit.back ? layers_->back : layers_->front;
    const auto patch = [&](int px, int py) {
        const DepthLayers::Patch& at = patches(px, py);
        return kernel::vec3(at.w, at.gu, at.gv);
    };
    const kernel::vec2 away(static_cast<float>(x - hit.x), static_cast<float>(y - hit.y));
    const bool same = layers_->labels(x, y) == layers_->labels(hit.x, hit.y);
    return same && kernel::surface_goes_on(patch(hit.x, hit.y), patch(x, y), away) ? Eigen::Vector2i(x, y)
                                                                                   : Eigen::Vector2i(hit.x, hit.y);
}

Vector3f ReferenceRenderer::follow(Vertex vertex, const Path& path) const {
    kernel::vec3 radiance(0.0f);
    kernel::vec3 throughput(1.0f);
    const auto bounces = static_cast<std::uint32_t>(std::max(scene_.render.bounces, 1));
    for (std::uint32_t b = 0; b < bounces; ++b) {
        kernel::vec3 direction;
        throughput *= leave(vertex, path, b, direction);
        if (kernel::max(throughput.x, kernel::max(throughput.y, throughput.z)) == 0) break;
        const kernel::vec3 origin = vertex.p + vertex.n * marchBias(layers_->camera, vertex.p.z);
        const std::optional<MarchHit> hit = march(*layers_, fromKernel(origin), fromKernel(direction));
        if (!hit) {
            radiance += throughput * toKernel(environment(direction));
            break;
        }
        vertex.p = origin + direction * hit->distance;
        const Eigen::Vector2i shown =
            shownPixel(*hit, vertex.p, kernel::rng_hit(path.pixel, path.sample, b, path.seed));
        const Surface& layer = hit->back ? *analysis_->back : *analysis_->front;
        const kernel::vec3 color = toKernel(layer.color(shown.x(), shown.y()));
        const kernel::vec3 normal = toKernel(layer.normal(shown.x(), shown.y()));
        const kernel::SegmentShading shading = shadingAt(shown.x(), shown.y());
        if (shading.blend.w == 0 || b + 1 == bounces || kernel::dot(normal, normal) == 0) {
            radiance += throughput * color;
            break;
        }
        radiance += throughput * color * shading.blend.y;
        throughput *= shading.blend.x;
        vertex.wo = -direction;
        vertex.n = kernel::shading_normal(normal, vertex.wo);
        vertex.shading = shading;
        vertex.role = kernel::kPathLater;
    }
    return fromKernel(radiance);
}

Vector3f ReferenceRenderer::pathRadiance(int x, int y, std::uint32_t sample) const {
    const kernel::SegmentShading shading = shadingAt(x, y);
    const Surface& front = *analysis_->front;
    if (shading.diffuse.w == 0 || !(front.depth(x, y) > 0)) return Vector3f::Zero();
    const Path path{static_cast<std::uint32_t>(front.depth.index(x, y)), sample, scene_.render.seed};
    const kernel::vec2 offset = kernel::rng_pixel(path.pixel, sample, path.seed) - kernel::vec2(0.5f);
    const Camera& camera = layers_->camera;
    const float u = static_cast<float>(x) + 0.5f + offset.x;
    const float v = static_cast<float>(y) + 0.5f + offset.y;
    Vertex vertex;
    vertex.p = toKernel(camera.ray(u, v) / layers_->front(x, y).at(offset.x, offset.y));
    vertex.wo = kernel::normalize(-vertex.p);
    vertex.n = kernel::shading_normal(normalAt(x, y, offset), vertex.wo);
    vertex.shading = shading;
    vertex.role = kernel::kPathPrimary;
    return follow(vertex, path);
}

kernel::vec3 ReferenceRenderer::normalAt(int x, int y, kernel::vec2 offset) const {
    const auto patch = [&](int px, int py) {
        const DepthLayers::Patch& p = layers_->front(px, py);
        return kernel::vec4(p.w, p.gu, p.gv, layers_->labels(px, py));
    };
    const Image<Vector3f>& normals = analysis_->front->normal;
    const kernel::vec3 own = toKernel(normals(x, y));
    const float fx = std::abs(offset.x);
    const float fy = std::abs(offset.y);
    kernel::vec3 sum = own * ((1 - fx) * (1 - fy));
    for (const auto& [sx, sy] : {std::pair{1, 0}, {0, 1}, {1, 1}}) {
        const int qx = std::clamp(x + (offset.x < 0 ? -sx : sx), 0, layers_->camera.width - 1);
        const int qy = std::clamp(y + (offset.y < 0 ? -sy : sy), 0, layers_->camera.height - 1);
        const kernel::vec3 n =
            kernel::continued_normal(patch(x, y), own, patch(qx, qy), toKernel(normals(qx, qy)),
                                     kernel::vec2(static_cast<float>(qx - x), static_cast<float>(qy - y)));
        sum += n * ((sx != 0 ? fx : 1 - fx) * (sy != 0 ? fy : 1 - fy));
    }
    return sum;
}

Accumulation ReferenceRenderer::reshade(int samples, std::uint32_t first, const Progress& progress) const {
    const int width = layers_->camera.width;
    const int height = layers_->camera.height;
    Accumulation result{.sum = ImageRgb(width, height, Vector3f::Zero()),
                        .sumSquaredLuminance = ImageF(width, height),
                        .samples = samples};
    std::atomic<std::uint64_t> dropped{0};
    parallelFor(progress, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            if (shadingOf(layers_->labels(x, y)).diffuse.w == 0) continue;
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            double squared = 0;
            for (int s = 0; s < samples; ++s) {
                const Vector3f value = pathRadiance(x, y, first + static_cast<std::uint32_t>(s));
                if (!kernel::path_valid(toKernel(value))) {
                    ++dropped;
                    continue;
                }
                const auto l = static_cast<double>(kernel::luminance(toKernel(value)));
                sum += value.cast<double>();
                squared += l * l;
            }
            result.sum(x, y) = sum.cast<float>();
            result.sumSquaredLuminance(x, y) = static_cast<float>(squared);
        }
    });
    result.dropped = dropped;
    return result;
}

std::vector<Vector3f> ReferenceRenderer::irradiance(const SurfaceSamples& samples, std::uint16_t label, float eta,
                                                    int rays, const Progress& progress) const {
    const std::uint32_t seed = kernel::rng_stream(scene_.render.seed, 2u * label + 1u);
    std::vector<Vector3f> result(samples.samples.size(), Vector3f::Zero());
    parallelFor(progress, static_cast<int>(result.size()), [&](int i) {
        const SurfaceSample& sample = samples.samples[static_cast<std::size_t>(i)];
        const auto id = static_cast<std::uint32_t>(i);
        Vertex vertex;
        vertex.p = toKernel(sample.position);
        vertex.n = toKernel(sample.normal);
        vertex.wo = vertex.n;
        vertex.shading = shadingOf(label);
        vertex.role = kernel::kPathEnter;
        vertex.eta = eta;
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (int j = 0; j < rays; ++j) {
            const Vector3f value = follow(vertex, {id, static_cast<std::uint32_t>(j), seed});
            if (kernel::path_valid(toKernel(value))) sum += value.cast<double>();
        }
        if (rays > 0) result[static_cast<std::size_t>(i)] = (sum * (std::numbers::pi / rays)).cast<float>();
    });
    return result;
}

ImageRgb ReferenceRenderer::translucentRadiosity(const SurfaceSamples& samples, const std::vector<Vector3f>& irradiance,
                                                 std::uint16_t label, const DiffusionProfile& profile,
                                                 const Progress& progress) const {
    CORE_ASSERT(samples.samples.size() == irradiance.size(), "one irradiance per surface sample");
    const Surface& front = *analysis_->front;
    ImageRgb result(layers_->camera.width, layers_->camera.height, Vector3f::Zero());
    if (samples.samples.empty()) return result;
    const std::vector<float> areas = sampleAreas(samples, samples.samples.size());
    const FlatSurface flat = flatSurface(profile);
    parallelFor(progress, result.height(), [&](int y) {
        for (int x = 0; x < result.width(); ++x) {
            if (layers_->labels(x, y) != label || !(front.depth(x, y) > 0)) continue;
            const Vector3f p = front.position(x, y);
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            Eigen::Vector3d whole = Eigen::Vector3d::Zero();  // the sum if all samples had an irradiance of 1
            for (std::size_t i = 0; i < irradiance.size(); ++i) {
                const double r2 = (p - samples.samples[i].position).cast<double>().squaredNorm();
                for (int c = 0; c < 3; ++c) {
                    const double weight = profile.evaluate(c, r2) * static_cast<double>(areas[i]);
                    sum[c] += weight * static_cast<double>(irradiance[i][c]);
                    whole[c] += weight;
                }
            }
            result(x, y) = flat.exitance(sum / std::numbers::pi, whole);
        }
    });
    return result;
}

ImageRgb ReferenceRenderer::translucency(const Progress& progress) const {
    const Surface& front = *analysis_->front;
    ImageRgb result(layers_->camera.width, layers_->camera.height, Vector3f::Zero());
    for (const Segment& segment : scene_.segments) {
        if (!segment.edit || !usable(*segment.edit) || !segment.edit->translucency) continue;
        const DiffusionProfile profile = profileFromTranslucency(*segment.edit->translucency);
        const SurfaceSamples samples =
            sampleSurface(*analysis_, layers_->labels, segment.label, scene_.render.surfaceSamples, scene_.render.seed);
        const std::vector<Vector3f> light =
            irradiance(samples, segment.label, profile.eta, scene_.render.irradianceSamples, progress);
        const ImageRgb radiosity =
            translucentRadiosity(samples, light, segment.label, blurred(profile, samples.areaPerSample()), progress);
        for (std::size_t i = 0; i < result.size(); ++i) {
            if (layers_->labels[i] != segment.label || !(front.depth[i] > 0)) continue;
            const kernel::vec3 wo = kernel::normalize(-toKernel(front.position[i]));
            const kernel::vec3 n = kernel::shading_normal(toKernel(front.normal[i]), wo);
            result[i] = radiosity[i] * kernel::fresnel_transmission(profile.eta, std::max(kernel::dot(n, wo), 0.0f));
        }
    }
    return result;
}

ImageRgb ReferenceRenderer::composite(const ImageRgb& reshaded, const ImageRgb& translucent) const {
    ImageRgb result = scene_.photo->color;
    for (const Segment& segment : scene_.segments) {
        if (!segment.edit || shadingOf(segment.label).diffuse.w == 0) continue;
        const Material& material = *segment.edit;
        const float weight = material.translucency ? material.translucency->weight : 0;
        for (int y = 0; y < result.height(); ++y)
            for (int x = 0; x < result.width(); ++x) {
                if (layers_->labels(x, y) != segment.label || !(analysis_->front->depth(x, y) > 0)) continue;
                Vector3f fresh = reshaded(x, y);
                if (material.translucency)
                    fresh += weightAt(weight, kernel::kDriveTranslucentWeight, x, y) * translucent(x, y);
                result(x, y) = weightAt(material.blendNew, kernel::kDriveBlendNew, x, y) * fresh +
                               weightAt(material.blendOriginal, kernel::kDriveBlendOriginal, x, y) * result(x, y);
            }
    }
    const std::vector<std::uint8_t> edited = editedLabels(shading_);
    for (const Segment& segment : scene_.segments) {
        if (!segment.edit || !usable(*segment.edit)) continue;
        for (const SilhouettePixel& p : findSilhouette(scene_.photo->color, layers_->labels, analysis_->front->depth,
                                                       segment.label, edited, coverageFrom(segment.glossy)))
            result(p.x, p.y) =
                p.coverage * result(p.sourceX, p.sourceY) + p.kept +
                weightAt(segment.edit->blendOriginal, kernel::kDriveBlendOriginal, p.sourceX, p.sourceY) *
                    p.keptOriginal;
    }
    return result;
}

ImageRgb renderReference(const Scene& scene, const std::shared_ptr<const Analysis>& analysis,
                         const Progress& progress) {
    const ReferenceRenderer renderer(scene, analysis);
    const Accumulation sums = renderer.reshade(scene.render.samples, 0, progress);
    const std::vector<std::uint8_t> edited = editedLabels(renderer.shading());
    const ImageRgb reshaded = scene.render.filter ? filterReshaded(sums, scene.photo->camera, *analysis->front,
                                                                   scene.photo->labels, edited, {}, progress)
                                                  : meanRadiance(sums);
    return renderer.composite(reshaded, renderer.translucency(progress));
}

}  // namespace core
