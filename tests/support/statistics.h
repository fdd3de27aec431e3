// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace test {

/// Regularised upper incomplete gamma function Q(a, x), by series or continued fraction.
inline double gammaQ(double a, double x) {
    if (x <= 0) return 1;
    const double front = std::exp(-x + a * std::log(x) - std::lgamma(a));
    if (x < a + 1) {
        double term = 1 / a;
        double sum = term;
        for (int n = 1; n < 10000 && term > sum * 1e-15; ++n) sum += term *= x / (a + n);
        return 1 - front * sum;
    }
    double b = x + 1 - a;
    double c = 1e300;
    double d = 1 / b;
    double h = d;
    for (int i = 1; i < 10000; ++i) {
        const double an = -i * (i - a);
        b += 2;
        d = 1 / (an * d + b);
        c = b + an / c;
        h *= d * c;
        if (std::abs(d * c - 1) < 1e-15) break;
    }
    return front * h;
}

/// p-value of Pearson's chi² test of counts against expected counts; bins expecting fewer than 5 are pooled. Returns 0
/// for counts in bins that expect (numerically) nothing.
inline double chiSquareP(std::vector<double> observed, const std::vector<double>& expected) {
    double pooledObserved = 0;
    double pooledExpected = 0;
    double statistic = 0;
    int bins = 0;
    const auto add = [&](double o, double e) {
        statistic += (o - e) * (o - e) / e;
        ++bins;
    };
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] >= 5) {
            add(observed[i], expected[i]);
        } else {
            pooledObserved += observed[i];
            pooledExpected += std::max(expected[i], 0.0);
        }
    }
    if (pooledExpected >= 5) {
        add(pooledObserved, pooledExpected);
    } else if (pooledObserved > pooledExpected + 25) {
        return 0;
    }
    return bins < 2 ? 1 : gammaQ(0.5 * (bins - 1), 0.5 * statistic);
}

/// Significance of each of `tests` tests if one of them may fail by chance with probability `total` (Šidák).
inline double sidak(double total, int tests) { return 1 - std::pow(1 - total, 1.0 / tests); }

/// Integral of `f(u, v)` over a rectangle: 3 × 3 Gauss-Legendre, refined where a quarter disagrees with the whole.
/// `mustSplit(u0, u1, v0, v1)` forces refinement around a known narrow peak, by 10 halvings at most.
template <class F, class S>
double integrate(const F& f, double u0, double u1, double v0, double v1, const S& mustSplit, double tolerance,
                 int depth = 0) {
    static constexpr std::array<double, 3> kNode{-0.774596669241483377, 0, 0.774596669241483377};
    static constexpr std::array<double, 3> kWeight{5.0 / 18, 8.0 / 18, 5.0 / 18};
    const auto rule = [&](double a, double b, double c, double d) {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                sum += kWeight[i] * kWeight[j] *
                       f(0.5 * (a + b) + 0.5 * (b - a) * kNode[i], 0.5 * (c + d) + 0.5 * (d - c) * kNode[j]);
        return sum * (b - a) * (d - c);
    };
    const double um = 0.5 * (u0 + u1);
    const double vm = 0.5 * (v0 + v1);
    const double whole = rule(u0, u1, v0, v1);
    const double parts = rule(u0, um, v0, vm) + rule(um, u1, v0, vm) + rule(u0, um, vm, v1) + rule(um, u1, vm, v1);
    const bool split = depth < 10 && (std::abs(parts - whole) > tolerance || mustSplit(u0, u1, v0, v1));
    if (!split) return parts;
    return integrate(f, u0, um, v0, vm, mustSplit, tolerance / 2, depth + 1) +
           integrate(f, um, u1, v0, vm, mustSplit, tolerance / 2, depth + 1) +
           integrate(f, u0, um, vm, v1, mustSplit, tolerance / 2, depth + 1) +
           integrate(f, um, u1, vm, v1, mustSplit, tolerance / 2, depth + 1);
}

}  // namespace test
