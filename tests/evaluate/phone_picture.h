// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "tests/evaluate/scene_folder.h"

namespace evaluate {

/// What a phone would keep of a path-traced scene. Nothing is random.
enum class PhoneDepth {
    Phone,  ///< its own small map: disparity reduced by 2.5, relief and corners finer than three samples lost, blurred
            ///< across edges (σ = 1 sample), shifted by 0.6 and −0.4 samples, rounded to 8 bits over its range
    Exact   ///< the scene's own
};

/// Radiance that becomes white in the phone's picture: the 98th percentile of the brightest channel.
[[nodiscard]] float phoneWhite(const SceneFolder& folder);

/// The scene with an 8-bit picture (divided by `phoneWhite`, clipped at 1, JPEG of quality 92) and the given depth,
/// loaded from files below `temporary` as a user's files are. Names and glossy flags are the folder's.
[[nodiscard]] core::Scene phoneScene(const SceneFolder& folder, PhoneDepth depth,
                                     const std::filesystem::path& temporary);

}  // namespace evaluate
