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
namespace test {

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

/// Radiance by direction, unit length.
using Light = std::function<Vector3f(const Vector3f&)>;

/// Spheres with their true back sides under a distant light that is also the photograph's background. The floor is a
/// slab of 2 cm at y = 0.3 m, up to `floorDepth` [m], label 1; <= 0: no floor. A wall without label stands at
/// `backgroundDepth` [m]; 0: no wall.
inline AnalyticScene spheresOnFloor(int width, int height, const std::vector<Sphere>& spheres, float floorDepth,
                                    const Light& light, float backgroundDepth = 0) {
    const float floorY = 0.3f;
    const auto hit = [&](const Vector3f& ray) {
        AnalyticHit nearest{.label = 0, .color = light(ray.normalized())};
        if (backgroundDepth > 0) {
            nearest.front = backgroundDepth;
            nearest.back = backgroundDepth + 0.01f;
            nearest.color = Vector3f(0.2f, 0.3f, 0.4f);
        }
        const auto isNearer = [&](float z) { return nearest.front == 0 || z < nearest.front; };
        if (floorDepth > 0 && ray.y() > 0) {
            const float z = floorY / ray.y();
            if (z < floorDepth && isNearer(z))
                nearest = {.front = z,
                           .back = (floorY + 0.02f) / ray.y(),
                           .frontNormal = {0, -1, 0},
                           .backNormal = {0, 1, 0},
                           .label = 1,
                           .color = {0.4f, 0.25f, 0.1f}};
        }
        for (const Sphere& sphere : spheres) {
            const float a = ray.squaredNorm();
            const float b = ray.dot(sphere.center);
            const float c = sphere.center.squaredNorm() - sphere.radius * sphere.radius;
            const float root = b * b - a * c;
            if (root < 0) continue;
            const float z = (b - std::sqrt(root)) / a;
            if (z <= 0 || !isNearer(z)) continue;
            const float zBack = std::max((b + std::sqrt(root)) / a, z + 0.001f);
            nearest = {.front = z,
                       .back = zBack,
                       .frontNormal = (ray * z - sphere.center).normalized(),
                       .backNormal = (ray * zBack - sphere.center).normalized(),
                       .label = sphere.label,
                       .color = sphere.color};
        }
        return nearest;
    };
    AnalyticScene result(core::Camera::fromHorizontalFov(width, height, 0.9f), hit);
    result.setEnvironment(light, 64);
    result.scene.render.filter = core::RenderParams().filter;
    return result;
}

/// Two spheres on a floor under a coloured sky; small enough for the CPU oracle.
inline AnalyticScene stillLife() {
    return spheresOnFloor(120, 90,
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
inline AnalyticScene randomSpheres(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<Sphere> spheres;
    for (int i = 0; i < 12; ++i)
        spheres.push_back(
            {Vector3f(uniform(random) - 0.5f, 0.6f * uniform(random) - 0.4f, 0.8f + 0.8f * uniform(random)),
             0.01f + 0.1f * uniform(random), static_cast<std::uint16_t>(2 + i),
             Vector3f(uniform(random), uniform(random), uniform(random))});
    return spheresOnFloor(width, height, spheres, 2.0f,
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
    core::Scene scene = source.scene;
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

}  // namespace test
