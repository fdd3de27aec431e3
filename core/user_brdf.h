// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "core/material.h"
#include "shaders/shared/param_info.h"

namespace core {

/// The text of a `.brdf.glsl` file (docs/user-brdfs.md), checked and made ready to stand in a kernel beside others:
/// comments and declarations of parameters are gone, every name is the file's own, and loops count their steps. Lines
/// stay where they are.
struct UserBrdf {
    std::string path;
    std::string code;        ///< every name the file declares begins with kUserBrdfPrefix
    std::uint32_t revision;  ///< of the text, from its hash: two different texts have two different ones
    std::vector<ParamInfo> params;
    std::deque<std::string> texts;  ///< what `params` points into
    bool usesAlbedo = false;
    bool usesSpecular = false;
    Fresnel defaultFresnel = Fresnel::None;
    std::vector<std::string> names;  ///< of the parameters, as `code` has them
};

/// Stands for the file in names of its code; whoever inserts the code replaces it by the file's slot.
inline constexpr std::string_view kUserBrdfPrefix = "user@_";

/// How far a user's text may go: bytes of the file, tokens in it, tokens after calls are expanded, depth of nesting and
/// tokens of one statement. What stays below compiles in bounded time and memory and, as its loops end, always ends.
inline constexpr std::size_t kMaxUserBrdfBytes = 64 << 10;
inline constexpr std::size_t kMaxUserBrdfTokens = 6000;
inline constexpr std::size_t kMaxUserBrdfExpanded = 30000;
inline constexpr std::size_t kMaxUserBrdfNesting = 48;
inline constexpr std::size_t kMaxUserBrdfStatement = 600;

/// Reads a file. Throws Error(Input) naming file, line and reason.
[[nodiscard]] UserBrdf parseUserBrdf(const std::string& path, std::string_view text);

}  // namespace core
