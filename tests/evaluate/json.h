// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace evaluate {

using Json = nlohmann::ordered_json;

/// Throws core::Error(Input) with the name of a file that cannot be read or is not JSON.
[[nodiscard]] Json readJson(const std::filesystem::path& path);

}  // namespace evaluate
