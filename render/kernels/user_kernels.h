// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <span>
#include <vector>

#include "core/material/user_brdf.h"
#include "core/scene/scene.h"
#include "shaders/shared/path.h"

namespace render {

/// BRDFs that the user wrote, in the order of their ids (shaders/brdf/user.h).
using UserFiles = std::vector<std::shared_ptr<const core::UserBrdf>>;

/// User BRDFs of a scene's edits, each once; writes their ids into `shading` (by label). Throws core::Error(Input) for
/// more than BRDF_USER_COUNT.
[[nodiscard]] UserFiles placeUserBrdfs(const core::Scene& scene, std::span<kernel::SegmentShading> shading);

enum class UserKernel { Reshade, Irradiance, CheckBrdf };

/// SPIR-V of a kernel with these BRDFs. Throws core::Error(Input) "PATH:LINE: REASON" for a file that is no GLSL.
/// Any thread; tenths of a second.
[[nodiscard]] std::vector<std::uint32_t> compileUserKernel(UserKernel kernel, const UserFiles& files);

/// The renderer's kernels with BRDFs that the user wrote, compiled in the background.
class UserKernels {
  public:
    struct Code {
        UserFiles files;
        std::vector<std::uint32_t> reshade;
        std::vector<std::uint32_t> irradiance;  ///< empty unless asked for
    };

    /// Starts to compile the kernel for these files; none = the program's own kernels.
    void want(const UserFiles& files, bool irradiance);
    /// Whether `code` is up to date, after waiting for up to `seconds`. Rethrows errors of compilation.
    [[nodiscard]] bool ready(double seconds);
    /// nullptr for the program's own kernels.
    [[nodiscard]] const std::shared_ptr<const Code>& code() const { return code_; }

  private:
    [[nodiscard]] bool current() const;
    void start();

    UserFiles files_;
    bool irradiance_ = false;
    std::shared_ptr<const Code> code_;
    std::future<std::shared_ptr<const Code>> compiling_;
};

}  // namespace render
