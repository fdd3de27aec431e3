// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "core/analysis/analysis.h"
#include "core/base/directional_map.h"
#include "core/geometry/depth_layers.h"
#include "core/material/brdf.h"
#include "core/scene/scene.h"

namespace test {

using core::Vector3f;

/// Contents of one pixel of an analytic scene.
struct AnalyticHit {
    float front = 0;  ///< z [m], 0 = nothing
    float back = 0;   ///< z [m]
    Vector3f frontNormal{0, 0, -1};
    Vector3f backNormal{0, 0, 1};
    std::uint16_t label = 1;  ///< ignored where there is nothing
    Vector3f color{0, 0, 0};  ///< of the photograph, also where there is nothing
};

/// A scene whose two layers are exact, without any analysis in between.
struct AnalyticScene {
    // Shared with `scene` and `analysis`, which only read them.
    std::shared_ptr<core::Photo> photo = std::make_shared<core::Photo>();
    std::shared_ptr<core::Surface> front;
    std::shared_ptr<core::Surface> back;
    std::shared_ptr<core::DirectionalMap> environment;  ///< null until setEnvironment()
    core::Scene scene;
    std::shared_ptr<core::Analysis> analysis = std::make_shared<core::Analysis>();

    /// Calls `hit` for every pixel with its ray (z = 1). The scene is rendered without a filter.
    AnalyticScene(const core::Camera& camera, const std::function<AnalyticHit(const Vector3f&)>& hit)
        : front(emptySurface(camera)), back(emptySurface(camera)) {
        photo->camera = camera;
        photo->color = core::ImageRgb(camera.width, camera.height);
        photo->labels = core::LabelImage(camera.width, camera.height);
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x) {
                const AnalyticHit p = hit(camera.pixelRay(x, y));
                photo->color(x, y) = p.color;
                if (p.front <= 0) continue;
                photo->labels(x, y) = p.label;
                putPatch(*front, camera, x, y, p.front, p.frontNormal, p.color);
                putPatch(*back, camera, x, y, p.back, p.backNormal, p.color);
            }
        photo->depth = front->depth;
        scene.photo = photo;
        core::addMissingSegments(scene);
        scene.render.filter = false;
        analysis->front = front;
        analysis->back = back;
    }

    [[nodiscard]] core::DepthLayers layers() const {
        return core::buildDepthLayers(photo->camera, photo->labels, *front, *back);
    }

    void setEnvironment(const std::function<Vector3f(const Vector3f&)>& radiance, int rows = 128) {
        environment = std::make_shared<core::DirectionalMap>();
        environment->radiance = core::ImageRgb(2 * rows, rows);
        environment->coverage = core::ImageF(2 * rows, rows, 1.0f);
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < 2 * rows; ++x)
                environment->radiance(x, y) = radiance(core::DirectionalMap::directionFromTexel(
                    {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, 2 * rows, rows));
        analysis->environment = environment;
    }

    core::Material& edit(std::uint16_t label, const char* brdf) {
        core::Material& m = scene.findSegment(label)->edit.emplace(core::defaultMaterial(*core::findBrdf(brdf)));
        m.albedo = m.specular.emplace(1, 1, 1);
        m.fresnel = core::Fresnel::None;
        return m;
    }

  private:
    static std::shared_ptr<core::Surface> emptySurface(const core::Camera& camera) {
        const core::ImageV3 zero(camera.width, camera.height, Vector3f::Zero());
        const core::ImageF none(camera.width, camera.height);
        return std::make_shared<core::Surface>(
            core::Surface{.depth = none, .normal = zero, .position = zero, .area = none, .color = zero});
    }

    static void putPatch(core::Surface& surface, const core::Camera& camera, int x, int y, float z,
                         const Vector3f& normal, const Vector3f& color) {
        surface.depth(x, y) = z;
        surface.normal(x, y) = normal;
        surface.position(x, y) = camera.backProject(x, y, z);
        surface.area(x, y) = z * z * z / (camera.fx * camera.fy * std::abs(normal.dot(surface.position(x, y))));
        surface.color(x, y) = color;
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
