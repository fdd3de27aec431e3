// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/action.h"

#include <QAction>

namespace ui {

QAction* makeAction(QObject* parent, const QString& key, const QString& text, const QKeySequence& shortcut,
                    const QString& help, const std::function<void()>& run) {
    auto* action = new QAction(text, parent);
    action->setObjectName(key);
    action->setShortcut(shortcut);
    const QString keys = shortcut.toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? help : QStringLiteral("%1 (%2)").arg(help, keys));
    action->setStatusTip(help);
    QObject::connect(action, &QAction::triggered, parent, run);
    return action;
}

}  // namespace ui
