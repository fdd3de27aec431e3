// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/devices.h"
#include "app/cli/session.h"
#include "core/analysis/notes.h"
#include "core/io/image_io.h"
#include "core/io/material_json.h"
#include "core/io/photo_loader.h"
#include "core/material/brdf_file.h"
#include "core/material/metals.h"
#include "core/scene/masks.h"
#include "core/scene/params.h"
#include "render/kernels/brdf_check.h"
#include "render/renderer.h"

namespace cli {

namespace {

struct RenderArguments {
    std::string project;
    std::vector<std::string> edits;
    std::vector<std::string> reflectances;
    std::vector<std::pair<const core::SceneParam*, double>> params;
    std::string environment;
    std::string backDepth;
    bool completeEnvironment = false;
    std::string output;
};

/// An option that sets a parameter of the scene; its range is that of core/scene/params.h. An option of a switch is a
/// flag for the state that is not the initial one.
struct ParamOption {
    const char* option;
    const char* key;
    const char* type;
    const char* help;
};

constexpr ParamOption kParamOptions[] = {
    {"--samples", "render.samples", "N", "Paths per pixel"},
    {"--time-limit", "render.time_limit", "S",
     "Stop rendering after this many seconds, but not before the first picture"},
    {"--bounces", "render.bounces", "N", "Surfaces a path may visit"},
    {"--seed", "render.seed", "N", "Seed of the random numbers"},
    {"--no-filter", "render.filter", "", "Leave the noise in"},
};

struct Edits {
    std::vector<std::pair<std::string, core::Material>> materials;
    std::vector<std::pair<std::string, core::Vector3f>> reflectances;
};

/// Sets the check that BRDFs by the user have to pass, and clears it at the end of the scope.
class UserBrdfChecks {
  public:
    explicit UserBrdfChecks(core::UserBrdfCheck check) { core::setUserBrdfCheck(std::move(check)); }
    ~UserBrdfChecks() { core::setUserBrdfCheck({}); }
    UserBrdfChecks(const UserBrdfChecks&) = delete;
    UserBrdfChecks& operator=(const UserBrdfChecks&) = delete;
};

std::string shortNumber(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

/// Parses the edits before anything is loaded; throws Error(Usage) for all that can be wrong without the project.
Edits parseEdits(const RenderArguments& args) {
    Edits edits;
    for (const std::string& text : args.edits) {
        const auto [label, json] = parseAssignment("--edit", text);
        try {
            edits.materials.emplace_back(label, core::materialFromJson(json));
        } catch (const core::Error& error) {
            throw error.withContext("In --edit of \"" + label + "\".");
        }
    }
    for (const std::string& text : args.reflectances) {
        const auto [label, value] = parseAssignment("--reflectance", text);
        const std::vector<float> rgb = parseNumbers("--reflectance", value, 3);
        const auto [min, max] = core::segmentParam("reflectance").legal;
        for (const float component : rgb)
            if (!(component >= static_cast<float>(min) && component <= static_cast<float>(max)))
                throw core::Error(core::ErrorKind::Usage, "--reflectance is \"" + text + "\", expected numbers in [" +
                                                              shortNumber(min) + ", " + shortNumber(max) + "].");
        edits.reflectances.emplace_back(label, core::Vector3f(rgb[0], rgb[1], rgb[2]));
    }
    return edits;
}

/// Applies edits and options to the scene of a project.
void applyArguments(const RenderArguments& args, const Edits& edits, core::Scene& scene) {
    if (!args.environment.empty()) {
        scene.environment.path = args.environment;
        core::Notes notes;
        scene.environment.image = core::loadEnvironment(args.environment, &notes);
        printNotes(notes);
        scene.environment.use =
            args.completeEnvironment ? core::EnvironmentUse::Complete : core::EnvironmentUse::Replace;
    }
    if (!args.backDepth.empty()) {
        scene.backDepthPath = args.backDepth;
        scene.backDepth = core::loadBackDepth(args.backDepth, scene.photo->camera);
    }
    for (const auto& [label, material] : edits.materials) requireSegment(scene, label).edit = material;
    for (const auto& [label, rho] : edits.reflectances) requireSegment(scene, label).reflectance = rho;
    // The time limit of a project is for the window.
    scene.render.timeLimit = 0;
    for (const auto& [param, value] : args.params) param->set(scene, core::fromNumber(*param, value));
}

/// Refuses edits that cannot be rendered.
void requireUsableEdits(const core::Scene& scene) {
    core::requireMasksFit(scene);
    for (const core::Segment& segment : scene.segments)
        if (segment.edit && !core::usable(*segment.edit))
            throw core::Error(core::ErrorKind::Input, segment.edit->brdfFile->problem)
                .withContext("In the edit of \"" + segment.name + "\".");
}

void render(const RenderArguments& args, const Session& session) {
    gpu::Device device;
    const auto open = [&] {
        if (!device) device = openDevice(session);
    };
    const UserBrdfChecks checks([&](const std::shared_ptr<const core::BrdfFile>& file) {
        open();
        render::requireSound(device, file);
    });
    const Edits edits = parseEdits(args);
    core::requireColorExtension(args.output);
    core::Scene scene = loadScene(args.project);
    applyArguments(args, edits, scene);
    requireUsableEdits(scene);
    refuseOverwritingInput(scene, args.project, args.output);
    core::requireWritable(args.output);

    open();
    const std::shared_ptr<const core::Analysis> analysis = analyse(scene, session);
    printNotes(core::analysisNotes(scene, *analysis));
    render::Renderer::Progress reached;
    const core::ImageRgb result =
        render::renderImage(device, scene, analysis, printedProgress().of(core::Task::Render), &reached);
    finishProgress();
    if (reached.timeUp)
        printNotes(core::Notes{core::Message("messages", "The time limit ended rendering after %1 of %2 samples.")
                                   .with(reached.samples, reached.target)});
    core::saveColor(result, args.output);
}

std::string metalWords() {
    std::string words;
    for (const core::Metal& metal : core::metals())
        words += (words.empty() ? "\"" : ", \"") + std::string(metal.key) + "\"";
    return words;
}

std::string brdfWords() {
    std::string words;
    for (const core::BrdfInfo& info : core::brdfs()) {
        words += std::string("  ") + info.key;
        for (const core::ParamInfo& param : info.params)
            words += (&param == info.params.data() ? ": " : ", ") + std::string(param.key);
        words += "\n";
    }
    return words;
}

std::string footer() {
    return std::string(
               "An edit is LABEL=JSON; LABEL is the number in the label map or the segment's name. Keys of the "
               "JSON object, "
               "all\n") +
           "optional but \"brdf\":\n"
           "  \"brdf\"          one of those below, with its own parameters, or \"file:PATH\": a measured BRDF (MERL)\n"
           "                  or one of your own (NAME.brdf.glsl)\n"
           "  \"albedo\"        [r, g, b], diffuse colour\n"
           "  \"specular\"      [r, g, b], or \"estimated\" (the default) from the photograph\n"
           "  \"fresnel\"       \"none\", \"schlick\", \"dielectric\", \"conductor\", with \"eta\" and \"k\"\n"
           "  \"metal\"         " +
           metalWords() +
           ": conductor with its eta and k\n"
           "  \"blend\"         {\"new\": 1, \"original\": 0}, weights of the new and the old picture\n"
           "  \"translucency\"  {\"preset\": \"marble\"}, {\"sigma_a\": [..], \"sigma_s_prime\": [..]} in 1/mm, or\n"
           "                  {\"diffuse_color\": [..], \"mean_free_path_mm\": [..]}; each with \"eta\", \"scale\", "
           "\"weight\"\n"
           "  \"drives\"        parameters that vary over the segment, a list of {\"parameter\": \"alpha\", \"mask\": "
           "\"FILE\",\n"
           "                  \"from\": 0.05, \"to\": 0.5, \"invert\": false, \"contrast\": 1}: the values where the "
           "mask "
           "is 0 and 1,\n"
           "                  of colours [r, g, b] or a factor; {\"parameter\": \"albedo\", \"source\": \"luminance\", "
           "\"strength\": 1}\n"
           "                  keeps the photograph's texture\n\n"
           "BRDFs and their parameters:\n" +
           brdfWords() +
           "\nThe same project, options, seed and device give the same bytes, unless there is a time limit.\n\n"
           "Example:\n"
           "  patina-cli render studio.patina --edit 'vase={\"brdf\": \"ggx\", \"alpha\": 0.35}' -o rough.png";
}

void addParamOption(CLI::App& command, const ParamOption& option, const std::shared_ptr<RenderArguments>& args) {
    const core::SceneParam& param = core::sceneParam(option.key);
    if (std::holds_alternative<bool>(param.initial)) {
        const double flipped = core::toNumber(param.initial) != 0 ? 0 : 1;
        command.add_flag_callback(
            option.option, [args, &param, flipped] { args->params.emplace_back(&param, flipped); }, option.help);
        return;
    }
    const auto store = [args, &param](const auto& value) {
        args->params.emplace_back(&param, static_cast<double>(value));
    };
    CLI::Option* added = nullptr;
    if (std::holds_alternative<std::int64_t>(param.initial))
        added = command.add_option_function<std::int64_t>(option.option, store, option.help)
                    ->check(CLI::Range(static_cast<std::int64_t>(param.legal.min),
                                       static_cast<std::int64_t>(param.legal.max)));
    else
        added = command.add_option_function<double>(option.option, store, option.help)
                    ->check(CLI::Range(param.legal.min, param.legal.max));
    added->type_name(option.type);
}

}  // namespace

void addRender(CLI::App& app, Session& session) {
    const auto args = std::make_shared<RenderArguments>();
    CLI::App* command = app.add_subcommand("render", "Apply edits and write the picture");
    command->footer(footer());
    command->add_option("project", args->project, "Project file")->required()->type_name("P.patina");
    command->add_option("--edit", args->edits, "Change a segment's material; may be given several times")
        ->type_name("LABEL=JSON")
        ->expected(1)
        ->take_all();
    for (const ParamOption& option : kParamOptions) addParamOption(*command, option, args);
    CLI::Option* environment = command
                                   ->add_option("--environment", args->environment,
                                                "Use this latitude-longitude map instead of the recovered light")
                                   ->type_name("FILE");
    command
        ->add_flag("--complete-environment", args->completeEnvironment,
                   "Use the map of --environment only for directions that the photograph does not show")
        ->needs(environment);
    command->add_option("--back-depth", args->backDepth, "Use these back sides instead of invented ones")
        ->type_name("FILE");
    command
        ->add_option("--reflectance", args->reflectances,
                     "Reflectance of a glossy segment instead of the estimated one; may be given several times")
        ->type_name("LABEL=R,G,B")
        ->expected(1)
        ->take_all();
    command->add_option("-o,--output", args->output, "Picture to write: .exr, .hdr (linear), .png, .tif, .jpg (sRGB)")
        ->required()
        ->type_name("FILE");
    command->callback([&session, args] { session.run = [&session, args] { render(*args, session); }; });
}

}  // namespace cli
