// SPDX-License-Identifier: GPL-3.0-or-later
// Where a table is taken to go on beyond what is seen of it, against one whose extent is known.
#include "core/analysis/segment/continued_supports.h"

#include <gtest/gtest.h>

#include "tests/support/ray_scene.h"

namespace {

using core::Vector3f;
using core::analysis::ContinuedSupports;

/// Floor, sphere and box; the floor ends within the picture behind, and beyond it at the sides.
struct ContinuedFloor : testing::Test {
    test::RayScene truth = test::stillLife(test::testCamera(320, 240));
    core::Photo photo = truth.photograph();
    core::Surface front = truth.frontSurface();
    ContinuedSupports continued{truth.camera, photo.labels, front};
    Vector3f down = test::rotation(0.5, {1, 0, 0}).col(1).cast<float>();
    Vector3f above = Vector3f(0, 0.05f, 1) - 0.2f * down;  ///< a point over the floor
    Vector3f side{1, 0, 0};
};

TEST_F(ContinuedFloor, GoesOnBesideThePictureButNotForEver) {
    EXPECT_TRUE(continued.meets(above, down + 4 * side));
    EXPECT_TRUE(continued.meets(above, down - 4 * side));
    EXPECT_FALSE(continued.meets(above, down + 100 * side));
}

TEST_F(ContinuedFloor, GoesOnBehindWhatStandsOnIt) {
    // From a point beside the box to the floor that the box hides.
    const Vector3f box = Vector3f(0.2f, 0.05f, 1);
    const Vector3f hidden = box + 0.07f * box.normalized();
    const Vector3f foot = hidden + down * down.dot(Vector3f(0, 0.05f, 1) - hidden);
    const Vector3f from = foot + 0.2f * side - 0.1f * down;
    EXPECT_TRUE(continued.meets(from, foot - from));
}

TEST_F(ContinuedFloor, EndsWhereThePictureShowsItsEnd) {
    // Beyond the floor's far edge, where the picture shows the distance.
    const Vector3f along = down.cross(side).z() > 0 ? down.cross(side) : Vector3f(-down.cross(side));
    const Vector3f beyond = Vector3f(-0.5f, 0.05f, 1) + 0.5f * along;
    const core::Vector2f pixel = truth.camera.project(beyond);
    ASSERT_EQ(front.depth(static_cast<int>(pixel.x()), static_cast<int>(pixel.y())), 0);
    EXPECT_FALSE(continued.meets(above, beyond - above));
}

TEST_F(ContinuedFloor, IsMetFromAboveOnly) {
    EXPECT_FALSE(continued.meets(above, -down));
    EXPECT_FALSE(continued.meets(above, side));
    EXPECT_FALSE(continued.meets(above + 0.4f * down, down + 4 * side));
    EXPECT_FALSE(continued.meets(above + 0.4f * down, -down + 4 * side));
}

TEST(ContinuedSupports, WithoutASupportNothingIsMet) {
    test::RayScene truth = test::stillLife(test::testCamera(160, 120));
    truth.objects.erase(truth.objects.begin());
    const core::Photo photo = truth.photograph();
    const core::Surface front = truth.frontSurface();
    const ContinuedSupports continued(truth.camera, photo.labels, front);
    EXPECT_FALSE(continued.meets(Vector3f(0, 0, 1), Vector3f(0, 1, 0)));
}

}  // namespace
