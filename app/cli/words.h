// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

namespace cli {

/// What the command line calls a task, "Recovering depth".
[[nodiscard]] const char* taskName(core::Task task);

}  // namespace cli
