// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "tests/evaluate/json.h"

namespace evaluate {

/// A path-traced picture of the scene with one segment's material replaced.
struct Edit {
    std::string name;
    std::uint16_t label = 0;
    std::filesystem::path truth;  ///< scene-linear, same scale as the photograph
    core::Material material;      ///< new material of the segment
};

/// True material of a glossy segment.
struct TrueGloss {
    core::Vector3f specularColor{0, 0, 0};
    float alpha = 0;  ///< GGX width
};

/// A path-traced photograph and the ground truth of everything the analysis recovers. The reference data's README files
/// explain folders and conventions.
struct SceneFolder {
    std::filesystem::path path;
    std::string name;
    core::Scene scene;                         ///< true depth and labels, segments named and flagged
    std::map<std::uint16_t, TrueGloss> gloss;  ///< of the glossy segments
    std::vector<Edit> edits;
};

/// Folders with a scene.json below `root`, sorted.
[[nodiscard]] std::vector<std::filesystem::path> findSceneFolders(const std::filesystem::path& root);
/// Throws core::Error(Input) for missing files and unknown contents.
[[nodiscard]] SceneFolder loadSceneFolder(const std::filesystem::path& path);

[[nodiscard]] core::ImageV3 trueNormals(const SceneFolder& folder);       ///< unit; zero where there is no surface
[[nodiscard]] core::ImageF trueBackDepth(const SceneFolder& folder);      ///< planar z [m]; 0 = none
[[nodiscard]] core::ImageRgb trueEnvironment(const SceneFolder& folder);  ///< latitude-longitude, camera frame

}  // namespace evaluate
