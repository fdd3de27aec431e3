// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/material/material.h"
#include "shaders/shared/path.h"

namespace core {

/// A parameter that drives can vary.
struct DriveParameter {
    std::string key;    ///< in files and on the command line: "alpha", "albedo", "blend.new"
    std::string label;  ///< for people, untranslated
    bool color = false;
    float min = 0, max = 1;
    kernel::uint slot = 0;  ///< shaders/shared/drive.h
};

/// Drivable parameters of a material: those of its BRDF, then "albedo", "specular", "eta", "k" where the BRDF reads
/// them, "blend.new", "blend.original" and, with translucency, "translucency.weight".
[[nodiscard]] std::vector<DriveParameter> driveParameters(const Material& material);

/// The drives among `drives` that vary a parameter of the material.
[[nodiscard]] std::vector<Drive> knownDrives(const std::vector<Drive>& drives, const Material& material);

/// The material's own value of a parameter, which drives replace; scalars are repeated three times.
/// `estimatedSpecular` as in core::toKernel.
[[nodiscard]] Vector3f ownValue(const Material& material, const DriveParameter& parameter,
                                const Vector3f& estimatedSpecular);

/// True if a drive of the material needs Analysis::textureDetail.
[[nodiscard]] bool drivenByLuminance(const Material& material);

}  // namespace core
