// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/kernels/brdf_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "gpu/error.h"
#include "gpu/instance.h"
#include "gpu/readback.h"
#include "kernels/check_brdf.h"
#include "render/kernels/direction_cells.h"
#include "render/kernels/kernels.h"
#include "render/kernels/measured_tables.h"
#include "render/kernels/user_kernels.h"
#include "shaders/brdf/measured.h"
#include "shaders/shared/check_brdf_block.h"

namespace render {

namespace {

constexpr std::uint32_t kBuildSamples = 4096;  // per case, to shape the cells
constexpr std::uint32_t kTestSamples = 8192;   // per case, to be counted in them
constexpr std::uint32_t kSamples = kBuildSamples + kTestSamples;
constexpr int kLevels = 9;
constexpr std::uint32_t kCells = 1U << kLevels;
constexpr std::uint32_t kCellsPerBin = 8;
constexpr std::uint32_t kSide = 6;
constexpr double kPoints = kSide * kSide;

constexpr double kTolerance = 0.02;        // error of density and energy by quadrature and float
constexpr double kMaxDeviation = 6;        // standard deviations
constexpr double kDispatchSeconds = 0.1;   // intended duration of a dispatch
constexpr double kMaxSeconds = 5;          // limit for all dispatches
constexpr std::uint32_t kFirstItems = 64;  // one workgroup, to measure the cost of an item

struct Case {
    core::Material material;
    std::string parameters;
    kernel::vec4 wo;
    double angle;
};

kernel::vec4 viewAt(double degrees) {
    const double theta = degrees * std::numbers::pi / 180;
    return {static_cast<float>(std::sin(theta) * std::cos(0.7)), static_cast<float>(std::sin(theta) * std::sin(0.7)),
            static_cast<float>(std::cos(theta)), 0};
}

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

/// Initial values from several directions; each parameter's limits, and all limits together, from two.
std::vector<Case> makeCases(const core::BrdfInfo& brdf, const std::shared_ptr<const core::BrdfFile>& file) {
    core::Material initial = file ? core::fileMaterial(file) : core::defaultMaterial(brdf);
    initial.albedo = core::Vector3f::Ones();
    initial.specular = core::Vector3f::Ones();
    std::vector<Case> cases;
    const auto add = [&](const core::Material& material, const std::string& parameters,
                         std::initializer_list<double> angles) {
        for (const double angle : angles) cases.push_back({material, parameters, viewAt(angle), angle});
    };
    add(initial, "", {0, 30, 60, 85});
    for (const bool greatest : {false, true}) {
        core::Material all = initial;
        for (std::size_t i = 0; i < brdf.params.size(); ++i) {
            const core::ParamInfo& param = brdf.params[i];
            core::Material one = initial;
            all.values.at(i) = one.values.at(i) = greatest ? param.max : param.min;
            add(one, std::string(param.key) + " = " + number(static_cast<double>(one.values.at(i))), {20, 75});
        }
        if (brdf.params.size() > 1)
            add(all, std::string("all parameters ") + (greatest ? "greatest" : "least"), {20, 75});
    }
    return cases;
}

/// Runs the kernel over items of all cases.
class Runner {
  public:
    Runner(const gpu::Device& device, const std::vector<Case>& cases, const std::shared_ptr<const core::BrdfFile>& file)
        : device_(device), file_(file), caseCount_(static_cast<std::uint32_t>(cases.size())) {
        using enum gpu::BindingType;
        using enum gpu::BufferUsage;
        const gpu::BindGroupLayout layout = makeLayout(device, "check_brdf",
                                                       {{CHECK_BRDF_CASES, ReadOnlyStorageBuffer},
                                                        {CHECK_BRDF_CELLS, ReadOnlyStorageBuffer},
                                                        {CHECK_BRDF_SAMPLES, StorageBuffer},
                                                        {CHECK_BRDF_SUMS, StorageBuffer}});
        const gpu::BindGroupLayout tables =
            makeLayout(device, "check_brdf tables", {{MEASURED_TABLES, ReadOnlyStorageBuffer}});
        std::vector<kernel::CheckBrdfCase> entries;
        std::uint32_t brdfs = 0;
        for (const Case& c : cases) {
            entries.push_back({core::toKernel(c.material, core::Vector3f::Ones()), c.wo});
            if (file && file->user) entries.back().brdf.type = BRDF_USER;
            brdfs |= 1U << entries.back().brdf.type;
        }
        std::vector<std::uint32_t> userCode;
        if (file && file->user) userCode = compileUserKernel(UserKernel::CheckBrdf, {file->user});
        const gpu::PipelineLayout pipelineLayout = device.createPipelineLayout(
            {.label = "check_brdf", .bindGroupLayouts = {layout, tables}, .immediateSize = sizeof(block_)});
        const gpu::ShaderModule module = device.createShaderModule(
            {.label = "check_brdf",
             .code = userCode.empty() ? std::span<const std::uint32_t>(check_brdf_spv) : userCode});
        pipeline_ = device.createComputePipeline({.label = "check_brdf",
                                                  .layout = pipelineLayout,
                                                  .module = module,
                                                  .constants = {{"0", static_cast<double>(brdfs)}}});
        const gpu::Buffer caseBuffer = makeBuffer(device, "BRDF cases", Storage, entries);
        cells_ = makeBuffer(device, "BRDF cells", Storage, std::vector<kernel::vec4>(std::size_t{caseCount_} * kCells));
        samples_ = device.createBuffer({.label = "BRDF samples",
                                        .size = std::uint64_t{caseCount_} * kSamples * sizeof(kernel::CheckBrdfSample),
                                        .usage = Storage | CopySrc});
        sums_ = device.createBuffer({.label = "BRDF sums",
                                     .size = std::uint64_t{caseCount_} * kCells * sizeof(kernel::CheckBrdfSums),
                                     .usage = Storage | CopySrc});
        group_ = device.createBindGroup({.label = "check_brdf",
                                         .layout = layout,
                                         .entries = {{.binding = CHECK_BRDF_CASES, .buffer = caseBuffer},
                                                     {.binding = CHECK_BRDF_CELLS, .buffer = cells_},
                                                     {.binding = CHECK_BRDF_SAMPLES, .buffer = samples_},
                                                     {.binding = CHECK_BRDF_SUMS, .buffer = sums_}}});
        MeasuredFiles files;
        if (file && file->measured) files.push_back(file->measured);
        tableGroup_ = device.createBindGroup(
            {.label = "check_brdf tables",
             .layout = tables,
             .entries = {{.binding = MEASURED_TABLES, .buffer = measured_.upload(device, files)}}});
    }

    [[nodiscard]] std::vector<kernel::CheckBrdfSample> sample() {
        dispatch(CHECK_BRDF_SAMPLE, 0, kFirstItems, kSamples);  // compiles
        run(CHECK_BRDF_SAMPLE, kSamples);
        return gpu::readBuffer<kernel::CheckBrdfSample>(device_, samples_, 0, std::size_t{caseCount_} * kSamples);
    }

    [[nodiscard]] std::vector<kernel::CheckBrdfSums> integrate(const std::vector<kernel::vec4>& cells) {
        device_.queue().writeBuffer(cells_, 0, cells);
        run(CHECK_BRDF_INTEGRATE, kCells);
        return gpu::readBuffer<kernel::CheckBrdfSums>(device_, sums_, 0, std::size_t{caseCount_} * kCells);
    }

  private:
    /// Splits the work, so that every dispatch is short, whatever the text does.
    void run(std::uint32_t mode, std::uint32_t perCase) {
        const std::uint32_t total = caseCount_ * perCase;
        std::uint32_t piece = kFirstItems;
        for (std::uint32_t first = 0; first < total;) {
            const std::uint32_t count = std::min(piece, total - first);
            const double seconds = dispatch(mode, first, count, perCase);
            first += count;
            seconds_ += seconds;
            const double expected = seconds_ + seconds * (total - first) / count;
            if (seconds > 4 * kDispatchSeconds ? expected > kMaxSeconds : seconds_ > kMaxSeconds)
                throw core::Error(core::ErrorKind::Input,
                                  core::Message("messages",
                                                "%1:1: It takes too long: trying it would take more than %2 seconds on "
                                                "this device.")
                                      .with(file_ ? file_->path : std::string("BRDF"), number(kMaxSeconds)));
            piece = static_cast<std::uint32_t>(
                std::clamp(count * kDispatchSeconds / std::max(seconds, 1e-6), double{kFirstItems}, 8.0 * count));
        }
    }

    double dispatch(std::uint32_t mode, std::uint32_t first, std::uint32_t count, std::uint32_t perCase) {
        block_ = {.mode = mode,
                  .first = first,
                  .count = count,
                  .perCase = perCase,
                  .side = kSide,
                  .pad0 = 0,
                  .pad1 = 0,
                  .pad2 = 0};
        const gpu::CommandEncoder encoder = device_.createCommandEncoder({.label = "check_brdf"});
        const gpu::ComputePassEncoder pass = encoder.beginComputePass({.label = "check_brdf"});
        pass.setPipeline(pipeline_);
        pass.setBindGroup(0, group_);
        pass.setBindGroup(1, tableGroup_);
        pass.setImmediates(0, block_);
        const ListGroups groups = listGroups(count, device_.limits());
        pass.dispatchWorkgroups(groups.x, groups.y);
        pass.end();
        const auto start = core::Clock::now();
        device_.queue().submit(encoder.finish());
        device_.waitIdle();
        return core::secondsSince(start);
    }

    gpu::Device device_;
    std::shared_ptr<const core::BrdfFile> file_;
    std::uint32_t caseCount_;
    kernel::CheckBrdfBlock block_{};
    gpu::ComputePipeline pipeline_;
    MeasuredTables measured_;
    gpu::Buffer cells_, samples_, sums_;
    gpu::BindGroup group_, tableGroup_;
    double seconds_ = 0;
};

/// Chi² of independent terms with mean 1, as standard deviations from its expected value [WH31].
class ChiSquare {
  public:
    void add(double observed, double expected, double variance) {
        const double difference = std::max(std::abs(observed - expected) - kTolerance * expected, 0.0);
        sum_ += difference * difference / std::max(variance, 1.0);
        ++terms_;
    }
    [[nodiscard]] double deviation() const {
        const double spread = 2 / (9 * terms_);
        return (std::cbrt(sum_ / terms_) - (1 - spread)) / std::sqrt(spread);
    }

  private:
    double sum_ = 0;
    double terms_ = 0;
};

double variance(float square, float mean) {
    const double m = static_cast<double>(mean);
    return std::max(static_cast<double>(square) - m * m, 0.0) / kPoints;
}

/// Judges one case.
class Judge {
  public:
    Judge(const Case& c, const core::UserBrdf* user, std::span<const kernel::CheckBrdfSample> samples,
          const DirectionCells& cells, std::span<const kernel::CheckBrdfSums> sums)
        : case_(c), user_(user), samples_(samples), cells_(cells), sums_(sums) {
        finding_.parameters = c.parameters;
        finding_.angle = c.angle;
    }

    BrdfFinding judge() {
        integrate();
        average();
        compare();
        findFaults();
        if (finding_.problem.empty()) findProblem();
        return finding_;
    }

  private:
    void integrate() {
        core::Vector3f albedo = core::Vector3f::Zero();
        double albedoVariance = 0;
        double asymmetry = 0;
        for (std::size_t i = 0; i < kCells; ++i) {
            const kernel::CheckBrdfSums& s = sums_[i];
            const double angle = DirectionCells::solidAngle(cells_.cells()[i]);
            finding_.density += static_cast<double>(s.value.w) * angle;
            densityVariance_ += variance(s.square.w, s.value.w) * angle * angle;
            albedo += core::Vector3f(s.value.x, s.value.y, s.value.z) * static_cast<float>(angle);
            albedoVariance += std::max({variance(s.square.x, s.value.x), variance(s.square.y, s.value.y),
                                        variance(s.square.z, s.value.z)}) *
                              angle * angle;
            asymmetry += static_cast<double>(s.other.x) * angle;
        }
        finding_.albedo = albedo;
        finding_.albedoError = std::sqrt(albedoVariance);
        finding_.asymmetry = asymmetry / std::max(static_cast<double>(albedo.maxCoeff()), 1e-6);
    }

    void average() {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        Eigen::Vector3d squares = Eigen::Vector3d::Zero();
        const std::size_t count = samples_.size() - kernel::kCheckBrdfCorners;
        for (const kernel::CheckBrdfSample& s : samples_.subspan(kernel::kCheckBrdfCorners)) {
            const Eigen::Vector3d w(s.weight.x, s.weight.y, s.weight.z);
            sum += w;
            squares += w.cwiseProduct(w);
        }
        const Eigen::Vector3d mean = sum / static_cast<double>(count);
        finding_.sampled = mean.cast<float>();
        const double variance = (squares / static_cast<double>(count) - mean.cwiseProduct(mean)).maxCoeff();
        finding_.sampledError = std::sqrt(std::max(variance, 0.0) / static_cast<double>(count));
    }

    void compare() {
        std::vector<double> observed(kCells / kCellsPerBin);
        double absorbed = 0;
        for (const kernel::CheckBrdfSample& s : samples_.subspan(kBuildSamples))
            ++(s.wi.z > 0 ? observed[cells_.find(s.wi) / kCellsPerBin] : absorbed);
        ChiSquare chi;
        double fewObserved = 0;
        double fewExpected = 0;
        double fewVariance = 0;
        for (std::size_t bin = 0; bin < observed.size(); ++bin) {
            double expected = 0;
            double error = 0;
            for (std::size_t i = bin * kCellsPerBin; i < (bin + 1) * kCellsPerBin; ++i) {
                const double angle = DirectionCells::solidAngle(cells_.cells()[i]);
                expected += static_cast<double>(sums_[i].value.w) * angle * kTestSamples;
                error += variance(sums_[i].square.w, sums_[i].value.w) * angle * angle * kTestSamples * kTestSamples;
            }
            if (expected < 5) {
                fewObserved += observed[bin];
                fewExpected += expected;
                fewVariance += expected + error;
            } else {
                chi.add(observed[bin], expected, expected + error);
            }
        }
        const double lost = std::max(1 - finding_.density, 0.0) * kTestSamples;
        chi.add(absorbed + fewObserved, lost + fewExpected,
                lost + kTolerance * kTolerance * kTestSamples * kTestSamples + fewVariance +
                    densityVariance_ * kTestSamples * kTestSamples);
        finding_.deviation = chi.deviation();
    }

    void fail(int core::UserBrdf::*line, const std::string& what) {
        finding_.line = user_ != nullptr ? user_->*line : 1;
        finding_.problem = what + ", seen at " + number(case_.angle) + "° to the normal" +
                           (case_.parameters.empty() ? "" : ", with " + case_.parameters) + ".";
    }

    void findFaults() {
        for (const kernel::CheckBrdfSample& s : samples_) addFault(static_cast<std::uint32_t>(s.wi.w), s.wi);
        for (const kernel::CheckBrdfSums& s : sums_) addFault(static_cast<std::uint32_t>(s.fault.w), s.fault);
    }

    void addFault(std::uint32_t faults, const kernel::vec4& wi) {
        if (faults == 0 || !finding_.problem.empty()) return;
        using U = core::UserBrdf;
        const std::string at =
            wi.z > 0 && wi.z <= 1
                ? " (light from " + number(std::acos(static_cast<double>(wi.z)) * 180 / std::numbers::pi) + "°)"
                : std::string();
        if ((faults & kernel::kCheckDirection) != 0)
            fail(&U::sampleLine, "sample() returns a direction that is not of unit length");
        else if ((faults & kernel::kCheckLoops) != 0)
            fail(&U::evaluateLine, "The loops of one call go on for more than 256 steps in all");
        else if ((faults & kernel::kCheckValue) != 0)
            fail(&U::evaluateLine, "evaluate() returns a value that is infinite or not a number" + at);
        else if ((faults & kernel::kCheckNegative) != 0)
            fail(&U::evaluateLine, "evaluate() returns a negative value" + at);
        else
            fail(&U::pdfLine, "pdf() returns a value that is negative, infinite or not a number" + at);
    }

    void findProblem() {
        using U = core::UserBrdf;
        const double densityError = std::sqrt(densityVariance_);
        const double albedo = static_cast<double>(finding_.albedo.maxCoeff());
        const double sampled = static_cast<double>(finding_.sampled.maxCoeff());
        const double errors = std::hypot(finding_.albedoError, finding_.sampledError);
        if (finding_.density > 1 + kTolerance + kMaxDeviation * densityError)
            fail(&U::pdfLine,
                 "pdf() integrates to " + number(finding_.density) + " over the hemisphere, expected at most 1");
        else if (finding_.deviation > kMaxDeviation)
            fail(&U::sampleLine,
                 "sample() does not follow pdf() (chi² test: " + number(finding_.deviation) + " standard deviations)");
        else if (albedo > 1 + kTolerance + kMaxDeviation * finding_.albedoError)
            fail(&U::evaluateLine,
                 "It reflects " + number(albedo) + " times what it receives, expected at most 1 with white colours");
        else if (std::abs(albedo - sampled) > kTolerance + kMaxDeviation * errors)
            fail(&U::sampleLine, "sample() leaves out directions into which evaluate() reflects: " + number(sampled) +
                                     " of the light by samples, " + number(albedo) + " by integration");
    }

    const Case& case_;
    const core::UserBrdf* user_;
    std::span<const kernel::CheckBrdfSample> samples_;
    const DirectionCells& cells_;
    std::span<const kernel::CheckBrdfSums> sums_;
    BrdfFinding finding_;
    double densityVariance_ = 0;
};

}  // namespace

std::vector<BrdfFinding> checkBrdf(const gpu::Device& device, const core::BrdfInfo& brdf,
                                   const std::shared_ptr<const core::BrdfFile>& file) {
    const std::vector<Case> cases = makeCases(brdf, file);
    Runner runner(device, cases, file);
    const std::vector<kernel::CheckBrdfSample> samples = runner.sample();
    std::vector<DirectionCells> trees;
    std::vector<kernel::vec4> cells;
    for (std::size_t c = 0; c < cases.size(); ++c) {
        std::vector<kernel::vec4> directions(kBuildSamples);
        for (std::size_t i = 0; i < kBuildSamples; ++i) directions[i] = samples[c * kSamples + i].wi;
        trees.emplace_back(directions, kLevels);
        cells.insert(cells.end(), trees.back().cells().begin(), trees.back().cells().end());
    }
    const std::vector<kernel::CheckBrdfSums> sums = runner.integrate(cells);
    std::vector<BrdfFinding> findings;
    for (std::size_t c = 0; c < cases.size(); ++c)
        findings.push_back(Judge(cases[c], file ? file->user.get() : nullptr,
                                 std::span(samples).subspan(c * kSamples, kSamples), trees[c],
                                 std::span(sums).subspan(c * kCells, kCells))
                               .judge());
    return findings;
}

void requireSound(const gpu::Device& device, const std::shared_ptr<const core::BrdfFile>& file) {
    for (const BrdfFinding& finding : checkBrdf(device, file->info, file))
        if (!finding.problem.empty())
            throw core::Error(core::ErrorKind::Input,
                              file->path + ":" + std::to_string(finding.line) + ": " + finding.problem);
}

core::UserBrdfCheck userBrdfCheck(const std::string& deviceWish) {
    return [deviceWish](const std::shared_ptr<const core::BrdfFile>& file) {
        try {
            const gpu::Adapter adapter = gpu::Instance::create().requestAdapter({.device = deviceWish});
            requireSound(adapter.requestDevice({.label = "BRDF check"}), file);
        } catch (const gpu::Error& error) {
            throw core::Error(
                core::ErrorKind::Input,
                core::Message("messages", "%1: It could not be tried: %2").with(file->path, std::string(error.what())));
        }
    };
}

}  // namespace render
