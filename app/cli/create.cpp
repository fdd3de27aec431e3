// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <numbers>
#include <sstream>

#include "app/cli/session.h"
#include "core/io/import/import_format.h"
#include "core/io/project.h"

namespace cli {

namespace {

struct CreateArguments {
    core::CreateOptions options;
    std::string depthKind;
    double depthUnit = 0;
    std::string intrinsics;
    float hfovDegrees = 0;
    std::string glossy;
    std::string output;
};

/// Files in which a photograph may carry its depth, one a line.
std::string depthInside() {
    std::string text;
    for (const core::ImportFormat* format : core::importFormats()) text += "\n  " + std::string(format->name);
    return text;
}

}  // namespace

void addCreate(CLI::App& app, Session& session) {
    const auto args = std::make_shared<CreateArguments>();
    CLI::App* command =
        app.add_subcommand("create", "Make a project from a photograph, its depth map and its segments");
    command->footer(
        "Images: EXR, PNG, TIFF, JPEG, PFM, HDR. Depth and segments may be smaller than the photograph if their shape "
        "is\n"
        "the same. A photograph may carry its depth:" +
        depthInside() +
        ".\n"
        "Without --intrinsics and --hfov, the photograph's own intrinsics are used, otherwise the focal length of its "
        "EXIF\n"
        "data, otherwise a field of view of 60 degrees.\n\n"
        "Example:\n"
        "  patina-cli create --color desk.jpg --depth desk_mm.png --segments desk_labels.png --glossy 2,5 \\\n"
        "      --hfov 66 -o desk.patina");
    command->add_option("--color", args->options.color, "Photograph")->required()->type_name("FILE");
    command
        ->add_option(
            "--depth", args->options.depth,
            "Depth map, or another photograph that carries its depth; not needed when the photograph carries its depth")
        ->type_name("FILE");
    CLI::Option* kind =
        command
            ->add_option("--depth-kind", args->depthKind,
                         "What depth values mean: z (planar), distance (along the ray), disparity or inverse (1/z) "
                         "[default: as stated by the photograph, otherwise z]")
            ->type_name("KIND")
            ->check(CLI::IsMember(core::wordsOf<core::DepthKind>()));
    CLI::Option* unit =
        command
            ->add_option("--depth-unit", args->depthUnit,
                         "Metres per stored unit [default: as stated by the photograph, otherwise 1 for "
                         "floating point and 0.001 for 16 bit]")
            ->type_name("METRES");
    CLI::Option* intrinsics =
        command->add_option("--intrinsics", args->intrinsics, "Focal lengths and principal point in pixels")
            ->type_name("FX,FY,CX,CY");
    CLI::Option* hfov = command->add_option("--hfov", args->hfovDegrees, "Horizontal field of view in degrees")
                            ->type_name("DEGREES")
                            ->excludes(intrinsics);
    command->add_option("--segments", args->options.segments, "Label map: one number per pixel, 0 = no segment")
        ->type_name("FILE");
    command->add_option("--glossy", args->glossy, "Segments that show reflections, by label")->type_name("LABEL,...");
    command->add_option("-o,--output", args->output, "Project file to write")->required()->type_name("P.patina");
    command->callback([&session, args, kind, unit, hfov] {
        session.run = [args, kind, unit, hfov] {
            core::CreateOptions& options = args->options;
            if (kind->count() > 0) options.depthKind = core::findWord<core::DepthKind>(args->depthKind);
            if (unit->count() > 0) options.depthUnit = args->depthUnit;
            if (!args->intrinsics.empty()) {
                const std::vector<float> n = parseNumbers("--intrinsics", args->intrinsics, 4);
                options.intrinsics = core::Camera{0, 0, n[0], n[1], n[2], n[3]};
            }
            if (hfov->count() > 0) options.hfov = args->hfovDegrees * std::numbers::pi_v<float> / 180.0f;
            std::istringstream list(args->glossy);
            for (std::string label; std::getline(list, label, ',');)
                if (!label.empty()) options.glossy.push_back(label);
            core::Notes notes;
            const core::Scene scene = core::createScene(options, &notes);
            printNotes(notes);
            refuseOverwritingInput(scene, {}, args->output);
            core::saveProject(scene, args->output);
        };
    });
}

}  // namespace cli
