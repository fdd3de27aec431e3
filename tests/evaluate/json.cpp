// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/json.h"

#include <fstream>

#include "core/base/error.h"

namespace evaluate {

Json readJson(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) throw core::Error(core::ErrorKind::Input, "File \"" + path.string() + "\" cannot be read.");
    try {
        return Json::parse(file);
    } catch (const Json::exception& error) {
        throw core::Error(core::ErrorKind::Input, "\"" + path.string() + "\" is no JSON: " + error.what());
    }
}

}  // namespace evaluate
