// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace ui {

/// A project that comes with the program.
struct Sample {
    QString title;
    QString project;  ///< path
    QString picture;  ///< path
};

/// The samples that are found, beside an installed program or in the source tree of this build.
[[nodiscard]] std::vector<Sample> bundledSamples();

}  // namespace ui
