// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "core/material/glsl_tokens.h"
#include "core/material/material.h"
#include "shaders/shared/param_info.h"

namespace core {

/// Parameters and colours that a user's BRDF declares.
struct UserBrdfParams {
    std::vector<ParamInfo> params;
    bool usesAlbedo = false;
    bool usesSpecular = false;
    std::deque<std::string> texts;  ///< owns the strings that `params` points to

    UserBrdfParams() = default;
    UserBrdfParams(const UserBrdfParams&) = delete;
    UserBrdfParams& operator=(const UserBrdfParams&) = delete;
};

/// Reads the declaration of a parameter or colour that begins at token `i` ("uniform") and adds it to `params`; its
/// range and label are in the comment on its line. Returns the next token. Throws Error(Input) naming `path`, line and
/// reason.
[[nodiscard]] std::size_t readUserParam(const GlslText& text, std::size_t i, const std::string& path,
                                        UserBrdfParams& params);

}  // namespace core
