// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace core {

/// Pinhole camera. Conventions of the whole program:
/// camera frame x right, y down, z forward (right-handed), metres; depth is planar z; pixel (i, j) has its centre at
/// (i+0.5, j+0.5), origin top-left; directions are unit length and point away from the surface; radiance is linear
/// Rec.709.
struct Camera {
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels
    float fx = 1;    ///< focal length [px]
    float fy = 1;
    float cx = 0;  ///< principal point [px], top-left corner of the image is (0, 0)
    float cy = 0;

    /// Ray through image point (u, v) with z = 1 (not unit length).
    [[nodiscard]] Eigen::Vector3f ray(float u, float v) const { return {(u - cx) / fx, (v - cy) / fy, 1.0f}; }
    /// Ray through the centre of pixel (x, y), z = 1.
    [[nodiscard]] Eigen::Vector3f pixelRay(int x, int y) const {
        return ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    }
    /// Point seen at the centre of pixel (x, y) at planar depth z [m].
    [[nodiscard]] Eigen::Vector3f backProject(int x, int y, float z) const { return pixelRay(x, y) * z; }
    /// Image point (u, v) of a point with z > 0.
    [[nodiscard]] Eigen::Vector2f project(const Eigen::Vector3f& p) const {
        return {fx * p.x() / p.z() + cx, fy * p.y() / p.z() + cy};
    }
    /// Square pixels, principal point in the centre, horizontal field of view in radians.
    [[nodiscard]] static Camera fromHorizontalFov(int width, int height, float hfov);

    bool operator==(const Camera&) const = default;
};

}  // namespace core
