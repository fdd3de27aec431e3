// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/bench_translucency.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <numbers>
#include <string>

#include "core/base/clock.h"
#include "core/base/parallel.h"
#include "core/shading/segment_shading.h"
#include "core/shading/surface_samples.h"
#include "gpu/readback.h"
#include "render/kernels/measured_tables.h"
#include "render/passes/diffusion_pass.h"
#include "render/passes/translucency_pass.h"
#include "render/renderer.h"
#include "render/scene_geometry.h"

namespace render {
namespace {

constexpr std::uint32_t kRays = 4;            // per surface sample
constexpr std::size_t kTestPairs = 60000000;  // summed one by one, for the error

/// Cost of a sum.
struct Times {
    double light = 0;  ///< samples' light into the grids [s]
    double sum = 0;    ///< from the grids to the pixels [s]
    double pairs = 0;  ///< products added for the latter: cells and pixels times the values they read
    double cells = 0;
};

/// One segment's translucency, recorded by the renderer's own passes without its slices.
struct Bench {
    gpu::Device device;
    const core::Scene& scene;
    const core::Analysis& analysis;
    const core::Progress& progress;
    core::Segment segment{};
    SceneGeometry geometry{device};
    TranslucencyPass irradiance{device, geometry.layout()};
    DiffusionPass diffusion{device, geometry.layout()};
    PathInputs paths{};
    Targets targets{};
    std::vector<kernel::SegmentShading> shading{};
    MeasuredTables measured{};

    // For one number of samples.
    core::SurfaceSamples samples{};
    std::vector<float> areas{};
    SurfacePoints points{};
    DiffusionGrids grids{};
    std::vector<std::uint32_t> pixels{};  // x | y << 16

    Bench(gpu::Device d, const core::Scene& s, const core::Analysis& a, const core::Progress& p);
    template <class Record>
    void submit(const Record& record) const;
    void prepare(int count);
    [[nodiscard]] core::DiffusionProfile profile() const;
    [[nodiscard]] Times sum();
    struct Error {
        double rms = 0;
        double max = 0;
    };
    /// `seconds`: time for all pixels.
    [[nodiscard]] Error compare(double* seconds = nullptr) const;
};

Bench::Bench(gpu::Device d, const core::Scene& s, const core::Analysis& a, const core::Progress& p)
    : device(std::move(d)), scene(s), analysis(a), progress(p) {
    segment = *std::ranges::find_if(scene.segments, [](const core::Segment& x) { return x.edit.has_value(); });
    const core::DepthLayers layers =
        core::buildDepthLayers(scene.photo->camera, scene.photo->labels, *analysis.front, *analysis.back);
    geometry.setLayers(layers, scene.photo->color, *analysis.front, *analysis.back);
    geometry.setEnvironment(analysis.environment ? *analysis.environment : core::DirectionalMap());
    shading = core::buildSegmentShading(scene, analysis);
    std::uint32_t brdfs = 0;
    for (const kernel::SegmentShading& entry : shading)
        if (entry.blend.w != 0) brdfs |= 1U << entry.brdf.type;
    irradiance.useBrdfs(brdfs, false, nullptr);
    paths.shading = makeBuffer(device, "segment shading", gpu::BufferUsage::Storage, shading);
    paths.dropped = makeBuffer(device, "dropped samples", gpu::BufferUsage::Storage, std::vector<kernel::uint>{0});
    paths.drives = makeBuffer(device, "drives", gpu::BufferUsage::Storage, std::vector<kernel::Drive>());
    paths.driveValues = makeBuffer(device, "drive values", gpu::BufferUsage::Storage, std::vector<float>());
    paths.measured = measured.upload(device, placeMeasured(scene, shading));
    targets.diffusion = device.createTexture({.label = "diffusion",
                                              .size = {geometry.width(), geometry.height()},
                                              .format = gpu::TextureFormat::RGBA32Float,
                                              .usage = gpu::TextureUsage::StorageBinding | gpu::TextureUsage::CopySrc});
    submit([&](const gpu::CommandEncoder& encoder) { geometry.record(encoder); });
}

template <class Record>
void Bench::submit(const Record& record) const {
    const gpu::CommandEncoder encoder = device.createCommandEncoder({.label = "benchmark"});
    record(encoder);
    device.queue().submit(encoder.finish());
    device.waitIdle();
}

core::DiffusionProfile Bench::profile() const {
    const double spacing = grids.grid.spacing;
    return core::blurred(core::profileFromTranslucency(*segment.edit->translucency),
                         std::max(samples.areaPerSample(), spacing * spacing));
}

/// Draws and lights samples.
void Bench::prepare(int count) {
    constexpr std::uint32_t kPointsPerSubmission = 2048;
    samples = core::sampleSurface(analysis, scene.photo->labels, segment.label, count, scene.render.seed);
    if (samples.samples.empty())
        throw core::Error(core::ErrorKind::Input, "The segment has no surface, so no light enters it.");
    areas = core::sampleAreas(samples, samples.samples.size());
    points = irradiance.upload(samples);
    std::vector<core::Vector3f> positions;
    for (const core::SurfaceSample& sample : samples.samples) positions.push_back(sample.position);
    core::DiffusionGrid grid = core::buildDiffusionGrid(
        positions, std::sqrt(samples.areaPerSample()), scene.photo->labels, analysis.front->depth,
        analysis.front->position, segment.label, scene.render.diffusionQuality, progress);
    pixels.clear();
    for (const kernel::uvec2& pixel : grid.pixels) pixels.push_back(pixel.x);
    grids = diffusion.upload(std::move(grid), points.sums, targets);
    diffusion.setAreas(grids, areas);
    const gpu::BindGroup group = irradiance.bindIrradiance(paths, points);
    for (std::uint32_t first = 0; first < points.count; first += kPointsPerSubmission) {
        progress.checkpoint(static_cast<float>(first) / static_cast<float>(points.count));
        submit([&](const gpu::CommandEncoder& encoder) {
            irradiance.record(encoder, geometry, group,
                              {.firstPoint = first,
                               .pointCount = std::min(kPointsPerSubmission, points.count - first),
                               .firstRay = 0,
                               .rayCount = kRays,
                               .label = segment.label,
                               .seed = scene.render.seed,
                               .bounces = 1,
                               .eta = core::profileFromTranslucency(*segment.edit->translucency).eta});
        });
    }
}

/// Sums onto all pixels; the best times of several runs.
Times Bench::sum() {
    constexpr int kRepetitions = 5;
    const core::DiffusionKernel kernel = core::fitDiffusionKernel(profile(), grids.grid);
    const auto run = [&](const std::vector<DiffusionStep>& steps) {
        const auto start = core::Clock::now();
        for (const DiffusionStep& step : steps)
            submit([&](const gpu::CommandEncoder& encoder) {
                diffusion.record(encoder, geometry, grids, step, 0, step.count, kRays, kernel);
            });
        return core::secondsSince(start);
    };
    Times times{.light = std::numeric_limits<double>::max(), .sum = std::numeric_limits<double>::max()};
    std::vector<DiffusionStep> light = DiffusionPass::lightSteps(grids);
    std::ranges::copy(DiffusionPass::smoothSteps(grids, kernel.finest, grids.grid.levels.size()),
                      std::back_inserter(light));
    const std::vector<DiffusionStep> sum = DiffusionPass::sumSteps(grids, kernel);
    for (int i = 0; i < kRepetitions; ++i) {
        progress.checkpoint(static_cast<float>(i) / kRepetitions);
        times.light = std::min(times.light, run(light));
        times.sum = std::min(times.sum, run(sum));
    }
    for (const DiffusionStep& step : sum)
        times.pairs += static_cast<double>(step.count) * static_cast<double>(accessesPerItem(step.kernel));
    times.cells = static_cast<double>(grids.grid.levels[0].count) * DIFFUSION_BRICK_CELLS;
    return times;
}

/// Error of the device's sum relative to the sum of all pairs with the profile itself.
Bench::Error Bench::compare(double* seconds) const {
    const std::vector<float> result = gpu::readTexture<float>(device, targets.diffusion);
    const std::vector<kernel::vec4> sums = gpu::readBuffer<kernel::vec4>(device, points.sums, 0, points.count);
    const core::DiffusionProfile exact = profile();
    const core::FlatSurface flat = core::flatSurface(exact);
    const std::size_t count = std::min(kTestPairs / samples.samples.size() + 1, pixels.size());
    double squares = 0;
    double total = 0;
    Error error;
    std::mutex mutex;
    const auto start = core::Clock::now();
    core::parallelFor(progress, static_cast<int>(count), [&](int i) {
        const std::uint32_t pixel = pixels[static_cast<std::size_t>(i) * pixels.size() / count];
        const auto x = static_cast<int>(pixel & 0xffffU);
        const auto y = static_cast<int>(pixel >> 16);
        const core::Vector3f p = analysis.front->position(x, y);
        Eigen::Vector3d truth = Eigen::Vector3d::Zero();
        Eigen::Vector3d whole = Eigen::Vector3d::Zero();
        for (std::size_t s = 0; s < sums.size(); ++s) {
            const double r2 = (p - samples.samples[s].position).cast<double>().squaredNorm();
            const Eigen::Vector3d light = Eigen::Vector3f(sums[s].x, sums[s].y, sums[s].z).cast<double>();
            for (int c = 0; c < 3; ++c) {
                const double weight = exact.evaluate(c, r2) * static_cast<double>(areas[s]);
                truth[c] += weight * light[c];
                whole[c] += weight;
            }
        }
        truth = flat.exitance(truth * (std::numbers::pi / kRays), whole).cast<double>();
        const float* texel = &result[4 * analysis.front->depth.index(x, y)];
        const std::lock_guard lock(mutex);
        for (int c = 0; c < 3; ++c) {
            const double difference = static_cast<double>(texel[c]) - truth[c];
            squares += difference * difference;
            total += truth[c] * truth[c];
            if (truth[c] > 0) error.max = std::max(error.max, std::abs(difference) / truth[c]);
        }
    });
    if (seconds != nullptr)
        *seconds = core::secondsSince(start) * static_cast<double>(pixels.size()) / static_cast<double>(count);
    error.rms = total > 0 ? std::sqrt(squares / total) : 0;
    return error;
}

double updateSeconds(const gpu::Device& device, core::Scene scene,
                     const std::shared_ptr<const core::Analysis>& analysis, const core::Progress& progress) {
    constexpr int kRepetitions = 5;
    constexpr double kBudget = 0.1;  // device time per submission [s]
    scene.render.samples = 1;
    scene.render.filter = false;
    scene.render.bounces = 1;
    scene.render.surfaceSamples = 40000;
    scene.render.irradianceSamples = kRays;
    Renderer renderer(device);
    double best = std::numeric_limits<double>::max();
    for (int i = 0; i <= kRepetitions; ++i) {
        for (core::Segment& segment : scene.segments)
            if (segment.edit) segment.edit->translucency->scale = 1.0f + 0.03f * static_cast<float>(i);
        const auto start = core::Clock::now();
        renderer.setScene(scene, analysis);
        bool worked = true;
        while (worked) {
            gpu::CommandEncoder encoder = device.createCommandEncoder({.label = "benchmark"});
            worked = renderer.record(encoder, kBudget);
            device.queue().submit(encoder.finish());
            device.waitIdle();
            progress.checkpoint(renderer.progress().fraction);
        }
        // The first run also lights the samples.
        if (i > 0) best = std::min(best, core::secondsSince(start));
    }
    return best;
}

}  // namespace

std::vector<BenchResult> benchTranslucency(const gpu::Device& device, const core::Scene& scene,
                                           const std::shared_ptr<const core::Analysis>& analysis,
                                           const core::Progress& progress) {
    std::vector<BenchResult> results;
    const auto add = [&](const std::string& metric, double value, const char* unit) {
        results.push_back({"translucency", metric, value, unit});
    };
    Bench bench(device, scene, *analysis, progress);
    std::map<int, Times> times;
    for (const int thousands : {10, 40, 160}) {
        const std::string size = std::to_string(thousands) + "k";
        bench.prepare(1000 * thousands);
        const Times& t = times[thousands] = bench.sum();
        double bruteSeconds = 0;
        const Bench::Error error = bench.compare(&bruteSeconds);
        const double brutePairs = 1000.0 * thousands * static_cast<double>(bench.pixels.size());
        add("seconds." + size, t.sum, "s");
        add("light_seconds." + size, t.light, "s");
        add("cells." + size, t.cells, "1");
        add("pairs." + size, t.pairs, "1");
        add("brute_pairs." + size, brutePairs, "1");
        add("pairs_ratio." + size, brutePairs / t.pairs, "1");
        add("rms_error." + size, error.rms, "1");
        add("max_error." + size, error.max, "1");
        if (thousands == 10) add("brute_seconds.10k", bruteSeconds, "s");
    }
    const auto exponent = [](double few, double many) { return std::log(many / few) / std::log(16.0); };
    add("exponent.seconds", exponent(times[10].sum, times[160].sum), "1");
    add("exponent.pairs", exponent(times[10].pairs, times[160].pairs), "1");
    add("update_seconds.40k", updateSeconds(device, scene, analysis, progress), "s");
    return results;
}

}  // namespace render
