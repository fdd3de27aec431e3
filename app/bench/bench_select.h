// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/bench/bench.h"

namespace render {

/// Times of selecting in the photograph, and in the same one enlarged to 12 megapixels: preparation once, and the
/// median and the slowest of clicks on a grid. Throws Error(Cancelled).
[[nodiscard]] std::vector<BenchResult> benchSelection(const core::Photo& photo, const core::Progress& progress);

}  // namespace render
