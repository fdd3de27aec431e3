// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <exception>
#include <span>

#include "core/base/error.h"
#include "core/base/progress.h"

namespace ui {

/// Translated name of a task: "Recovering depth". From any thread.
[[nodiscard]] QString taskName(core::Task task);

/// The message in the window's language, followed by where its setting is. From any thread.
[[nodiscard]] QString translated(const core::Message& message);
/// The error's message, in the window's language if it is a core::Error. From any thread.
[[nodiscard]] QString translated(const std::exception& error);
/// Each message. From any thread.
[[nodiscard]] QStringList translatedEach(std::span<const core::Message> notes);

}  // namespace ui
