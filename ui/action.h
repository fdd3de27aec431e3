// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <functional>

class QAction;
class QObject;

namespace ui {

/// An action that runs `run`; `key` is its object name, `help` its tool tip, which names the shortcut, and status tip.
QAction* makeAction(QObject* parent, const QString& key, const QString& text, const QKeySequence& shortcut,
                    const QString& help, const std::function<void()>& run);

}  // namespace ui
