// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>
#include <vector>

#include "ui/tools/tool.h"

namespace ui {

class BrushOptions;

/// A tool of the window: one row makes its button, shortcut and options.
struct ToolEntry {
    const char* key;       ///< object name of its action
    const char* title;     ///< untranslated (context "ToolRegistry")
    const char* shortcut;  ///< "" = none
    const char* help;      ///< untranslated
    bool needsDepth;
    void (*draw)(QPainter&);  ///< its icon in a square of 20 × 20
    Tool* (*make)(SelectionSession& session, BrushOptions& brush, QObject* parent);

    [[nodiscard]] QString translatedTitle() const;
    [[nodiscard]] QString translatedHelp() const;
    [[nodiscard]] QIcon icon(const QColor& color) const;
};

/// In the order of their buttons; the first one moves the picture and picks segments.
[[nodiscard]] const std::vector<ToolEntry>& toolRegistry();

}  // namespace ui
