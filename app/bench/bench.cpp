// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/bench.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <mutex>
#include <numbers>
#include <random>

#include "app/bench/bench_embree.h"
#include "app/bench/bench_select.h"
#include "app/bench/bench_translucency.h"
#include "core/analysis/pipeline.h"
#include "core/base/clock.h"
#include "core/base/color.h"
#include "core/base/parallel.h"
#include "core/geometry/depth_layers.h"
#include "core/material/brdf.h"
#include "core/shading/environment_sampler.h"
#include "core/shading/reference_renderer.h"
#include "gpu/pass_timer.h"
#include "render/analysis/gpu_analysis_kernels.h"
#include "render/analysis/march_rays.h"
#include "render/renderer.h"
#include "render/scene_geometry.h"
#include "shaders/shared/sampling.h"

namespace render {
namespace {

/// Device time per frame of the window that the renderer gets [s].
constexpr double kFrameSeconds = 0.03;

/// Time of [BRD14] for 5 rays through each pixel of its Dragon, 1024x1024 pixels, on a GTX 760 [s].
constexpr double kPaperSeconds = 0.045;

struct Benchmarks {
    gpu::Device device;
    const core::Scene& scene;
    std::shared_ptr<const core::Analysis> analysis;
    core::AnalysisKernels& kernels;  ///< chosen by the user
    core::Progress progress;
    std::vector<BenchResult> results;

    void add(const char* name, const std::string& metric, double value, const char* unit) {
        results.push_back({name, metric, value, unit});
    }
    void march();
    void reshade();
    void quality();
    void translucency();
    void analyse();
    /// Seconds per stage and "total".
    [[nodiscard]] std::map<std::string, double> analysisSeconds(core::AnalysisKernels& kernels) const;

    [[nodiscard]] core::DepthLayers layers() const {
        if (analysis->layers) return *analysis->layers;
        return core::buildDepthLayers(scene.photo->camera, scene.photo->labels, *analysis->front, *analysis->back);
    }
    [[nodiscard]] std::vector<Ray> cosineRays(std::size_t count) const;
    [[nodiscard]] core::Scene withEdit(const core::Material& material) const;
    /// Pixels of the segment that `withEdit` edits.
    [[nodiscard]] std::size_t editedPixels() const;
    [[nodiscard]] std::vector<std::size_t> chosenPixels(const core::Scene& edited, std::size_t count) const;
    [[nodiscard]] std::vector<double> manyPaths(const core::Scene& reference,
                                                const std::shared_ptr<const core::Analysis>& lit,
                                                const std::vector<std::size_t>& pixels, std::uint32_t paths) const;
    [[nodiscard]] core::ImageRgb rendered(Renderer& renderer, double seconds) const;
    [[nodiscard]] double renderSeconds(Renderer& renderer, bool firstPictureOnly, double budgetSeconds) const;
};

/// Cosine-weighted rays from random visible surface points, row by row: the rays of re-shading a matte picture, in its
/// order.
std::vector<Ray> Benchmarks::cosineRays(std::size_t count) const {
    const core::Surface& front = *analysis->front;
    std::vector<std::size_t> visible;
    for (std::size_t i = 0; i < front.depth.size(); ++i)
        if (front.depth[i] > 0 && front.normal[i].squaredNorm() > 0.5f) visible.push_back(i);
    if (visible.empty())
        throw core::Error(core::ErrorKind::Input, "There is no valid depth in the picture, so no ray can be marched.");
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<std::size_t> origins(count);
    for (std::size_t& origin : origins) origin = visible[random() % visible.size()];
    std::sort(origins.begin(), origins.end());
    std::vector<Ray> rays(count);
    for (std::size_t k = 0; k < count; ++k) {
        Ray& ray = rays[k];
        const std::size_t i = origins[k];
        const core::Vector3f& n = front.normal[i];
        const kernel::vec3 d = kernel::from_local({n.x(), n.y(), n.z()},
                                                  kernel::sample_cosine_hemisphere({uniform(random), uniform(random)}));
        ray.origin = front.position[i] + n * core::marchBias(scene.photo->camera, front.depth[i]);
        ray.direction = core::Vector3f(d.x, d.y, d.z).normalized();
    }
    return rays;
}

/// Best time of several builds [s].
double pyramidBuildSeconds(const gpu::Device& device, SceneGeometry& geometry) {
    double build = std::numeric_limits<double>::max();
    for (int i = 0; i < kTimedBuilds; ++i) {
        gpu::PassTimer timer(device);
        const gpu::CommandEncoder encoder = device.createCommandEncoder({.label = "build pyramid"});
        {
            const auto region = timer.measure(encoder, "build pyramid");
            geometry.recordPyramid(encoder);
        }
        device.waitIdle();
        const auto start = core::Clock::now();
        device.queue().submit(encoder.finish());
        device.waitIdle();
        double seconds = core::secondsSince(start);
        for (const auto& timing : timer.takeResults()) seconds = timing.seconds;
        build = std::min(build, seconds);
    }
    return build;
}

/// Share of `hits` that the oracle confirms.
double oracleAgreement(const core::DepthLayers& layers, const std::vector<Ray>& rays, const std::vector<RayHit>& hits,
                       const core::Progress& progress) {
    std::size_t agreed = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (i % 1024 == 0) progress.checkpoint(static_cast<float>(i) / static_cast<float>(rays.size()));
        const auto expected = core::march(layers, rays[i].origin, rays[i].direction);
        agreed += expected ? hits[i].found && hits[i].x == expected->x && hits[i].y == expected->y : !hits[i].found;
    }
    return static_cast<double>(agreed) / static_cast<double>(rays.size());
}

void Benchmarks::march() {
    constexpr std::size_t kRays = 1 << 18;
    constexpr std::size_t kSlowRays = 1 << 14;  // for methods that are slow on a processor
    const core::DepthLayers sceneLayers = layers();
    SceneGeometry geometry(device);
    geometry.setLayers(sceneLayers, scene.photo->color, *analysis->front, *analysis->back);
    geometry.setEnvironment(core::DirectionalMap());

    const double build = pyramidBuildSeconds(device, geometry);
    add("march", "build_seconds.pyramid", build, "s");

    RayMarcher marcher(device, geometry);
    const std::vector<Ray> rays = cosineRays(kRays);
    // Whole workgroups from all over the picture.
    constexpr std::size_t kGroup = 64;
    std::vector<Ray> fewRays;
    for (std::size_t i = 0; i < kRays; ++i)
        if (i / kGroup % (kRays / kSlowRays) == 0) fewRays.push_back(rays[i]);
    const auto rate = [&](const std::vector<Ray>& list, MarchMethod method, const ConstantStepParams& steps) {
        double best = std::numeric_limits<double>::max();
        for (int i = 0; i < kTimedMarches; ++i) {
            progress.checkpoint(static_cast<float>(i) / kTimedMarches);
            (void)marcher.march(list, method, steps);
            best = std::min(best, marcher.seconds());
        }
        return static_cast<double>(list.size()) / best;
    };
    // Steps of the minimum thickness of a segment, over the depth of the scene.
    float farthest = 0;
    for (const float z : analysis->front->depth.pixels()) farthest = std::max(farthest, z);
    const ConstantStepParams steps{.stepSize = core::BackSideParams().minThickness, .maxDistance = 2 * farthest};
    const double constantRate = rate(fewRays, MarchMethod::ConstantSteps, steps);
    const double pyramidRate = rate(rays, MarchMethod::Pyramid, steps);
    add("march", "rays_per_second.constant", constantRate, "1/s");
    add("march", "rays_per_second.pyramid", pyramidRate, "1/s");
    add("march", "ratio.pyramid_to_constant", pyramidRate / constantRate, "1");

    if (const auto embree = benchEmbree(*analysis->front, *analysis->back, scene.photo->labels, rays)) {
        add("march", "build_seconds.embree", embree->buildSeconds, "s");
        add("march", "rays_per_second.embree", embree->raysPerSecond, "1/s");
        add("march", "hit_share.embree", embree->hitShare, "1");
        add("march", "ratio.pyramid_to_embree", pyramidRate / embree->raysPerSecond, "1");
        const double editRays = 16.0 * static_cast<double>(editedPixels());
        add("march", "edit_rays", editRays, "1");
        add("march", "ratio.edit_to_embree",
            (embree->buildSeconds + editRays / embree->raysPerSecond) / (build + editRays / pyramidRate), "1");
    }

    const std::vector<RayHit> hits = marcher.march(fewRays, MarchMethod::Pyramid);
    const auto found = std::count_if(hits.begin(), hits.end(), [](const RayHit& hit) { return hit.found; });
    add("march", "hit_share.pyramid", static_cast<double>(found) / kSlowRays, "1");
    add("march", "oracle_agreement", oracleAgreement(sceneLayers, fewRays, hits, progress), "1");
}

/// The scene with only one segment edited: the first glossy one, otherwise the second largest (the largest is usually
/// what objects stand on).
core::Scene Benchmarks::withEdit(const core::Material& material) const {
    core::Scene edited = scene;
    std::map<std::uint16_t, std::size_t> sizes;
    for (const std::uint16_t label : scene.photo->labels.pixels())
        if (label != 0) ++sizes[label];
    std::vector<core::Segment*> candidates;
    for (core::Segment& segment : edited.segments) {
        segment.edit.reset();
        if (sizes.contains(segment.label)) candidates.push_back(&segment);
    }
    if (candidates.empty())
        throw core::Error(core::ErrorKind::Input, "The scene has no segment, so there is nothing to re-shade.");
    std::sort(candidates.begin(), candidates.end(), [&](const core::Segment* a, const core::Segment* b) {
        if (a->glossy != b->glossy) return a->glossy;
        return sizes[a->label] > sizes[b->label];
    });
    const std::size_t choice = candidates[0]->glossy || candidates.size() == 1 ? 0 : 1;
    candidates[choice]->edit = material;
    return edited;
}

std::size_t Benchmarks::editedPixels() const {
    const core::Scene edited = withEdit(core::defaultMaterial(*core::findBrdf("ggx")));
    const auto& labels = edited.photo->labels.pixels();
    return static_cast<std::size_t>(std::count_if(labels.begin(), labels.end(), [&](std::uint16_t label) {
        const core::Segment* segment = edited.findSegment(label);
        return segment != nullptr && segment->edit;
    }));
}

double Benchmarks::renderSeconds(Renderer& renderer, bool firstPictureOnly, double budgetSeconds) const {
    device.waitIdle();
    const auto start = core::Clock::now();
    bool worked = true;
    while (worked && !(firstPictureOnly && renderer.progress().samples >= 1)) {
        gpu::CommandEncoder encoder = device.createCommandEncoder({.label = "benchmark"});
        worked = renderer.record(encoder, budgetSeconds);
        device.queue().submit(encoder.finish());
        device.waitIdle();
        progress.checkpoint(renderer.progress().fraction);
    }
    return core::secondsSince(start);
}

void Benchmarks::reshade() {
    core::Material material = core::defaultMaterial(*core::findBrdf("ggx"));
    core::Scene edited = withEdit(material);
    edited.render.samples = 5;
    edited.render.filter = false;
    Renderer renderer(device);
    renderer.setScene(edited, analysis);
    (void)renderSeconds(renderer, false, 0.1);  // measures the cost of slices
    edited.render.seed += 1;
    renderer.setScene(edited, analysis);
    add("reshade", "seconds_per_5_rays", renderSeconds(renderer, false, 0.1), "s");
    add("reshade", "paper_seconds_per_5_rays", kPaperSeconds, "s");
    edited.render.seed += 1;
    edited.render.filter = true;
    renderer.setScene(edited, analysis);
    add("reshade", "first_picture_seconds", renderSeconds(renderer, true, kFrameSeconds), "s");
}

/// The picture of `renderer` after `seconds`.
core::ImageRgb Benchmarks::rendered(Renderer& renderer, double seconds) const {
    device.waitIdle();
    const auto start = core::Clock::now();
    bool worked = true;
    while (worked && core::secondsSince(start) < seconds) {
        gpu::CommandEncoder encoder = device.createCommandEncoder({.label = "benchmark"});
        worked = renderer.record(encoder, kFrameSeconds);
        device.queue().submit(encoder.finish());
        device.waitIdle();
        progress.checkpoint(renderer.progress().fraction);
    }
    return readResult(device, renderer);
}

/// The environment with a sun of 2 degrees behind the camera, high and to the left, as bright as everything else.
std::shared_ptr<const core::DirectionalMap> withSun(const core::DirectionalMap& environment) {
    auto map = std::make_shared<core::DirectionalMap>(environment);
    const int width = map->radiance.width();
    const int height = map->radiance.height();
    const core::Vector3f towards = core::Vector3f(-0.5f, -0.7f, -0.5f).normalized();
    std::vector<std::size_t> texels;
    float solidAngle = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const core::Vector2f center(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            if (core::DirectionalMap::directionFromTexel(center, width, height).dot(towards) < std::cos(0.0175f))
                continue;
            texels.push_back(map->radiance.index(x, y));
            solidAngle += core::DirectionalMap::texelSolidAngle(y, width, height);
        }
    const core::Vector3f total = map->mean() * (4 * std::numbers::pi_v<float>);
    for (const std::size_t i : texels) map->radiance[i] += total / solidAngle;
    return map;
}

/// Pixels of the edited segment, evenly chosen and away from its outline, where pixels are mixed.
std::vector<std::size_t> Benchmarks::chosenPixels(const core::Scene& edited, std::size_t count) const {
    constexpr int kFromOutline = 3;  // [px]
    const core::LabelImage& labels = scene.photo->labels;
    std::vector<std::size_t> pixels;
    for (int y = kFromOutline; y + kFromOutline < labels.height(); ++y)
        for (int x = kFromOutline; x + kFromOutline < labels.width(); ++x) {
            const core::Segment* segment = edited.findSegment(labels(x, y));
            if (segment == nullptr || !segment->edit) continue;
            bool inside = true;
            for (int v = y - kFromOutline; v <= y + kFromOutline; ++v)
                for (int u = x - kFromOutline; u <= x + kFromOutline; ++u)
                    inside = inside && labels(u, v) == labels(x, y) && analysis->front->depth(u, v) > 0;
            if (inside) pixels.push_back(labels.index(x, y));
        }
    if (pixels.empty())
        throw core::Error(core::ErrorKind::Input, "The segment is too thin: no pixel of it is away from its outline.");
    std::mt19937 random(1);
    std::shuffle(pixels.begin(), pixels.end(), random);
    pixels.resize(std::min(pixels.size(), count));
    return pixels;
}

/// Mean luminance of many paths through each of `pixels`, by the CPU twin.
std::vector<double> Benchmarks::manyPaths(const core::Scene& reference,
                                          const std::shared_ptr<const core::Analysis>& lit,
                                          const std::vector<std::size_t>& pixels, std::uint32_t paths) const {
    const core::ReferenceRenderer renderer(reference, lit);
    const int width = scene.photo->labels.width();
    std::vector<double> means(pixels.size());
    core::parallelFor(progress, static_cast<int>(pixels.size()), [&](int k) {
        const auto i = static_cast<int>(pixels[static_cast<std::size_t>(k)]);
        double sum = 0;
        for (std::uint32_t s = 0; s < paths; ++s)
            sum += static_cast<double>(core::luminance(renderer.pathRadiance(i % width, i / width, s)));
        means[static_cast<std::size_t>(k)] = sum / paths;
    });
    return means;
}

void Benchmarks::quality() {
    constexpr std::uint32_t kTruePaths = 16384;
    constexpr std::size_t kPixels = 512;
    if (!analysis->environment || analysis->environment->empty())
        throw core::Error(core::ErrorKind::Input,
                          "There is no environment, so the quality of its sampling has no meaning.");
    core::Material material = core::defaultMaterial(*core::findBrdf("ggx"));
    material.values[0] = 0.35f;
    core::Scene edited = withEdit(material);
    const std::vector<std::size_t> pixels = chosenPixels(edited, kPixels);
    const std::pair<const char*, std::shared_ptr<const core::DirectionalMap>> lights[] = {
        {"photo", analysis->environment}, {"sun", withSun(*analysis->environment)}};
    for (const auto& [light, environment] : lights) {
        auto lit = std::make_shared<core::Analysis>(*analysis);
        lit->environment = environment;
        core::Scene reference = edited;
        reference.render.seed += 1000;
        const std::vector<double> truth = manyPaths(reference, lit, pixels, kTruePaths);
        const double mean = std::accumulate(truth.begin(), truth.end(), 0.0) / static_cast<double>(truth.size());
        struct Method {
            const char* name;
            core::LightSampling sampling;
            bool filter;
        };
        for (const auto& [method, sampling, filter] :
             {Method{"brdf", core::LightSampling::BrdfOnly, false}, Method{"both", core::LightSampling::Both, false},
              Method{"filtered", core::LightSampling::Both, true}}) {
            Renderer renderer(device, sampling);
            core::Scene timed = edited;
            timed.render.filter = filter;
            timed.render.samples = 1 << 20;
            renderer.setScene(timed, lit);
            (void)rendered(renderer, 1);  // measures the cost of slices
            for (const double seconds : {0.1, 0.3, 1.0, 3.0}) {
                timed.render.seed += 1;
                renderer.setScene(timed, lit);
                const core::ImageRgb image = rendered(renderer, seconds);
                double squares = 0;
                for (std::size_t k = 0; k < pixels.size(); ++k) {
                    const double error = static_cast<double>(core::luminance(image[pixels[k]])) - truth[k];
                    squares += error * error;
                }
                char name[64];
                std::snprintf(name, sizeof(name), "rms_error.%s.%s.%.1fs", light, method, seconds);
                add("quality", name, std::sqrt(squares / static_cast<double>(pixels.size())) / mean, "1");
                std::snprintf(name, sizeof(name), "samples.%s.%s.%.1fs", light, method, seconds);
                add("quality", name, renderer.progress().samples, "1");
            }
        }
    }
}

void Benchmarks::translucency() {
    core::Material material = core::defaultMaterial(*core::findBrdf("none"));
    material.translucency = core::Translucency();
    const std::vector<BenchResult> found = benchTranslucency(device, withEdit(material), analysis, progress);
    results.insert(results.end(), found.begin(), found.end());
}

std::map<std::string, double> Benchmarks::analysisSeconds(core::AnalysisKernels& twin) const {
    static const std::map<core::Task, std::string> kMetrics = {{core::Task::RecoverDepth, "filter"},
                                                               {core::Task::ComputeNormals, "geometry"},
                                                               {core::Task::InventBackSides, "backside"},
                                                               {core::Task::BuildDepthLayers, "geometry"},
                                                               {core::Task::EstimateReflectance, "reflectance"},
                                                               {core::Task::RecoverEnvironment, "environment"}};
    std::map<std::string, double> seconds;
    auto last = core::Clock::now();
    std::mutex mutex;  // reports come from any thread
    const core::Progress timed([&](core::Task task, float fraction) {
        const auto now = core::Clock::now();
        const std::lock_guard lock(mutex);
        // Steps report their begin and end; the time in between belongs to the reporting step.
        const auto metric = kMetrics.find(task);
        if (metric != kMetrics.end()) seconds[metric->second] += std::chrono::duration<double>(now - last).count();
        last = now;
        progress.checkpoint(fraction);
    });
    const auto start = core::Clock::now();
    core::AnalysisPipeline pipeline;
    (void)pipeline.run(scene, timed, twin);
    seconds["total"] = core::secondsSince(start);
    return seconds;
}

void Benchmarks::analyse() {
    const auto addAll = [&](const std::string& prefix, const std::map<std::string, double>& seconds) {
        for (const char* stage : {"filter", "geometry", "backside", "reflectance", "environment", "total"}) {
            const auto found = seconds.find(stage);
            add("analyse", prefix + stage, found == seconds.end() ? 0.0 : found->second, "s");
        }
    };
    const auto peakBytes = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return static_cast<double>(usage.ru_maxrss) * 1024;
    };
    const bool onDevice = &kernels != &core::cpuAnalysisKernels();
    const std::map<std::string, double> cpu = analysisSeconds(core::cpuAnalysisKernels());
    double peak = peakBytes();
    GpuAnalysisKernels deviceKernels(device);
    (void)analysisSeconds(deviceKernels);  // compiles the kernels
    const std::map<std::string, double> gpu = analysisSeconds(deviceKernels);
    if (onDevice) peak = peakBytes();
    addAll("seconds.", onDevice ? gpu : cpu);
    add("analyse", "peak_bytes", peak, "B");
    addAll("cpu_seconds.", cpu);
    // After a failure of the device its times would be those of the CPU.
    if (deviceKernels.takeNotes().empty()) addAll("gpu_seconds.", gpu);
}

}  // namespace

const std::vector<std::string>& benchmarkNames() {
    static const std::vector<std::string> names = {"march", "reshade", "quality", "translucency", "analyse", "select"};
    return names;
}

std::vector<BenchResult> runBenchmarks(const std::vector<std::string>& names, gpu::Device device,
                                       const core::Scene& scene, const std::shared_ptr<const core::Analysis>& analysis,
                                       core::AnalysisKernels& kernels, const core::Progress& progress) {
    for (const std::string& name : names) {
        if (std::find(benchmarkNames().begin(), benchmarkNames().end(), name) != benchmarkNames().end()) continue;
        std::string known;
        for (const std::string& n : benchmarkNames()) known.append(known.empty() ? "" : ", ").append(n);
        throw core::Error(core::ErrorKind::Usage,
                          "There is no benchmark \"" + name + "\". The benchmarks are: " + known + ".");
    }
    if (!scene.photo || !analysis)
        throw core::Error(core::ErrorKind::Input, "The benchmark needs an analysed photograph.");
    const auto wanted = [&](const char* name) {
        return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    };
    Benchmarks bench{std::move(device), scene, analysis, kernels, progress, {}};
    if (wanted("march")) bench.march();
    if (wanted("reshade")) bench.reshade();
    if (wanted("quality")) bench.quality();
    if (wanted("translucency")) bench.translucency();
    if (wanted("analyse")) bench.analyse();
    if (wanted("select"))
        for (BenchResult& result : benchSelection(*scene.photo, progress)) bench.results.push_back(std::move(result));
    return bench.results;
}

}  // namespace render
