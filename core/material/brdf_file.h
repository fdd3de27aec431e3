// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/material/brdf.h"
#include "core/material/measured_brdf.h"
#include "core/material/user_brdf.h"

namespace core {

/// A BRDF that a file defines. Immutable and shared by the materials that name the file.
struct BrdfFile {
    std::string path;  ///< absolute, or relative to the current folder
    std::string name;  ///< for people
    Message problem;   ///< why it cannot be used, a full sentence that names the file; empty = usable
    std::shared_ptr<const MeasuredBrdf> measured;  ///< one of these two, when usable
    std::shared_ptr<const UserBrdf> user;
    BrdfInfo info;                       ///< key kFileBrdf
    std::vector<ParamInfo> unread;       ///< parameters of an unusable file, as far as an edit names them
    std::deque<std::string> unreadKeys;  ///< what `unread` points into

    BrdfFile() = default;
    BrdfFile(const BrdfFile&) = delete;
    BrdfFile& operator=(const BrdfFile&) = delete;
};

/// Loads a BRDF: one that the user wrote (core/material/user_brdf.h) from NAME.brdf.glsl, else a measured one
/// (core/material/measured_brdf.h). A file that did not change since it was last loaded, and is still in use, gives the
/// same object. Throws Error(Input) naming the file, what was expected and what was found. Any thread.
[[nodiscard]] std::shared_ptr<const BrdfFile> loadBrdfFile(const std::string& path);

/// The same, but a file that cannot be used gives an object that says why. It has `keys` as parameters without limits,
/// so that their values are kept until the file can be used again.
[[nodiscard]] std::shared_ptr<const BrdfFile> loadBrdfFileOrProblem(const std::string& path,
                                                                    const std::vector<std::string>& keys = {});

/// Value of a parameter that an edit of an unusable file names, but gives no value.
inline constexpr float kNoValue = std::numeric_limits<float>::max();

/// Called for every BRDF that the user wrote when it is loaded, on the loading thread; throws Error(Input) for one that
/// cannot be used. Compiling and trying it takes a graphics device, which core does not have
/// (render/kernels/brdf_check.h). Set before anything is loaded.
using UserBrdfCheck = std::function<void(const std::shared_ptr<const BrdfFile>&)>;
void setUserBrdfCheck(UserBrdfCheck check);

/// A material of the file's BRDF with its initial values.
[[nodiscard]] Material fileMaterial(std::shared_ptr<const BrdfFile> file);

/// The material with another state of its file: parameters keep their values by key.
[[nodiscard]] Material withReloadedFile(const Material& material, std::shared_ptr<const BrdfFile> file);

}  // namespace core
