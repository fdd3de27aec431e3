// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/project.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>

#include "core/base/files.h"
#include "core/io/image_io.h"
#include "core/io/json_reader.h"
#include "core/io/label_map.h"
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
/// Share of the time to load a project that its photograph takes; masks, BRDFs and maps take the rest.
constexpr float kPhotoEnd = 0.9f;

Message knownLabels(const Scene& scene) {
    std::string text;
    for (const Segment& segment : scene.segments) {
        text += (text.empty() ? "" : ", ") + std::to_string(segment.label);
        if (segment.name != "segment " + std::to_string(segment.label)) text += " (" + segment.name + ")";
    }
    return text.empty() ? Message("messages", "it has no segments") : Message("messages", "it has %1").with(text);
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
    if (reader.has("depth_kind")) reader.readWord("depth_kind", request.depthKind.emplace());
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
                    Notes* notes) {
    JsonReader reader(value, place, ErrorKind::Input);
    Segment segment;
    reader.require("label");
    int label = 0;
    reader.read("label", label, 1, 65535);
    segment.label = static_cast<std::uint16_t>(label);
    segment.name = "segment " + std::to_string(label);
    reader.read("name", segment.name);
    if (segment.name.empty())
        reader.fail(Message("messages", "\"%1\" is empty, expected a name.").with(reader.place("name")));
    readParams(reader, segmentParams(), segment);
    if (const json* edit = reader.find("edit"))
        segment.edit = readMaterial(*edit, reader.place("edit"), ErrorKind::Input, masks, folder, notes);
    reader.finish();
    return segment;
}

void readSegments(const json& list, const std::string& folder, Scene& scene, Notes* notes) {
    MaskLoader masks(folder);
    if (!list.is_array())
        throw Error(ErrorKind::Input, Message("messages", "\"%1\" is not a list [...].").with("segments"));
    std::set<std::uint16_t> labels;
    std::set<std::string> names;
    std::set<std::uint16_t> present;
    for (const std::uint16_t label : scene.photo->labels.pixels())
        if (label != 0 && (present.empty() || !present.contains(label))) present.insert(label);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string place = "segments[" + std::to_string(i) + "]";
        Segment segment = readSegment(list[i], place, masks, folder, notes);
        if (!present.contains(segment.label))
            throw Error(ErrorKind::Input,
                        Message("messages", "\"%1.label\" is %2, but the label map \"%3\" has no such label.")
                            .with(place, segment.label, scene.photo->source.segments));
        if (!labels.insert(segment.label).second)
            throw Error(ErrorKind::Input, Message("messages", "\"%1.label\" is %2, which another segment has already.")
                                              .with(place, segment.label));
        if (!names.insert(segment.name).second)
            throw Error(ErrorKind::Input,
                        Message("messages", "\"%1.name\" is \"%2\", which another segment has already.")
                            .with(place, segment.name));
        scene.segments.push_back(std::move(segment));
    }
}

void readVersion(JsonReader& reader) {
    std::string format;
    reader.read("format", format);
    if (format != "patina")
        reader.fail(Message("messages", "The file is not a Patina project: expected \"format\": \"patina\"."));
    reader.require("version");
    int version = 0;
    reader.read("version", version, 1, std::numeric_limits<int>::max());
    if (version > kVersion)
        reader.fail(Message("messages", "The project has version %1, this program reads up to version %2.")
                        .with(version, kVersion));
}

Scene readProject(const std::string& path, Notes* notes, const Progress& progress, const MovedFiles& moved) {
    json document = parseJson(readFile(path, kMaxProjectBytes), ErrorKind::Input);
    if (!moved.empty()) replaceMovedFiles(document, fs::path(path).parent_path().string(), moved);
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
        // Files of versions that had a second way to fill holes.
        if (object == "depth_filter") (void)inner.find("hole_radius");
    });
    reader.finish();

    PhotoRequest request = readPhoto(*photo, paths);
    // A mask that is one object has one segment.
    if (segments != nullptr && segments->size() > 1) request.maskEdges = MaskEdges::Keep;
    scene.photo = loadPhoto(request, notes, progress.part(0, kPhotoEnd));
    if (segments != nullptr) {
        Notes unheard;
        readSegments(*segments, fs::path(path).parent_path().string(), scene, notes != nullptr ? notes : &unheard);
        requireMasksFit(scene);
    }
    addMissingSegments(scene);
    if (!scene.environment.path.empty()) scene.environment.image = loadEnvironment(scene.environment.path, notes);
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

/// The scene with a file for its labels, which is written if they have none.
Scene withLabelFile(const Scene& scene, const std::string& project) {
    const Photo& photo = *scene.photo;
    const bool saved = !photo.source.segments.empty() ||
                       std::ranges::all_of(photo.labels.pixels(), [](std::uint16_t label) { return label == 0; });
    return saved ? scene : withSavedLabels(scene, project);
}

Scene sceneOf(std::shared_ptr<const Photo> photo, const CreateOptions& options) {
    Scene scene;
    scene.photo = std::move(photo);
    addMissingSegments(scene);
    for (const std::string& name : options.glossy) {
        Segment* segment = scene.findSegment(name);
        if (segment == nullptr)
            throw Error(ErrorKind::Usage, Message("messages", "There is no segment \"%1\" in \"%2\": %3.")
                                              .with(name, options.segments.empty() ? options.color : options.segments,
                                                    knownLabels(scene)));
        segment->glossy = true;
    }
    return scene;
}

}  // namespace

PhotoRequest photoRequest(const CreateOptions& options) {
    PhotoRequest request;
    request.source.color = options.color;
    request.source.depth = options.depth;
    request.source.segments = options.segments;
    request.depthKind = options.depthKind;
    request.depthUnit = options.depthUnit;
    request.intrinsics = options.intrinsics;
    request.hfov = options.hfov;
    return request;
}

Scene createScene(const CreateOptions& options, Notes* notes, const Progress& progress) {
    return sceneOf(loadPhoto(photoRequest(options), notes, progress), options);
}

Scene createScene(const CreateOptions& options, const PhotoFiles& files, Notes* notes, const Progress& progress) {
    return sceneOf(loadPhoto(files, photoRequest(options), notes, progress), options);
}

Scene loadProject(const std::string& path, Notes* notes, const Progress& progress, const MovedFiles& moved) {
    try {
        return readProject(path, notes, progress, moved);
    } catch (const Error& error) {
        const ErrorKind kind = error.kind() == ErrorKind::Usage ? ErrorKind::Input : error.kind();
        throw error.as(kind).withContext(Message("messages", "While loading \"%1\".").with(path));
    }
}

void saveProject(const Scene& scene, const std::string& path) {
    CORE_ASSERT(scene.photo != nullptr, "only a scene with a photograph is saved");
    std::error_code code;
    fs::path folder = fs::path(path).parent_path();
    if (folder.empty()) folder = fs::current_path(code);
    try {
        writeFileAtomically(path, writeScene(withSavedMasks(withLabelFile(scene, path), path), folder).dump(2) + "\n");
    } catch (const json::exception&) {
        throw Error(
            ErrorKind::Output,
            Message("messages", "Cannot write \"%1\": a file or segment name in it is not valid UTF-8.").with(path));
    }
}

}  // namespace core
