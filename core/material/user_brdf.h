// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/material/user_brdf_params.h"

namespace core {

/// A BRDF written by the user (docs/user-brdfs.md), prepared to be inserted into a kernel beside others: declarations
/// of parameters are removed, names get a prefix of the file, loops count their steps, indices are bounded. Lines keep
/// their numbers.
struct UserBrdf : UserBrdfParams {
    std::string path;
    std::string code;                                   ///< all names the file declares begin with kUserBrdfPrefix
    std::uint32_t revision = 0;                         ///< hash of the file's text
    bool usesFresnel = false;                           ///< calls fresnel(): the edit's Fresnel mode applies
    int evaluateLine = 1, pdfLine = 1, sampleLine = 1;  ///< lines of the three functions
};

/// Precedes every name in `UserBrdf::code`; the @ is replaced by the file's number when the code is inserted.
inline constexpr std::string_view kUserBrdfPrefix = "user@n";

inline constexpr std::string_view kUserBrdfExtension = ".brdf.glsl";
inline constexpr std::size_t kMaxUserBrdfBytes = 64 << 10;
/// Tokens of a function with all calls expanded, as drivers do: a software device compiles three such functions in
/// about ten seconds.
inline constexpr std::size_t kMaxUserBrdfExpanded = 2500;
inline constexpr int kMaxUserBrdfElements = 64;     ///< elements of one array
inline constexpr int kMaxUserBrdfElementSum = 256;  ///< elements of all arrays together

/// Reads the text of a file. Accepted text compiles in bounded time, terminates, and reaches only its own names and
/// those offered to it; whether it is valid GLSL is left to the compiler (render/kernels/user_kernels.h). Throws
/// Error(Input) naming path, line and reason.
[[nodiscard]] std::shared_ptr<const UserBrdf> parseUserBrdf(const std::string& path, std::string_view text);

/// Same as `parseUserBrdf`, from a file. Throws Error(Input).
[[nodiscard]] std::shared_ptr<const UserBrdf> loadUserBrdf(const std::string& path);

}  // namespace core
