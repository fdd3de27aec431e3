// SPDX-License-Identifier: GPL-3.0-or-later
// Back sides of analytic solids: rounded, with flat faces, standing on a table, thin; and of segments that are hardly
// any.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/analysis/back/back_side.h"
#include "core/analysis/segment/support_planes.h"
#include "tests/support/ray_scene.h"

namespace {

using core::BackSideMethod;
using core::Vector3f;
using core::analysis::BackLayer;
using test::Vector3d;

using Interval = test::Shape::Interval;

/// Half axes `half` along the columns of `axes`.
struct Ellipsoid : test::Shape {
    Vector3d center, half;
    Eigen::Matrix3d axes;
    Ellipsoid(const Vector3d& c, const Vector3d& h, const Eigen::Matrix3d& a) : center(c), half(h), axes(a) {}

    [[nodiscard]] std::optional<Interval> intersect(const Vector3d& o, const Vector3d& d) const override {
        const auto unit = [&](const Vector3d& v) -> Vector3d { return (axes.transpose() * v).cwiseQuotient(half); };
        auto hit = test::Sphere(Vector3d::Zero(), 1).intersect(unit(o - center), unit(d));
        if (!hit) return hit;
        for (Vector3d* normal : {&hit->enterNormal, &hit->leaveNormal})
            *normal = (axes * normal->cwiseQuotient(half)).normalized();
        return hit;
    }
};

/// Solid of revolution about a unit `axis`: what is within `radius` of it, endless.
std::optional<Interval> intersectTube(const Vector3d& o, const Vector3d& d, const Vector3d& axis, double radius) {
    const Vector3d across = d - d.dot(axis) * axis;
    if (across.norm() < 1e-12) return std::nullopt;
    return test::Sphere(Vector3d::Zero(), radius).intersect(o - o.dot(axis) * axis, across);
}

/// Upright or lying cylinder with flat ends, `half` from the centre.
struct Cylinder : test::Shape {
    Vector3d center, axis;
    double radius, half;
    Cylinder(const Vector3d& c, const Vector3d& a, double r, double h) : center(c), axis(a), radius(r), half(h) {}

    [[nodiscard]] std::optional<Interval> intersect(const Vector3d& o, const Vector3d& d) const override {
        auto hit = intersectTube(o - center, d, axis, radius);
        if (!hit) return hit;
        const double slope = d.dot(axis);
        const double start = (o - center).dot(axis);
        const double sign = slope > 0 ? 1 : -1;
        if (slope != 0 && (-sign * half - start) / slope > hit->enter)
            hit->enter = (-sign * half - start) / slope, hit->enterNormal = -sign * axis;
        if (slope != 0 && (sign * half - start) / slope < hit->leave)
            hit->leave = (sign * half - start) / slope, hit->leaveNormal = sign * axis;
        if (hit->enter >= hit->leave) return std::nullopt;
        return hit;
    }
};

/// A cylinder with half spheres for ends.
struct Capsule : test::Shape {
    Cylinder middle;
    Capsule(const Vector3d& c, const Vector3d& axis, double radius, double half) : middle(c, axis, radius, half) {}

    [[nodiscard]] std::optional<Interval> intersect(const Vector3d& o, const Vector3d& d) const override {
        auto hit = middle.intersect(o, d);
        for (const double end : {-middle.half, middle.half}) {
            const auto other = test::Sphere(middle.center + end * middle.axis, middle.radius).intersect(o, d);
            if (!other) continue;
            if (!hit) hit = other;
            if (other->enter < hit->enter) hit->enter = other->enter, hit->enterNormal = other->enterNormal;
            if (other->leave > hit->leave) hit->leave = other->leave, hit->leaveNormal = other->leaveNormal;
        }
        return hit;
    }
};

/// What of a shape lies above a plane: `point` on it, `up` away from what is cut off.
struct CutOff : test::Shape {
    std::shared_ptr<test::Shape> whole;
    Vector3d point, up;
    CutOff(std::shared_ptr<test::Shape> s, const Vector3d& p, const Vector3d& u)
        : whole(std::move(s)), point(p), up(u) {}

    [[nodiscard]] std::optional<Interval> intersect(const Vector3d& o, const Vector3d& d) const override {
        auto hit = whole->intersect(o, d);
        const double ground = up.dot(point - o) / up.dot(d);
        if (!hit || up.dot(d) >= 0 || ground >= hit->leave) return hit;
        if (ground <= hit->enter) return std::nullopt;
        hit->leave = ground;
        hit->leaveNormal = -up;
        return hit;
    }
};

constexpr std::uint16_t kObject = 2;

/// A table 0.25 m below the eye, seen 20 degrees from above, and a solid on it.
struct Table {
    Eigen::Matrix3d tilt = test::rotation(0.35, {1, 0, 0});
    Vector3d up = -tilt.col(1);
    Vector3d top = Vector3d(0, 0.1, 1.0);  ///< a point of the table top

    [[nodiscard]] test::RayScene with(const std::shared_ptr<test::Shape>& shape) const {
        test::RayScene scene;
        scene.camera = test::testCamera(320, 240);
        scene.objects.push_back(
            {1, std::make_shared<test::Box>(top - 0.05 * up, Vector3d(3, 0.05, 0.8), tilt), {}, false});
        scene.objects.push_back({kObject, shape, {}, false});
        return scene;
    }
};

struct Result {
    core::Photo photo;
    core::Surface truth;
    BackLayer back;

    /// Median |z_back − truth| over the median true thickness.
    [[nodiscard]] float error() const {
        std::vector<float> errors, thickness;
        for (std::size_t i = 0; i < photo.depth.size(); ++i) {
            if (photo.labels[i] != kObject) continue;
            errors.push_back(std::abs(back.surface.depth[i] - truth.depth[i]));
            thickness.push_back(truth.depth[i] - photo.depth[i]);
        }
        std::ranges::sort(errors);
        std::ranges::sort(thickness);
        return errors[errors.size() / 2] / thickness[thickness.size() / 2];
    }
    [[nodiscard]] const core::BackSideInfo& info() const {
        return *std::ranges::find(back.segments, kObject, &core::BackSideInfo::label);
    }
    void expectValid(float minThickness) const {
        for (std::size_t i = 0; i < photo.depth.size(); ++i) {
            if (photo.depth[i] <= 0) continue;
            ASSERT_GE(back.surface.depth[i], photo.depth[i] + minThickness * 0.99f);
            ASSERT_TRUE(std::isfinite(back.surface.depth[i]));
            ASSERT_NEAR(back.surface.normal[i].norm(), 1, 1e-4f);
        }
    }
};

/// Traced once, used for several methods.
struct View {
    core::Photo photo;
    core::Surface front, truth;
    explicit View(const test::RayScene& scene)
        : photo(scene.photograph()), front(scene.frontSurface()), truth(scene.backSurface()) {}
};

Result invent(const View& view, const core::BackSideParams& params = {}) {
    Result result{view.photo, view.truth, {}};
    std::vector<core::Segment> segments(2);
    segments[0].label = 1;
    segments[1].label = kObject;
    for (core::Segment& segment : segments) segment.backSide = params;
    result.back =
        core::analysis::inventBackSide(view.photo.camera, result.photo.labels, view.front, segments, nullptr, 0, {});
    return result;
}

/// Only the labelled pixels of a sphere's picture that `keep` accepts are the object.
Result inventPart(const test::RayScene& scene, const std::function<bool(int, int)>& keep) {
    Result result{scene.photograph(), scene.backSurface(), {}};
    for (int y = 0; y < result.photo.labels.height(); ++y)
        for (int x = 0; x < result.photo.labels.width(); ++x)
            if (result.photo.labels(x, y) == kObject && !keep(x, y)) result.photo.labels(x, y) = 3;
    result.back =
        core::analysis::inventBackSide(scene.camera, result.photo.labels, scene.frontSurface(), {}, nullptr, 0, {});
    return result;
}

const Table kTable;

TEST(BackSideShapes, SphereOnATableIsRounded) {
    const Result result = invent(View(kTable.with(std::make_shared<test::Sphere>(kTable.top + 0.1 * kTable.up, 0.1))));
    EXPECT_EQ(result.info().used, BackSideMethod::SpannedMirror);
    EXPECT_TRUE(result.info().onSupport);
    EXPECT_LT(result.error(), 0.04f);
    result.expectValid(0.002f);
}

TEST(BackSideShapes, EllipsoidIsRoundedWhicheverWayItLies) {
    for (const double angle : {0.0, 0.5, 1.1, 2.0}) {
        const Eigen::Matrix3d axes = test::rotation(angle, {0.3, 1, 0.2});
        test::RayScene scene;
        scene.camera = test::testCamera(320, 240);
        scene.objects.push_back(
            {kObject, std::make_shared<Ellipsoid>(Vector3d(0.1, 0.05, 1), Vector3d(0.15, 0.08, 0.1), axes), {}, false});
        const Result result = invent(View(scene));
        EXPECT_EQ(result.info().used, BackSideMethod::SpannedMirror) << angle;
        EXPECT_LT(result.error(), 0.05f) << angle;
    }
}

TEST(BackSideShapes, CapsuleAndThinRodAreAsDeepAsTheyAreWide) {
    // The thin rod is 8 pixels wide: its outline lies between pixels, which costs it some depth.
    for (const auto& [radius, tolerance] : {std::pair{0.06, 0.12f}, {0.012, 0.35f}}) {
        const Vector3d axis = Vector3d(1, 0.6, 0.4).normalized();
        test::RayScene scene;
        scene.camera = test::testCamera(320, 240);
        scene.objects.push_back({kObject, std::make_shared<Capsule>(Vector3d(0, 0, 1), axis, radius, 0.2), {}, false});
        const Result result = invent(View(scene));
        EXPECT_EQ(result.info().used, BackSideMethod::SpannedMirror) << radius;
        EXPECT_LT(result.error(), tolerance) << radius;
    }
}

TEST(BackSideShapes, BoxesOnATableAreContinuedAtRightAngles) {
    for (const double angle : {0.1, 0.4, 0.785, 1.2}) {
        const Eigen::Matrix3d axes = kTable.tilt * test::rotation(angle, {0, 1, 0});
        const Result result = invent(View(
            kTable.with(std::make_shared<test::Box>(kTable.top + 0.08 * kTable.up, Vector3d(0.1, 0.08, 0.07), axes))));
        EXPECT_EQ(result.info().used, BackSideMethod::FlatFaces) << angle;
        EXPECT_LT(result.info().mirrorError, 0.5f) << angle;
        EXPECT_LT(result.error(), 0.05f) << angle;
        result.expectValid(0.002f);
    }
}

TEST(BackSideShapes, FacesEndAtTheBorderOfTheirLastPixels) {
    test::RayScene scene = kTable.with(std::make_shared<test::Box>(
        kTable.top + 0.08 * kTable.up, Vector3d(0.1, 0.08, 0.07), kTable.tilt * test::rotation(0.5, {0, 1, 0})));
    scene.camera = test::testCamera(160, 120);
    const Result result = invent(View(scene));
    EXPECT_EQ(result.info().used, BackSideMethod::FlatFaces);
    EXPECT_LT(result.error(), 0.03f) << "half a pixel at each end";
}

TEST(BackSideShapes, WhereTheSupportCutsItOffNothingIsPrescribed) {
    // An upright cylinder: its front meets the table facing the camera, and goes on behind that line.
    const Result result =
        invent(View(kTable.with(std::make_shared<Cylinder>(kTable.top + 0.08 * kTable.up, kTable.up, 0.08, 0.08))), [] {
            core::BackSideParams params;
            params.method = BackSideMethod::SpannedMirror;
            return params;
        }());
    EXPECT_LT(result.error(), 0.13f) << "0.18 when the mirror is held at that line";
}

TEST(BackSideShapes, NearItsSupportTheOutlineIsNotHeld) {
    // Bellied, and cut off by the table where they already turn away from the eye: that outline is not the belly's.
    for (const auto& [height, tolerance] : {std::pair{0.5, 0.02f}, {0.7, 0.04f}, {0.8, 0.018f}}) {
        const auto whole =
            std::make_shared<Ellipsoid>(kTable.top + height * 0.1 * kTable.up, Vector3d(0.12, 0.1, 0.12), kTable.tilt);
        const Result result = invent(View(kTable.with(std::make_shared<CutOff>(whole, kTable.top, kTable.up))));
        EXPECT_EQ(result.info().used, BackSideMethod::SpannedMirror) << height;
        EXPECT_LT(result.error(), tolerance) << height << ": 0.058, 0.052, 0.021 when the mirror is held there";
        result.expectValid(0.002f);
    }
}

TEST(BackSideShapes, NothingSinksThroughTheTableByAnyMethod) {
    const test::RayScene scene =
        kTable.with(std::make_shared<Cylinder>(kTable.top + 0.08 * kTable.up, kTable.up, 0.08, 0.08));
    const View view(scene);
    for (const BackSideMethod method :
         {BackSideMethod::Automatic, BackSideMethod::Offset, BackSideMethod::ParallelMirror, BackSideMethod::PcaMirror,
          BackSideMethod::SpannedMirror, BackSideMethod::FlatFaces}) {
        core::BackSideParams params;
        params.method = method;
        params.offset = 0.3f;
        params.thicknessScale = 3;
        const Result result = invent(view, params);
        EXPECT_TRUE(result.info().onSupport);
        int checked = 0;
        for (int y = 0; y < 240; ++y) {
            for (int x = 0; x < 320; ++x) {
                if (result.photo.labels(x, y) != kObject) continue;
                const float z = result.back.surface.depth(x, y);
                // What minThickness demands may stick out.
                if (z < result.photo.depth(x, y) + 0.0021f) continue;
                const Vector3d p = scene.camera.backProject(x, y, z).cast<double>();
                ASSERT_GT((p - kTable.top).dot(kTable.up), -0.001) << static_cast<int>(method);
                ++checked;
            }
        }
        EXPECT_GT(checked, 1000);
    }
}

TEST(BackSideShapes, RoundedBackMeetsTheFrontAtTheOutline) {
    const Result result = invent(View(kTable.with(std::make_shared<test::Sphere>(kTable.top + 0.1 * kTable.up, 0.1))));
    float deepest = 0, atOutline = 0;
    for (int y = 0; y < 240; ++y) {
        for (int x = 0; x < 320; ++x) {
            if (result.photo.labels(x, y) != kObject) continue;
            const float t = result.back.surface.depth(x, y) - result.photo.depth(x, y);
            deepest = std::max(deepest, t);
            const bool edge = result.photo.labels(x - 1, y) != kObject || result.photo.labels(x + 1, y) != kObject;
            if (edge) atOutline = std::max(atOutline, t);
        }
    }
    EXPECT_NEAR(deepest, 0.2f, 0.02f);
    EXPECT_LT(atOutline, 0.3f * deepest);
}

TEST(BackSideShapes, ShiftAndScaleAreHonoured) {
    test::RayScene scene;
    scene.camera = test::testCamera(320, 240);
    scene.objects.push_back({kObject, std::make_shared<test::Sphere>(Vector3d(0, 0, 1), 0.1), {}, false});
    const View view(scene);
    for (const BackSideMethod method :
         {BackSideMethod::SpannedMirror, BackSideMethod::PcaMirror, BackSideMethod::ParallelMirror}) {
        core::BackSideParams params;
        params.method = method;
        const float plain = invent(view, params).back.surface.depth(160, 120);
        params.planeShift = 0.03f;
        const float shifted = invent(view, params).back.surface.depth(160, 120);
        if (method == BackSideMethod::SpannedMirror) {
            // Mirrored in inverse depth: the surface stands where 1/z is half-way.
            const float surface = 2 / (1 / plain + 1 / 0.9f);
            EXPECT_NEAR(shifted, 1 / (2 / (surface + 0.03f) - 1 / 0.9f), 0.002f);
        } else {
            EXPECT_NEAR(shifted, plain + 0.06f, 0.006f);
        }
        params.planeShift = 0;
        params.thicknessScale = 0.5f;
        EXPECT_NEAR(invent(view, params).back.surface.depth(160, 120), 0.5f * (plain + 0.9f), 0.001f);
    }
}

TEST(BackSideShapes, TinyAndOddSegmentsGiveAStatedResult) {
    const test::RayScene scene = kTable.with(std::make_shared<test::Sphere>(kTable.top + 0.1 * kTable.up, 0.1));
    const core::Photo photo = scene.photograph();
    int cx = 0, cy = 0, count = 0;
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x)
            if (photo.labels(x, y) == kObject) {
                cx += x;
                cy += y;
                ++count;
            }
    cx /= count;
    cy /= count;
    const std::vector<std::function<bool(int, int)>> parts{
        [=](int x, int y) { return x == cx && y == cy; },
        [=](int x, int y) { return std::abs(x - cx) + std::abs(y - cy) <= 1; },
        [=](int, int y) { return y == cy; },
        [=](int x, int) { return x == cx; },
        [=](int x, int y) { return (x + y) % 2 == 0; },
        [=](int x, int) { return std::abs(x - cx) > 10; },
    };
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Result result = inventPart(scene, parts[i]);
        result.expectValid(0.002f);
        const core::BackSideInfo& info = result.info();
        if (i < 2) {
            EXPECT_EQ(info.used, BackSideMethod::Offset);
            EXPECT_NE(info.note, "");
        }
        EXPECT_GE(info.mirrorError, 0);
        EXPECT_LE(info.mirrorError, 1);
    }
}

TEST(BackSideShapes, NoDepthNoBack) {
    core::Photo photo = kTable.with(std::make_shared<test::Sphere>(kTable.top, 0.1)).photograph();
    core::Surface front;
    front.depth = core::ImageF(320, 240);
    front.area = front.depth;
    front.normal = front.position = core::ImageV3(320, 240);
    front.color = photo.color;
    const BackLayer back = core::analysis::inventBackSide(photo.camera, photo.labels, front, {}, nullptr, 0, {});
    EXPECT_TRUE(back.segments.empty());
    EXPECT_TRUE(std::ranges::all_of(back.surface.depth.pixels(), [](float z) { return z == 0; }));
}

TEST(BackSideShapes, SupportPlaneIsTheTableTop) {
    const test::RayScene scene = kTable.with(std::make_shared<test::Sphere>(kTable.top + 0.1 * kTable.up, 0.1));
    const core::Photo photo = scene.photograph();
    const core::Surface front = scene.frontSurface();
    const std::vector<bool> supports = core::analysis::findSupports(photo.labels);
    core::analysis::SegmentPixels segment{scene.camera, photo.labels, front, supports, kObject, {}, {}};
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x)
            if (segment.contains(x, y)) {
                segment.pixels.push_back({x, y});
                segment.box.add({x, y});
            }
    const auto plane = core::analysis::fitSupportPlane(segment);
    ASSERT_TRUE(plane);
    EXPECT_GT(plane->normal.dot(-kTable.up.cast<float>()), 0.9999f);
    EXPECT_NEAR(plane->offset, -kTable.top.dot(kTable.up), 1e-3);
}

}  // namespace
