// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/new_photo_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <numbers>

#include "ui/background_task.h"
#include "ui/words.h"

namespace ui {

namespace {

/// Delay before a typed path is looked at [ms].
constexpr int kTypingDelay = 250;
constexpr int kSentenceWidth = 400;

QLabel* makeSentence(const QString& key, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(key);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    // Without it the label reserves the height that its text has when it is narrow.
    label->setMinimumWidth(kSentenceWidth);
    label->hide();
    return label;
}

double degrees(float radians) { return static_cast<double>(radians) * 180 / std::numbers::pi; }

}  // namespace

NewPhotoDialog::NewPhotoDialog(QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("newPhotoDialog"));
    setWindowTitle(tr("New from photograph and depth"));
    setMinimumWidth(560);
    auto* form = new QFormLayout;
    const QString pictures = tr("Pictures (*.exr *.png *.jpg *.jpeg *.tif *.tiff *.hdr *.pfm);;All files (*)");
    const QString photographs =
        tr("Photographs (*.exr *.png *.jpg *.jpeg *.heic *.heif *.tif *.tiff *.hdr *.pfm *.pcd);;All files (*)");
    color_ = addFileRow(*form, QStringLiteral("newColor"), tr("Photograph"),
                        tr("Colour picture; EXR and HDR files are read as linear light"), photographs);
    found_ = makeSentence(QStringLiteral("newFound"), this);
    found_->setAccessibleName(tr("What the photograph's file contains"));
    form->addRow(QString(), found_);
    depth_ = addFileRow(*form, QStringLiteral("newDepth"), tr("Depth"),
                        tr("Depth map of the same view. Leave empty if the photograph contains depth (portrait photos "
                           "of phones, EXR with "
                           "a Z channel, point clouds)."),
                        pictures);
    makeDepthRows(*form);
    segments_ = addFileRow(*form, QStringLiteral("newSegments"), tr("Segments"),
                           tr("Label map: one number per object, 0 for none; or a black-and-white mask of one object"),
                           pictures);
    fieldOfView_ = new QDoubleSpinBox(this);
    fieldOfView_->setObjectName(QStringLiteral("newFieldOfView"));
    fieldOfView_->setToolTip(
        tr("Horizontal field of view. Automatic reads it from the photograph, otherwise assumes 60°."));
    fieldOfView_->setRange(0, 170);
    fieldOfView_->setDecimals(2);
    fieldOfView_->setSuffix(tr("°"));
    form->addRow(tr("Field of view"), fieldOfView_);

    problem_ = makeSentence(QStringLiteral("newProblem"), this);
    problem_->setAccessibleName(tr("Why the project cannot be made"));
    QPalette warning = problem_->palette();
    warning.setColor(QPalette::WindowText, QColor(240, 150, 110));
    problem_->setPalette(warning);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    ok_ = buttons->button(QDialogButtonBox::Ok);
    ok_->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        problem_->hide();
        emit chosen();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(problem_);
    layout->addWidget(buttons);
    typing_ = new QTimer(this);
    typing_->setSingleShot(true);
    connect(typing_, &QTimer::timeout, this, &NewPhotoDialog::inspect);
    connect(color_, &QLineEdit::textChanged, this, [this] {
        contents_.reset();
        contentsProblem_.clear();
        typing_->start(kTypingDelay);
        showContents();
    });
    connect(depth_, &QLineEdit::textChanged, this, &NewPhotoDialog::showContents);
    showContents();
    updateOk();
}

NewPhotoDialog::~NewPhotoDialog() {
    if (inspection_ == nullptr || !inspection_->running()) return;
    // Reading a picture cannot be interrupted: it ends without the dialog.
    BackgroundTask* orphan = inspection_.release();
    orphan->disconnect(this);
    orphan->setParent(parentWidget());
    for (const auto end : {&BackgroundTask::succeeded, &BackgroundTask::cancelled})
        connect(orphan, end, orphan, &QObject::deleteLater);
    connect(orphan, &BackgroundTask::failed, orphan, &QObject::deleteLater);
}

void NewPhotoDialog::makeDepthRows(QFormLayout& form) {
    depthKind_ = new QComboBox(this);
    depthKind_->setObjectName(QStringLiteral("newDepthKind"));
    depthKind_->addItem(tr("Depth along the viewing axis"), static_cast<int>(core::DepthKind::Z));
    depthKind_->addItem(tr("Distance from the camera"), static_cast<int>(core::DepthKind::Distance));
    depthKind_->addItem(tr("Disparity (phones)"), static_cast<int>(core::DepthKind::Disparity));
    depthKind_->addItem(tr("Inverse depth (networks)"), static_cast<int>(core::DepthKind::Inverse));
    form.addRow(tr("Depth is"), depthKind_);
    depthUnit_ = new QDoubleSpinBox(this);
    depthUnit_->setObjectName(QStringLiteral("newDepthUnit"));
    depthUnit_->setToolTip(tr(
        "Metres per stored unit. Automatic uses what the photograph states, otherwise 1 for floating-point files and "
        "0.001 for 16-bit files."));
    depthUnit_->setRange(0, 1000);
    depthUnit_->setDecimals(6);
    depthUnit_->setSuffix(tr(" m"));
    form.addRow(tr("Depth unit"), depthUnit_);
}

QLineEdit* NewPhotoDialog::addFileRow(QFormLayout& form, const QString& key, const QString& label,
                                      const QString& toolTip, const QString& filter) {
    auto* edit = new QLineEdit(this);
    edit->setObjectName(key);
    edit->setToolTip(toolTip);
    edit->setAccessibleName(label);
    auto* browse = new QPushButton(tr("Browse…"), this);
    browse->setObjectName(key + QStringLiteral("Browse"));
    browse->setToolTip(toolTip);
    // Enter confirms the dialog, whichever button was pressed last.
    browse->setAutoDefault(false);
    auto* row = new QHBoxLayout;
    row->addWidget(edit, 1);
    row->addWidget(browse);
    form.addRow(label, row);
    connect(browse, &QPushButton::clicked, this, [this, edit, label, filter] {
        const QString path = QFileDialog::getOpenFileName(this, label, edit->text(), filter);
        if (path.isEmpty()) return;
        edit->setText(path);
        edit->setFocus();
    });
    connect(edit, &QLineEdit::textChanged, this, &NewPhotoDialog::updateOk);
    return edit;
}

void NewPhotoDialog::setColorFile(const QString& path) {
    color_->setText(path);
    inspect();
}

void NewPhotoDialog::showProblem(const QString& sentence) {
    problem_->setText(sentence);
    problem_->show();
}

void NewPhotoDialog::updateOk() {
    if (ok_ != nullptr) ok_->setEnabled(!color_->text().trimmed().isEmpty());
}

void NewPhotoDialog::inspect() {
    typing_->stop();
    const QString path = color_->text().trimmed();
    if (path == inspected_ || (inspection_ != nullptr && inspection_->running())) return;
    inspected_ = path;
    contents_.reset();
    contentsProblem_.clear();
    if (path.isEmpty()) {
        showContents();
        return;
    }
    const auto result = std::make_shared<core::PhotoContents>();
    inspection_ = std::make_unique<BackgroundTask>(
        [result, path](const core::Progress&) { *result = core::inspectPhoto(path.toStdString()); });
    // The next one replaces the task, which must not happen inside its own signal.
    const auto ended = [this] {
        showContents();
        typing_->start(0);
    };
    const auto wanted = [this, path] { return color_->text().trimmed() == path; };
    connect(inspection_.get(), &BackgroundTask::succeeded, this, [this, result, ended, wanted] {
        if (wanted()) contents_ = *result;
        ended();
    });
    connect(inspection_.get(), &BackgroundTask::failed, this, [this, ended, wanted](const QString& sentence) {
        if (wanted()) contentsProblem_ = sentence;
        ended();
    });
    inspection_->start();
    showContents();
}

QString NewPhotoDialog::contentsText() const {
    if (color_->text().trimmed().isEmpty()) return {};
    if (!contentsProblem_.isEmpty()) return contentsProblem_;
    if (!contents_) return tr("Reading the photograph…");
    QStringList parts;
    if (!contents_->device.empty()) parts << QString::fromStdString(contents_->device);
    parts << tr("%1 × %2 pixels").arg(contents_->width).arg(contents_->height);
    parts << (contents_->hfov ? tr("field of view %1°").arg(degrees(*contents_->hfov), 0, 'f', 1)
                              : tr("no field of view stated"));
    if (contents_->depthPlace.empty()) {
        parts << (depth_->text().trimmed().isEmpty() ? tr("no depth inside: choose a depth map")
                                                     : tr("no depth inside"));
    } else {
        parts << tr("depth inside, %1 × %2 pixels: %3")
                     .arg(contents_->depthWidth)
                     .arg(contents_->depthHeight)
                     .arg(translated(contents_->depthPlace));
    }
    return parts.join(QStringLiteral(" · "));
}

void NewPhotoDialog::showContents() {
    const QString text = contentsText();
    found_->setText(text);
    found_->setVisible(!text.isEmpty());
    const bool inside = contents_ && !contents_->depthPlace.empty() && depth_->text().trimmed().isEmpty();
    const bool stated = inside && contents_->kind.has_value();
    if (!stated && !depthKind_->isEnabled()) depthKind_->setCurrentIndex(0);
    depthKind_->setEnabled(!stated);
    depthKind_->setToolTip(stated ? tr("The photograph's file says what its depth is")
                                  : tr("Meaning of the numbers in the depth file"));
    if (stated) depthKind_->setCurrentIndex(depthKind_->findData(static_cast<int>(*contents_->kind)));
    const QString automatic = tr("automatic");
    const auto known = [&](const QString& value) { return tr("automatic: %1").arg(value); };
    depthUnit_->setSpecialValueText(!inside                 ? automatic
                                    : contents_->unitStated ? known(tr("%1 m").arg(contents_->unit))
                                                            : tr("automatic: %1 m, assumed").arg(contents_->unit));
    fieldOfView_->setSpecialValueText(
        contents_ && contents_->hfov ? known(tr("%1°").arg(degrees(*contents_->hfov), 0, 'f', 1)) : automatic);
    adjustSize();
}

core::CreateOptions NewPhotoDialog::options() const {
    core::CreateOptions options;
    options.color = color_->text().trimmed().toStdString();
    options.depth = depth_->text().trimmed().toStdString();
    options.segments = segments_->text().trimmed().toStdString();
    options.depthKind = static_cast<core::DepthKind>(depthKind_->currentData().toInt());
    if (depthUnit_->value() > 0) options.depthUnit = depthUnit_->value();
    if (fieldOfView_->value() > 0) {
        options.hfov = static_cast<float>(fieldOfView_->value() * std::numbers::pi / 180);
    }
    return options;
}

}  // namespace ui
