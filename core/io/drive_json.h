// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/error.h"
#include "core/io/mask_io.h"
#include "core/material/material.h"

namespace core {

/// The "drives" of a material, whose other keys have been read; `place` is where the list stands. Loads the masks.
void readDrives(const nlohmann::json& list, const std::string& place, ErrorKind kind, MaskLoader& masks,
                Material& material);
/// `filePath` turns the path of a file into what is written; empty = unchanged.
[[nodiscard]] nlohmann::ordered_json writeDrives(const Material& material,
                                                 const std::function<std::string(const std::string&)>& filePath);

}  // namespace core
