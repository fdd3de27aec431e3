// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <tuple>

namespace render {

/// Something made of objects of the device, such as a bind group. Remembers what it was made of, and is made again when
/// that differs.
template <class Made, class... From>
class Bound {
  public:
    /// `make(from...)`, or its last result while `from` stays the same.
    template <class Make>
    const Made& of(const Make& make, const From&... from) {
        if (!from_ || *from_ != std::tie(from...)) {
            made_ = make(from...);
            from_.emplace(from...);
        }
        return made_;
    }

  private:
    Made made_;
    std::optional<std::tuple<From...>> from_;
};

}  // namespace render
