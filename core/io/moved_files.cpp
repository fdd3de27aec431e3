// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/moved_files.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/io/json_reader.h"
#include "core/io/project.h"

namespace core {

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

using Visit = std::function<void(std::string& path)>;

/// The member of an object; nullptr when there is none, or `value` is no object.
json* memberOf(json& value, const char* key) {
    const auto found = value.is_object() ? value.find(key) : value.end();
    return found != value.end() ? &*found : nullptr;
}

void visitPath(json* object, const char* key, const Visit& visit) {
    json* const value = object != nullptr ? memberOf(*object, key) : nullptr;
    if (value == nullptr || !value->is_string() || value->get_ref<std::string&>().empty()) return;
    visit(value->get_ref<std::string&>());
}

/// Visits the paths of the files without which a project cannot be opened.
void visitPaths(json& project, const Visit& visit) {
    for (const char* key : {"color", "depth", "segments"}) visitPath(memberOf(project, "photo"), key, visit);
    visitPath(&project, "back_depth", visit);
    visitPath(memberOf(project, "environment"), "path", visit);
    json* const segments = memberOf(project, "segments");
    if (segments == nullptr || !segments->is_array()) return;
    for (json& segment : *segments) {
        json* const edit = memberOf(segment, "edit");
        json* const drives = edit != nullptr ? memberOf(*edit, "drives") : nullptr;
        if (drives == nullptr || !drives->is_object()) continue;
        for (json& drive : *drives) visitPath(&drive, "mask", visit);
    }
}

std::string fullPath(const std::string& folder, const std::string& path) {
    const fs::path given(path);
    return given.is_absolute() ? path : (fs::path(folder) / given).string();
}

}  // namespace

std::vector<std::string> missingFiles(const std::string& project, const MovedFiles& moved) {
    json document = parseJson(readFile(project, kMaxProjectBytes), ErrorKind::Input);
    const std::string folder = fs::path(project).parent_path().string();
    std::vector<std::string> missing;
    visitPaths(document, [&](std::string& path) {
        const std::string expected = fullPath(folder, path);
        const auto found = moved.find(expected);
        std::error_code code;
        if (fs::exists(found != moved.end() ? found->second : expected, code)) return;
        if (std::ranges::find(missing, expected) == missing.end()) missing.push_back(expected);
    });
    return missing;
}

MovedFiles filesBeside(std::span<const std::string> missing, const std::string& file, const std::string& place) {
    const fs::path oldFolder = fs::path(file).parent_path();
    const fs::path newFolder = fs::path(place).parent_path();
    MovedFiles moved;
    for (const std::string& path : missing) {
        const fs::path name = fs::path(path).filename();
        const fs::path parent = fs::path(path).parent_path().filename();
        for (const fs::path& candidate :
             {path == file ? fs::path(place) : newFolder / fs::path(path).lexically_relative(oldFolder),
              newFolder / name, newFolder / parent / name}) {
            std::error_code code;
            if (!fs::is_regular_file(candidate, code)) continue;
            moved[path] = candidate.lexically_normal().string();
            break;
        }
    }
    return moved;
}

void replaceMovedFiles(json& project, const std::string& folder, const MovedFiles& moved) {
    visitPaths(project, [&](std::string& path) {
        const auto found = moved.find(fullPath(folder, path));
        if (found != moved.end()) path = fs::absolute(found->second).string();
    });
}

}  // namespace core
