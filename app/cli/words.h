// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/message.h"
#include "core/base/progress.h"

namespace cli {

/// English name of a task, "Recovering depth".
[[nodiscard]] const char* taskName(core::Task task);

/// The message in English, followed by the options that it concerns.
[[nodiscard]] std::string sentence(const core::Message& message);

}  // namespace cli
