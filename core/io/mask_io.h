// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/scene/mask.h"
#include "core/scene/scene.h"

namespace core {

/// An image file as a mask: the stored values of its first channel (Y where there is one), undecoded, integers divided
/// by their maximum; clamped to [0, 1]. Throws Error(Input) naming the file when it cannot be read or a value is not
/// finite.
[[nodiscard]] std::shared_ptr<const Mask> loadMask(const std::string& path);

/// Loads each file once, so that drives of the same file share its mask.
class MaskLoader {
  public:
    /// Relative paths start at `folder`; "" = the current one.
    explicit MaskLoader(std::string folder = {}) : folder_(std::move(folder)) {}
    [[nodiscard]] std::shared_ptr<const Mask> load(const std::string& path);

  private:
    std::string folder_;
    std::map<std::string, std::shared_ptr<const Mask>> masks_;
};

/// The scene with every mask in a file. Masks without one are written beside the project, as 16-bit PNG in the folder
/// NAME.masks, named after segment, parameter and content, so that a file once written never changes. Throws
/// Error(Output).
[[nodiscard]] Scene withSavedMasks(const Scene& scene, const std::string& project);

}  // namespace core
