// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/material/brdf.h"

namespace core {

/// Loads a BRDF: one written by the user (core/material/user_brdf.h) from NAME.brdf.glsl, otherwise a measured one
/// (core/material/measured_brdf.h). A file that is still in use and has not changed since it was loaded gives the same
/// object. Throws Error(Input) naming the file, what was expected and what was found. Any thread.
[[nodiscard]] std::shared_ptr<const BrdfFile> loadBrdfFile(const std::string& path);

/// Same as `loadBrdfFile`, but an unusable file gives an object with a `problem`. Its parameters are `keys`, without
/// limits, so that their values survive until the file can be used again.
[[nodiscard]] std::shared_ptr<const BrdfFile> loadBrdfFileOrProblem(const std::string& path,
                                                                    const std::vector<std::string>& keys = {});

/// Value of a parameter of an unusable file that an edit names without giving a value.
inline constexpr float kNoValue = std::numeric_limits<float>::max();

/// Called on the loading thread for every user-written BRDF that is loaded; throws Error(Input) for one that cannot be
/// used. Compiling and testing it needs a graphics device, which core does not have (render/kernels/brdf_check.h). Set
/// before anything is loaded.
using UserBrdfCheck = std::function<void(const std::shared_ptr<const BrdfFile>&)>;
void setUserBrdfCheck(UserBrdfCheck check);

/// A material of the file's BRDF with its initial values.
[[nodiscard]] Material fileMaterial(std::shared_ptr<const BrdfFile> file);

/// The material with a newer state of its file: parameters keep their values by key.
[[nodiscard]] Material withReloadedFile(const Material& material, std::shared_ptr<const BrdfFile> file);

}  // namespace core
