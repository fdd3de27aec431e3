// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/base/progress.h"
#include "core/geometry/surface.h"

namespace core::analysis {

/// Repairs normals in the band along outlines where depth was compressed, or enlarged with colour as a guide: there
/// neighbouring pixels face in unrelated directions, and anything glossy turns them into beads. Pixels whose normal
/// agrees with too few neighbours get the mean normal of reliable ones nearby in their segment, the depth that
/// continues theirs, and the position and patch area that follow: rays starting in a dent would hit its walls. At
/// creases and round rims half of the neighbours agree, or those along the rim: these normals are kept.
///
/// `depthSampleSpacing` as in `Photo`. Pixels without a label are left alone.
void repairNormals(Surface& surface, const LabelImage& labels, const Camera& camera, float depthSampleSpacing,
                   const Progress& progress);

}  // namespace core::analysis
