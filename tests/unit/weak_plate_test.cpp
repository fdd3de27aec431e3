// SPDX-License-Identifier: GPL-3.0-or-later
// The plate's solver against a dense solution in double precision, and what it must leave alone.
#include "core/analysis/depth/weak_plate.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

namespace {

using core::Progress;
using core::analysis::WeakPlate;

constexpr int kWidth = 17;
constexpr int kHeight = 13;

/// An L-shaped plate.
bool isPlateCell(int x, int y) { return x >= 0 && y >= 0 && x < kWidth && y < kHeight && (x < 8 || y > 5); }

double uneven(int x, int y) { return 1 + 0.3 * std::sin(0.7 * x) * std::cos(0.5 * y); }

struct Cells {
    std::vector<double> data, trust, stiffness;
};

Cells randomCells() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(0, 1);
    Cells cells;
    for (int i = 0; i < kWidth * kHeight; ++i) {
        cells.data.push_back(any(random));
        cells.trust.push_back(any(random) < 0.3 ? 0.0 : any(random));
        cells.stiffness.push_back(0.05 + any(random));
    }
    return cells;
}

/// The energy's minimum by Cholesky's decomposition of all cells at once.
Eigen::VectorXd denseMinimum(const Cells& cells, double length) {
    const int count = kWidth * kHeight;
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    const double factor = std::pow(length, 4);
    const auto at = [](int x, int y) { return y * kWidth + x; };
    const auto stiffness = [&](int x, int y) { return cells.stiffness[static_cast<std::size_t>(at(x, y))]; };
    struct Term {
        int dx, dy;
        double weight;
    };
    const auto addDifference = [&](int x, int y, const std::vector<Term>& terms, double weight) {
        for (const Term& t : terms)
            if (!isPlateCell(x + t.dx, y + t.dy)) return;
        for (const Term& s : terms)
            for (const Term& t : terms)
                a(at(x + s.dx, y + s.dy), at(x + t.dx, y + t.dy)) += weight * s.weight * t.weight;
    };
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const int i = at(x, y);
            if (!isPlateCell(x, y)) {
                a(i, i) = 1;
                continue;
            }
            a(i, i) += cells.trust[static_cast<std::size_t>(i)];
            right(i) = cells.trust[static_cast<std::size_t>(i)] * cells.data[static_cast<std::size_t>(i)];
            addDifference(x, y, {{-1, 0, 1}, {0, 0, -2}, {1, 0, 1}}, factor * stiffness(x, y));
            addDifference(x, y, {{0, -1, 1}, {0, 0, -2}, {0, 1, 1}}, factor * stiffness(x, y));
            double least = stiffness(x, y);
            for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}})
                if (isPlateCell(x + dx, y + dy)) least = std::min(least, stiffness(x + dx, y + dy));
            addDifference(x, y, {{0, 0, 1}, {1, 0, -1}, {0, 1, -1}, {1, 1, 1}}, 2 * factor * least);
        }
    }
    return a.ldlt().solve(right);
}

WeakPlate plateOf(const Cells& cells, double length) {
    WeakPlate plate(kWidth, kHeight, length);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (!isPlateCell(x, y)) continue;
            const auto i = static_cast<std::size_t>(y * kWidth + x);
            plate.setCell(x, y, cells.data[i], cells.trust[i]);
            plate.setStiffness(plate.at(x, y), cells.stiffness[i]);
        }
    }
    return plate;
}

TEST(WeakPlate, RelaxesToTheLeastEnergy) {
    const Cells cells = randomCells();
    for (const double length : {0.7, 2.0, 4.0}) {
        WeakPlate plate = plateOf(cells, length);
        plate.relax(3000, Progress());
        const Eigen::VectorXd truth = denseMinimum(cells, length);
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                if (isPlateCell(x, y)) {
                    ASSERT_NEAR(plate.value(plate.at(x, y)), truth(y * kWidth + x), 1e-6)
                        << length << ": " << x << ", " << y;
                }
    }
}

TEST(WeakPlate, APlaneStaysOnAllLevels) {
    const auto plane = [](double x, double y) { return 1 + 0.02 * x - 0.03 * y; };
    WeakPlate fine(40, 32, 8);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 40; ++x)
            if (x < 20 || y > 10) fine.setCell(x, y, plane(x, y), (x + y) % 3 == 0 ? 0.0 : 1.0);
    WeakPlate coarse = fine.coarser();
    coarse.relax(400, Progress());
    fine.prolongFrom(coarse);
    fine.relax(400, Progress());
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 40; ++x)
            if (x < 20 || y > 10) {
                ASSERT_NEAR(fine.value(fine.at(x, y)), plane(x, y), 1e-3) << x << ", " << y;
            }
}

TEST(WeakPlate, IsTheSameOnAnyNumberOfThreads) {
    const auto relaxed = [](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        WeakPlate plate(90, 120, 5);
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 90; ++x) plate.setCell(x, y, uneven(x, y), 1);
        plate.relax(40, Progress());
        std::vector<double> values;
        for (std::size_t i = 0; i < plate.cellCount(); ++i) values.push_back(plate.value(i));
        return values;
    };
    EXPECT_EQ(relaxed(1), relaxed(4));
}

}  // namespace
