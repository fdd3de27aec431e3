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

/// A material from project files and the command line (docs/command-line.md). `place` names the object in messages;
/// errors are of `kind`, those of masks Error(Input). `"brdf": "file:PATH"` loads the file, relative to `folder` ("" =
/// the current one). A file that cannot be used is an Error(Input) without `notes`; with it, the material keeps the
/// problem and a sentence is added.
[[nodiscard]] Material readMaterial(const nlohmann::json& value, const std::string& place, ErrorKind kind,
                                    MaskLoader& masks, const std::string& folder = {}, Notes* notes = nullptr);
/// `filePath` turns the path of a file into what is written; empty = unchanged.
[[nodiscard]] nlohmann::ordered_json writeMaterial(const Material& material,
                                                   const std::function<std::string(const std::string&)>& filePath = {});

/// One `--edit` value (docs/command-line.md) as JSON text to a material and back. Throws Error(Usage) naming the key.
[[nodiscard]] Material materialFromJson(const std::string& json);
[[nodiscard]] std::string materialToJson(const Material& material);

}  // namespace core
