// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "core/material/material.h"

namespace core {

/// Complex index of refraction n + ik of a pure metal, per channel. Means of the published tables over 600–700, 500–600
/// and 400–500 nm for red, green and blue (refractiveindex.info, CC0).
struct Metal {
    const char* key;    ///< in files and on the command line
    const char* label;  ///< for people, untranslated (context "metals")
    float n[3];
    float k[3];
};

[[nodiscard]] std::span<const Metal> metals();

/// By key ("gold"); nullptr when there is none.
[[nodiscard]] const Metal* findMetal(std::string_view key);

/// The metal whose values the material has; nullptr when there is none or the Fresnel mode is not Conductor.
[[nodiscard]] const Metal* metalOf(const Material& material);

/// Makes the material's specular lobe that of the clean metal: Fresnel mode, n, k, and a white specular colour.
void setMetal(Material& material, const Metal& metal);

}  // namespace core
