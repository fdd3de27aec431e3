// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/scene/scene.h"

/// Scenes of exact shapes, ray traced in double: ground truth for everything the analysis estimates from a photograph.
namespace test {

using core::Vector3f;
using Eigen::Vector3d;

/// A solid, convex shape: a ray has one interval inside it.
struct Shape {
    virtual ~Shape() = default;
    struct Interval {
        double enter, leave;
        Vector3d enterNormal, leaveNormal;  ///< outward
    };
    [[nodiscard]] virtual std::optional<Interval> intersect(const Vector3d& o, const Vector3d& d) const = 0;
};

struct Sphere : Shape {
    Vector3d center;
    double radius;
    Sphere(const Vector3d& c, double r) : center(c), radius(r) {}
    [[nodiscard]] std::optional<Interval> intersect(const Vector3d& o, const Vector3d& d) const override {
        const Vector3d oc = o - center;
        const double a = d.squaredNorm();
        const double b = oc.dot(d);
        const double discriminant = b * b - a * (oc.squaredNorm() - radius * radius);
        if (discriminant <= 0) return std::nullopt;
        const double root = std::sqrt(discriminant);
        const double t0 = (-b - root) / a;
        const double t1 = (-b + root) / a;
        return Interval{t0, t1, (oc + t0 * d) / radius, (oc + t1 * d) / radius};
    }
};

/// Box with half extents along the columns of `axes`. A slab (floor) is a very wide box.
struct Box : Shape {
    Vector3d center;
    Vector3d half;
    Eigen::Matrix3d axes;
    Box(const Vector3d& c, const Vector3d& h, const Eigen::Matrix3d& a = Eigen::Matrix3d::Identity())
        : center(c), half(h), axes(a) {}
    [[nodiscard]] std::optional<Interval> intersect(const Vector3d& o, const Vector3d& d) const override {
        const Vector3d lo = axes.transpose() * (o - center);
        const Vector3d ld = axes.transpose() * d;
        Interval result{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), {}, {}};
        for (int k = 0; k < 3; ++k) {
            if (ld[k] == 0) {
                if (std::abs(lo[k]) > half[k]) return std::nullopt;
                continue;
            }
            const double sign = ld[k] > 0 ? 1 : -1;
            const double near = (-sign * half[k] - lo[k]) / ld[k];
            const double far = (sign * half[k] - lo[k]) / ld[k];
            if (near > result.enter) {
                result.enter = near;
                result.enterNormal = -sign * axes.col(k);
            }
            if (far < result.leave) {
                result.leave = far;
                result.leaveNormal = sign * axes.col(k);
            }
        }
        if (result.enter > result.leave) return std::nullopt;
        return result;
    }
};

struct SceneObject {
    std::uint16_t label;
    std::shared_ptr<Shape> shape;
    /// Radiance leaving the surface for a diffuse object; for a mirror the factor on what it reflects.
    std::function<Vector3f(const Vector3d& position)> color;
    bool mirror = false;
};

struct RayScene {
    core::Camera camera;
    std::vector<SceneObject> objects;
    std::function<Vector3f(const Vector3d& direction)> environment;

    struct Hit {
        const SceneObject* object;
        double t;
        Vector3d normal;
    };
    [[nodiscard]] std::optional<Hit> trace(const Vector3d& o, const Vector3d& d) const {
        std::optional<Hit> best;
        for (const SceneObject& object : objects) {
            const auto interval = object.shape->intersect(o, d);
            if (!interval || interval->enter <= 1e-9) continue;
            if (!best || interval->enter < best->t) best = Hit{&object, interval->enter, interval->enterNormal};
        }
        return best;
    }

    [[nodiscard]] Vector3f radiance(const Vector3d& o, const Vector3d& d, int bounces = 4) const {
        const auto hit = trace(o, d);
        if (!hit) return environment ? environment(d.normalized()) : Vector3f(0.5f, 0.5f, 0.5f);
        const Vector3d p = o + hit->t * d;
        const Vector3f color = hit->object->color ? hit->object->color(p) : Vector3f(0.5f, 0.5f, 0.5f);
        if (!hit->object->mirror || bounces == 0) return color;
        const Vector3d r = d - 2 * d.dot(hit->normal) * hit->normal;
        return color.cwiseProduct(radiance(p + 1e-7 * hit->normal, r, bounces - 1));
    }

    [[nodiscard]] core::Photo photograph() const {
        core::Photo photo;
        photo.camera = camera;
        photo.color = core::ImageRgb(camera.width, camera.height);
        photo.depth = core::ImageF(camera.width, camera.height);
        photo.labels = core::LabelImage(camera.width, camera.height);
        forEachPixel([&](int x, int y, const Vector3d& ray) {
            photo.color(x, y) = radiance(Vector3d::Zero(), ray);
            if (const auto hit = trace(Vector3d::Zero(), ray)) {
                photo.depth(x, y) = static_cast<float>(hit->t);  // ray has z = 1, so t is planar z
                photo.labels(x, y) = hit->object->label;
            }
        });
        return photo;
    }

    /// Exact surfaces: the front where the pixel's ray enters the first object, the back where it leaves the same
    /// object.
    [[nodiscard]] core::Surface frontSurface() const { return surface(true); }
    [[nodiscard]] core::Surface backSurface() const { return surface(false); }

    /// Everything the steps need, one segment per object.
    [[nodiscard]] core::Scene scene() const {
        core::Scene result;
        result.photo = std::make_shared<core::Photo>(photograph());
        core::addMissingSegments(result);
        for (const SceneObject& object : objects)
            if (core::Segment* segment = result.findSegment(object.label)) segment->glossy = object.mirror;
        return result;
    }

    template <class Visit>
    void forEachPixel(const Visit& visit) const {
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x)
                visit(x, y, Vector3d((x + 0.5 - camera.cx) / camera.fx, (y + 0.5 - camera.cy) / camera.fy, 1));
    }

  private:
    [[nodiscard]] core::Surface surface(bool front) const {
        core::Surface result;
        result.depth = core::ImageF(camera.width, camera.height);
        result.area = result.depth;
        result.normal = core::ImageV3(camera.width, camera.height);
        result.position = result.normal;
        result.color = result.normal;
        forEachPixel([&](int x, int y, const Vector3d& ray) {
            const auto hit = trace(Vector3d::Zero(), ray);
            if (!hit) return;
            const auto interval = *hit->object->shape->intersect(Vector3d::Zero(), ray);
            const double z = front ? interval.enter : interval.leave;
            result.depth(x, y) = static_cast<float>(z);
            result.normal(x, y) = (front ? interval.enterNormal : interval.leaveNormal).cast<float>();
            result.position(x, y) = (z * ray).cast<float>();
            if (front) result.color(x, y) = radiance(Vector3d::Zero(), ray);
        });
        return result;
    }
};

/// Camera of a small test picture, 50 degrees wide.
inline core::Camera testCamera(int width = 160, int height = 120) {
    return core::Camera::fromHorizontalFov(width, height, 0.8727f);
}

/// Rotation about `axis` by `angle` [rad].
inline Eigen::Matrix3d rotation(double angle, const Vector3d& axis) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

inline Vector3f randomDirection(std::mt19937& random) {
    std::normal_distribution<float> normal;
    Vector3f d;
    do {
        d = {normal(random), normal(random), normal(random)};
    } while (d.norm() < 1e-3f);
    return d.normalized();
}

/// A sphere on a tilted floor seen from above, with a box beside it: labels 1 (floor), 2 (sphere), 3 (box).
inline RayScene stillLife(const core::Camera& camera) {
    RayScene scene;
    scene.camera = camera;
    const Eigen::Matrix3d tilt = rotation(0.5, {1, 0, 0});
    const Vector3d up = -tilt.col(1);
    const Vector3d floorTop(0, 0.05, 1.0);
    scene.objects.push_back(
        {1, std::make_shared<Box>(floorTop - 0.05 * up, Vector3d(3, 0.05, 0.4), tilt), [](const Vector3d& p) {
             const auto s = static_cast<float>(0.5 + 0.3 * std::sin(9 * p.x()) * std::cos(7 * p.z()));
             return Vector3f(s, 0.7f * s, 0.4f);
         }});
    scene.objects.push_back({2, std::make_shared<Sphere>(floorTop + 0.12 * up + Vector3d(-0.08, 0, 0), 0.12),
                             [](const Vector3d&) { return Vector3f(0.9f, 0.6f, 0.3f); }, true});
    scene.objects.push_back({3,
                             std::make_shared<Box>(floorTop + 0.07 * up + Vector3d(0.2, 0, 0),
                                                   Vector3d(0.06, 0.07, 0.06), tilt * rotation(0.6, {0, 1, 0})),
                             [](const Vector3d&) { return Vector3f(0.2f, 0.3f, 0.8f); }});
    scene.environment = [](const Vector3d& d) {
        return Vector3f(static_cast<float>(0.8 + 0.5 * d.x()), static_cast<float>(0.7 - 0.4 * d.y()),
                        static_cast<float>(0.9 + 0.3 * d.z()));
    };
    return scene;
}

}  // namespace test
