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
#include "core/io/photo_loader.h"
#include "core/scene/masks.h"

namespace core {

using nlohmann::json;
using nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

constexpr int kVersion = 1;
constexpr std::size_t kMaxProjectBytes = std::size_t{64} << 20U;
const std::vector<std::string> kBackSideMethods{"automatic",  "offset",         "parallel_mirror",
                                                "pca_mirror", "spanned_mirror", "flat_faces"};
const std::vector<std::string> kEnvironmentUses{"replace", "complete"};
const std::vector<std::string> kEnvironmentFills{"shepard", "membrane"};
const std::vector<std::string> kDiffusionQualities{"draft", "standard", "fine"};

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
    if (const auto kind = reader.readChoice("depth_kind", {"z", "distance", "disparity", "inverse"}))
        request.source.depthKind = static_cast<DepthKind>(*kind);
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
    reader.read("glossy", segment.glossy);
    if (const json* backSide = reader.find("back_side")) {
        JsonReader back(*backSide, reader.place("back_side"), ErrorKind::Input);
        if (const auto method = back.readChoice("method", kBackSideMethods))
            segment.backSide.method = static_cast<BackSideMethod>(*method);
        back.read("offset", segment.backSide.offset, 0.0f, 1000.0f);
        back.read("plane_shift", segment.backSide.planeShift, -1000.0f, 1000.0f);
        back.read("thickness_scale", segment.backSide.thicknessScale, 0.0f, 1000.0f);
        back.read("min_thickness", segment.backSide.minThickness, 0.0f, 1000.0f);
        back.finish();
    }
    if (reader.has("reflectance")) {
        Vector3f rho(1, 1, 1);
        reader.read("reflectance", rho, 1e-4f, 100.0f);
        segment.reflectance = rho;
    }
    if (reader.has("lobe_width")) {
        float alpha = 0;
        reader.read("lobe_width", alpha, 1e-3f, 1.0f);
        segment.lobeWidth = alpha;
    }
    if (const json* smoothing = reader.find("smoothing"); smoothing != nullptr && !smoothing->is_null())
        reader.read("smoothing", segment.smoothing.emplace(), 0.0f, 200.0f);
    if (const json* edit = reader.find("edit"))
        segment.edit = readMaterial(*edit, reader.place("edit"), ErrorKind::Input, masks, folder, notes);
    reader.finish();
    return segment;
}

void readSegments(const json& list, const std::string& folder, Scene& scene, std::vector<std::string>* notes) {
    MaskLoader masks(folder);
    if (!list.is_array()) throw Error(ErrorKind::Input, "\"segments\" is no list [...].");
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

void readDepthFilter(const json& value, DepthFilterParams& params) {
    JsonReader reader(value, "depth_filter", ErrorKind::Input);
    reader.read("enabled", params.enabled);
    reader.read("automatic", params.automatic);
    reader.read("spatial_sigma", params.spatialSigma, 0.1f, 100.0f);
    reader.read("color_sigma", params.colorSigma, 1e-4f, 100.0f);
    reader.read("depth_sigma", params.depthSigma, 1e-6f, 100.0f);
    (void)reader.find("hole_radius");  // written by older versions, which had a second way to fill holes
    reader.finish();
}

void readEnvironment(const json& value, const PathReader& paths, EnvironmentParams& params) {
    JsonReader reader(value, "environment", ErrorKind::Input);
    paths.read(reader, "path", params.path);
    reader.read("rotation", params.rotation, -1000.0f, 1000.0f);
    reader.read("scale", params.scale, 0.0f, 1e6f);
    reader.read("height", params.height, 4, 4096);
    if (const auto use = reader.readChoice("use", kEnvironmentUses)) params.use = static_cast<EnvironmentUse>(*use);
    if (const auto fill = reader.readChoice("fill", kEnvironmentFills))
        params.fill = static_cast<EnvironmentFill>(*fill);
    reader.finish();
    if (!params.path.empty()) params.image = loadEnvironment(params.path);
}

void readRender(const json& value, RenderParams& params) {
    JsonReader reader(value, "render", ErrorKind::Input);
    reader.read("samples", params.samples, 1, 1'000'000);
    reader.read("time_limit", params.timeLimit, 0, 86400);
    reader.read("seed", params.seed);
    reader.read("bounces", params.bounces, 1, 64);
    reader.read("filter", params.filter);
    reader.read("surface_samples", params.surfaceSamples, 1, 10'000'000);
    reader.read("irradiance_samples", params.irradianceSamples, 1, 1'000'000);
    if (const auto quality = reader.readChoice("translucency_quality", kDiffusionQualities))
        params.diffusionQuality = static_cast<DiffusionQuality>(*quality);
    reader.finish();
}

Scene readProject(const std::string& path, std::vector<std::string>* notes) {
    const json document = parseJson(readFile(path, kMaxProjectBytes), ErrorKind::Input);
    JsonReader reader(document, "", ErrorKind::Input);
    std::string format;
    reader.read("format", format);
    if (format != "patina") reader.fail("The file is no Patina project: expected \"format\": \"patina\".");
    reader.require("version");
    int version = 0;
    reader.read("version", version, 1, std::numeric_limits<int>::max());
    if (version > kVersion)
        reader.fail("The project has version " + std::to_string(version) + ", this program reads up to version " +
                    std::to_string(kVersion) + ".");
    const PathReader paths(path);
    reader.require("photo");
    const json* photo = reader.find("photo");
    const json* filter = reader.find("depth_filter");
    const json* environment = reader.find("environment");
    const json* render = reader.find("render");
    const json* segments = reader.find("segments");
    Scene scene;
    paths.read(reader, "back_depth", scene.backDepthPath);
    reader.finish();

    PhotoRequest request = readPhoto(*photo, paths);
    if (filter != nullptr) readDepthFilter(*filter, scene.depthFilter);
    if (render != nullptr) readRender(*render, scene.render);
    scene.photo = loadPhoto(request, notes);
    if (segments != nullptr) {
        std::vector<std::string> unheard;
        readSegments(*segments, fs::path(path).parent_path().string(), scene, notes != nullptr ? notes : &unheard);
        requireMasksFit(scene);
    }
    addMissingSegments(scene);
    if (environment != nullptr) readEnvironment(*environment, paths, scene.environment);
    if (!scene.backDepthPath.empty()) scene.backDepth = loadBackDepth(scene.backDepthPath, scene.photo->camera);
    return scene;
}

/// `path` as seen from `folder`; both through their real folders, because ".." does not mean the same behind a link.
std::string relativeTo(const fs::path& folder, const std::string& path) {
    if (path.empty()) return {};
    std::error_code code;
    const fs::path relative = fs::relative(path, folder, code);
    return (code || relative.empty() ? fs::absolute(path) : relative).generic_string();
}

ordered_json writeSegment(const Segment& segment, const fs::path& folder) {
    ordered_json result;
    result["label"] = segment.label;
    result["name"] = segment.name;
    result["glossy"] = segment.glossy;
    result["back_side"] = {{"method", backSideMethodKey(segment.backSide.method)},
                           {"offset", toJson(segment.backSide.offset)},
                           {"plane_shift", toJson(segment.backSide.planeShift)},
                           {"thickness_scale", toJson(segment.backSide.thicknessScale)},
                           {"min_thickness", toJson(segment.backSide.minThickness)}};
    if (segment.reflectance) result["reflectance"] = toJson(*segment.reflectance);
    if (segment.lobeWidth) result["lobe_width"] = toJson(*segment.lobeWidth);
    if (segment.smoothing) result["smoothing"] = toJson(*segment.smoothing);
    if (segment.edit)
        result["edit"] =
            writeMaterial(*segment.edit, [&](const std::string& file) { return relativeTo(folder, file); });
    return result;
}

ordered_json writeScene(const Scene& scene, const fs::path& folder) {
    const Photo& photo = *scene.photo;
    const PhotoSource& source = photo.source;
    ordered_json result;
    result["format"] = "patina";
    result["version"] = kVersion;
    ordered_json& files = result["photo"];
    files["color"] = relativeTo(folder, source.color);
    if (!source.depth.empty()) files["depth"] = relativeTo(folder, source.depth);
    files["depth_kind"] = depthKindKey(source.depthKind);
    files["depth_unit"] = source.depthUnit;
    if (!source.segments.empty()) files["segments"] = relativeTo(folder, source.segments);
    files["intrinsics"] = {{"fx", toJson(photo.camera.fx)},
                           {"fy", toJson(photo.camera.fy)},
                           {"cx", toJson(photo.camera.cx)},
                           {"cy", toJson(photo.camera.cy)}};
    result["segments"] = ordered_json::array();
    for (const Segment& segment : scene.segments) result["segments"].push_back(writeSegment(segment, folder));
    result["depth_filter"] = {{"enabled", scene.depthFilter.enabled},
                              {"automatic", scene.depthFilter.automatic},
                              {"spatial_sigma", toJson(scene.depthFilter.spatialSigma)},
                              {"color_sigma", toJson(scene.depthFilter.colorSigma)},
                              {"depth_sigma", toJson(scene.depthFilter.depthSigma)}};
    ordered_json& environment = result["environment"];
    if (!scene.environment.path.empty()) environment["path"] = relativeTo(folder, scene.environment.path);
    environment["rotation"] = toJson(scene.environment.rotation);
    environment["scale"] = toJson(scene.environment.scale);
    environment["height"] = scene.environment.height;
    environment["use"] = kEnvironmentUses[static_cast<std::size_t>(scene.environment.use)];
    environment["fill"] = kEnvironmentFills[static_cast<std::size_t>(scene.environment.fill)];
    if (!scene.backDepthPath.empty()) result["back_depth"] = relativeTo(folder, scene.backDepthPath);
    result["render"] = {
        {"samples", scene.render.samples},
        {"time_limit", scene.render.timeLimit},
        {"seed", scene.render.seed},
        {"bounces", scene.render.bounces},
        {"filter", scene.render.filter},
        {"surface_samples", scene.render.surfaceSamples},
        {"irradiance_samples", scene.render.irradianceSamples},
        {"translucency_quality", kDiffusionQualities[static_cast<std::size_t>(scene.render.diffusionQuality)]}};
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

const std::string& backSideMethodKey(BackSideMethod method) {
    return kBackSideMethods[static_cast<std::size_t>(method)];
}

}  // namespace core
