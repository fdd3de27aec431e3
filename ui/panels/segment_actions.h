// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QObject>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/scene/scene.h"
#include "ui/scene_change.h"

namespace ui {

class BackgroundTask;
class Workspace;

/// What can be done with the segments chosen in the list, for buttons, menu and shortcuts. Each change is one undo
/// step.
class SegmentActions : public QObject {
    Q_OBJECT
  public:
    /// Shortcuts work while `owner` or a child of it has the focus.
    SegmentActions(Workspace& workspace, QWidget* owner);
    ~SegmentActions() override;

    /// The segments that the actions are about, from top to bottom. Enables the actions that would change something.
    void setChosen(std::vector<std::uint16_t> labels);
    /// In the order of buttons and menu; nullptr separates groups.
    [[nodiscard]] const QList<QAction*>& all() const { return all_; }

    /// The first one stays.
    void merge(const std::vector<std::uint16_t>& labels);
    void rename(std::uint16_t label, const QString& name);
    void setGlossy(const std::vector<std::uint16_t>& labels, bool on);
    void setVisible(const std::vector<std::uint16_t>& labels, bool on);
    void setLocked(const std::vector<std::uint16_t>& labels, bool on);
    /// Reads masks and label maps in the background and makes segments of them, in one step.
    void importFiles(const QStringList& paths);
    /// The chosen segments as a picture of 0 and 255.
    void exportMask(const QString& path);
    /// Of the chosen segments.
    void toggleGlossy();
    /// Whether a file is being read or written, or segments are being changed in the background.
    [[nodiscard]] bool working() const;

  signals:
    void message(const QString& text);
    void error(const QString& sentence);
    void notices(const QStringList& sentences);
    void renameWanted(quint16 label);
    /// Select these rows.
    void chooseWanted(const std::vector<std::uint16_t>& labels);

  private:
    QAction* add(const QString& key, const char* icon, const QString& text, const QKeySequence& shortcut,
                 void (SegmentActions::*run)());
    void makeActions();
    void update();
    void updateTexts(const std::vector<const core::Segment*>& segments);
    /// Whether the one chosen segment is in several pieces.
    [[nodiscard]] bool inPieces();

    /// What is left to do after a step; `made` are the labels of the segments that are new.
    using Made = std::function<void(const std::vector<std::uint16_t>& made)>;
    /// Makes a step, says its notes, or `done`, then calls `then`; or says why it is not possible.
    void change(const QString& step, const SceneChange::Operation& operation, const QString& done,
                const Made& then = {});
    void sayNotes(const core::Notes& notes, const QString& done);
    /// Sets a member of some segments.
    void setFlag(const std::vector<std::uint16_t>& labels, bool core::Segment::*flag, bool on, const QString& step);
    [[nodiscard]] QString nameOf(std::uint16_t label) const;
    /// "vase", or "3 segments".
    [[nodiscard]] QString namesOf(const std::vector<std::uint16_t>& labels) const;
    [[nodiscard]] std::vector<const core::Segment*> segmentsOf(const std::vector<std::uint16_t>& labels) const;
    /// Runs work on another thread, then `done` on this one.
    void start(std::function<void(const core::Progress&)> work, const std::function<void()>& done);

    void renameChosen();
    void duplicate();
    void mergeChosen();
    void split();
    void remove();
    void selectEdited();
    void selectPixels();
    void toggleVisible();
    void toggleLocked();
    void chooseImport();
    void chooseMaskFile();

    Workspace& workspace_;
    QWidget* owner_;
    SceneChange* change_;
    std::vector<std::uint16_t> chosen_;
    QList<QAction*> all_;
    QAction *rename_, *duplicate_, *merge_, *split_, *delete_, *selectEdited_, *selectPixels_, *glossy_, *visible_,
        *locked_, *import_, *exportMask_;
    std::unique_ptr<BackgroundTask> task_;
    QStringList notices_;  ///< of this document, the latest last
    struct {
        std::weak_ptr<const core::Photo> photo;
        std::uint16_t label = 0;
        bool several = false;
    } pieces_;  ///< the last answer of inPieces()
};

}  // namespace ui
