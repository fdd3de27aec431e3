// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/membrane.h"

#include <gtest/gtest.h>

namespace {

using core::analysis::MembraneCell;

/// Held at 0 on the left and at 1 on the right.
core::Image<MembraneCell> heldOnBothSides() {
    core::Image<MembraneCell> cells(33, 33, {0, MembraneCell::Kind::Free});
    for (int y = 0; y < cells.height(); ++y) {
        cells(0, y) = {0, MembraneCell::Kind::Fixed};
        cells(32, y) = {1, MembraneCell::Kind::Fixed};
    }
    return cells;
}

TEST(Membrane, HangsBetweenWhatIsFixed) {
    core::Image<MembraneCell> cells = heldOnBothSides();
    core::analysis::solveMembrane(cells, {});
    for (int y = 0; y < cells.height(); ++y)
        for (int x = 0; x < cells.width(); ++x)
            ASSERT_NEAR(cells(x, y).value, static_cast<float>(x) / 32, 0.03f) << x << ", " << y;
}

TEST(Membrane, IsHeldDownByABoundItWouldExceedAndByNoOther) {
    core::Image<MembraneCell> cells = heldOnBothSides();
    for (int y = 0; y < cells.height(); ++y) {
        cells(16, y).most = 0.1f;
        cells(24, y).most = 0.9f;
    }
    core::analysis::solveMembrane(cells, {});
    for (int y = 0; y < cells.height(); ++y) {
        for (int x = 0; x < cells.width(); ++x) {
            const auto u = static_cast<float>(x);
            const float expected = x <= 16 ? 0.1f * u / 16 : 0.1f + 0.9f * (u - 16) / 16;
            ASSERT_NEAR(cells(x, y).value, expected, 0.03f) << x << ", " << y;
            ASSERT_LE(cells(x, y).value, cells(x, y).most);
        }
    }
}

}  // namespace
