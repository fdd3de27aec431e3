// SPDX-License-Identifier: GPL-3.0-or-later
// Compares edits with path-traced truth: for every scene below the folder given (or PATINA_REFERENCE_DATA) it analyses
// the input, renders each edit as recovered, with the true light, and with the true light and back side, and prints one
// table; pictures and the table as JSON go to the output folder.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/io/image_io.h"
#include "core/io/project.h"
#include "core/pipeline.h"
#include "core/render/renderer.h"
#include "gpu/adapter.h"
#include "gpu/instance.h"
#include "tests/evaluate/metrics.h"

namespace {

namespace fs = std::filesystem;
using core::Vector3f;
using Json = nlohmann::json;

struct Edit {
    std::string name;
    std::uint16_t label = 0;
    fs::path truth;
    core::Material material;
};

Json readJson(const fs::path& path) {
    std::ifstream file(path);
    if (!file) throw core::Error(core::ErrorKind::Input, "File \"" + path.string() + "\" cannot be read.");
    return Json::parse(file);
}

Vector3f vector3(const Json& json) {
    return {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

/// The material of an edit as the reference data describes it, in the words of the command line's `--edit`.
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

/// The studio's wax names the index-matched medium that was walked in as albedo and σ_t.
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

std::vector<Edit> editsOf(const fs::path& folder, const Json& sceneJson) {
    std::vector<Edit> edits;
    const bool separate = fs::exists(folder / "edits/edits.json");
    const Json list = separate ? readJson(folder / "edits/edits.json").at("edits") : sceneJson.at("edits");
    for (const Json& entry : list) {
        Edit edit;
        edit.truth = separate ? folder / "edits" / entry.at("file").get<std::string>()
                              : folder / entry.at("file").get<std::string>();
        edit.name = edit.truth.stem().string();
        edit.label = entry.at("label");
        const Json& edited = entry.at("edited_material");
        edit.material = edited.contains("walk_medium") ? waxOf(edited.at("walk_medium")) : materialOf(edited);
        edits.push_back(std::move(edit));
    }
    return edits;
}

core::Scene sceneOf(const fs::path& folder, const Json& json) {
    core::CreateOptions options;
    options.color = (folder / "color.exr").string();
    options.depth = (folder / "depth.exr").string();
    options.segments = (folder / "segments.png").string();
    core::Camera camera;
    camera.width = json.at("width");
    camera.height = json.at("height");
    camera.fx = json.at("fx");
    camera.fy = json.at("fy");
    camera.cx = json.at("cx");
    camera.cy = json.at("cy");
    options.intrinsics = camera;
    core::Scene scene = core::createScene(options);
    for (const Json& segment : json.at("segments")) {
        if (core::Segment* found = scene.findSegment(segment.at("label").get<std::uint16_t>())) {
            found->name = segment.at("name");
            found->glossy = segment.at("glossy");
        }
    }
    return scene;
}

/// Input, ours, ours with the true light, ours with true light and back side, truth: one row, display-encoded.
void saveStrip(const fs::path& path, const std::vector<const core::ImageRgb*>& pictures,
               const core::Image<std::uint8_t>& mask, float exposure) {
    int x0 = mask.width(), y0 = mask.height(), x1 = 0, y1 = 0;
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            if (mask(x, y) == 0) continue;
            x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
        }
    }
    constexpr int kMargin = 24;
    x0 = std::max(x0 - kMargin, 0), y0 = std::max(y0 - kMargin, 0);
    x1 = std::min(x1 + kMargin, mask.width() - 1), y1 = std::min(y1 + kMargin, mask.height() - 1);
    const int width = x1 - x0 + 1;
    const int height = y1 - y0 + 1;
    core::ImageRgb strip(width * static_cast<int>(pictures.size()), height);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x)
                strip(static_cast<int>(i) * width + x, y) = (*pictures[i])(x0 + x, y0 + y) * exposure;
        }
    }
    core::saveColor(strip, path.string());
}

Json toJson(const evaluate::Metrics& m) {
    return {{"psnr", m.psnr}, {"ssim", m.ssim}, {"rel_mse", m.relMse}, {"mean_ratio", m.meanRatio}};
}

void row(const char* what, const std::string& name, const evaluate::Metrics (&m)[4]) {
    std::printf("| %s | %s |", what, name.c_str());
    for (const auto& x : m) std::printf(" %.1f |", x.psnr);
    for (const auto& x : m) std::printf(" %.3f |", x.ssim);
    for (const auto& x : m) std::printf(" %.3f |", x.relMse);
    for (const auto& x : m) std::printf(" %.2f |", x.meanRatio);
    std::printf("\n");
    std::fflush(stdout);
}

void evaluateScene(const fs::path& folder, const fs::path& output, int samples, const gpu::Device& device,
                   Json& results) {
    const Json json = readJson(folder / "scene.json");
    const std::string name = folder.filename().string();
    core::Scene scene = sceneOf(folder, json);
    scene.render.samples = samples;

    core::Scene trueLight = scene;
    trueLight.environment.image = std::make_shared<core::ImageRgb>(core::loadColor((folder / "env.exr").string()));
    trueLight.environment.path = "env.exr";
    core::Scene trueAll = trueLight;
    trueAll.backDepth = std::make_shared<core::ImageF>(core::loadScalar((folder / "depth_back.exr").string()));
    trueAll.backDepthPath = "depth_back.exr";

    core::AnalysisPipeline pipeline;
    for (const Edit& edit : editsOf(folder, json)) {
        const core::ImageRgb truth = core::loadColor(edit.truth.string());
        const float exposure = evaluate::displayExposure(truth);
        const auto mask = evaluate::erodedMask(scene.photo->labels, edit.label, 1);
        std::vector<core::ImageRgb> pictures = {scene.photo->color};
        for (core::Scene* variant : {&scene, &trueLight, &trueAll}) {
            core::Scene edited = *variant;
            edited.findSegment(edit.label)->edit = edit.material;
            pictures.push_back(render::renderImage(device, edited, pipeline.run(edited)));
        }
        evaluate::Metrics metrics[4];
        Json entry = {{"scene", name}, {"edit", edit.name}};
        const char* keys[4] = {"unedited", "ours", "true_light", "true_light_and_back"};
        for (std::size_t i = 0; i < 4; ++i) {
            metrics[i] = evaluate::compare(pictures[i], truth, mask, exposure);
            entry[keys[i]] = toJson(metrics[i]);
        }
        row(name.c_str(), edit.name, metrics);
        results.push_back(entry);
        saveStrip(output / (name + "_" + edit.name + ".png"),
                  {&pictures[0], &pictures[1], &pictures[2], &pictures[3], &truth}, mask, exposure);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const char* folder = argc > 1 ? argv[1] : std::getenv("PATINA_REFERENCE_DATA");
    if (folder == nullptr) {
        std::fputs("Skipped: PATINA_REFERENCE_DATA does not name a folder with reference scenes.\n", stderr);
        return 0;
    }
    const fs::path output = argc > 2 ? argv[2] : "evaluation";
    const int samples = argc > 3 ? std::atoi(argv[3]) : 64;
    try {
        fs::create_directories(output);
        const gpu::Device device = gpu::Instance::create().requestAdapter({}).requestDevice({.label = "evaluate"});
        std::printf(
            "PSNR [dB], SSIM, relative MSE and mean radiance over truth, inside the edited segment eroded by one "
            "pixel;\n"
            "each for: unedited / ours / ours + true light / ours + true light + true back side; %d samples.\n\n",
            samples);
        std::printf("| scene | edit |");
        for (const char* metric : {"PSNR", "SSIM", "relMSE", "mean"})
            for (const char* variant : {"unedited", "ours", "+light", "+back"})
                std::printf(" %s %s |", metric, variant);
        std::printf("\n|---|---|");
        for (int i = 0; i < 16; ++i) std::printf("---|");
        std::printf("\n");
        Json results = Json::array();
        std::vector<fs::path> scenes;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.path().filename() == "scene.json") scenes.push_back(entry.path().parent_path());
        std::sort(scenes.begin(), scenes.end());
        for (const auto& scene : scenes) evaluateScene(scene, output, samples, device, results);
        std::ofstream(output / "evaluation.json") << results.dump(1) << "\n";
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
