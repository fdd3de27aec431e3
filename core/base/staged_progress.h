// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/base/progress.h"

namespace core {

/// Divides a progress among consecutive stages in proportion to their costs, in any unit, so that the fraction that is
/// reported follows time.
class StagedProgress {
  public:
    /// `cost`: estimate for all stages together.
    StagedProgress(const Progress& whole, double cost) : rest_(whole), remaining_(cost) {}

    /// Replaces the estimate for all stages to come, when more is known about them.
    void setRemaining(double cost) { remaining_ = cost; }

    /// The progress of the next stage, which begins where the one before it ends.
    [[nodiscard]] Progress next(double cost) {
        const float share = remaining_ > cost ? static_cast<float>(cost / remaining_) : 1.0f;
        remaining_ = std::max(remaining_ - cost, 0.0);
        Progress stage = rest_.part(0, share);
        rest_ = rest_.part(share, 1);
        return stage;
    }

  private:
    Progress rest_;
    double remaining_;
};

}  // namespace core
