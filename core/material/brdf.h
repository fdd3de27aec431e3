// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/material/material.h"
#include "shaders/shared/brdf_params.h"
#include "shaders/shared/param_info.h"

namespace core {

struct MeasuredBrdf;  // core/material/measured_brdf.h
struct UserBrdf;      // core/material/user_brdf.h

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

/// A BRDF that a file defines. Immutable and shared by the materials that name the file.
struct BrdfFile {
    std::string path;  ///< absolute, or relative to the current folder
    std::string name;  ///< for people
    Message problem;   ///< why it is unusable, a full sentence that names the file; empty = usable
    std::shared_ptr<const MeasuredBrdf> measured;  ///< this or `user`, when usable
    std::shared_ptr<const UserBrdf> user;
    BrdfInfo info;                       ///< key kFileBrdf
    std::vector<ParamInfo> unread;       ///< parameters of an unusable file that an edit names
    std::deque<std::string> unreadKeys;  ///< owns the keys of `unread`

    BrdfFile() = default;
    BrdfFile(const BrdfFile&) = delete;
    BrdfFile& operator=(const BrdfFile&) = delete;
};

/// All BRDFs, in the order of their ids.
[[nodiscard]] std::span<const BrdfInfo> brdfs();

/// By key ("ggx"); nullptr when there is none.
[[nodiscard]] const BrdfInfo* findBrdf(std::string_view key);

/// The material's BRDF, from the list or from its file; nullptr for an unknown key.
[[nodiscard]] const BrdfInfo* findBrdf(const Material& material);

/// Whether the material can be shaded; false where the file of its BRDF is unusable.
[[nodiscard]] bool usable(const Material& material);

/// A material of this BRDF with its table's initial values and default Fresnel mode.
[[nodiscard]] Material defaultMaterial(const BrdfInfo& brdf);

/// The material as kernels and the reference renderer read it. `estimatedSpecular` is the segment's ρ, used when the
/// material does not choose a specular colour. Parameters are clamped to what the BRDF's code can evaluate, not to the
/// slider's range. Refers to the material's file, which must outlive it. Throws Error(Usage) for an unknown BRDF key
/// and Error(Input) for an unusable file.
[[nodiscard]] kernel::BrdfParams toKernel(const Material& material, const Vector3f& estimatedSpecular);

/// The BRDFs and their parameters as a Markdown table, as in docs/command-line.md.
[[nodiscard]] std::string brdfTableMarkdown();

}  // namespace core
