// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/pixel.h"
#include "core/base/progress.h"
#include "core/selection/selection_picture.h"

namespace core {

/// What the user pointed at, in pixels of the photograph.
struct SelectionSeeds {
    std::vector<Pixel> add;     ///< on the object
    std::vector<Pixel> remove;  ///< not on it
};

/// Selects objects in one photograph (docs/method.md#selection). Built once; then every selection takes milliseconds.
/// Immutable: copies are cheap and may be used from any thread. Results do not depend on the number of threads.
class Selector {
  public:
    /// Throws Error(Cancelled).
    explicit Selector(const SelectionInput& input, const Progress& progress = {});

    /// The object under the seeds, a mask of the photograph's size; empty selection without `add`. A pixel of `add` is
    /// selected, one of `remove` is not. Throws Error(Usage) for a seed outside the photograph and for a pixel that is
    /// both added and removed, and Error(Cancelled).
    [[nodiscard]] BinaryMask select(const SelectionSeeds& seeds, const Progress& progress = {}) const;
    /// Objects that stand on support planes, labelled from 1 in decreasing size; 0 elsewhere. None without depth.
    /// Throws Error(Cancelled).
    [[nodiscard]] LabelImage propose(const Progress& progress = {}) const;

    /// `mask`, of the photograph's size, with its outline moved to where the colour changes, by at most `radius`
    /// pixels, 1 or more. Throws Error(Cancelled).
    [[nodiscard]] BinaryMask refine(const BinaryMask& mask, int radius, const Progress& progress = {}) const;

    [[nodiscard]] int width() const;
    [[nodiscard]] int height() const;

    struct State;
    [[nodiscard]] const State& state() const { return *state_; }

  private:
    std::shared_ptr<const State> state_;
};

}  // namespace core
