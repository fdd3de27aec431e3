// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

namespace core {

/// Where files of a project are now, by the path at which the project expects them (resolved, not relative).
using MovedFiles = std::map<std::string, std::string>;

/// Files that a project cannot be opened without and that are not where it expects them, nor where `moved` says: the
/// photograph, its depth and label map, loaded light, a measured back side, masks. Throws Error(Input) for a file that
/// is no JSON; what is wrong inside one is left to core::loadProject.
[[nodiscard]] std::vector<std::string> missingFiles(const std::string& project, const MovedFiles& moved = {});

/// The new places of `missing` after the user has found one of them, `file`, at `place`: the others are looked for
/// beside it, with the folders between them or without. Those that are not found are left out.
[[nodiscard]] MovedFiles filesBeside(std::span<const std::string> missing, const std::string& file,
                                     const std::string& place);

/// Replaces the paths in a project's JSON by those in `moved`. `folder` is that of the project file.
void replaceMovedFiles(nlohmann::json& project, const std::string& folder, const MovedFiles& moved);

}  // namespace core
