// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <vector>

#include "ui/tools/brush_tool.h"
#include "ui/tools/selection_session.h"
#include "ui/tools/tool.h"

class QAction;
class QActionGroup;
class QKeyEvent;
class QLabel;
class QMainWindow;
class QMenu;
class QToolBar;

namespace ui {

/// The tools of a window: their buttons, options and keys, and the menu of what can be done with a selection. Hands
/// what happens on the canvas to the active tool.
class ToolBox : public QObject {
    Q_OBJECT
  public:
    ToolBox(Workspace& workspace, Canvas& canvas, QObject* parent = nullptr);

    [[nodiscard]] SelectionSession& session() { return session_; }
    /// Fills the menu "Select".
    void fillMenu(QMenu& menu);
    /// Adds the bars for tools and options to the window. After `fillMenu`.
    void addBars(QMainWindow& window);
    /// `key` of a tool's row.
    void choose(const QString& key);
    [[nodiscard]] QString chosen() const;
    /// Keys while the picture has the focus. False: not a key of the tools.
    bool pressKey(const QKeyEvent& event);
    bool releaseKey(const QKeyEvent& event);
    /// Takes back the last part of what is being drawn. False: nothing is.
    bool undo();

  private:
    [[nodiscard]] Tool& tool() const { return *tools_[active_]; }
    /// Whether strokes go to the active tool, rather than to a mask that is painted.
    [[nodiscard]] bool drawing() const;
    void activate(std::size_t index);
    void fillOperations(QMenu& menu);
    void fillSegmentActions(QMenu& menu);
    /// What an action makes of the selection, on the worker's thread; `width` [px] is that of the bar at the click.
    using Operation = std::function<core::BinaryMask(const core::Selector&, const core::BinaryMask& selected, int width,
                                                     const core::Progress&)>;
    /// Its tool tip: what it does, and what is missing for it.
    [[nodiscard]] QString toolTipOf(std::size_t index) const;
    QAction* addOperation(QMenu& menu, const QString& key, const QString& text, const QKeySequence& shortcut,
                          const QString& help, Operation operation, bool refines = false);
    void connectCanvas();
    void followDocument();
    void refresh();
    void refreshPointer();
    /// False: nothing has a brush.
    bool resizeBrush(float factor);
    void rehover(Qt::KeyboardModifiers modifiers);
    void addUses(QToolBar& bar);
    /// The sentence about the tool, and what can be done with a selection.
    QToolBar* makeHintBar(QMainWindow& window);

    Workspace& workspace_;
    Canvas& canvas_;
    SelectionSession session_;
    BrushOptions brush_;
    std::vector<Tool*> tools_;
    std::size_t active_ = 0;
    QActionGroup* buttons_ = nullptr;
    QActionGroup* uses_ = nullptr;
    QAction* usesPlace_ = nullptr;
    QAction* clear_ = nullptr;
    QAction* selectAll_ = nullptr;
    QAction* makeSegment_ = nullptr;
    QAction* findObjects_ = nullptr;
    std::vector<QAction*> barOperations_;   ///< shown in the bar too
    std::vector<QAction*> operations_;      ///< need a selection
    std::vector<QAction*> segmentChanges_;  ///< need a selection and a segment
    std::vector<QAction*> options_;         ///< places of the tools' controls in the bar; nullptr = none
    QLabel* name_ = nullptr;
    QLabel* hint_ = nullptr;
    QPointF pointer_;  ///< latest position in the picture
    bool hovering_ = false;
};

}  // namespace ui
