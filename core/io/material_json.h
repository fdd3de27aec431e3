// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/mask_io.h"
#include "core/material/material.h"

namespace core {

/// A material as it is stored in project files and given on the command line (docs/command-line.md). `place` is where
/// the object stands, for messages; errors are of `kind`, those of masks Error(Input). `"brdf": "file:PATH"` loads the
/// file, relative to `folder` ("" = the current one). A file that cannot be used is an Error(Input) without `notes`;
/// with it, the material keeps the problem and a sentence is added.
[[nodiscard]] Material readMaterial(const nlohmann::json& value, const std::string& place, ErrorKind kind,
                                    MaskLoader& masks, const std::string& folder = {}, Notes* notes = nullptr);
/// `filePath`: how a path is written.
[[nodiscard]] nlohmann::ordered_json writeMaterial(const Material& material,
                                                   const std::function<std::string(const std::string&)>& filePath = {});

}  // namespace core
