// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"

namespace core::analysis {

/// A thin plate on a grid of cells, some of them outside: the values v that minimise
/// Σ trust (v − data)² + length⁴ Σ stiffness (v_xx² + 2 v_xy² + v_yy²). No second difference reaches outside, so the
/// plate is free at its edge and a plane of any tilt costs nothing. One of a series of levels, each of half the
/// resolution of the previous one.
class WeakPlate {
  public:
    /// `length` [cells]: structures narrower than this cost more to follow than to ignore.
    WeakPlate(int width, int height, double length);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] double length() const { return length_; }
    /// Index of a cell; x from −2 to width + 1, y from −2 to height + 1: a border of outside cells.
    [[nodiscard]] std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y + kBorder) * static_cast<std::size_t>(stride_) +
               static_cast<std::size_t>(x + kBorder);
    }
    [[nodiscard]] bool inside(std::size_t cell) const { return inside_[cell] != 0; }
    [[nodiscard]] std::size_t cellCount() const { return inside_.size(); }
    [[nodiscard]] std::size_t stride() const { return static_cast<std::size_t>(stride_); }

    /// Makes a cell part of the plate, with stiffness 1; `trust` 0 = nothing was measured there.
    void setCell(int x, int y, double data, double trust);
    [[nodiscard]] double data(std::size_t cell) const { return data_[cell]; }
    [[nodiscard]] double value(std::size_t cell) const { return value_[cell]; }
    [[nodiscard]] const std::vector<double>& trust() const { return trust_; }
    void setTrust(std::size_t cell, double trust) { trust_[cell] = trust; }
    void setStiffness(std::size_t cell, double stiffness) { stiffness_[cell] = stiffness; }

    [[nodiscard]] WeakPlate coarser() const;
    /// Sets data, trust and stiffness to means over 2×2 cells of `fine`; data weighted by their trust.
    void restrictFrom(const WeakPlate& fine);
    /// Interpolates the values of `coarse` bilinearly, extrapolated linearly beyond its cells.
    void prolongFrom(const WeakPlate& coarse);
    /// Conjugate gradients from the current values towards those of least energy. The same on any number of threads.
    /// Cancellable.
    void relax(int iterations, const Progress& progress);

    /// √(v_xx² + 2 v_xy² + v_yy²) about a cell, of values or data.
    [[nodiscard]] double bendOfValues(std::size_t cell) const { return bend(value_, cell); }
    [[nodiscard]] double bendOfData(std::size_t cell) const { return bend(data_, cell); }

  private:
    static constexpr int kBorder = 2;

    [[nodiscard]] double bend(const std::vector<double>& of, std::size_t cell) const;
    [[nodiscard]] std::vector<double> continuedValues() const;
    void prepareOperator();
    [[nodiscard]] double diagonal(std::size_t cell) const;
    /// image = half of the energy's gradient at the values `of`, without its constant part.
    void apply(const std::vector<double>& of, std::vector<double>& image);

    int width_, height_, stride_;
    double length_;
    std::vector<std::uint8_t> inside_;
    std::vector<double> trust_, data_, stiffness_, value_;
    // Used while relaxing: length⁴ stiffness of each second difference, 0 where it reaches outside, and moments.
    std::vector<double> stiffX_, stiffY_, stiffXY_, momentX_, momentY_, momentXY_;
};

}  // namespace core::analysis
