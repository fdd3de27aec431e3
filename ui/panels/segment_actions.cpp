// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/segment_actions.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QWidget>
#include <algorithm>

#include "core/base/label_table.h"
#include "core/io/label_map.h"
#include "core/io/photo_loader.h"
#include "core/scene/segment_areas.h"
#include "core/scene/segments.h"
#include "ui/background_task.h"
#include "ui/recent_files.h"
#include "ui/widgets/line_icon.h"
#include "ui/words.h"
#include "ui/workspace.h"

namespace ui {

namespace {

/// The segments of one scene that another does not have.
std::vector<std::uint16_t> newLabels(const core::Scene& before, const core::Scene& after) {
    core::LabelTable<char> known(0);
    for (const core::Segment& segment : before.segments) known[segment.label] = 1;
    std::vector<std::uint16_t> labels;
    for (const core::Segment& segment : after.segments)
        if (known[segment.label] == 0) labels.push_back(segment.label);
    return labels;
}

}  // namespace

SegmentActions::SegmentActions(Workspace& workspace, QWidget* owner)
    : QObject(owner), workspace_(workspace), owner_(owner), change_(new SceneChange(workspace, owner)) {
    makeActions();
    connect(&workspace, &Workspace::sceneChanged, this, &SegmentActions::update);
    connect(change_, &SceneChange::message, this, &SegmentActions::message);
    connect(change_, &SceneChange::failed, this, &SegmentActions::error);
    connect(&workspace, &Workspace::documentReplaced, this, [this] {
        task_.reset();
        notices_.clear();
        emit notices({});
    });
    update();
}

SegmentActions::~SegmentActions() = default;

QAction* SegmentActions::add(const QString& key, const char* icon, const QString& text, const QKeySequence& shortcut,
                             void (SegmentActions::*run)()) {
    auto* action = new QAction(lineIcon(icon), text, this);
    action->setObjectName(key);
    action->setShortcut(shortcut);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(action, &QAction::triggered, this, run);
    owner_->addAction(action);
    all_ << action;
    return action;
}

void SegmentActions::makeActions() {
    using A = SegmentActions;
    rename_ = add("segmentRename", icons::kRename, tr("Rename"), Qt::Key_F2, &A::renameChosen);
    duplicate_ =
        add("segmentDuplicate", icons::kDuplicate, tr("Duplicate"), QKeySequence(Qt::CTRL | Qt::Key_J), &A::duplicate);
    merge_ = add("segmentMerge", icons::kMerge, tr("Merge"), QKeySequence(Qt::CTRL | Qt::Key_M), &A::mergeChosen);
    split_ = add("segmentSplit", icons::kSplit, tr("Split into pieces"), {}, &A::split);
    delete_ = add("segmentDelete", icons::kDelete, tr("Delete"), QKeySequence::Delete, &A::remove);
    all_ << nullptr;
    selectPixels_ = add("segmentSelectPixels", icons::kSelectPixels, tr("Select pixels"), {}, &A::selectPixels);
    selectEdited_ = add("segmentSelectEdited", icons::kSelectEdited, tr("Select all edited"), {}, &A::selectEdited);
    all_ << nullptr;
    glossy_ = add("segmentGlossy", icons::kGlossy, tr("Glossy"), {}, &A::toggleGlossy);
    glossy_->setCheckable(true);
    glossy_->setToolTip(tr("Treat the segment's colours as reflections (Space)"));
    visible_ = add("segmentVisible", icons::kHidden, {}, {}, &A::toggleVisible);
    locked_ = add("segmentLocked", icons::kLocked, {}, {}, &A::toggleLocked);
    all_ << nullptr;
    import_ = add("segmentImport", icons::kImport, tr("Import mask or label map…"), {}, &A::chooseImport);
    exportMask_ = add("segmentExportMask", icons::kExport, tr("Export mask…"), {}, &A::chooseMaskFile);
    rename_->setToolTip(tr("Give the segment another name (F2)"));
    delete_->setToolTip(tr("Delete the segments; their pixels belong to none (Del)"));
    selectEdited_->setToolTip(tr("Select all segments that have a new material"));
    selectPixels_->setToolTip(tr("Select the segments' pixels in the picture"));
    import_->setToolTip(
        tr("Make segments from a black-and-white mask or a label map. Files can also be dropped on the list."));
    exportMask_->setToolTip(tr("Save the segments' pixels as a picture: white on black"));
}

void SegmentActions::setChosen(std::vector<std::uint16_t> labels) {
    chosen_ = std::move(labels);
    update();
}

std::vector<const core::Segment*> SegmentActions::segmentsOf(const std::vector<std::uint16_t>& labels) const {
    core::LabelTable<const core::Segment*> known(nullptr);
    for (const core::Segment& segment : workspace_.scene().segments) known[segment.label] = &segment;
    std::vector<const core::Segment*> segments;
    for (const std::uint16_t label : labels)
        if (known[label] != nullptr) segments.push_back(known[label]);
    return segments;
}

bool SegmentActions::inPieces() {
    const std::shared_ptr<const core::Photo>& photo = workspace_.scene().photo;
    if (pieces_.photo.lock() != photo || pieces_.label != chosen_.front())
        pieces_ = {photo, chosen_.front(), core::segmentPieces(photo->labels, chosen_.front(), false).count > 1};
    return pieces_.several;
}

void SegmentActions::update() {
    const std::vector<const core::Segment*> segments = segmentsOf(chosen_);
    const bool any = !segments.empty(), one = segments.size() == 1;
    const auto unlocked = std::ranges::count(segments, false, &core::Segment::locked);
    const auto& selection = workspace_.scene().selection;
    rename_->setEnabled(one);
    duplicate_->setEnabled(one && selection != nullptr);
    merge_->setEnabled(unlocked > 1 && !segments.front()->locked);
    split_->setEnabled(one && unlocked == 1 && inPieces());
    delete_->setEnabled(unlocked > 0);
    selectPixels_->setEnabled(any);
    selectEdited_->setEnabled(
        std::ranges::any_of(workspace_.scene().segments, [](const core::Segment& s) { return s.edit.has_value(); }));
    for (QAction* action : {glossy_, visible_, locked_, exportMask_}) action->setEnabled(any);
    import_->setEnabled(workspace_.hasPhoto());
    updateTexts(segments);
}

void SegmentActions::updateTexts(const std::vector<const core::Segment*>& segments) {
    const bool any = !segments.empty(), one = segments.size() == 1;
    const bool hidden = any && std::ranges::none_of(segments, &core::Segment::visible);
    const bool locked = any && std::ranges::all_of(segments, &core::Segment::locked);
    glossy_->setChecked(any && std::ranges::all_of(segments, &core::Segment::glossy));
    const auto show = [](QAction& action, const QString& text, const char* icon, const QString& toolTip) {
        if (action.text() == text) return;
        action.setText(text);
        action.setIcon(lineIcon(icon));
        action.setToolTip(toolTip);
    };
    if (hidden)
        show(*visible_, tr("Show"), icons::kShown, tr("Show the new material again"));
    else
        show(*visible_, tr("Hide"), icons::kHidden, tr("Show the segment as photographed, and keep its material"));
    if (locked)
        show(*locked_, tr("Unlock"), icons::kUnlocked, tr("Let the segment's pixels change again"));
    else
        show(*locked_, tr("Lock"), icons::kLocked, tr("Protect the segment's pixels from every change"));
    if (duplicate_->isEnabled())
        duplicate_->setToolTip(tr("Make a segment of the selected pixels, with everything else as in \"%1\" (Ctrl+J)")
                                   .arg(nameOf(chosen_.front())));
    else
        duplicate_->setToolTip(
            tr("Segments share no pixels: select in the picture the pixels that the copy shall have, "
               "and here one segment."));
    if (merge_->isEnabled())
        merge_->setToolTip(
            tr("Make one segment of all, with the name and material of \"%1\" (Ctrl+M)").arg(nameOf(chosen_.front())));
    else
        merge_->setToolTip(tr("Select two or more segments; the uppermost keeps its name and material."));
    split_->setToolTip(split_->isEnabled() ? tr("Make a segment of each piece that does not touch the others")
                       : one               ? tr("The segment is in one piece, or locked.")
                                           : tr("Select one segment that is in several pieces."));
}

QString SegmentActions::nameOf(std::uint16_t label) const {
    const core::Segment* segment = workspace_.scene().findSegment(label);
    return segment != nullptr ? QString::fromStdString(segment->name) : QString();
}

QString SegmentActions::namesOf(const std::vector<std::uint16_t>& labels) const {
    return labels.size() == 1 ? nameOf(labels.front()) : tr("%1 segments").arg(labels.size());
}

void SegmentActions::change(const QString& step, const SceneChange::Operation& operation, const QString& done,
                            const Made& then) {
    change_->run(step, operation, [this, done, then](const core::Scene& before, const core::Notes& notes) {
        sayNotes(notes, done);
        if (then) then(newLabels(before, workspace_.scene()));
    });
}

void SegmentActions::sayNotes(const core::Notes& notes, const QString& done) {
    const QStringList sentences = translatedEach(notes);
    for (const QString& sentence : sentences) {
        notices_.removeAll(sentence);
        notices_ << sentence;
    }
    constexpr qsizetype kKeptNotices = 10;
    notices_ = notices_.mid(std::max<qsizetype>(0, notices_.size() - kKeptNotices));
    if (!sentences.isEmpty()) emit notices(notices_);
    emit message(sentences.isEmpty() ? done : sentences.join(QLatin1Char(' ')));
}

void SegmentActions::setFlag(const std::vector<std::uint16_t>& labels, bool core::Segment::*flag, bool on,
                             const QString& step) {
    core::LabelTable<char> wanted(0);
    for (const std::uint16_t label : labels) wanted[label] = 1;
    workspace_.editScene(step, [&](core::Scene& scene) {
        for (core::Segment& segment : scene.segments)
            if (wanted[segment.label] != 0) segment.*flag = on;
    });
}

void SegmentActions::setGlossy(const std::vector<std::uint16_t>& labels, bool on) {
    setFlag(labels, &core::Segment::glossy, on,
            (on ? tr("Flag %1 as glossy") : tr("Flag %1 as not glossy")).arg(namesOf(labels)));
}

void SegmentActions::setVisible(const std::vector<std::uint16_t>& labels, bool on) {
    setFlag(labels, &core::Segment::visible, on, (on ? tr("Show %1") : tr("Hide %1")).arg(namesOf(labels)));
}

void SegmentActions::setLocked(const std::vector<std::uint16_t>& labels, bool on) {
    setFlag(labels, &core::Segment::locked, on, (on ? tr("Lock %1") : tr("Unlock %1")).arg(namesOf(labels)));
}

void SegmentActions::rename(std::uint16_t label, const QString& name) {
    const std::string text = name.toStdString();
    const auto& all = workspace_.scene().segments;
    const core::Segment* segment = workspace_.scene().findSegment(label);
    if (segment == nullptr || segment->name == text) return;
    if (text.empty()) {
        emit message(tr("A segment needs a name."));
    } else if (std::ranges::find(all, text, &core::Segment::name) != all.end()) {
        emit message(tr("There is already a segment named \"%1\".").arg(name));
    } else {
        workspace_.editScene(tr("Rename segment"), [&](core::Scene& scene) { scene.findSegment(label)->name = text; });
    }
}

void SegmentActions::merge(const std::vector<std::uint16_t>& labels) {
    const std::uint16_t first = labels.front();
    const QString done = tr("%1 segments are one now: %2").arg(labels.size()).arg(nameOf(first));
    change(
        tr("Merge segments"),
        [labels](const core::Scene& scene, core::Notes* notes, const core::Progress&) {
            return core::mergeSegments(scene, labels, notes);
        },
        done, [this, first](const std::vector<std::uint16_t>&) { emit chooseWanted({first}); });
}

void SegmentActions::renameChosen() { emit renameWanted(chosen_.front()); }

void SegmentActions::mergeChosen() { merge(std::vector(chosen_)); }

void SegmentActions::duplicate() {
    const std::uint16_t label = chosen_.front();
    change(
        tr("Duplicate %1").arg(nameOf(label)),
        [label, selection = workspace_.scene().selection](const core::Scene& scene, core::Notes* notes,
                                                          const core::Progress&) {
            core::Scene next = core::duplicateSegment(scene, label, selection->mask, notes);
            next.selection = nullptr;
            return next;
        },
        tr("Duplicated %1").arg(nameOf(label)),
        [this](const std::vector<std::uint16_t>& made) { emit chooseWanted(made); });
}

void SegmentActions::split() {
    const std::uint16_t label = chosen_.front();
    const QString name = nameOf(label);
    change(
        tr("Split %1").arg(name),
        [label](const core::Scene& scene, core::Notes* notes, const core::Progress& progress) {
            return core::splitSegment(scene, label, notes, progress);
        },
        {},
        [this, label, name](const std::vector<std::uint16_t>& made) {
            std::vector<std::uint16_t> pieces{label};
            pieces.insert(pieces.end(), made.begin(), made.end());
            emit message(tr("%1 is in %2 segments now").arg(name).arg(pieces.size()));
            emit chooseWanted(pieces);
        });
}

void SegmentActions::remove() {
    const std::vector<std::uint16_t> labels = chosen_;
    change(tr("Delete %1").arg(namesOf(labels)),
           [labels](const core::Scene& scene, core::Notes* notes, const core::Progress&) {
               return core::deleteSegments(scene, labels, notes);
           },
           {});
}

void SegmentActions::selectEdited() {
    std::vector<std::uint16_t> labels;
    for (const core::Segment& segment : workspace_.scene().segments)
        if (segment.edit) labels.push_back(segment.label);
    emit chooseWanted(labels);
}

void SegmentActions::selectPixels() {
    auto selection = std::make_shared<core::PixelSelection>();
    selection->mask = core::maskOfSegments(workspace_.scene().photo->labels, chosen_);
    const auto& old = workspace_.scene().selection;
    if (old != nullptr && old->mask == selection->mask) return;
    workspace_.editScene(tr("Select pixels"), [&](core::Scene& scene) { scene.selection = selection; });
}

void SegmentActions::toggleGlossy() {
    const auto segments = segmentsOf(chosen_);
    if (!segments.empty()) setGlossy(std::vector(chosen_), !std::ranges::all_of(segments, &core::Segment::glossy));
}

void SegmentActions::toggleVisible() {
    setVisible(std::vector(chosen_), std::ranges::none_of(segmentsOf(chosen_), &core::Segment::visible));
}

void SegmentActions::toggleLocked() {
    setLocked(std::vector(chosen_), !std::ranges::all_of(segmentsOf(chosen_), &core::Segment::locked));
}

bool SegmentActions::working() const { return (task_ != nullptr && task_->running()) || change_->running(); }

void SegmentActions::start(std::function<void(const core::Progress&)> work, const std::function<void()>& done) {
    task_ = std::make_unique<BackgroundTask>(std::move(work));
    connect(task_.get(), &BackgroundTask::failed, this, &SegmentActions::error);
    connect(task_.get(), &BackgroundTask::succeeded, this, done);
    task_->start();
}

void SegmentActions::importFiles(const QStringList& paths) {
    if (!workspace_.hasPhoto() || paths.isEmpty()) return;
    if (working()) return emit message(tr("Please wait until the last file has been read or written."));
    struct Maps {
        std::vector<std::pair<std::string, core::LabelImage>> named;
        core::Notes notes;
    };
    auto maps = std::make_shared<Maps>();
    const auto read = [maps, paths, camera = workspace_.scene().photo->camera](const core::Progress& progress) {
        for (const QString& path : paths) {
            progress.checkpoint(static_cast<float>(maps->named.size()) / static_cast<float>(paths.size()));
            maps->named.emplace_back(QFileInfo(path).completeBaseName().toStdString(),
                                     core::loadLabelMap(path.toStdString(), camera, &maps->notes));
        }
    };
    start(read, [this, maps] {
        const auto add = [maps](const core::Scene& scene, core::Notes* notes, const core::Progress&) {
            *notes = maps->notes;
            core::Scene next = scene;
            for (const auto& [name, labels] : maps->named) next = core::withImportedSegments(next, labels, name, notes);
            return next;
        };
        change(tr("Import segments"), add, {}, [this, maps](const std::vector<std::uint16_t>& made) {
            if (maps->notes.empty()) emit message(tr("Imported %1").arg(namesOf(made)));
            emit chooseWanted(made);
        });
    });
}

void SegmentActions::exportMask(const QString& path) {
    if (chosen_.empty()) return;
    if (working()) return emit message(tr("Please wait until the last file has been read or written."));
    start(
        [photo = workspace_.scene().photo, chosen = chosen_, path](const core::Progress&) {
            core::saveMask(core::maskOfSegments(photo->labels, chosen), path.toStdString());
        },
        [this, path] { emit message(tr("Exported %1").arg(path)); });
}

void SegmentActions::chooseImport() {
    auto* chooser =
        new QFileDialog(owner_->window(), tr("Import mask or label map"), RecentFiles::folder(workspace_.document()),
                        tr("Pictures (*.png *.tif *.tiff *.exr *.pfm *.pgm *.hdr);;All files (*)"));
    chooser->setObjectName(QStringLiteral("segmentImportFile"));
    chooser->setAttribute(Qt::WA_DeleteOnClose);
    chooser->setFileMode(QFileDialog::ExistingFiles);
    connect(chooser, &QFileDialog::filesSelected, this, &SegmentActions::importFiles);
    chooser->open();
}

void SegmentActions::chooseMaskFile() {
    QString name = namesOf(chosen_);
    name.replace(QLatin1Char('/'), QLatin1Char('-'));
    auto* chooser =
        new QFileDialog(owner_->window(), tr("Export mask"), RecentFiles::folder(workspace_.document(), true),
                        tr("PNG (*.png);;TIFF (*.tif);;OpenEXR (*.exr)"));
    chooser->setObjectName(QStringLiteral("segmentMaskFile"));
    chooser->setAttribute(Qt::WA_DeleteOnClose);
    chooser->setAcceptMode(QFileDialog::AcceptSave);
    chooser->setDefaultSuffix(QStringLiteral("png"));
    chooser->selectFile(name + QStringLiteral(".png"));
    connect(chooser, &QFileDialog::fileSelected, this, &SegmentActions::exportMask);
    chooser->open();
}

}  // namespace ui
