// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/brdf.h"
#include "core/measured_brdf.h"

namespace core {

/// A BRDF that a file defines. Immutable and shared by the materials that name the file.
struct BrdfFile {
    std::string path;     ///< absolute, or relative to the current folder
    std::string name;     ///< for people
    std::string problem;  ///< why it cannot be used, a full sentence that names the file; "" = usable
    std::shared_ptr<const MeasuredBrdf> measured;
    BrdfInfo info;  ///< key kFileBrdf

    BrdfFile() = default;
    BrdfFile(const BrdfFile&) = delete;
    BrdfFile& operator=(const BrdfFile&) = delete;
};

/// Loads a measured BRDF (core/measured_brdf.h). A file that did not change since it was last loaded, and is still in
/// use, gives the same object. Throws Error(Input) naming the file, what was expected and what was found. Any thread.
[[nodiscard]] std::shared_ptr<const BrdfFile> loadBrdfFile(const std::string& path);

/// The same, but a file that cannot be used gives an object that says why.
[[nodiscard]] std::shared_ptr<const BrdfFile> loadBrdfFileOrProblem(const std::string& path);

/// A material of the file's BRDF with its initial values.
[[nodiscard]] Material fileMaterial(std::shared_ptr<const BrdfFile> file);

/// The material with another state of its file: parameters keep their values by key.
[[nodiscard]] Material withReloadedFile(const Material& material, std::shared_ptr<const BrdfFile> file);

}  // namespace core
