// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/session.h"
#include "core/io/image_io.h"
#include "core/io/label_map.h"
#include "core/io/project.h"
#include "core/scene/segments.h"
#include "core/selection/selector.h"

namespace cli {

namespace {

/// A point that the user gave.
struct SegmentClick {
    bool removes = false;
    std::string point;  ///< "X,Y"
};

struct SegmentArguments {
    std::string project;
    std::vector<std::string> add;
    std::vector<std::string> remove;
    std::vector<SegmentClick> clicks;  ///< both, in the order they were given
    bool propose = false;
    std::string into;
    std::string output;
};

core::Pixel parsePixel(const SegmentClick& click) {
    // Farther points lie outside every photograph.
    constexpr float kFar = 1e6f;
    const std::vector<float> xy = parseNumbers(click.removes ? "--remove" : "--add", click.point, 2);
    return {static_cast<int>(std::floor(std::clamp(xy[0], -kFar, kFar))),
            static_cast<int>(std::floor(std::clamp(xy[1], -kFar, kFar)))};
}

/// What the clicks point at; of two on one pixel the later counts, as in the window.
core::SelectionSeeds seedsOf(const std::vector<SegmentClick>& clicks) {
    core::SelectionSeeds seeds;
    for (const SegmentClick& click : clicks) {
        const core::Pixel pixel = parsePixel(click);
        const auto same = [&](const core::Pixel& other) { return other.x == pixel.x && other.y == pixel.y; };
        std::erase_if(seeds.add, same);
        std::erase_if(seeds.remove, same);
        (click.removes ? seeds.remove : seeds.add).push_back(pixel);
    }
    if (!clicks.empty() && seeds.add.empty())
        throw core::Error(core::ErrorKind::Usage, "Each point of --add is taken away by a later --remove.");
    return seeds;
}

/// The points of both options in the order of the command line.
std::vector<SegmentClick> clicksInOrder(const CLI::App& command, const SegmentArguments& args) {
    std::vector<SegmentClick> clicks;
    std::size_t added = 0, removed = 0;
    for (const CLI::Option* option : command.parse_order()) {
        if (option->check_name("--add")) clicks.push_back({false, args.add.at(added++)});
        if (option->check_name("--remove")) clicks.push_back({true, args.remove.at(removed++)});
    }
    return clicks;
}

void checkUsage(const SegmentArguments& args) {
    const auto fail = [](const char* message) { throw core::Error(core::ErrorKind::Usage, message); };
    if (args.propose && (!args.add.empty() || !args.remove.empty() || !args.into.empty()))
        fail("--propose finds all objects; it takes no --add, --remove or --into.");
    if (!args.propose && args.add.empty()) fail("Nothing says what to select: give --add X,Y or --propose.");
}

void segment(const SegmentArguments& args) {
    checkUsage(args);
    const core::SelectionSeeds seeds = seedsOf(args.clicks);
    const core::Scene scene = loadScene(args.project);
    refuseOverwritingInput(scene, args.project, args.output);
    core::requireWritable(args.output);
    const core::Photo& photo = *scene.photo;
    const core::Progress progress = printedProgress().of(core::Task::FindRegions);
    const core::Selector selector({photo.color, photo.depth, photo.camera, photo.depthSampleSpacing},
                                  progress.part(0, 0.9f));
    if (args.propose) {
        const core::LabelImage objects = selector.propose(progress.part(0.9f, 1.0f));
        finishProgress();
        return core::saveLabels(objects, args.output);
    }
    const core::BinaryMask mask = selector.select(seeds, progress.part(0.9f, 1.0f));
    finishProgress();
    if (args.into.empty()) return core::saveMask(mask, args.output);
    core::Notes notes;
    const core::Scene changed = core::withSegment(scene, mask, args.into, &notes);
    core::saveMask(mask, args.output);
    core::saveProject(changed, args.project);
    printNotes(notes);
}

}  // namespace

void addSegment(CLI::App& app, Session& session) {
    const auto args = std::make_shared<SegmentArguments>();
    CLI::App* command = app.add_subcommand("segment", "Select an object in the photograph by pointing at it");
    command->footer(
        "Points are pixels of the photograph, the first one is 0,0. Each --add lies on the object, each --remove "
        "beside\n"
        "it; usually one --add is enough. Of two points on one pixel the later counts.\n\n"
        "Example:\n"
        "  patina-cli segment desk.patina --add 820,410 --into vase -o vase.png");
    command->add_option("project", args->project, "Project file")->required()->type_name("P.patina");
    command->add_option("--add", args->add, "Point on the object; may be repeated")->type_name("X,Y")->take_all();
    command->add_option("--remove", args->remove, "Point that is not on the object; may be repeated")
        ->type_name("X,Y")
        ->take_all();
    command->add_flag("--propose", args->propose, "Find all objects that stand on a table, floor or wall, by depth");
    command->add_option("--into", args->into, "Make the selection this segment of the project, new or existing")
        ->type_name("LABEL");
    command->add_option("-o,--output", args->output, "Mask to write, 255 = selected; with --propose a label map")
        ->required()
        ->type_name("FILE");
    command->callback([&session, args, command] {
        args->clicks = clicksInOrder(*command, *args);
        session.run = [args] { segment(*args); };
    });
}

}  // namespace cli
