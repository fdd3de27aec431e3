// SPDX-License-Identifier: GPL-3.0-or-later
// The device's kernels of the analysis against those of the CPU, which are independent of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <string>
#include <utility>

#include "core/analysis/depth/depth_noise.h"
#include "core/analysis/depth/filter_depth.h"
#include "core/analysis/depth/normals.h"
#include "core/analysis/light/shepard.h"
#include "core/analysis/light/sphere_membrane.h"
#include "core/analysis/pipeline.h"
#include "core/io/project.h"
#include "render/analysis/gpu_analysis_kernels.h"
#include "tests/gpu/render_support.h"

namespace {

using core::AnalysisKernels;
using core::ImageF;
using core::Vector3f;
using render::GpuAnalysisKernels;
using test::AnalyticScene;

/// A device that a test may destroy.
gpu::Device ownDevice() { return gpu::Instance::create().requestAdapter().requestDevice({.label = "analysis test"}); }

struct Picture {
    core::Camera camera;
    ImageF depth;
    core::LabelImage labels;
    core::ImageRgb color;
};

/// Curved surfaces with steps in depth inside and between segments, holes, lone pixels, and noise of σ/z.
Picture makePicture(int width, int height, float noise, unsigned seed) {
    Picture picture;
    picture.camera = core::Camera::fromHorizontalFov(width, height, 0.9f);
    picture.depth = ImageF(width, height);
    picture.labels = core::LabelImage(width, height);
    picture.color = core::ImageRgb(width, height);
    std::mt19937 random(seed);
    std::normal_distribution<float> normal;
    std::uniform_real_distribution<float> uniform(0, 1);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float u = static_cast<float>(x) / 40;
            const float v = static_cast<float>(y) / 40;
            const int stripe = x / 23 + y / 31;
            picture.labels(x, y) = static_cast<std::uint16_t>(stripe % 5 * 16411 % 65536);
            float z = 1 + 0.1f * std::sin(u) * std::cos(v) + 0.3f * static_cast<float>(stripe % 3);
            if (x % 37 == 11) z += 0.4f;  // a step inside a segment
            z *= 1 + noise * normal(random);
            picture.depth(x, y) = uniform(random) < 0.03f || std::hypot(x - 50, y - 20) < 9 ? 0.0f : z;
            picture.color(x, y) = Vector3f(0.5f + 0.5f * std::sin(3 * u), uniform(random), 1.5f * uniform(random));
        }
    }
    return picture;
}

constexpr std::pair<int, int> kSizes[] = {{1, 1}, {257, 3}, {3, 131}, {97, 61}, {200, 150}};

core::analysis::FilterPass makeFilterPass(int step) {
    core::analysis::FilterPass pass;
    std::size_t i = 0;
    for (int dy = 0; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx)
            if (dy > 0 || dx > 0)
                pass.pairs[i++] = {dx * step, dy * step, 2 * std::exp(-0.5f * static_cast<float>(dx * dx + dy * dy))};
    pass.reach = 2 * step;
    pass.range.first = 0.5f;
    pass.range.cellsPerUnit = 20;
    for (std::size_t k = 0; k < pass.range.sigma.size(); ++k)
        pass.range.sigma[k] = 0.01f + 0.004f * static_cast<float>(k % 5);
    pass.colorFactor = 2;
    return pass;
}

TEST(AnalysisKernels, FilterDepthLikeTheCpu) {
    GpuAnalysisKernels kernels(test::device());
    for (const auto& [width, height] : kSizes) {
        const Picture picture = makePicture(width, height, 0.01f, 5);
        const auto color = core::analysis::encodeColor(picture.color, core::Progress());
        const ImageF w = core::analysis::inverseOf(picture.depth);
        const auto filter = kernels.depthFilter(color, picture.labels);
        double changed = 0;
        for (const int step : {1, 4}) {
            const core::analysis::FilterPass pass = makeFilterPass(step);
            const ImageF expected = core::analysis::runFilterPass(pass, w, color, picture.labels, core::Progress());
            const ImageF actual = filter->run(pass, w, core::Progress());
            for (std::size_t i = 0; i < w.size(); ++i) {
                // Sums of 12 pairs of floats, in any order and possibly fused: a few units in the last place of w.
                ASSERT_NEAR(actual[i], expected[i], 3e-6f * w[i]) << width << "x" << height << " pixel " << i;
                changed += std::abs(static_cast<double>(expected[i] - w[i]));
            }
        }
        if (w.size() > 1000) {
            EXPECT_GT(changed / static_cast<double>(w.size()), 1e-4);
        }
    }
    EXPECT_TRUE(kernels.takeNotes().empty());
}

TEST(AnalysisKernels, FitSurfacesLikeTheCpu) {
    GpuAnalysisKernels kernels(test::device());
    std::size_t pixels = 0;
    std::size_t different = 0;
    for (const float noise : {0.0f, 0.003f}) {
        std::vector<Picture> pictures;
        for (const auto& [width, height] : kSizes) pictures.push_back(makePicture(width, height, noise, 7));
        // Contours of spheres, where exact depth ends like a square root.
        const AnalyticScene spheres = test::randomSpheres(400, 300, 3);
        pictures.push_back({spheres.photo->camera, spheres.photo->depth, spheres.photo->labels, spheres.photo->color});
        for (const Picture& picture : pictures) {
            const int width = picture.camera.width;
            const int height = picture.camera.height;
            core::ImageV3 known(width, height);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width / 2; x += 3) known(x, y) = Vector3f(0.6f, 0, 0.8f);
            for (const core::ImageV3* given : {static_cast<const core::ImageV3*>(nullptr), &std::as_const(known)}) {
                const auto side = given != nullptr ? core::analysis::Side::Back : core::analysis::Side::Front;
                const core::analysis::SurfaceInput input{picture.camera, picture.labels, side, noise, given};
                core::Surface expected;
                core::Surface actual;
                expected.depth = actual.depth = picture.depth;
                core::analysis::computeSurface(input, expected, core::Progress());
                kernels.computeSurface(input, actual, core::Progress());
                for (std::size_t i = 0; i < picture.depth.size(); ++i) {
                    const float z = picture.depth[i];
                    // A position is two products and two quotients: 4 units in the last place.
                    ASSERT_LE((actual.position[i] - expected.position[i]).norm(), 1e-6f * expected.position[i].norm());
                    if (!(z > 0)) {
                        ASSERT_TRUE(actual.normal[i].isZero(0) && actual.position[i].isZero(0) && actual.area[i] == 0);
                        continue;
                    }
                    ++pixels;
                    // Rounding of inverse depth, 1e-7 of w, over a slope of a pixel, 1e-2 to 1e-3 of w, and twice
                    // through weights: 1e-3 rad. More where a comparison of the fit goes the other way.
                    const bool same = (actual.normal[i] - expected.normal[i]).norm() < 1e-3f &&
                                      std::abs(actual.area[i] - expected.area[i]) < 5e-3f * expected.area[i];
                    different += same ? 0 : 1;
                    ASSERT_NEAR(actual.normal[i].norm(), 1, 1e-5f);
                    ASSERT_GT(actual.area[i], 0);
                }
            }
        }
    }
    EXPECT_GT(pixels, 100000u);
    EXPECT_LE(static_cast<double>(different), 1e-3 * static_cast<double>(pixels)) << different << " of " << pixels;
    EXPECT_TRUE(kernels.takeNotes().empty());
}

TEST(AnalysisKernels, MarchLikeTheCpu) {
    GpuAnalysisKernels kernels(test::device());
    for (const auto& [width, height] : {std::pair{211, 157}, std::pair{257, 3}, std::pair{1, 1}}) {
        const AnalyticScene scene = test::randomSpheres(width, height, 3);
        const core::DepthLayers layers = scene.layers();
        std::mt19937 random(9);
        std::uniform_real_distribution<float> uniform(0, 1);
        std::vector<core::MarchRay> rays;
        for (int i = 0; i < 30000; ++i) {
            const float z = 0.3f + 2 * uniform(random);
            rays.push_back({scene.photo->camera.ray(uniform(random) * static_cast<float>(width),
                                                    uniform(random) * static_cast<float>(height)) *
                                z,
                            test::randomDirection(random)});
        }
        for (std::size_t i = 0; i < rays.size(); i += 100) rays[i].direction.setZero();
        const auto marcher = kernels.rayMarcher(layers);
        const auto oracle = core::cpuAnalysisKernels().rayMarcher(layers);
        for (const std::uint16_t without : {std::uint16_t{0}, std::uint16_t{1}, std::uint16_t{5}}) {
            const auto actual = marcher->march(rays, without, core::Progress());
            const auto expected = oracle->march(rays, without, core::Progress());
            ASSERT_EQ(actual.size(), rays.size());
            std::size_t agreed = 0;
            std::size_t hits = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                hits += expected[i] ? 1 : 0;
                if (actual[i]) {
                    ASSERT_TRUE(scene.photo->labels.contains(actual[i]->x, actual[i]->y));
                    ASSERT_TRUE(without == 0 || scene.photo->labels(actual[i]->x, actual[i]->y) != without);
                    ASSERT_NE(i % 100, 0u) << "a ray without direction hits nothing";
                }
                // Single against double precision: rays through the corner of a pixel may take the other one.
                const bool same = actual[i].has_value() == expected[i].has_value() &&
                                  (!actual[i] || (actual[i]->x == expected[i]->x && actual[i]->y == expected[i]->y &&
                                                  actual[i]->back == expected[i]->back &&
                                                  std::abs(actual[i]->distance - expected[i]->distance) <=
                                                      1e-3f * expected[i]->distance + 1e-4f));
                agreed += same ? 1 : 0;
            }
            EXPECT_GE(static_cast<double>(agreed), 0.999 * static_cast<double>(rays.size()))
                << width << "x" << height << " without " << without;
            EXPECT_TRUE(height < 100 || hits > rays.size() / 50) << hits;
        }
    }
    EXPECT_TRUE(kernels.takeNotes().empty());
}

/// A map known in two patches and some lone texels.
core::DirectionalMap partlyKnown(int height) {
    core::DirectionalMap map{core::ImageRgb(2 * height, height), ImageF(2 * height, height)};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < 2 * height; ++x) {
            const bool inPatch = x < height / 2 || (y > 3 * height / 4 && x > height);
            if (!inPatch && uniform(random) > 0.01f) continue;
            map.radiance(x, y) = Vector3f(1 + uniform(random), 0.2f + static_cast<float>(y), 30 * uniform(random));
            map.coverage(x, y) = uniform(random) < 0.2f ? 0.0f : 1 + 5 * uniform(random);
            if (!(map.coverage(x, y) > 0)) map.radiance(x, y).setZero();
        }
    }
    map.coverage(0, 0) = 1;
    map.radiance(0, 0) = Vector3f(1, 2, 3);
    return map;
}

TEST(AnalysisKernels, FillDirectionsLikeTheCpu) {
    GpuAnalysisKernels kernels(test::device());
    for (const int height : {4, 17, 64}) {
        const core::DirectionalMap map = partlyKnown(height);
        const float scale = 30 + static_cast<float>(height);

        core::DirectionalMap expected = map;
        core::DirectionalMap actual = map;
        const core::analysis::DirectionTree tree(map);
        core::analysis::fillShepard(tree, expected, core::Progress());
        kernels.fillShepard(tree, actual, core::Progress());
        std::size_t different = 0;
        for (std::size_t i = 0; i < map.radiance.size(); ++i) {
            // Thousands of weights that fall with the cube of an angle: 1e-4. Where a group is at the limit for
            // counting as one, the two may differ by the error of that approximation.
            different +=
                (actual.radiance[i] - expected.radiance[i]).norm() > 1e-4f * expected.radiance[i].norm() ? 1 : 0;
            ASSERT_LE((actual.radiance[i] - expected.radiance[i]).norm(), 0.01f * expected.radiance[i].norm())
                << "height " << height << " texel " << i;
        }
        EXPECT_LE(static_cast<double>(different), 5e-3 * static_cast<double>(map.radiance.size()))
            << "height " << height;

        for (const float screen : {0.0f, 0.06f}) {
            const auto rows = core::analysis::membraneRows(height, screen);
            core::ImageRgb expectedValues = map.radiance;
            core::ImageRgb actualValues = map.radiance;
            core::analysis::relaxMembrane(map.coverage, rows, expectedValues, core::Progress());
            kernels.relaxMembrane(map.coverage, rows, actualValues, core::Progress());
            for (std::size_t i = 0; i < map.radiance.size(); ++i)
                // 60 sweeps of averages, in which rounding does not accumulate.
                ASSERT_LE((actualValues[i] - expectedValues[i]).norm(), 1e-5f * scale)
                    << "height " << height << " texel " << i;
        }
    }
    EXPECT_TRUE(kernels.takeNotes().empty());
}

core::Scene bundledSample() {
    core::Scene scene = core::loadProject(PATINA_SAMPLES "/studio/studio.patina");
    scene.environment.fill = core::EnvironmentFill::Shepard;  // which includes the membrane
    return scene;
}

/// Noisy depth instead of the rendered one, so that every pass of the filter has work.
core::Scene withNoise(core::Scene scene) {
    auto photo = std::make_shared<core::Photo>(*scene.photo);
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    for (float& z : photo->depth.pixels()) z *= 1 + 0.004f * normal(random);
    scene.photo = photo;
    return scene;
}

/// Spheres on a floor, two of them glossy: small, but large enough for several slices.
core::Scene smallScene() {
    core::Scene scene = test::randomSpheres(400, 300, 3).scene;
    scene.environment.height = 32;
    for (core::Segment& segment : scene.segments) segment.glossy = segment.label == 3 || segment.label == 5;
    return scene;
}

TEST(AnalysisKernels, AnalyseTheSampleLikeTheCpu) {
    for (const bool noisy : {false, true}) {
        const core::Scene scene = noisy ? withNoise(bundledSample()) : bundledSample();
        GpuAnalysisKernels kernels(test::device());
        const auto expected = core::AnalysisPipeline().run(scene);
        const auto actual = core::AnalysisPipeline().run(scene, {}, kernels);
        EXPECT_TRUE(kernels.takeNotes().empty());

        std::size_t pixels = 0;
        std::size_t depths = 0;
        std::size_t normals = 0;
        for (std::size_t i = 0; i < expected->front->depth.size(); ++i) {
            const float z = expected->front->depth[i];
            ASSERT_EQ(z > 0, actual->front->depth[i] > 0);
            if (!(z > 0)) continue;
            ++pixels;
            depths += std::abs(actual->front->depth[i] - z) > 1e-5f * z ? 1 : 0;
            normals += (actual->front->normal[i] - expected->front->normal[i]).norm() > 5e-3f ? 1 : 0;
        }
        // Ranges of later passes depend on noise measured on earlier results, which propagates rounding.
        EXPECT_LE(static_cast<double>(depths), 1e-3 * static_cast<double>(pixels)) << "noisy " << noisy;
        EXPECT_LE(static_cast<double>(normals), 2e-3 * static_cast<double>(pixels)) << "noisy " << noisy;

        // Visible difference: a hundredth of the estimates, far below the error of the method.
        ASSERT_EQ(actual->reflectances.size(), expected->reflectances.size());
        ASSERT_FALSE(expected->reflectances.empty());
        for (std::size_t i = 0; i < expected->reflectances.size(); ++i) {
            EXPECT_LE((actual->reflectances[i]->rho - expected->reflectances[i]->rho).norm(),
                      0.01f * expected->reflectances[i]->rho.norm());
            EXPECT_NEAR(actual->reflectances[i]->alpha, expected->reflectances[i]->alpha,
                        0.05f * expected->reflectances[i]->alpha);
        }
        EXPECT_LE((actual->environment->mean() - expected->environment->mean()).norm(),
                  0.01f * expected->environment->mean().norm());
    }
}

TEST(AnalysisKernels, RepeatToTheByte) {
    const core::Scene scene = withNoise(smallScene());
    const auto analyse = [&] {
        GpuAnalysisKernels kernels(test::device());
        return core::AnalysisPipeline().run(scene, {}, kernels);
    };
    const auto first = analyse();
    const auto second = analyse();
    EXPECT_EQ(first->front->depth, second->front->depth);
    EXPECT_EQ(first->front->normal, second->front->normal);
    EXPECT_EQ(first->back->area, second->back->area);
    EXPECT_EQ(first->environment->radiance, second->environment->radiance);
    EXPECT_EQ(first->environment->coverage, second->environment->coverage);
}

/// Expects that `work` stops with Error(Cancelled) when the user stops it after its first report.
template <class Work>
void expectStops(const char* what, const Work& work) {
    std::atomic<bool> cancel{false};
    std::atomic<int> reports{0};
    const core::Progress progress(
        [&](core::Task, float) {
            cancel = true;
            ++reports;
        },
        &cancel);
    try {
        work(progress);
        ADD_FAILURE() << what << " was not cancelled";
    } catch (const core::Error& error) {
        EXPECT_EQ(error.kind(), core::ErrorKind::Cancelled) << error.what();
    }
    EXPECT_EQ(reports, 1) << what << " went on";
}

TEST(AnalysisKernels, StopBetweenSlices) {
    GpuAnalysisKernels kernels(test::device());
    const Picture picture = makePicture(200, 150, 0.01f, 5);
    const auto color = core::analysis::encodeColor(picture.color, core::Progress());
    expectStops("depth filter", [&](const core::Progress& stopped) {
        (void)kernels.depthFilter(color, picture.labels)
            ->run(makeFilterPass(1), core::analysis::inverseOf(picture.depth), stopped);
    });
    expectStops("surface", [&](const core::Progress& stopped) {
        core::Surface surface;
        surface.depth = picture.depth;
        kernels.computeSurface({picture.camera, picture.labels}, surface, stopped);
    });
    const core::DepthLayers layers = test::randomSpheres(100, 80, 3).layers();
    expectStops("march", [&](const core::Progress& stopped) {
        const std::vector<core::MarchRay> rays(20000, {{0, 0, 1}, {0, 1, 0}});
        (void)kernels.rayMarcher(layers)->march(rays, 0, stopped);
    });
    core::DirectionalMap map = partlyKnown(64);
    expectStops("Shepard", [&](const core::Progress& stopped) {
        kernels.fillShepard(core::analysis::DirectionTree(map), map, stopped);
    });
    expectStops("membrane", [&](const core::Progress& stopped) {
        kernels.relaxMembrane(map.coverage, core::analysis::membraneRows(64, 0), map.radiance, stopped);
    });
    EXPECT_TRUE(kernels.takeNotes().empty());
}

TEST(AnalysisKernels, AStoppedAnalysisCanBeTakenUpAgain) {
    const core::Scene scene = smallScene();
    for (const core::Task stop : {core::Task::ComputeNormals, core::Task::InventBackSides,
                                  core::Task::EstimateReflectance, core::Task::RecoverEnvironment}) {
        GpuAnalysisKernels kernels(test::device());
        std::atomic<bool> cancel{false};
        const core::Progress progress(
            [&](core::Task task, float fraction) {
                if (task == stop && fraction > 0) cancel = true;
            },
            &cancel);
        core::AnalysisPipeline pipeline;
        try {
            (void)pipeline.run(scene, progress, kernels);
            ADD_FAILURE() << "not cancelled in " << static_cast<int>(stop);
        } catch (const core::Error& error) {
            EXPECT_EQ(error.kind(), core::ErrorKind::Cancelled) << error.what();
        }
        EXPECT_FALSE(pipeline.runCounts().contains(stop));
        EXPECT_NE(pipeline.run(scene, {}, kernels)->environment, nullptr);
        EXPECT_EQ(pipeline.runCounts().at(core::Task::RecoverDepth), 1) << "what was finished is kept";
        EXPECT_TRUE(kernels.takeNotes().empty());
    }
}

TEST(AnalysisKernels, GoOnOnTheCpuWhenTheDeviceIsGone) {
    const core::Scene scene = smallScene();
    const auto expected = core::AnalysisPipeline().run(scene);
    for (const core::Task lostIn : {core::Task::ComputeNormals, core::Task::EstimateReflectance}) {
        const gpu::Device device = ownDevice();
        GpuAnalysisKernels kernels(device);
        bool destroyed = false;
        const core::Progress progress(
            [&](core::Task task, float) {
                if (task == lostIn && !std::exchange(destroyed, true)) device.destroy();
            },
            nullptr);
        const auto actual = core::AnalysisPipeline().run(scene, progress, kernels);
        const auto notes = kernels.takeNotes();
        ASSERT_EQ(notes.size(), 1u);
        EXPECT_NE(notes[0].english().find("on the CPU"), std::string::npos) << notes[0].english();
        EXPECT_TRUE(kernels.takeNotes().empty());
        if (lostIn == core::Task::ComputeNormals) {
            EXPECT_EQ(actual->environment->radiance, expected->environment->radiance);
        }
    }
}

TEST(AnalysisKernels, AreTakenAsAskedFor) {
    using render::AnalysisTwin;
    EXPECT_EQ(render::parseAnalysisTwin("auto", "x"), AnalysisTwin::Automatic);
    EXPECT_EQ(render::parseAnalysisTwin("cpu", "x"), AnalysisTwin::Cpu);
    EXPECT_EQ(render::parseAnalysisTwin("gpu", "x"), AnalysisTwin::Gpu);
    try {
        (void)render::parseAnalysisTwin("fast", "--analysis");
        FAIL();
    } catch (const core::Error& error) {
        EXPECT_EQ(error.kind(), core::ErrorKind::Usage);
        EXPECT_STREQ(error.what(), "--analysis is \"fast\", expected auto, cpu or gpu.");
    }
    EXPECT_EQ(render::createAnalysisKernels(AnalysisTwin::Cpu, ""), nullptr);
    EXPECT_NE(render::createAnalysisKernels(AnalysisTwin::Gpu, ""), nullptr);
    // The tests' device is a software device.
    EXPECT_EQ(render::createAnalysisKernels(AnalysisTwin::Automatic, ""), nullptr);
    EXPECT_EQ(render::createAnalysisKernels(AnalysisTwin::Automatic, "no such device"), nullptr);
    EXPECT_THROW((void)render::createAnalysisKernels(AnalysisTwin::Gpu, "no such device"), gpu::Error);
}

}  // namespace
