// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "app/cli/devices.h"
#include "app/cli/session.h"
#include "core/analysis/notes.h"
#include "core/io/cryptomatte.h"
#include "core/io/image_io.h"
#include "core/material/drive_parameters.h"
#include "core/shading/drive_table.h"

namespace cli {

namespace {

using Analysis = core::Analysis;
constexpr float kMillimetres = 1000.0f;
constexpr float kMilliSquareMillimetres = 1e9f;

/// A layer: its name and how it is written.
struct Layer {
    const char* name;
    void (*save)(const core::Scene& scene, const Analysis& analysis, const std::string& path);
};

/// Layers of the input, which need no analysis; `analysis` is empty.
constexpr std::array kInputLayers{
    Layer{"color", [](const core::Scene& scene, const Analysis&,
                      const std::string& path) { core::saveColor(scene.photo->color, path); }},
    Layer{"segments", [](const core::Scene& scene, const Analysis&,
                         const std::string& path) { core::saveLabels(scene.photo->labels, path); }},
    Layer{"cryptomatte", [](const core::Scene& scene, const Analysis&,
                            const std::string& path) { core::saveCryptomatte(scene, path); }},
};

/// Layers computed by the analysis.
constexpr std::array kAnalysisLayers{
    Layer{"depth", [](const core::Scene&, const Analysis& analysis,
                      const std::string& path) { core::saveScalar(analysis.front->depth, path, "Z", kMillimetres); }},
    Layer{"normals", [](const core::Scene&, const Analysis& analysis,
                        const std::string& path) { core::saveVectors(analysis.front->normal, path); }},
    Layer{"positions", [](const core::Scene&, const Analysis& analysis,
                          const std::string& path) { core::savePositions(analysis.front->position, path); }},
    Layer{"area",
          [](const core::Scene&, const Analysis& analysis, const std::string& path) {
              core::saveScalar(analysis.front->area, path, "area", kMilliSquareMillimetres);
          }},
    Layer{"back-depth",
          [](const core::Scene&, const Analysis& analysis, const std::string& path) {
              core::saveScalar(analysis.back->depth, path, "Z", kMillimetres);
          }},
    Layer{"back-normals", [](const core::Scene&, const Analysis& analysis,
                             const std::string& path) { core::saveVectors(analysis.back->normal, path); }},
    Layer{"environment", [](const core::Scene&, const Analysis& analysis,
                            const std::string& path) { core::saveDirectionalMap(*analysis.environment, path); }},
    Layer{"coverage",
          [](const core::Scene&, const Analysis& analysis, const std::string& path) {
              core::saveScalar(analysis.environment->coverage, path, "coverage", 1.0f);
          }},
};

const Layer* findLayer(std::span<const Layer> layers, const std::string& name) {
    for (const Layer& layer : layers)
        if (name == layer.name) return &layer;
    return nullptr;
}

[[noreturn]] void failUnknownLayer(const std::string& name) {
    std::string known;
    for (const std::span<const Layer> layers :
         {std::span<const Layer>(kInputLayers), std::span<const Layer>(kAnalysisLayers)})
        for (const Layer& layer : layers) known += std::string(layer.name) + ", ";
    throw core::Error(core::ErrorKind::Usage, "There is no layer \"" + name + "\", expected one of " + known +
                                                  "reflected:LABEL, incident:LABEL, parameter:LABEL:NAME.");
}

/// Writes a parameter of an edit, with its drives: colours as colours, scalars unscaled.
void saveParameter(const core::Scene& scene, const Analysis& analysis, const core::Segment& segment,
                   const std::string& parameter, const std::string& path) {
    constexpr float kTenThousandths = 10000;
    const core::ImageRgb values = core::effectiveParameter(scene, analysis, segment, parameter);
    const std::vector<core::DriveParameter> known = core::driveParameters(*segment.edit);
    if (std::ranges::find(known, parameter, &core::DriveParameter::key)->color) return core::saveColor(values, path);
    core::ImageF scalars(values.width(), values.height());
    for (std::size_t i = 0; i < scalars.size(); ++i) scalars[i] = values[i].x();
    core::saveScalar(scalars, path, "Y", kTenThousandths);
}

void exportLayer(const std::string& project, const std::string& name, const std::string& output,
                 const Session& session) {
    const std::size_t colon = name.find(':');
    const std::string kind = name.substr(0, colon);
    const bool parameter = kind == "parameter";
    const bool perSegment = kind == "reflected" || kind == "incident" || parameter;
    const std::size_t last = parameter ? name.rfind(':') : std::string::npos;
    if (parameter && (colon == std::string::npos || last == colon)) failUnknownLayer(name);
    const Layer* input = findLayer(kInputLayers, name);
    const Layer* analysed = findLayer(kAnalysisLayers, name);
    if (perSegment ? colon == std::string::npos : input == nullptr && analysed == nullptr) failUnknownLayer(name);
    core::requireColorExtension(output);

    core::Scene scene = loadScene(project);
    refuseOverwritingInput(scene, project, output);
    if (input != nullptr) return input->save(scene, {}, output);

    std::optional<std::uint16_t> label;
    if (perSegment) {
        const core::Segment& segment =
            requireSegment(scene, name.substr(colon + 1, parameter ? last - colon - 1 : std::string::npos));
        if (!parameter && !segment.glossy)
            throw core::Error(core::ErrorKind::Usage,
                              "The segment \"" + segment.name + "\" is not glossy, so it has no " + kind + " light.");
        label = segment.label;
    }
    const std::shared_ptr<const Analysis> analysis = analyse(scene, session);
    printNotes(core::analysisNotes(scene, *analysis));
    if (!perSegment) return analysed->save(scene, *analysis, output);
    if (parameter) return saveParameter(scene, *analysis, *scene.findSegment(*label), name.substr(last + 1), output);
    const core::Reflectance* reflectance = analysis->findReflectance(*label);
    if (reflectance == nullptr)
        throw core::Error(core::ErrorKind::Input, "The segment \"" + name.substr(colon + 1) +
                                                      "\" shows no reflection: none of its pixels has depth.");
    core::saveDirectionalMap(kind == "reflected" ? reflectance->reflected : reflectance->incident, output);
}

}  // namespace

void addExport(CLI::App& app, Session& session) {
    struct Arguments {
        std::string project;
        std::string layer;
        std::string output;
    };
    const auto args = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("export", "Write a layer of the project as an image");
    command->footer(
        "Layers:\n"
        "  color            the photograph\n"
        "  depth            planar depth after filtering [m]; PNG: millimetres\n"
        "  normals          unit normals in the camera frame (x right, y down, z forward); PNG: 0.5 + 0.5 n\n"
        "  positions        points in the camera frame [m]\n"
        "  area             surface area behind each pixel [m^2]; PNG: 1/1000 mm^2\n"
        "  segments         label map\n"
        "  cryptomatte      segments as Cryptomatte 1.2 (EXR)\n"
        "  back-depth       depth of the invented back sides [m]\n"
        "  back-normals     normals of the back sides\n"
        "  reflected:LABEL  light reflected by a glossy segment, by mirrored view direction (latitude-longitude)\n"
        "  incident:LABEL   light that reaches a glossy segment (latitude-longitude)\n"
        "  parameter:LABEL:NAME  parameter of a segment's edit per pixel, with its drives (alpha, albedo, ...);\n"
        "                   PNG: colours sRGB, others in 1/10000\n"
        "  environment      the recovered distant light (latitude-longitude; in EXR with the coverage as a channel)\n"
        "  coverage         number of pixels that observed each direction of the environment; 0 = interpolated\n\n"
        "The format follows the extension: .exr, .png, .tif, .jpg, .hdr.");
    command->add_option("project", args->project, "Project file")->required()->type_name("P.patina");
    command->add_option("--layer", args->layer, "Layer to write")->required()->type_name("LAYER");
    command->add_option("-o,--output", args->output, "Image to write")->required()->type_name("FILE");
    command->callback([&session, args] {
        session.run = [&session, args] { exportLayer(args->project, args->layer, args->output, session); };
    });
}

}  // namespace cli
