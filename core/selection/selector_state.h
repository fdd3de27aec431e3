// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/selection/region_tree.h"
#include "core/selection/selector.h"
#include "core/selection/superpixels.h"
#include "core/selection/support.h"

namespace core {

/// What a Selector knows about its photograph. For the sources of core/selection.
struct Selector::State {
    Image<PackedLab> lab;         ///< at the photograph's resolution
    Image<PackedLab> workingLab;  ///< at the working resolution
    SelectionPicture picture;
    Superpixels superpixels;
    std::vector<int> supportOf;  ///< by superpixel, see findSupports
    RegionTree tree;
};

}  // namespace core
