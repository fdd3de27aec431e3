// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <exception>
#include <span>

#include "core/base/error.h"
#include "core/base/progress.h"

namespace ui {

/// What the window calls a task, translated: "Recovering depth". From any thread.
[[nodiscard]] QString taskName(core::Task task);

/// The message in the window's language, and where its setting is. From any thread, as the others.
[[nodiscard]] QString translated(const core::Message& message);
/// What went wrong; in the window's language as far as it is a core::Error.
[[nodiscard]] QString translated(const std::exception& error);
/// The sentences one after the other.
[[nodiscard]] QString translated(std::span<const core::Message> notes);

}  // namespace ui
