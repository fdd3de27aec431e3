// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/base/directional_map.h"
#include "core/geometry/depth_layers.h"
#include "core/material/brdf.h"
#include "core/scene/scene.h"
#include "gpu/adapter.h"
#include "gpu/device.h"
#include "gpu/instance.h"
#include "gpu/readback.h"
#include "render/renderer.h"

/// Small analytic scenes for the tests of kernels and renderer.
namespace testing_support {

using core::Vector3f;

inline gpu::Device device() {
    static const gpu::Instance instance = gpu::Instance::create();
    static const gpu::Device device = instance.requestAdapter().requestDevice({.label = "test"});
    return device;
}

/// The named BRDF with its initial values.
inline core::Material material(const char* brdf) { return core::defaultMaterial(*core::findBrdf(brdf)); }

struct Sphere {
    Vector3f center;  ///< [m]
    float radius;     ///< [m]
    std::uint16_t label;
    Vector3f color{0.5f, 0.5f, 0.5f};
};

/// A scene of spheres in front of a tilted floor, with the true back sides.
struct AnalyticScene {
    std::shared_ptr<core::Photo> photo = std::make_shared<core::Photo>();
    std::shared_ptr<core::Surface> front = std::make_shared<core::Surface>();
    std::shared_ptr<core::Surface> back = std::make_shared<core::Surface>();
    std::shared_ptr<core::DirectionalMap> environment = std::make_shared<core::DirectionalMap>();

    [[nodiscard]] core::DepthLayers layers() const {
        return core::buildDepthLayers(photo->camera, photo->labels, *front, *back);
    }
    [[nodiscard]] std::shared_ptr<core::Analysis> analysis() const {
        auto result = std::make_shared<core::Analysis>();
        result->front = front;
        result->back = back;
        result->environment = environment;
        return result;
    }
    [[nodiscard]] core::Scene scene() const {
        core::Scene result;
        result.photo = photo;
        core::addMissingSegments(result);
        return result;
    }
};

inline core::Surface emptySurface(int width, int height) {
    core::Surface surface;
    surface.depth = core::ImageF(width, height, 0.0f);
    surface.normal = core::ImageV3(width, height, Vector3f::Zero());
    surface.position = core::ImageV3(width, height, Vector3f::Zero());
    surface.area = core::ImageF(width, height, 0.0f);
    surface.color = core::ImageRgb(width, height, Vector3f::Zero());
    return surface;
}

inline void putPoint(core::Surface& surface, const core::Camera& camera, int x, int y, float z, const Vector3f& normal,
                     const Vector3f& color) {
    surface.depth(x, y) = z;
    surface.normal(x, y) = normal;
    surface.position(x, y) = camera.backProject(x, y, z);
    surface.area(x, y) = z * z * z / (camera.fx * camera.fy * std::abs(normal.dot(surface.position(x, y))));
    surface.color(x, y) = color;
}

/// `floorDepth` <= 0: no floor. The floor is a slab of 2 cm at y = 0.3 m, up to that depth, label 1.
inline AnalyticScene makeAnalyticScene(int width, int height, const std::vector<Sphere>& spheres, float floorDepth,
                                       const std::function<Vector3f(const Vector3f&)>& light,
                                       float backgroundDepth = 0) {
    AnalyticScene result;
    core::Photo& photo = *result.photo;
    photo.camera = core::Camera::fromHorizontalFov(width, height, 0.9f);
    photo.color = core::ImageRgb(width, height, Vector3f::Zero());
    photo.depth = core::ImageF(width, height, 0.0f);
    photo.labels = core::LabelImage(width, height, 0);
    *result.front = emptySurface(width, height);
    *result.back = emptySurface(width, height);
    const float floorY = 0.3f;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Vector3f ray = photo.camera.pixelRay(x, y);
            float best = 0;
            photo.color(x, y) = light(ray.normalized());
            if (backgroundDepth > 0) {
                best = backgroundDepth;
                photo.color(x, y) = Vector3f(0.2f, 0.3f, 0.4f);
                putPoint(*result.front, photo.camera, x, y, best, {0, 0, -1}, photo.color(x, y));
                putPoint(*result.back, photo.camera, x, y, best + 0.01f, {0, 0, 1}, photo.color(x, y));
            }
            if (floorDepth > 0 && ray.y() > 0) {
                const float z = floorY / ray.y();
                if (z < floorDepth && (best == 0 || z < best)) {
                    best = z;
                    photo.labels(x, y) = 1;
                    photo.color(x, y) = Vector3f(0.4f, 0.25f, 0.1f);
                    putPoint(*result.front, photo.camera, x, y, z, {0, -1, 0}, photo.color(x, y));
                    putPoint(*result.back, photo.camera, x, y, (floorY + 0.02f) / ray.y(), {0, 1, 0},
                             photo.color(x, y));
                }
            }
            for (const Sphere& sphere : spheres) {
                const float a = ray.squaredNorm();
                const float b = ray.dot(sphere.center);
                const float c = sphere.center.squaredNorm() - sphere.radius * sphere.radius;
                const float root = b * b - a * c;
                if (root < 0) continue;
                const float z = (b - std::sqrt(root)) / a;
                if (z <= 0 || (best > 0 && z > best)) continue;
                best = z;
                const float zBack = std::max((b + std::sqrt(root)) / a, z + 0.001f);
                photo.labels(x, y) = sphere.label;
                photo.color(x, y) = sphere.color;
                putPoint(*result.front, photo.camera, x, y, z, (ray * z - sphere.center).normalized(), sphere.color);
                putPoint(*result.back, photo.camera, x, y, zBack, (ray * zBack - sphere.center).normalized(),
                         sphere.color);
            }
            photo.depth(x, y) = best;
        }
    }
    const int rows = 64;
    result.environment->radiance = core::ImageRgb(2 * rows, rows);
    result.environment->coverage = core::ImageF(2 * rows, rows, 1.0f);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < 2 * rows; ++x)
            result.environment->radiance(x, y) = light(core::DirectionalMap::directionFromTexel(
                {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, 2 * rows, rows));
    return result;
}

/// Two spheres on a floor under a coloured sky; small enough for the CPU oracle.
inline AnalyticScene stillLife() {
    return makeAnalyticScene(120, 90,
                             {{Vector3f(-0.12f, 0.13f, 0.9f), 0.16f, 2, Vector3f(0.6f, 0.2f, 0.1f)},
                              {Vector3f(0.2f, 0.16f, 1.05f), 0.13f, 3, Vector3f(0.1f, 0.3f, 0.7f)}},
                             2.0f, [](const Vector3f& d) -> Vector3f {
                                 return Vector3f(0.6f, 0.8f, 1.2f) * (1 - 0.8f * d.y()) +
                                        Vector3f(2, 1.5f, 1) * std::max(d.x(), 0.0f);
                             });
}

inline Vector3f randomDirection(std::mt19937& random) {
    std::normal_distribution<float> normal;
    while (true) {
        const Vector3f d(normal(random), normal(random), normal(random));
        if (d.norm() > 1e-3f) return d.normalized();
    }
}

/// A dozen spheres of all sizes over a floor; a different arrangement for every seed.
inline AnalyticScene makeRandomScene(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<Sphere> spheres;
    for (int i = 0; i < 12; ++i)
        spheres.push_back(
            {Vector3f(uniform(random) - 0.5f, 0.6f * uniform(random) - 0.4f, 0.8f + 0.8f * uniform(random)),
             0.01f + 0.1f * uniform(random), static_cast<std::uint16_t>(2 + i),
             Vector3f(uniform(random), uniform(random), uniform(random))});
    return makeAnalyticScene(width, height, spheres, 2.0f,
                             [](const Vector3f& d) -> Vector3f { return Vector3f(1.0f, 0.8f, 0.6f) * (1.2f - d.y()); });
}

inline core::Material ggx(float alpha) {
    core::Material m = material("ggx");
    m.values[0] = alpha;
    m.specular = Vector3f(0.9f, 0.7f, 0.5f);
    return m;
}

/// A translucent material without a surface of its own.
inline core::Material marble() {
    core::Material m = material("none");
    m.translucency = core::Translucency();
    m.translucency->sigmaA = Vector3f(0.02f, 0.04f, 0.07f);
    m.translucency->sigmaSPrime = Vector3f(0.3f, 0.35f, 0.4f);
    return m;
}

/// `source` with one segment edited, unfiltered.
inline core::Scene edited(const AnalyticScene& source, std::uint16_t label, const core::Material& m, int samples) {
    core::Scene scene = source.scene();
    scene.findSegment(label)->edit = m;
    scene.render.samples = samples;
    scene.render.filter = false;
    return scene;
}

struct Comparison {
    double nearlyEqual = 0;     ///< share of the segment's pixels that agree within 0.2 % + 1e-3
    double meanDifference = 0;  ///< relative difference of the means over the segment
    std::size_t pixels = 0;
};

inline Comparison compare(const core::ImageRgb& actual, const core::ImageRgb& expected, const core::LabelImage& labels,
                          std::uint16_t label) {
    Comparison result;
    double sumActual = 0;
    double sumExpected = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i] != label) continue;
        ++result.pixels;
        result.nearlyEqual +=
            (actual[i] - expected[i]).cwiseAbs().maxCoeff() <= 0.002f * expected[i].cwiseAbs().maxCoeff() + 1e-3f;
        sumActual += static_cast<double>(actual[i].sum());
        sumExpected += static_cast<double>(expected[i].sum());
    }
    result.nearlyEqual /= static_cast<double>(result.pixels);
    result.meanDifference = std::abs(sumActual - sumExpected) / sumExpected;
    return result;
}

/// Records and submits until there is nothing left; returns the number of submissions that did not merely wait.
inline int finish(render::Renderer& renderer, double budgetSeconds) {
    int slices = 0;
    for (int i = 1; i < 100000; ++i) {
        gpu::CommandEncoder encoder = device().createCommandEncoder({.label = "test"});
        const bool worked = renderer.record(encoder, budgetSeconds);
        device().queue().submit(encoder.finish());
        device().waitIdle();
        if (!renderer.progress().waiting) ++slices;
        if (!worked) return slices;
    }
    ADD_FAILURE() << "the renderer does not end";
    return 0;
}

inline std::vector<float> pixels(const render::Renderer& renderer) {
    return gpu::readTexture<float>(device(), renderer.result());
}

}  // namespace testing_support
