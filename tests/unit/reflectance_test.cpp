// SPDX-License-Identifier: GPL-3.0-or-later
// Reflectance (docs/method.md#reflectance) and environment (#environment) of ray-traced mirrors whose truth is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/analysis/light/environment.h"
#include "core/analysis/light/reflectance.h"
#include "core/analysis/notes.h"
#include "core/analysis/pipeline.h"
#include "tests/support/ray_scene.h"

namespace {

using core::DirectionalMap;
using core::Vector3f;
using test::Vector3d;

Vector3f texelDirection(int x, int y, const DirectionalMap& map) {
    return DirectionalMap::directionFromTexel({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f},
                                              map.radiance.width(), map.radiance.height());
}

struct MirrorSphere : testing::Test {
    static void SetUpTestSuite() {
        truth = test::stillLife(test::testCamera(320, 240));
        scene = truth.scene();
        scene.environment.height = 64;
        core::AnalysisPipeline pipeline;
        analysis = pipeline.run(scene);
    }
    static void TearDownTestSuite() { analysis.reset(); }
    inline static test::RayScene truth;
    inline static core::Scene scene;
    inline static std::shared_ptr<const core::Analysis> analysis;
};

TEST_F(MirrorSphere, ReflectanceIsFound) {
    ASSERT_EQ(analysis->reflectances.size(), 1u);
    const core::Reflectance& r = *analysis->reflectances[0];
    EXPECT_EQ(r.label, 2);
    EXPECT_TRUE(r.reliable);
    EXPECT_GT(r.commonSolidAngle, 0.5f);
    EXPECT_NEAR(r.rho.x(), 0.9f, 0.03f);
    EXPECT_NEAR(r.rho.y(), 0.6f, 0.02f);
    EXPECT_NEAR(r.rho.z(), 0.3f, 0.01f);
    EXPECT_EQ(analysis->findReflectance(2), &r);
    EXPECT_EQ(analysis->findReflectance(1), nullptr);
}

TEST_F(MirrorSphere, LobeIsFoundToBeNarrow) {
    const core::Reflectance& r = *analysis->reflectances[0];
    EXPECT_TRUE(r.alphaReliable);
    // A pixel of this small picture mirrors a cone of about two degrees itself.
    EXPECT_LT(r.alpha, 0.03f);
}

TEST_F(MirrorSphere, UsersLobeWidthReplacesTheEstimate) {
    core::Scene edited = scene;
    edited.findSegment(2)->lobeWidth = 0.2f;
    core::AnalysisPipeline pipeline;
    EXPECT_EQ(pipeline.run(edited)->reflectances[0]->alpha, 0.2f);
}

TEST_F(MirrorSphere, UsersMapCompletesWhatWasNotSeen) {
    core::Scene edited = scene;
    edited.environment.image = std::make_shared<core::ImageRgb>(64, 32, Vector3f(7, 7, 7));
    edited.environment.path = "seven.exr";
    edited.environment.use = core::EnvironmentUse::Complete;
    core::AnalysisPipeline pipeline;
    const auto result = pipeline.run(edited);
    const DirectionalMap& map = *result->environment;
    ASSERT_EQ(map.radiance.height(), 64);
    int far = 0;
    for (std::size_t i = 0; i < map.radiance.size(); ++i) {
        if (map.coverage[i] > 0) {
            EXPECT_EQ(map.radiance[i], analysis->environment->radiance[i]);
        } else if (map.radiance[i].isApprox(Vector3f(7, 7, 7), 0.02f)) {
            ++far;
        }
    }
    EXPECT_GT(far, 500);
}

TEST_F(MirrorSphere, ReflectedMapHoldsWhatTheSphereShows) {
    // Directions above the floor: the sphere shows ρ times the environment there.
    const DirectionalMap& map = analysis->reflectances[0]->reflected;
    std::vector<float> errors;
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 128; ++x) {
            if (map.coverage(x, y) <= 0) continue;
            const Vector3f d = texelDirection(x, y, map);
            const Vector3f expected = truth.environment(d.cast<double>()).cwiseProduct(Vector3f(0.9f, 0.6f, 0.3f));
            errors.push_back((map.radiance(x, y) - expected).norm() / expected.norm());
        }
    }
    ASSERT_GT(errors.size(), 300u);
    std::ranges::sort(errors);
    EXPECT_LT(errors[errors.size() / 2], 0.02f);
    EXPECT_LT(errors[errors.size() * 9 / 10], 0.05f);
}

TEST_F(MirrorSphere, EnvironmentHasNoGapsWhereTheSphereIsCoarse) {
    // A map three times as fine as the sphere's pixels: what lies between them is known too, and right.
    core::Scene fine = scene;
    fine.environment.height = 192;
    core::AnalysisPipeline pipeline;
    const DirectionalMap map = *pipeline.run(fine)->environment;
    float gaps = 0;  // [sr]
    float inside = 0;
    std::vector<float> errors;
    for (int y = 1; y < 60; ++y) {
        const float solidAngle = DirectionalMap::texelSolidAngle(y, 384, 192);
        for (int x = 1; x < 383; ++x) {
            const bool known = map.coverage(x, y) > 0;
            if (known) {
                const Vector3f expected = truth.environment(texelDirection(x, y, map).cast<double>());
                errors.push_back((map.radiance(x, y) - expected).norm() / expected.norm());
            }
            if (map.coverage(x - 1, y) <= 0 || map.coverage(x, y - 1) <= 0 || map.coverage(x + 1, y) <= 0 ||
                map.coverage(x, y + 1) <= 0)
                continue;
            inside += solidAngle;
            if (!known) gaps += solidAngle;
        }
    }
    EXPECT_GT(inside, 1);
    EXPECT_LT(gaps, 0.02f * inside);
    std::ranges::sort(errors);
    EXPECT_LT(errors[errors.size() / 2], 0.02f);
    EXPECT_LT(errors[errors.size() * 9 / 10], 0.06f);
}

TEST_F(MirrorSphere, IncidentMapHoldsTheFloorAndTheBox) {
    const DirectionalMap& map = analysis->reflectances[0]->incident;
    const Vector3d center = Vector3d(0, 0.05, 1) - 0.12 * test::rotation(0.5, {1, 0, 0}).col(1) + Vector3d(-0.08, 0, 0);
    int box = 0;
    int agree = 0;
    int count = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 128; ++x) {
            if (map.coverage(x, y) <= 0) continue;
            test::RayScene others = truth;
            others.objects.erase(others.objects.begin() + 1);
            const Vector3d d = texelDirection(x, y, map).cast<double>();
            const auto hit = others.trace(center, d);
            if (!hit) continue;
            ++count;
            if (hit->object->label == 3) ++box;
            if ((map.radiance(x, y) - others.radiance(center, d)).norm() < 0.15f) ++agree;
        }
    }
    EXPECT_GT(count, 1000);
    EXPECT_GT(box, 20);
    EXPECT_GT(agree, 0.85 * count);
}

TEST_F(MirrorSphere, EnvironmentIsTheTruthWhereItWasSeen) {
    const DirectionalMap& map = *analysis->environment;
    std::vector<float> errors;
    double observed = 0;
    for (int y = 0; y < map.radiance.height(); ++y) {
        for (int x = 0; x < map.radiance.width(); ++x) {
            ASSERT_TRUE(map.radiance(x, y).allFinite());
            if (map.coverage(x, y) <= 0) continue;
            // Below the floor's horizon a ray that leaves the picture may still meet the floor outside of it.
            const Vector3d d = texelDirection(x, y, map).cast<double>();
            if (d.dot(test::rotation(0.5, {1, 0, 0}).col(1)) > -0.1) continue;
            observed += DirectionalMap::texelSolidAngle(y, map.radiance.width(), map.radiance.height());
            const Vector3f expected = truth.environment(d);
            errors.push_back((map.radiance(x, y) - expected).norm() / expected.norm());
        }
    }
    EXPECT_GT(observed, 3);
    std::ranges::sort(errors);
    EXPECT_LT(errors[errors.size() / 2], 0.02f);
    EXPECT_LT(errors[errors.size() * 95 / 100], 0.1f);
}

TEST_F(MirrorSphere, FloorBesideThePictureIsNotTakenForTheEnvironment) {
    // Below the horizon, as far as the floor is taken to go on: not observed, but filled by what the sphere shows
    // there.
    const DirectionalMap& map = *analysis->environment;
    const Vector3f down = test::rotation(0.5, {1, 0, 0}).col(1).cast<float>();
    const Vector3d center = Vector3d(-0.08, 0.05, 1) - 0.12 * down.cast<double>();
    test::RayScene others = truth;
    others.objects.erase(others.objects.begin() + 1);
    float all = 0;
    float observed = 0;
    Vector3f filled = Vector3f::Zero();
    Vector3f floor = Vector3f::Zero();
    for (int y = 0; y < map.radiance.height(); ++y) {
        const float solidAngle = DirectionalMap::texelSolidAngle(y, map.radiance.width(), map.radiance.height());
        for (int x = 0; x < map.radiance.width(); ++x) {
            const Vector3f d = texelDirection(x, y, map);
            if (d.dot(down) < 0.2f || std::abs(d.x()) < 0.9f) continue;
            all += solidAngle;
            if (map.coverage(x, y) > 0) observed += solidAngle;
            filled += solidAngle * map.radiance(x, y);
            floor += solidAngle * others.radiance(center, d.cast<double>());
        }
    }
    EXPECT_GT(all, 0.2f);
    EXPECT_LT(observed, 0.01f * all);
    // The floor is near: from another point of the sphere its pattern lies elsewhere, its mean does not.
    EXPECT_LT((filled - floor).norm(), 0.2f * floor.norm()) << filled.transpose() << " for " << floor.transpose();
}

TEST_F(MirrorSphere, UsersReflectanceReplacesTheEstimate) {
    core::Scene edited = scene;
    edited.findSegment(2)->reflectance = Vector3f(0.45f, 0.3f, 0.15f);
    core::AnalysisPipeline pipeline;
    const auto result = pipeline.run(edited);
    EXPECT_EQ(result->reflectances[0]->rho, Vector3f(0.45f, 0.3f, 0.15f));
    // Half the reflectance means twice the light, where only the sphere saw it: straight up.
    const Vector3f up(0, -1, 0);
    EXPECT_NEAR(result->environment->lookup(up).x(), 2 * analysis->environment->lookup(up).x(),
                0.1f * analysis->environment->lookup(up).x());
}

/// A chrome ball alone, the classical light probe: nothing but what lies behind it is known otherwise.
TEST(LightProbe, ABallAloneIsNoContradiction) {
    const std::vector<std::function<Vector3f(const Vector3d&)>> lights = {
        [](const Vector3d& d) {
            return Vector3f(static_cast<float>(0.8 + 0.5 * d.x()), static_cast<float>(0.7 - 0.4 * d.y()),
                            static_cast<float>(0.9 + 0.3 * d.z()));
        },
        [](const Vector3d& d) {  // a lamp behind the camera
            return Vector3f(Vector3f::Constant(static_cast<float>(0.3 + 4 * std::exp(8 * (-d.z() - 1)))));
        },
        [](const Vector3d& d) { return d.y() < 0 ? Vector3f(0.5f, 0.7f, 1.2f) : Vector3f(0.2f, 0.15f, 0.1f); },
        [](const Vector3d& d) {  // stripes
            return Vector3f(Vector3f::Constant(static_cast<float>(0.6 + 0.4 * std::sin(5 * d.x() + 3 * d.y()))));
        },
    };
    for (const bool dark : {false, true}) {
        for (std::size_t i = 0; i < lights.size(); ++i) {
            SCOPED_TRACE(testing::Message() << "light " << i << (dark ? ", cut out" : ""));
            test::RayScene truth;
            truth.camera = test::testCamera(160, 120);
            truth.environment = lights[i];
            truth.objects.push_back({1, std::make_shared<test::Sphere>(Vector3d(0.01, -0.02, 0.6), 0.16),
                                     [](const Vector3d&) { return Vector3f(1, 1, 1); }, true});
            core::Scene scene = truth.scene();
            if (dark) {
                core::Photo photo = *scene.photo;
                for (std::size_t k = 0; k < photo.color.size(); ++k)
                    if (photo.labels[k] == 0) photo.color[k] = Vector3f::Zero();
                scene.photo = std::make_shared<core::Photo>(std::move(photo));
            }
            scene.environment.height = 32;
            core::AnalysisPipeline pipeline;
            const auto analysis = pipeline.run(scene);
            ASSERT_EQ(analysis->reflectances.size(), 1U);
            EXPECT_FALSE(core::analysis::showsMoreThanItMirrors(*analysis->reflectances[0]));
            for (const core::Message& note : core::analysisNotes(scene, *analysis))
                EXPECT_EQ(note.english().find("more light than it can mirror"), std::string::npos) << note.english();
            std::vector<float> errors;
            const DirectionalMap& map = *analysis->environment;
            for (int y = 0; y < map.radiance.height(); ++y)
                for (int x = 0; x < map.radiance.width(); ++x) {
                    const Vector3f d = texelDirection(x, y, map);
                    if (map.coverage(x, y) <= 0 || d.z() > 0.5f) continue;
                    const Vector3f expected = truth.environment(d.cast<double>());
                    errors.push_back((map.radiance(x, y) - expected).norm() / expected.norm());
                }
            ASSERT_GT(errors.size(), 500U);
            std::ranges::sort(errors);
            EXPECT_LT(errors[errors.size() / 2], 0.06f);
        }
    }
}

TEST(ReflectanceBadInput, SegmentsOfFewPixelsAndFlatColourGiveNumbers) {
    const test::RayScene truth = test::stillLife(test::testCamera(80, 60));
    core::Photo photo = truth.photograph();
    for (Vector3f& c : photo.color.pixels()) c = Vector3f(0.4f, 0.4f, 0.4f);
    for (std::size_t i = 0; i < photo.labels.size(); ++i)
        if (photo.labels[i] != 0) photo.labels[i] = 1;
    photo.labels(40, 30) = 5;
    photo.labels(10, 40) = 6;
    photo.labels(11, 40) = 6;
    photo.depth(12, 40) = std::numeric_limits<float>::quiet_NaN();
    photo.depth(13, 40) = -3;
    core::Scene scene;
    scene.photo = std::make_shared<core::Photo>(std::move(photo));
    core::addMissingSegments(scene);
    for (core::Segment& segment : scene.segments) segment.glossy = true;
    core::Segment absent;
    absent.label = 900;
    absent.name = "absent";
    absent.glossy = true;
    scene.segments.push_back(absent);
    scene.environment.height = 16;
    core::AnalysisPipeline pipeline;
    const auto analysis = pipeline.run(scene);
    ASSERT_EQ(analysis->reflectances.size(), 4u);
    for (const auto& r : analysis->reflectances) {
        EXPECT_TRUE(r->rho.allFinite());
        EXPECT_GE(r->rho.minCoeff(), 0.02f);
        EXPECT_LE(r->rho.maxCoeff(), 1.0f);
    }
    EXPECT_FALSE(analysis->reflectances[3]->reliable);
    for (const Vector3f& c : analysis->environment->radiance.pixels()) EXPECT_TRUE(c.allFinite());
}

TEST(Environment, WithoutAnyEvidenceItIsWhiteAndFromAbove) {
    test::RayScene wall;
    wall.camera = test::testCamera(40, 30);
    wall.objects.push_back({1, std::make_shared<test::Box>(Vector3d(0, 0, 2), Vector3d(9, 9, 0.1)),
                            [](const Vector3d& p) { return p.x() < 0 ? Vector3f(1, 0, 0) : Vector3f(0, 1, 0); }});
    core::AnalysisPipeline pipeline;
    const auto analysis = pipeline.run(wall.scene());
    const core::ImageRgb& light = analysis->environment->radiance;
    for (const Vector3f& c : light.pixels()) {
        EXPECT_GT(c.x(), 0);
        EXPECT_FLOAT_EQ(c.x(), c.y());
        EXPECT_FLOAT_EQ(c.x(), c.z());
    }
    EXPECT_GT(light(0, 0).x(), light(0, light.height() - 1).x());
    for (const float count : analysis->environment->coverage.pixels()) EXPECT_EQ(count, 0);
}

TEST(Environment, DistantPixelsAreSeenAtTheirDirections) {
    test::RayScene truth = test::stillLife(test::testCamera(160, 120));
    for (test::SceneObject& object : truth.objects) object.mirror = false;
    core::AnalysisPipeline pipeline;
    const auto analysis = pipeline.run(truth.scene());
    const core::Photo photo = truth.photograph();
    // Closer than a texel of the map [px] to the picture's border, light that was not seen is mixed in.
    constexpr int kTexel = 6;
    int distant = 0;
    truth.forEachPixel([&](int x, int y, const Vector3d& ray) {
        if (x < kTexel || x >= photo.depth.width() - kTexel || y < kTexel || y > kTexel + 4) return;
        if (photo.depth(x, y) > 0) return;
        ++distant;
        const Vector3f seen = analysis->environment->lookup(ray.normalized().cast<float>());
        EXPECT_LT((seen - truth.environment(ray.normalized())).norm(), 0.05f);
    });
    EXPECT_GT(distant, 300);
}

TEST(UserEnvironment, TurnsScalesAndCoversEverything) {
    core::ImageRgb image(64, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) image(x, y) = Vector3f(static_cast<float>(x), static_cast<float>(y), 1);
    const DirectionalMap map = core::analysis::userEnvironment(image, 2 * 3.14159265f / 4, 2, 32, {});
    EXPECT_EQ(map.radiance.width(), 64);
    for (const float c : map.coverage.pixels()) EXPECT_EQ(c, 1);
    // A quarter turn to the right: what was in front is on the right now.
    EXPECT_NEAR(map.radiance(32 + 16, 10).x(), 2 * 32, 0.1f);
    EXPECT_NEAR(map.radiance(20, 10).y(), 2 * 10, 0.1f);
    EXPECT_NEAR(map.radiance(20, 10).z(), 2, 1e-3f);
}

TEST(UserEnvironment, LargeAndOddSizesKeepTheirMean) {
    core::ImageRgb image(3000, 1100, Vector3f(0.2f, 0.4f, 0.8f));
    const DirectionalMap map = core::analysis::userEnvironment(image, 0.3f, 1, 1024, {});
    EXPECT_EQ(map.radiance.height(), 1024);
    EXPECT_EQ(map.radiance.width(), 2048);
    EXPECT_TRUE(map.mean().isApprox(Vector3f(0.2f, 0.4f, 0.8f), 1e-4f));
}

}  // namespace
