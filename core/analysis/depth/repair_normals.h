// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/step.h"
#include "core/base/camera.h"

namespace core::analysis {

/// Gives pixels whose normal agrees with too few around them the mean normal of settled ones near by in their segment,
/// the depth that continues theirs, and the position and patch area that go with it: rays that start in a dent would
/// hit its walls. Where depth was compressed, or enlarged and guided by colour, it goes to
/// pieces in a band along outlines: single pixels face anywhere, and anything glossy turns them into beads. At a crease
/// or a round rim half of the neighbours, or those along it, agree: these keep their normals.
/// `step`: pixels per sample of the depth map, as Photo::depthStep. Pixels without a label are left alone.
void settleNormals(Surface& surface, const LabelImage& labels, const Camera& camera, float step,
                   const Progress& progress);

}  // namespace core::analysis
