// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/scene_folder.h"

#include <algorithm>

#include "core/io/image_io.h"
#include "core/io/image_reader.h"
#include "core/io/material_json.h"
#include "core/io/project.h"

namespace evaluate {

namespace fs = std::filesystem;
using core::Vector3f;

namespace {

Vector3f vector3(const Json& json) {
    return {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

/// Converts an edit's material from the reference data to the keys of the command line's `--edit`.
core::Material materialOf(const Json& edited) {
    const std::string model = edited.at("model");
    Json edit;
    if (model == "ggx_reflection") {
        edit = {{"brdf", "ggx"},
                {"alpha", edited.at("alpha")},
                {"specular", edited.at("specular_color")},
                {"fresnel", "none"}};
    } else if (model == "lambert") {
        edit = {{"brdf", "lambert"}, {"albedo", edited.at("diffuse_albedo")}};
    } else if (edited.contains("medium")) {
        const Json& medium = edited.at("medium");
        edit = {{"brdf", "none"},
                {"translucency",
                 {{"sigma_a", medium.at("sigma_a_per_mm")},
                  {"sigma_s_prime", medium.at("sigma_s_per_mm")},
                  {"eta", medium.at("relative_index")}}}};
    } else {
        throw core::Error(core::ErrorKind::Input, "Unknown reference material \"" + model + "\".");
    }
    return core::materialFromJson(edit.dump());
}

/// The studio's wax gives its index-matched medium as albedo and σ_t.
core::Material waxOf(const Json& medium) {
    const Vector3f albedo = vector3(medium.at("single_scattering_albedo"));
    const Vector3f sigmaT = vector3(medium.at("sigma_t_per_mm"));
    core::Material material =
        core::materialFromJson(R"({"brdf": "none", "translucency": {"preset": "marble", "eta": 1}})");
    material.translucency->preset.clear();
    material.translucency->sigmaSPrime = albedo.cwiseProduct(sigmaT);
    material.translucency->sigmaA = (Vector3f::Ones() - albedo).cwiseProduct(sigmaT);
    return material;
}

std::vector<Edit> readEdits(const fs::path& folder, const Json& sceneJson) {
    const bool separate = fs::exists(folder / "edits/edits.json");
    const fs::path base = separate ? folder / "edits" : folder;
    const Json list = separate ? readJson(base / "edits.json").at("edits") : sceneJson.value("edits", Json::array());
    std::vector<Edit> edits;
    for (const Json& entry : list) {
        Edit edit;
        edit.truth = base / entry.at("file").get<std::string>();
        edit.name = edit.truth.stem().string();
        edit.label = entry.at("label");
        const Json& edited = entry.at("edited_material");
        edit.material = edited.contains("walk_medium") ? waxOf(edited.at("walk_medium")) : materialOf(edited);
        edits.push_back(std::move(edit));
    }
    return edits;
}

SceneFolder readSceneFolder(const fs::path& path, const Json& json) {
    SceneFolder folder;
    folder.path = path;
    folder.name = path.filename().string();
    core::CreateOptions options;
    options.color = (path / "color.exr").string();
    options.depth = (path / "depth.exr").string();
    options.segments = (path / "segments.png").string();
    options.intrinsics =
        core::Camera{json.at("width"), json.at("height"), json.at("fx"), json.at("fy"), json.at("cx"), json.at("cy")};
    folder.scene = core::createScene(options);
    for (const Json& entry : json.at("segments")) {
        core::Segment* segment = folder.scene.findSegment(entry.at("label").get<std::uint16_t>());
        if (segment == nullptr) continue;
        segment->name = entry.at("name");
        segment->glossy = entry.at("glossy");
        const Json& material = entry.at("material");
        if (segment->glossy && material.contains("alpha"))
            folder.gloss[segment->label] = {vector3(material.at("specular_color")), material.at("alpha")};
    }
    folder.edits = readEdits(path, json);
    return folder;
}

}  // namespace

std::vector<fs::path> findSceneFolders(const fs::path& root) {
    std::vector<fs::path> folders;
    for (const auto& entry : fs::recursive_directory_iterator(root))
        if (entry.path().filename() == "scene.json") folders.push_back(entry.path().parent_path());
    std::ranges::sort(folders);
    return folders;
}

SceneFolder loadSceneFolder(const fs::path& path) {
    const Json json = readJson(path / "scene.json");
    try {
        return readSceneFolder(path, json);
    } catch (const Json::exception& error) {
        throw core::Error(core::ErrorKind::Input,
                          "\"" + path.string() + "\" is no scene folder as expected: " + error.what());
    }
}

core::ImageV3 trueNormals(const SceneFolder& folder) {
    core::ImageV3 normals = core::ImageReader((folder.path / "normal.exr").string()).readRgb(0, 1, 2);
    for (Vector3f& n : normals.pixels()) n.normalize();
    return normals;
}

core::ImageF trueBackDepth(const SceneFolder& folder) {
    return core::loadScalar((folder.path / "depth_back.exr").string());
}

core::ImageRgb trueEnvironment(const SceneFolder& folder) {
    return core::loadColor((folder.path / "env.exr").string());
}

}  // namespace evaluate
