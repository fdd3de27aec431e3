// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/base/progress.h"

namespace ui {

/// What the window calls a task, translated: "Recovering depth". From any thread.
[[nodiscard]] QString taskName(core::Task task);

}  // namespace ui
