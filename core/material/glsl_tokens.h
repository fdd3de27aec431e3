// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"

namespace core {

/// A word or sign of a GLSL text; comments are skipped.
struct GlslToken {
    enum class Kind { Name, Number, Sign };
    std::string text;
    int line = 1;
    Kind kind = Kind::Sign;
    [[nodiscard]] bool is(std::string_view other) const { return text == other; }
    [[nodiscard]] bool isName() const { return kind == Kind::Name; }
};

struct GlslText {
    std::vector<GlslToken> tokens;
    std::map<int, std::string> lineComments;  ///< text after "//", by line
};

/// Throws Error(Input) "PATH:LINE: REASON".
[[noreturn]] void refuseGlsl(const std::string& path, int line, const Message& reason);

// Limits of a text that bound the time, memory and recursion depth of everything that reads it later.
inline constexpr std::size_t kMaxGlslTokens = 6000;
inline constexpr std::size_t kMaxGlslNesting = 40;     ///< nested brackets
inline constexpr std::size_t kMaxGlslStatement = 600;  ///< tokens between two of ; { }
inline constexpr std::size_t kMaxGlslName = 64;        ///< characters
inline constexpr int kMaxGlslElses = 100;              ///< "else if" nests without brackets

/// Splits a text into tokens. Throws Error(Input) naming path, line and reason when it is not UTF-8, is too long, or
/// has preprocessor lines, characters unknown to GLSL, an unterminated comment or unbalanced brackets.
[[nodiscard]] GlslText tokenizeGlsl(const std::string& path, std::string_view text);

}  // namespace core
