// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace core {

/// A HEIF file (ISO/IEC 23008-12) in which auxiliary images that refer to several items (`auxl`), as phones write them
/// since iOS 18 for the picture and its tone-mapped version, refer to the primary item alone, or to the first where it
/// is not among them: libheif before 1.18 refuses the others. nullopt when there are none, or the boxes are damaged.
[[nodiscard]] std::optional<std::string> withSingleAuxiliaryTargets(std::string_view file);

}  // namespace core
