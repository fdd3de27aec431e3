// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.h"
#include "core/io/mask_io.h"
#include "core/material.h"

namespace core {

/// A material as it is stored in project files and given on the command line (DESIGN section 5). `place` is where the
/// object stands, for messages; errors are of `kind`, those of masks Error(Input).
[[nodiscard]] Material readMaterial(const nlohmann::json& value, const std::string& place, ErrorKind kind,
                                    MaskLoader& masks);
/// `filePath`: how a path is written.
[[nodiscard]] nlohmann::ordered_json writeMaterial(const Material& material,
                                                   const std::function<std::string(const std::string&)>& filePath = {});

}  // namespace core
