// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/error.h"
#include "core/material.h"

namespace core {

/// A material as it is stored in project files and given on the command line (DESIGN section 5). `place` is where the
/// object stands, for messages; errors are of `kind`.
[[nodiscard]] Material readMaterial(const nlohmann::json& value, const std::string& place, ErrorKind kind);
[[nodiscard]] nlohmann::ordered_json writeMaterial(const Material& material);

}  // namespace core
