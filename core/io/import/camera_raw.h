// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace core {

/// Throws Error(Input) when the file holds what a camera's sensor measured (DNG, CR2, CR3, NEF, ARW, ORF, RAF, RW2...):
/// the picture that image libraries find in it is a preview. Decides by content; other files, and those that cannot be
/// opened, pass.
void refuseCameraRaw(const std::string& path);

}  // namespace core
