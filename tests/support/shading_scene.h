// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "core/analysis/analysis.h"
#include "core/material/brdf.h"
#include "core/scene/scene.h"

namespace test {

using core::Vector3f;

/// What an analytic scene shows in one pixel.
struct AnalyticHit {
    float front = 0;  ///< z [m], 0 = nothing
    float back = 0;
    Vector3f frontNormal{0, 0, -1};
    Vector3f backNormal{0, 0, 1};
    std::uint16_t label = 1;
    Vector3f color{0, 0, 0};
};

/// A scene whose two layers are exact, without any analysis in between.
struct AnalyticScene {
    core::Scene scene;
    std::shared_ptr<core::Analysis> analysis;

    /// `hit` is asked for every pixel with its ray (z = 1).
    AnalyticScene(const core::Camera& camera, const std::function<AnalyticHit(const Vector3f&)>& hit) {
        const int w = camera.width;
        const int h = camera.height;
        const Vector3f zero = Vector3f::Zero();
        core::Surface front{.depth = core::ImageF(w, h),
                            .normal = core::ImageV3(w, h, zero),
                            .position = core::ImageV3(w, h, zero),
                            .area = core::ImageF(w, h),
                            .color = core::ImageRgb(w, h, zero)};
        core::Surface back = front;
        core::LabelImage labels(w, h);
        const auto fill = [&](core::Surface& s, int x, int y, float z, const Vector3f& n, const Vector3f& color) {
            s.depth(x, y) = z;
            s.normal(x, y) = n;
            s.position(x, y) = camera.backProject(x, y, z);
            s.area(x, y) = z * z * z / (camera.fx * camera.fy * std::abs(n.dot(s.position(x, y))));
            s.color(x, y) = color;
        };
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                const AnalyticHit p = hit(camera.pixelRay(x, y));
                if (p.front <= 0) continue;
                labels(x, y) = p.label;
                fill(front, x, y, p.front, p.frontNormal, p.color);
                fill(back, x, y, p.back, p.backNormal, p.color);
            }
        auto photo = std::make_shared<core::Photo>();
        photo->camera = camera;
        photo->color = front.color;
        photo->depth = front.depth;
        photo->labels = labels;
        scene.photo = photo;
        core::addMissingSegments(scene);
        scene.render.filter = false;
        analysis = std::make_shared<core::Analysis>();
        analysis->front = std::make_shared<core::Surface>(std::move(front));
        analysis->back = std::make_shared<core::Surface>(std::move(back));
    }

    void setEnvironment(const std::function<Vector3f(const Vector3f&)>& radiance) {
        core::DirectionalMap map{.radiance = core::ImageRgb(256, 128), .coverage = core::ImageF(256, 128, 1.0f)};
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 256; ++x)
                map.radiance(x, y) = radiance(core::DirectionalMap::directionFromTexel(
                    {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, 256, 128));
        analysis->environment = std::make_shared<core::DirectionalMap>(std::move(map));
    }

    core::Material& edit(std::uint16_t label, const char* brdf) {
        core::Material& m = scene.findSegment(label)->edit.emplace(core::defaultMaterial(*core::findBrdf(brdf)));
        m.albedo = m.specular.emplace(1, 1, 1);
        m.fresnel = core::Fresnel::None;
        return m;
    }
};

inline core::Camera squareCamera(int size, float focal) {
    return {.width = size,
            .height = size,
            .fx = focal,
            .fy = focal,
            .cx = 0.5f * static_cast<float>(size),
            .cy = 0.5f * static_cast<float>(size)};
}

/// Sphere of `radius` around (0, 0, z).
inline std::function<AnalyticHit(const Vector3f&)> sphere(float radius, float z, const Vector3f& color = {0, 0, 0}) {
    return [=](const Vector3f& ray) {
        AnalyticHit hit;
        const Vector3f center(0, 0, z);
        const float a = ray.squaredNorm();
        const float b = ray.dot(center);
        const float d = b * b - a * (z * z - radius * radius);
        if (d <= 1e-7f) return hit;
        hit.front = (b - std::sqrt(d)) / a;
        hit.back = (b + std::sqrt(d)) / a;
        hit.frontNormal = (ray * hit.front - center).normalized();
        hit.backNormal = (ray * hit.back - center).normalized();
        hit.color = color;
        return hit;
    };
}

/// Slab z = front .. back filling the image.
inline std::function<AnalyticHit(const Vector3f&)> slab(float front, float back, const Vector3f& color = {0, 0, 0}) {
    return [=](const Vector3f&) { return AnalyticHit{.front = front, .back = back, .color = color}; };
}

}  // namespace test
