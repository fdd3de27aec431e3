// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/error.h"

namespace core {

using Eigen::Vector2f;
using Eigen::Vector3f;

/// Initial value of pixels: zero, also for Eigen types, whose default constructor leaves them uninitialised.
template <class T>
[[nodiscard]] T zeroPixel() {
    if constexpr (requires { T::Zero(); })
        return T::Zero();
    else
        return T{};
}

/// Row-major pixels, row 0 at the top. Pixel (x, y) covers [x, x+1) × [y, y+1); its centre is (x+0.5, y+0.5).
template <class T>
class Image {
  public:
    Image() = default;
    Image(int width, int height, const T& value = zeroPixel<T>())
        : width_(width),
          height_(height),
          pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value) {}

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] bool empty() const { return pixels_.empty(); }
    [[nodiscard]] std::size_t size() const { return pixels_.size(); }
    [[nodiscard]] bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
    template <class Other>
    [[nodiscard]] bool sameSize(const Other& other) const {
        return width_ == other.width() && height_ == other.height();
    }

    [[nodiscard]] std::size_t index(int x, int y) const {
        CORE_ASSERT(contains(x, y), "pixel outside the image");
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    T& operator()(int x, int y) { return pixels_[index(x, y)]; }
    const T& operator()(int x, int y) const { return pixels_[index(x, y)]; }
    T& operator[](std::size_t i) { return pixels_[i]; }
    const T& operator[](std::size_t i) const { return pixels_[i]; }

    [[nodiscard]] std::span<T> pixels() { return pixels_; }
    [[nodiscard]] std::span<const T> pixels() const { return pixels_; }
    [[nodiscard]] T* data() { return pixels_.data(); }
    [[nodiscard]] const T* data() const { return pixels_.data(); }

    bool operator==(const Image&) const = default;

  private:
    int width_ = 0;
    int height_ = 0;
    std::vector<T> pixels_;
};

using ImageF = Image<float>;
using ImageRgb = Image<Vector3f>;         ///< scene-linear, Rec.709 primaries
using ImageV3 = Image<Vector3f>;          ///< positions or normals, camera frame
using LabelImage = Image<std::uint16_t>;  ///< 0 = no segment

}  // namespace core
