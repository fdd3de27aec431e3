// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/project.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>

#include "core/base/files.h"
#include "core/io/image_io.h"
#include "core/io/json_reader.h"
#include "core/io/material_json.h"
#include "core/io/param_json.h"
#include "core/io/photo_loader.h"
#include "core/scene/masks.h"

namespace core {

using nlohmann::json;
using nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

constexpr int kVersion = 1;
constexpr std::size_t kMaxProjectBytes = std::size_t{64} << 20U;
std::string knownLabels(const Scene& scene) {
    std::string text;
    for (const Segment& segment : scene.segments) {
        text += (text.empty() ? "" : ", ") + std::to_string(segment.label);
        if (segment.name != "segment " + std::to_string(segment.label)) text += " (" + segment.name + ")";
    }
    return text.empty() ? "it has no segments" : "it has " + text;
}

/// Resolves the paths of a project file, which are relative to its folder.
class PathReader {
  public:
    explicit PathReader(const std::string& project) : folder_(fs::path(project).parent_path()) {}
    void read(JsonReader& reader, const char* key, std::string& target) const {
        reader.read(key, target);
        if (target.empty()) return;
        const fs::path path(target);
        target = path.is_absolute() ? target : (folder_ / path).string();
    }

  private:
    fs::path folder_;
};

PhotoRequest readPhoto(const json& value, const PathReader& paths) {
    JsonReader reader(value, "photo", ErrorKind::Input);
    PhotoRequest request;
    reader.require("color");
    paths.read(reader, "color", request.source.color);
    paths.read(reader, "depth", request.source.depth);
    paths.read(reader, "segments", request.source.segments);
    reader.readWord("depth_kind", request.source.depthKind);
    if (reader.has("depth_unit")) {
        double unit = 1;
        reader.read("depth_unit", unit, 1e-12, 1e12);
        request.depthUnit = unit;
    }
    if (const json* intrinsics = reader.find("intrinsics")) {
        JsonReader camera(*intrinsics, "photo.intrinsics", ErrorKind::Input);
        Camera& result = request.intrinsics.emplace();
        for (const char* key : {"fx", "fy", "cx", "cy"}) camera.require(key);
        camera.read("fx", result.fx, 1e-3f, 1e8f);
        camera.read("fy", result.fy, 1e-3f, 1e8f);
        camera.read("cx", result.cx, -1e8f, 1e8f);
        camera.read("cy", result.cy, -1e8f, 1e8f);
        camera.finish();
    }
    reader.finish();
    return request;
}

Segment readSegment(const json& value, const std::string& place, MaskLoader& masks, const std::string& folder,
                    std::vector<std::string>* notes) {
    JsonReader reader(value, place, ErrorKind::Input);
    Segment segment;
    reader.require("label");
    int label = 0;
    reader.read("label", label, 1, 65535);
    segment.label = static_cast<std::uint16_t>(label);
    segment.name = "segment " + std::to_string(label);
    reader.read("name", segment.name);
    if (segment.name.empty()) reader.fail("\"" + reader.place("name") + "\" is empty, expected a name.");
    readParams(reader, segmentParams(), segment);
    if (const json* edit = reader.find("edit"))
        segment.edit = readMaterial(*edit, reader.place("edit"), ErrorKind::Input, masks, folder, notes);
    reader.finish();
    return segment;
}

void readSegments(const json& list, const std::string& folder, Scene& scene, std::vector<std::string>* notes) {
    MaskLoader masks(folder);
    if (!list.is_array()) throw Error(ErrorKind::Input, "\"segments\" is not a list [...].");
    std::set<std::uint16_t> labels;
    std::set<std::string> names;
    std::set<std::uint16_t> present;
    for (const std::uint16_t label : scene.photo->labels.pixels())
        if (label != 0 && (present.empty() || !present.contains(label))) present.insert(label);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string place = "segments[" + std::to_string(i) + "]";
        Segment segment = readSegment(list[i], place, masks, folder, notes);
        if (!present.contains(segment.label))
            throw Error(ErrorKind::Input, "\"" + place + ".label\" is " + std::to_string(segment.label) +
                                              ", but the label map \"" + scene.photo->source.segments +
                                              "\" has no such label.");
        if (!labels.insert(segment.label).second)
            throw Error(ErrorKind::Input, "\"" + place + ".label\" is " + std::to_string(segment.label) +
                                              ", which another segment has already.");
        if (!names.insert(segment.name).second)
            throw Error(ErrorKind::Input,
                        "\"" + place + ".name\" is \"" + segment.name + "\", which another segment has already.");
        scene.segments.push_back(std::move(segment));
    }
}

void readVersion(JsonReader& reader) {
    std::string format;
    reader.read("format", format);
    if (format != "patina") reader.fail("The file is not a Patina project: expected \"format\": \"patina\".");
    reader.require("version");
    int version = 0;
    reader.read("version", version, 1, std::numeric_limits<int>::max());
    if (version > kVersion)
        reader.fail("The project has version " + std::to_string(version) + ", this program reads up to version " +
                    std::to_string(kVersion) + ".");
}

Scene readProject(const std::string& path, std::vector<std::string>* notes) {
    const json document = parseJson(readFile(path, kMaxProjectBytes), ErrorKind::Input);
    JsonReader reader(document, "", ErrorKind::Input);
    readVersion(reader);
    const PathReader paths(path);
    Scene scene;
    reader.require("photo");
    const json* photo = reader.find("photo");
    const json* segments = reader.find("segments");
    paths.read(reader, "back_depth", scene.backDepthPath);
    readParams(reader, sceneParams(), scene, [&](std::string_view object, JsonReader& inner) {
        if (object == "environment") paths.read(inner, "path", scene.environment.path);
    });
    reader.finish();

    scene.photo = loadPhoto(readPhoto(*photo, paths), notes);
    if (segments != nullptr) {
        std::vector<std::string> unheard;
        readSegments(*segments, fs::path(path).parent_path().string(), scene, notes != nullptr ? notes : &unheard);
        requireMasksFit(scene);
    }
    addMissingSegments(scene);
    if (!scene.environment.path.empty()) scene.environment.image = loadEnvironment(scene.environment.path);
    if (!scene.backDepthPath.empty()) scene.backDepth = loadBackDepth(scene.backDepthPath, scene.photo->camera);
    return scene;
}

/// `path` relative to `folder`, resolving links, because ".." means something else behind a link.
std::string relativeTo(const fs::path& folder, const std::string& path) {
    if (path.empty()) return {};
    std::error_code code;
    const fs::path relative = fs::relative(path, folder, code);
    return (code || relative.empty() ? fs::absolute(path) : relative).generic_string();
}

ordered_json writePhoto(const Photo& photo, const fs::path& folder) {
    const PhotoSource& source = photo.source;
    ordered_json result;
    result["color"] = relativeTo(folder, source.color);
    if (!source.depth.empty()) result["depth"] = relativeTo(folder, source.depth);
    result["depth_kind"] = wordOf(source.depthKind);
    result["depth_unit"] = source.depthUnit;
    if (!source.segments.empty()) result["segments"] = relativeTo(folder, source.segments);
    result["intrinsics"] = {{"fx", toJson(photo.camera.fx)},
                            {"fy", toJson(photo.camera.fy)},
                            {"cx", toJson(photo.camera.cx)},
                            {"cy", toJson(photo.camera.cy)}};
    return result;
}

ordered_json writeSegment(const Segment& segment, const fs::path& folder) {
    ordered_json result;
    result["label"] = segment.label;
    result["name"] = segment.name;
    writeParams(result, segmentParams(), segment);
    if (segment.edit)
        result["edit"] =
            writeMaterial(*segment.edit, [&](const std::string& file) { return relativeTo(folder, file); });
    return result;
}

ordered_json writeScene(const Scene& scene, const fs::path& folder) {
    ordered_json result;
    result["format"] = "patina";
    result["version"] = kVersion;
    result["photo"] = writePhoto(*scene.photo, folder);
    result["segments"] = ordered_json::array();
    for (const Segment& segment : scene.segments) result["segments"].push_back(writeSegment(segment, folder));
    // Created first, because insertion decides the order of keys.
    result["depth_filter"] = ordered_json::object();
    result["environment"] = ordered_json::object();
    if (!scene.environment.path.empty()) result["environment"]["path"] = relativeTo(folder, scene.environment.path);
    if (!scene.backDepthPath.empty()) result["back_depth"] = relativeTo(folder, scene.backDepthPath);
    writeParams(result, sceneParams(), scene);
    return result;
}

}  // namespace

Scene createScene(const CreateOptions& options, std::vector<std::string>* notes) {
    PhotoRequest request;
    request.source.color = options.color;
    request.source.depth = options.depth;
    request.source.segments = options.segments;
    request.source.depthKind = options.depthKind;
    request.depthUnit = options.depthUnit;
    request.intrinsics = options.intrinsics;
    request.hfov = options.hfov;
    Scene scene;
    scene.photo = loadPhoto(request, notes);
    addMissingSegments(scene);
    for (const std::string& name : options.glossy) {
        Segment* segment = scene.findSegment(name);
        if (segment == nullptr)
            throw Error(ErrorKind::Usage, "There is no segment \"" + name + "\" in \"" +
                                              (options.segments.empty() ? options.color : options.segments) +
                                              "\": " + knownLabels(scene) + ".");
        segment->glossy = true;
    }
    return scene;
}

Scene loadProject(const std::string& path, std::vector<std::string>* notes) {
    try {
        return readProject(path, notes);
    } catch (const Error& error) {
        const ErrorKind kind = error.kind() == ErrorKind::Usage ? ErrorKind::Input : error.kind();
        throw Error(kind, error.what()).withContext("While loading \"" + path + "\".");
    }
}

void saveProject(const Scene& scene, const std::string& path) {
    CORE_ASSERT(scene.photo != nullptr, "only a scene with a photograph is saved");
    std::error_code code;
    fs::path folder = fs::path(path).parent_path();
    if (folder.empty()) folder = fs::current_path(code);
    try {
        writeFileAtomically(path, writeScene(withSavedMasks(scene, path), folder).dump(2) + "\n");
    } catch (const json::exception&) {
        throw Error(ErrorKind::Output,
                    "Cannot write \"" + path + "\": a file or segment name in it is not valid UTF-8.");
    }
}

}  // namespace core
