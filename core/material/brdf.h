// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/material/material.h"
#include "shaders/shared/brdf_params.h"
#include "shaders/shared/param_info.h"

namespace core {

/// One entry of the list of BRDFs (shaders/brdf/registry.h).
struct BrdfInfo {
    int id;                             ///< in files and kernels; never reused
    const char* key;                    ///< in files and on the command line
    const char* label;                  ///< for people, untranslated (context "brdfs")
    std::span<const ParamInfo> params;  ///< in the order of Material::values; at most kBrdfValueCount
    bool usesAlbedo;                    ///< reads Material::albedo
    bool usesSpecular;                  ///< reads Material::specular and the Fresnel mode
    Fresnel defaultFresnel;             ///< when an edit does not name a mode
};

/// All BRDFs, in the order of their ids.
[[nodiscard]] std::span<const BrdfInfo> brdfs();

/// By key ("ggx"); nullptr when there is none.
[[nodiscard]] const BrdfInfo* findBrdf(std::string_view key);

/// The material's BRDF: of the list, or of its file; nullptr for an unknown key.
[[nodiscard]] const BrdfInfo* findBrdf(const Material& material);

/// Whether the material can be shaded: false where its BRDF's file could not be used.
[[nodiscard]] bool usable(const Material& material);

/// A material of this BRDF with its table's initial values and default Fresnel mode.
[[nodiscard]] Material defaultMaterial(const BrdfInfo& brdf);

/// The material as kernels and the reference renderer read it. `estimatedSpecular` is the segment's ρ, used when the
/// material does not choose a specular colour. Parameters are clamped to what the BRDF's text can evaluate, not to the
/// slider's range. Refers to the material's file, which has to outlive it. Throws Error(Usage) for an unknown BRDF key
/// and Error(Input) for a file that could not be used.
[[nodiscard]] kernel::BrdfParams toKernel(const Material& material, const Vector3f& estimatedSpecular);

/// The BRDFs and their parameters as the rows of a Markdown table, as docs/command-line.md has it.
[[nodiscard]] std::string brdfTableMarkdown();

}  // namespace core
