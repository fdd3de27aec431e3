// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "app/bench/bench.h"
#include "core/analysis/analysis.h"
#include "core/base/progress.h"
#include "core/scene/scene.h"
#include "gpu/device.h"

namespace render {

/// The benchmark "translucency" on `scene`, whose one edited segment is translucent. For 10k, 40k and 160k samples:
/// seconds and pairs (sources evaluated) of a sum over all samples onto all pixels; rms_error and max_error (relative,
/// of the device's sum against a sum of all pairs in double precision, over a subset of pixels and all channels). Sums
/// of all pairs on the device (brute_*.10k), the time from a changed scattering parameter to the complete picture
/// (update_seconds.40k), and the exponents with which pairs and seconds grow with samples.
[[nodiscard]] std::vector<BenchResult> benchTranslucency(const gpu::Device& device, const core::Scene& scene,
                                                         const std::shared_ptr<const core::Analysis>& analysis,
                                                         const core::Progress& progress);

}  // namespace render
