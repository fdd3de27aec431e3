// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/depth/weak_plate.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace core::analysis {
namespace {

double squareOf(double x) { return x * x; }

/// Calls `body(first, last)` with the range of cells of every row.
template <class Body>
void forPlateRows(const WeakPlate& plate, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<int>(0, plate.height(), 16), [&](const tbb::blocked_range<int>& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y) body(plate.at(0, y), plate.at(plate.width(), y));
    });
}

/// Σ a b over the plate, in an order that does not depend on the threads; both are 0 outside.
double dotProduct(const WeakPlate& plate, const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> rows(static_cast<std::size_t>(plate.height()), 0);
    forPlateRows(plate, [&](std::size_t first, std::size_t last) {
        double sum = 0;
        for (std::size_t i = first; i < last; ++i) sum += a[i] * b[i];
        rows[first / plate.stride() - plate.at(0, 0) / plate.stride()] = sum;
    });
    double sum = 0;
    for (const double row : rows) sum += row;
    return sum;
}

}  // namespace

WeakPlate::WeakPlate(int width, int height, double length)
    : width_(width), height_(height), stride_(width + 2 * kBorder), length_(length) {
    const std::size_t count = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height + 2 * kBorder);
    inside_.assign(count, 0);
    trust_.assign(count, 0);
    data_.assign(count, 0);
    stiffness_.assign(count, 1);
    value_.assign(count, 0);
}

void WeakPlate::setCell(int x, int y, double data, double trust) {
    const std::size_t i = at(x, y);
    inside_[i] = 1;
    data_[i] = value_[i] = data;
    trust_[i] = trust;
    stiffness_[i] = 1;
}

WeakPlate WeakPlate::coarser() const {
    WeakPlate coarse((width_ + 1) / 2, (height_ + 1) / 2, length_ / 2);
    coarse.restrictFrom(*this);
    return coarse;
}

void WeakPlate::restrictFrom(const WeakPlate& fine) {
    tbb::parallel_for(0, height_, [&](int y) {
        for (int x = 0; x < width_; ++x) {
            double trust = 0, data = 0, all = 0, stiffness = 0;
            int count = 0;
            for (int k = 0; k < 4; ++k) {
                const std::size_t i = fine.at(2 * x + (k & 1), 2 * y + (k >> 1));
                if (fine.inside_[i] == 0) continue;
                trust += fine.trust_[i];
                data += fine.trust_[i] * fine.data_[i];
                all += fine.data_[i];
                stiffness += fine.stiffness_[i];
                ++count;
            }
            if (count == 0) continue;
            setCell(x, y, trust > 0 ? data / trust : all / count, trust / 4);
            stiffness_[at(x, y)] = stiffness / count;
        }
    });
}

std::vector<double> WeakPlate::continuedValues() const {
    std::vector<double> values = value_;
    const std::ptrdiff_t row = stride_;
    const std::array<std::ptrdiff_t, 8> steps{-1, 1, -row, row, -row - 1, -row + 1, row - 1, row + 1};
    for (int y = -1; y <= height_; ++y) {
        for (int x = -1; x <= width_; ++x) {
            const std::size_t i = at(x, y);
            if (inside_[i] != 0) continue;
            const std::uint8_t* const in = inside_.data() + i;
            const double* const v = value_.data() + i;
            double lines = 0, points = 0;
            int lineCount = 0, pointCount = 0;
            for (const std::ptrdiff_t step : steps) {
                if (in[step] == 0) continue;
                points += v[step], ++pointCount;
                if (in[2 * step] != 0) lines += 2 * v[step] - v[2 * step], ++lineCount;
            }
            if (pointCount > 0) values[i] = lineCount > 0 ? lines / lineCount : points / pointCount;
        }
    }
    return values;
}

void WeakPlate::prolongFrom(const WeakPlate& coarse) {
    const std::vector<double> values = coarse.continuedValues();
    tbb::parallel_for(0, height_, [&](int y) {
        for (int x = 0; x < width_; ++x) {
            const std::size_t i = at(x, y);
            if (inside_[i] == 0) continue;
            const std::size_t c = coarse.at((x + 1) / 2 - 1, (y + 1) / 2 - 1);
            const double fx = (x & 1) != 0 ? 0.25 : 0.75;
            const double fy = (y & 1) != 0 ? 0.25 : 0.75;
            const auto inRow = [&](std::size_t left) { return (1 - fx) * values[left] + fx * values[left + 1]; };
            value_[i] = (1 - fy) * inRow(c) + fy * inRow(c + coarse.stride());
        }
    });
}

double WeakPlate::bend(const std::vector<double>& of, std::size_t cell) const {
    const std::ptrdiff_t row = stride_;
    const double* const v = of.data() + cell;
    const std::uint8_t* const in = inside_.data() + cell;
    double squared = 0;
    if (in[-1] != 0 && in[1] != 0) squared += squareOf(v[-1] - 2 * v[0] + v[1]);
    if (in[-row] != 0 && in[row] != 0) squared += squareOf(v[-row] - 2 * v[0] + v[row]);
    if (in[1] != 0 && in[row] != 0 && in[row + 1] != 0) squared += 2 * squareOf(v[0] - v[1] - v[row] + v[row + 1]);
    return std::sqrt(squared);
}

void WeakPlate::prepareOperator() {
    for (auto* const field : {&stiffX_, &stiffY_, &stiffXY_, &momentX_, &momentY_, &momentXY_})
        field->assign(inside_.size(), 0);
    const std::ptrdiff_t row = stride_;
    const double factor = squareOf(squareOf(length_));
    forPlateRows(*this, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const std::uint8_t* const in = inside_.data() + i;
            if (in[0] == 0) continue;
            const double* const b = stiffness_.data() + i;
            if (in[-1] != 0 && in[1] != 0) stiffX_[i] = factor * b[0];
            if (in[-row] != 0 && in[row] != 0) stiffY_[i] = factor * b[0];
            if (in[1] != 0 && in[row] != 0 && in[row + 1] != 0)
                stiffXY_[i] = 2 * factor * std::min(std::min(b[0], b[1]), std::min(b[row], b[row + 1]));
        }
    });
}

double WeakPlate::diagonal(std::size_t cell) const {
    const std::size_t row = stride();
    return trust_[cell] + 4 * stiffX_[cell] + stiffX_[cell - 1] + stiffX_[cell + 1] + 4 * stiffY_[cell] +
           stiffY_[cell - row] + stiffY_[cell + row] + stiffXY_[cell] + stiffXY_[cell - 1] + stiffXY_[cell - row] +
           stiffXY_[cell - row - 1];
}

void WeakPlate::apply(const std::vector<double>& of, std::vector<double>& image) {
    const std::ptrdiff_t row = stride_;
    forPlateRows(*this, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const double* const v = of.data() + i;
            momentX_[i] = stiffX_[i] * (v[-1] - 2 * v[0] + v[1]);
            momentY_[i] = stiffY_[i] * (v[-row] - 2 * v[0] + v[row]);
            momentXY_[i] = stiffXY_[i] * (v[0] - v[1] - v[row] + v[row + 1]);
        }
    });
    forPlateRows(*this, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const double* const mx = momentX_.data() + i;
            const double* const my = momentY_.data() + i;
            const double* const m = momentXY_.data() + i;
            image[i] = trust_[i] * of[i] + mx[-1] - 2 * mx[0] + mx[1] + my[-row] - 2 * my[0] + my[row] + m[0] - m[-1] -
                       m[-row] + m[-row - 1];
        }
    });
}

void WeakPlate::relax(int iterations, const Progress& progress) {
    prepareOperator();
    const std::size_t count = inside_.size();
    std::vector<double> residual(count, 0), scaled(count, 0), direction(count, 0), image(count, 0), inverse(count, 0);
    apply(value_, image);
    forPlateRows(*this, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (inside_[i] == 0) continue;
            inverse[i] = 1 / std::max(diagonal(i), 1e-12);
            residual[i] = trust_[i] * data_[i] - image[i];
            direction[i] = scaled[i] = inverse[i] * residual[i];
        }
    });
    double before = dotProduct(*this, residual, scaled);
    for (int iteration = 0; iteration < iterations && before > 0; ++iteration) {
        progress.checkpoint(static_cast<float>(iteration) / static_cast<float>(iterations));
        apply(direction, image);
        const double curvature = dotProduct(*this, direction, image);
        if (!(curvature > 0)) return;
        const double step = before / curvature;
        forPlateRows(*this, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                value_[i] += step * direction[i];
                residual[i] -= step * image[i];
                scaled[i] = inverse[i] * residual[i];
            }
        });
        const double now = dotProduct(*this, residual, scaled);
        const double keep = now / before;
        before = now;
        forPlateRows(*this, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) direction[i] = scaled[i] + keep * direction[i];
        });
    }
}

}  // namespace core::analysis
