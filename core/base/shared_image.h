// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

#include "core/base/image.h"

namespace core {

/// An image whose copies share their pixels until one of them is written to.
template <class T>
class SharedImage {
  public:
    SharedImage() = default;
    SharedImage(Image<T> image) : image_(std::make_shared<Image<T>>(std::move(image))) {}

    operator const Image<T>&() const { return *image_; }
    [[nodiscard]] const Image<T>& image() const { return *image_; }

    [[nodiscard]] int width() const { return image_->width(); }
    [[nodiscard]] int height() const { return image_->height(); }
    [[nodiscard]] bool empty() const { return image_->empty(); }
    [[nodiscard]] std::size_t size() const { return image_->size(); }
    [[nodiscard]] bool contains(int x, int y) const { return image_->contains(x, y); }
    template <class Other>
    [[nodiscard]] bool sameSize(const Other& other) const {
        return image_->sameSize(other);
    }
    [[nodiscard]] std::size_t index(int x, int y) const { return image_->index(x, y); }

    const T& operator()(int x, int y) const { return std::as_const(*image_)(x, y); }
    const T& operator[](std::size_t i) const { return std::as_const(*image_)[i]; }
    [[nodiscard]] std::span<const T> pixels() const { return std::as_const(*image_).pixels(); }
    [[nodiscard]] const T* data() const { return std::as_const(*image_).data(); }

    T& operator()(int x, int y) { return own()(x, y); }
    T& operator[](std::size_t i) { return own()[i]; }
    [[nodiscard]] std::span<T> pixels() { return own().pixels(); }

    /// Whether both have the same pixels in memory, not only equal ones.
    [[nodiscard]] bool shares(const SharedImage& other) const { return image_ == other.image_; }

  private:
    Image<T>& own() {
        if (image_.use_count() > 1) image_ = std::make_shared<Image<T>>(*image_);
        return *image_;
    }

    std::shared_ptr<Image<T>> image_ = std::make_shared<Image<T>>();
};

}  // namespace core
