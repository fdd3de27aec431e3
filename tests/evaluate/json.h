// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace evaluate {

using Json = nlohmann::ordered_json;

/// Throws core::Error(Input) naming the file when it cannot be read or is no JSON.
[[nodiscard]] Json readJson(const std::filesystem::path& path);

}  // namespace evaluate
