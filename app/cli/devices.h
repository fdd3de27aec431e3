// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/cli/session.h"
#include "core/analysis/analysis.h"
#include "core/analysis/kernels.h"
#include "core/scene/scene.h"
#include "gpu/device.h"

namespace cli {

/// The device the user asked for, or the best there is; says on stderr which it took. Throws gpu::Error(NoAdapter).
[[nodiscard]] gpu::Device openDevice(const Session& session);

/// Kernels for the expensive parts of the analysis, by --analysis, otherwise by PATINA_ANALYSIS, otherwise automatic;
/// nullptr = the CPU.
/// Throws core::Error(Usage) for an unknown wish, gpu::Error when the GPU is asked for and there is none.
[[nodiscard]] std::unique_ptr<core::AnalysisKernels> openAnalysisKernels(const Session& session);
/// The scene's analysis; prints what went otherwise than asked for.
[[nodiscard]] std::shared_ptr<const core::Analysis> analyse(const core::Scene& scene, const Session& session);

}  // namespace cli
