// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/message.h"
#include "core/base/progress.h"

namespace cli {

/// What the command line calls a task, "Recovering depth".
[[nodiscard]] const char* taskName(core::Task task);

/// The message in English, and the options that it is about.
[[nodiscard]] std::string sentence(const core::Message& message);

}  // namespace cli
