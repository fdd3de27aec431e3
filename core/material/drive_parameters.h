// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/material/material.h"
#include "shaders/shared/path.h"

namespace core {

/// A parameter that a drive may vary.
struct DriveParameter {
    std::string key;    ///< "alpha", "albedo", "blend.new": the word of files and command line
    std::string label;  ///< for people, untranslated
    bool color = false;
    float min = 0, max = 1;
    kernel::uint slot = 0;  ///< shaders/shared/drive.h
};

/// Those of the material's BRDF, then "albedo", "specular", "eta", "k" where it reads them, "blend.new",
/// "blend.original" and, with translucency, "translucency.weight".
[[nodiscard]] std::vector<DriveParameter> driveParameters(const Material& material);

/// Those of `drives` that vary a parameter the material has.
[[nodiscard]] std::vector<Drive> knownDrives(const std::vector<Drive>& drives, const Material& material);

/// The material's own value of a parameter, which drives replace; a scalar three times. `estimatedSpecular`: as for
/// core::toKernel.
[[nodiscard]] Vector3f ownValue(const Material& material, const DriveParameter& parameter,
                                const Vector3f& estimatedSpecular);

/// Whether a drive of the material needs Analysis::textureDetail.
[[nodiscard]] bool drivenByLuminance(const Material& material);

}  // namespace core
