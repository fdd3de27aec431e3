// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tests/evaluate/scene_folder.h"

namespace evaluate {

/// Duration of every analysis step of a scene and this process's peak memory, measured as by `patina-cli bench
/// analyse`. Cases with a target have "limit_seconds" and "limit_bytes": two glossy segments at 1024², and 12
/// megapixels (the studio, enlarged).
[[nodiscard]] std::vector<Json> speedReports(const SceneFolder& folder);

/// Table of all cases, as Markdown.
void printSpeed(std::ostream& out, const Json& reports);

[[nodiscard]] std::string gibibytes(const Json& bytes);

}  // namespace evaluate
