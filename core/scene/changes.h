// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

namespace core {

/// The processing graph, in order. An edit names the first stage it touches; everything after it may be stale.
enum class Stage { Input, Geometry, BackSide, Reflectance, Environment, Irradiance, Reshade, Composite, Display };

/// First stage whose result differs between two scenes; Display when nothing that is computed changed.
[[nodiscard]] Stage firstChangedStage(const Scene& before, const Scene& after);

}  // namespace core
