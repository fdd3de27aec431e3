// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/material/material.h"
#include "shaders/shared/param_info.h"

namespace core {

/// A BRDF that the user wrote (docs/user-brdfs.md), made ready to stand in a kernel beside others: declarations of
/// parameters are taken out, names are the file's own, loops count their steps, indices stay inside. Lines stay where
/// they are in the file.
struct UserBrdf {
    std::string path;
    std::string code;  ///< every name that the file declares begins with kUserBrdfPrefix
    /// Of the text: another text has another one, as far as 32 bits can tell.
    std::uint32_t revision = 0;
    std::vector<ParamInfo> params;
    bool usesAlbedo = false;
    bool usesSpecular = false;
    bool usesFresnel = false;                           ///< calls fresnel(): the edit's Fresnel mode counts
    int evaluateLine = 1, pdfLine = 1, sampleLine = 1;  ///< of the three functions
    std::deque<std::string> texts;                      ///< what `params` points into

    UserBrdf() = default;
    UserBrdf(const UserBrdf&) = delete;
    UserBrdf& operator=(const UserBrdf&) = delete;
};

/// In `UserBrdf::code`, before every name; whoever inserts the code replaces the @ by the file's number.
inline constexpr std::string_view kUserBrdfPrefix = "user@n";

inline constexpr std::string_view kUserBrdfExtension = ".brdf.glsl";
inline constexpr std::size_t kMaxUserBrdfBytes = 64 << 10;
/// Tokens of a function once what it calls stands in its place, which is what drivers make of it: a software device
/// compiles three such functions in about ten seconds.
inline constexpr std::size_t kMaxUserBrdfExpanded = 2500;
inline constexpr int kMaxUserBrdfElements = 64;     ///< of an array
inline constexpr int kMaxUserBrdfElementSum = 256;  ///< of all numbers in brackets

/// Reads the text of a file. What it accepts compiles in bounded time, ends, and reaches nothing but its own names and
/// what it is offered; whether it is GLSL only the compiler knows (render/kernels/user_kernels.h). Throws Error(Input)
/// naming path, line and reason.
[[nodiscard]] std::shared_ptr<const UserBrdf> parseUserBrdf(const std::string& path, std::string_view text);

/// The same from a file. Throws Error(Input).
[[nodiscard]] std::shared_ptr<const UserBrdf> loadUserBrdf(const std::string& path);

}  // namespace core
