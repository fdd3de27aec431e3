// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/scene/mask.h"
#include "core/scene/scene.h"

namespace core {

/// An image file as a mask: stored values of its first channel (Y where there is one), integers over their greatest
/// value, undecoded; clamped to [0, 1]. Throws Error(Input) naming the file when it cannot be read or a value is not
/// finite.
[[nodiscard]] std::shared_ptr<const Mask> loadMask(const std::string& path);

/// Loads each file once, so that drives that name the same one share it.
class MaskLoader {
  public:
    /// Relative paths start at `folder`; "" = the current one.
    explicit MaskLoader(std::string folder = {}) : folder_(std::move(folder)) {}
    [[nodiscard]] std::shared_ptr<const Mask> load(const std::string& path);

  private:
    std::string folder_;
    std::map<std::string, std::shared_ptr<const Mask>> masks_;
};

/// The scene with every mask in a file: those without one are written beside the project, 16-bit PNG in the folder
/// NAME.masks, called by segment, parameter and content, so that a file once written never changes. Throws
/// Error(Output).
[[nodiscard]] Scene withSavedMasks(const Scene& scene, const std::string& project);

}  // namespace core
