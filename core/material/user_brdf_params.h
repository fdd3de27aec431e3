// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/material/glsl_tokens.h"
#include "core/material/user_brdf.h"

namespace core {

/// Reads the declaration of a parameter or colour that begins at token `i` ("uniform") and adds it to `brdf`; its range
/// and label are in the comment of its line. Returns the token behind it. Throws Error(Input) naming path, line and
/// reason.
[[nodiscard]] std::size_t readUserParam(const GlslText& text, std::size_t i, UserBrdf& brdf);

}  // namespace core
