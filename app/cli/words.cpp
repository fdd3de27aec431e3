// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/words.h"

namespace cli {

const char* taskName(core::Task task) {
    switch (task) {
        case core::Task::Working:
            return "Working";
        case core::Task::LoadPhoto:
            return "Loading the photograph";
        case core::Task::FindRegions:
            return "Finding regions to select";
        case core::Task::RecoverDepth:
            return "Recovering depth";
        case core::Task::ComputeNormals:
            return "Computing normals";
        case core::Task::InventBackSides:
            return "Inventing back sides";
        case core::Task::BuildDepthLayers:
            return "Building depth layers";
        case core::Task::EstimateReflectance:
            return "Estimating reflectance";
        case core::Task::RecoverEnvironment:
            return "Recovering the environment";
        case core::Task::SeparateTexture:
            return "Separating texture from shading";
        case core::Task::Render:
            return "Rendering";
        case core::Task::FilterPicture:
            return "Filtering the picture";
        case core::Task::SumDiffusion:
            return "Summing diffuse light";
        case core::Task::Benchmark:
            return "Running benchmarks";
    }
    return "";
}

std::string sentence(const core::Message& message) {
    switch (message.setting()) {
        case core::Setting::None:
            break;
        case core::Setting::DepthUnit:
            return message.english() + " See --depth-unit.";
        case core::Setting::DepthUnitOrKind:
            return message.english() + " See --depth-unit and --depth-kind.";
        case core::Setting::FieldOfView:
            return message.english() + " See --hfov.";
    }
    return message.english();
}

}  // namespace cli
