// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/new_photo_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/io/photo_loader.h"
#include "ui/background_task.h"
#include "ui/recent_files.h"
#include "ui/widgets/depth_view.h"
#include "ui/words.h"

namespace ui {

namespace {

/// Delay before a typed path or number is looked at [ms].
constexpr int kTypingDelay = 250;
/// Where the middle of the scene is assumed to be when nothing says how long a unit is [m].
constexpr double kAssumedMiddle = 1;
/// Median depths outside suggest a wrong unit [m].
constexpr float kLeastMiddle = 0.05f;
constexpr float kMostMiddle = 1000;
constexpr double kMaxUnit = 1e12;

QLabel* makeSentence(const QString& key, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(key);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

double degrees(float radians) { return static_cast<double>(radians) * 180 / std::numbers::pi; }

QString significant(double value, int digits) { return QLocale().toString(value, 'g', digits); }

/// Units go from micrometres to kilometres, so they have significant digits instead of decimals.
class UnitBox : public QDoubleSpinBox {
  public:
    using QDoubleSpinBox::QDoubleSpinBox;
    [[nodiscard]] QString textFromValue(double value) const override { return significant(value, 6); }
};

}  // namespace

/// What is found in the background for one query.
struct NewPhotoDialog::Findings {
    Query query;
    std::shared_ptr<const core::PhotoFiles> files;  ///< nullptr: the photograph cannot be read
    std::optional<core::PhotoContents> contents;
    std::optional<core::DepthBeside> beside;  ///< looked for when the photograph has no depth
    std::shared_ptr<const DepthPoints> points;
    core::DepthKind kind = core::DepthKind::Z;
    double unit = 1;  ///< metres per stored unit, as used for `points`
    bool unitAssumed = false;
    QString photoProblem;
    QString depthProblem;
};

NewPhotoDialog::NewPhotoDialog(QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("newPhotoDialog"));
    setWindowTitle(tr("Open a photograph"));
    auto* columns = new QHBoxLayout;
    columns->addWidget(makeSwitches(), 2);
    columns->addWidget(makeView(), 3);

    problem_ = makeSentence(QStringLiteral("newProblem"), this);
    problem_->hide();
    problem_->setAccessibleName(tr("Why the project cannot be made"));
    QPalette warning = problem_->palette();
    warning.setColor(QPalette::WindowText, QColor(240, 150, 110));
    problem_->setPalette(warning);
    reading_ = new QProgressBar(this);
    reading_->setObjectName(QStringLiteral("newReading"));
    reading_->setAccessibleName(tr("Reading the photograph"));
    reading_->setRange(0, 0);
    reading_->setTextVisible(false);
    reading_->setMaximumHeight(fontMetrics().height() / 2);
    QSizePolicy policy = reading_->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    reading_->setSizePolicy(policy);
    reading_->hide();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
    open_ = buttons->button(QDialogButtonBox::Open);
    open_->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &NewPhotoDialog::pressOpen);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(columns, 1);
    layout->addWidget(problem_);
    layout->addWidget(reading_);
    layout->addWidget(buttons);

    // A dialog's own size is at most two thirds of the screen, which leaves the depth small.
    const QSize space = screen()->availableSize() * 9 / 10;
    resize((QSize(64, 38) * fontMetrics().height()).expandedTo(sizeHint()).boundedTo(space));

    typing_ = new QTimer(this);
    typing_->setSingleShot(true);
    connect(typing_, &QTimer::timeout, this, &NewPhotoDialog::refresh);
    connect(color_, &QLineEdit::textChanged, this, &NewPhotoDialog::colorChanged);
    connect(depth_, &QLineEdit::textChanged, this, [this] { typing_->start(kTypingDelay); });
    for (QDoubleSpinBox* box : {depthUnit_, fieldOfView_})
        connect(box, &QDoubleSpinBox::valueChanged, this, &NewPhotoDialog::refresh);
    colorChanged();
}

NewPhotoDialog::~NewPhotoDialog() {
    if (task_ == nullptr || !task_->running()) return;
    // Reading a picture cannot be interrupted: it ends without the dialog.
    BackgroundTask* orphan = task_.release();
    orphan->disconnect(this);
    orphan->setParent(parentWidget());
    for (const auto end : {&BackgroundTask::succeeded, &BackgroundTask::cancelled})
        connect(orphan, end, orphan, &QObject::deleteLater);
    connect(orphan, &BackgroundTask::failed, orphan, &QObject::deleteLater);
}

QWidget* NewPhotoDialog::makeSwitches() {
    auto* side = new QWidget(this);
    auto* form = new QFormLayout;
    color_ = addFileRow(
        *form, QStringLiteral("newColor"), tr("Photograph"),
        tr("Colour picture; EXR and HDR files are read as linear light"),
        tr("Photographs (*.exr *.png *.jpg *.jpeg *.heic *.heif *.tif *.tiff *.hdr *.pfm *.pcd);;All files (*)"));
    found_ = makeSentence(QStringLiteral("newFound"), side);
    found_->setAccessibleName(tr("What the photograph's file contains"));
    form->addRow(found_);
    makeDepthRows(*form);
    fieldOfView_ = new QDoubleSpinBox(side);
    fieldOfView_->setObjectName(QStringLiteral("newFieldOfView"));
    fieldOfView_->setToolTip(
        tr("Horizontal field of view. Automatic reads it from the photograph, otherwise assumes 60°. If it is wrong, "
           "turned objects look too deep or too flat."));
    fieldOfView_->setRange(0, 170);
    fieldOfView_->setDecimals(2);
    fieldOfView_->setSuffix(tr("°"));
    form->addRow(tr("Field of view"), fieldOfView_);
    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(form);
    layout->addWidget(makeMore());
    layout->addStretch(1);
    return side;
}

void NewPhotoDialog::makeDepthRows(QFormLayout& form) {
    depth_ = addFileRow(form, QStringLiteral("newDepth"), tr("Depth"),
                        tr("Depth map of the same view. Leave empty if the photograph contains depth (portrait photos "
                           "of phones, EXR with "
                           "a Z channel, point clouds)."),
                        tr("Pictures (*.exr *.png *.jpg *.jpeg *.tif *.tiff *.hdr *.pfm);;All files (*)"));
    depthKind_ = new QComboBox(this);
    depthKind_->setObjectName(QStringLiteral("newDepthKind"));
    depthKind_->addItem(tr("Depth along the viewing axis"), static_cast<int>(core::DepthKind::Z));
    depthKind_->addItem(tr("Distance from the camera"), static_cast<int>(core::DepthKind::Distance));
    depthKind_->addItem(tr("Disparity (phones)"), static_cast<int>(core::DepthKind::Disparity));
    depthKind_->addItem(tr("Inverse depth (networks)"), static_cast<int>(core::DepthKind::Inverse));
    depthKind_->setToolTip(tr("Meaning of the numbers in the depth map"));
    connect(depthKind_, &QComboBox::activated, this, [this] {
        kind_ = static_cast<core::DepthKind>(depthKind_->currentData().toInt());
        refresh();
    });
    form.addRow(tr("Depth is"), depthKind_);
    exchange_ = new QPushButton(tr("Exchange near and far"), this);
    exchange_->setObjectName(QStringLiteral("newExchange"));
    exchange_->setToolTip(
        tr("For maps whose bright parts are far where they should be near, or the other way round: reads the numbers "
           "as inverse depth instead of depth, or back"));
    exchange_->setAutoDefault(false);
    connect(exchange_, &QPushButton::clicked, this, &NewPhotoDialog::exchangeNearAndFar);
    form.addRow(QString(), exchange_);
    depthUnit_ = new UnitBox(this);
    depthUnit_->setObjectName(QStringLiteral("newDepthUnit"));
    depthUnit_->setToolTip(tr(
        "Metres per stored unit. Automatic uses what the photograph states, otherwise 1 for floating-point files and "
        "0.001 for 16-bit files."));
    depthUnit_->setDecimals(12);
    depthUnit_->setRange(0, kMaxUnit);
    depthUnit_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    depthUnit_->setSuffix(tr(" m"));
    form.addRow(tr("Depth unit"), depthUnit_);
}

QWidget* NewPhotoDialog::makeMore() {
    auto* more = new QWidget(this);
    auto* fold = new QToolButton(more);
    fold->setObjectName(QStringLiteral("newMore"));
    fold->setText(tr("More"));
    fold->setToolTip(tr("Open with objects that were marked in another program"));
    fold->setCheckable(true);
    fold->setAutoRaise(true);
    fold->setArrowType(Qt::RightArrow);
    fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* rows = new QWidget(more);
    auto* form = new QFormLayout(rows);
    form->setContentsMargins(0, 0, 0, 0);
    segments_ = addFileRow(*form, QStringLiteral("newSegments"), tr("Segments"),
                           tr("Label map: one number per object, 0 for none; or a black-and-white mask of one object"),
                           tr("Pictures (*.exr *.png *.jpg *.jpeg *.tif *.tiff *.hdr *.pfm);;All files (*)"));
    rows->hide();
    connect(fold, &QToolButton::toggled, this, [fold, rows](bool on) {
        fold->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
        rows->setVisible(on);
    });
    auto* layout = new QVBoxLayout(more);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(fold);
    layout->addWidget(rows);
    return more;
}

QWidget* NewPhotoDialog::makeView() {
    auto* side = new QWidget(this);
    view_ = new DepthView(side);
    view_->setObjectName(QStringLiteral("newDepthView"));
    auto* buttons = new QHBoxLayout;
    const auto add = [&](const QString& key, const QString& text, const QString& toolTip, DepthView::Side from) {
        auto* button = new QToolButton(side);
        button->setObjectName(key);
        button->setText(text);
        button->setToolTip(toolTip);
        connect(button, &QToolButton::clicked, view_, [this, from] { view_->showSide(from); });
        buttons->addWidget(button);
        viewButtons_.push_back(button);
    };
    add(QStringLiteral("newViewTurned"), tr("Turned"), tr("From the right and above"), DepthView::Side::Turned);
    add(QStringLiteral("newViewFront"), tr("Front"), tr("As the camera saw it"), DepthView::Side::Front);
    add(QStringLiteral("newViewTop"), tr("Top"), tr("From above, with the camera below"), DepthView::Side::Top);
    add(QStringLiteral("newViewSide"), tr("Side"), tr("From the right, with the camera at the left"),
        DepthView::Side::Right);
    buttons->addStretch(1);
    depthText_ = makeSentence(QStringLiteral("newDepthText"), side);
    depthText_->setAccessibleName(tr("How deep the scene is"));
    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(view_, 1);
    layout->addLayout(buttons);
    layout->addWidget(depthText_);
    return side;
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
        const QString path = QFileDialog::getOpenFileName(this, label, startOf(*edit), filter);
        if (path.isEmpty()) return;
        edit->setText(path);
        edit->setFocus();
    });
    return edit;
}

void NewPhotoDialog::setColorFile(const QString& path) {
    color_->setText(path);
    open_->setFocus();
    refresh();
}

void NewPhotoDialog::showProblem(const QString& sentence) {
    problem_->setText(sentence);
    problem_->show();
}

QString NewPhotoDialog::startOf(const QLineEdit& edit) const {
    for (const QLineEdit* each : {&edit, static_cast<const QLineEdit*>(color_)})
        if (const QString path = each->text().trimmed(); !path.isEmpty())
            return each == &edit ? path : QFileInfo(path).absolutePath();
    return RecentFiles::lastFolder();
}

NewPhotoDialog::Query NewPhotoDialog::query() const {
    Query result;
    result.color = color_->text().trimmed();
    result.depth = depth_->text().trimmed();
    result.kind = kind_;
    if (!kind_ && beside_ && result.depth.toStdString() == beside_->path) result.kind = beside_->kind;
    if (depthUnit_->value() > 0) result.unit = depthUnit_->value();
    if (fieldOfView_->value() > 0) result.hfov = static_cast<float>(fieldOfView_->value() * std::numbers::pi / 180);
    return result;
}

bool NewPhotoDialog::upToDate() const {
    const Query wanted = query();
    if (wanted.color.isEmpty()) return true;
    return (task_ == nullptr || !task_->running()) && findings_ != nullptr && findings_->query == wanted;
}

void NewPhotoDialog::colorChanged() {
    open_->setEnabled(!color_->text().trimmed().isEmpty());
    opening_ = false;
    exchanged_.reset();
    kind_.reset();
    if (beside_ && depth_->text().trimmed().toStdString() == beside_->path) depth_->clear();
    beside_.reset();
    for (QDoubleSpinBox* box : {depthUnit_, fieldOfView_}) {
        const QSignalBlocker block(box);
        box->setValue(0);
    }
    showNothing(color_->text().trimmed().isEmpty() ? tr("Choose a photograph.") : tr("Reading the photograph…"));
    typing_->start(kTypingDelay);
}

void NewPhotoDialog::exchangeNearAndFar() {
    if (findings_ == nullptr || findings_->points == nullptr) return;
    const QSignalBlocker block(depthUnit_);
    if (exchanged_ && exchanged_->kindAfter == kind_ && exchanged_->unitAfter == depthUnit_->value()) {
        kind_ = exchanged_->kindBefore;
        depthUnit_->setValue(exchanged_->unitBefore);
        exchanged_.reset();
    } else {
        exchanged_.emplace();
        exchanged_->kindBefore = kind_;
        exchanged_->unitBefore = depthUnit_->value();
        const bool length = findings_->kind == core::DepthKind::Z || findings_->kind == core::DepthKind::Distance;
        kind_ = length ? core::DepthKind::Inverse : core::DepthKind::Z;
        // A value v with the depth m·v = z gets the depth n/v; both agree at the median depth if n = z²/m.
        const auto middle = static_cast<double>(findings_->points->middle);
        depthUnit_->setValue(middle * middle / findings_->unit);
        exchanged_->kindAfter = kind_;
        exchanged_->unitAfter = depthUnit_->value();
    }
    refresh();
}

void NewPhotoDialog::pressOpen() {
    problem_->hide();
    if (upToDate()) {
        emit chosen();
        return;
    }
    opening_ = true;
    refresh();
}

void NewPhotoDialog::refresh() {
    typing_->stop();
    if (task_ != nullptr && task_->running()) return;
    const Query wanted = query();
    if (wanted.color.isEmpty()) {
        findings_ = nullptr;
        opening_ = false;
        return;
    }
    if (upToDate()) {
        if (std::exchange(opening_, false)) emit chosen();
        return;
    }
    const auto result = std::make_shared<Findings>();
    task_ = std::make_unique<BackgroundTask>(
        [result, wanted, before = findings_](const core::Progress&) { *result = look(wanted, before); });
    // The next one replaces the task, which must not happen inside its own signal.
    connect(task_.get(), &BackgroundTask::succeeded, this, [this, result] { take(result); });
    connect(task_.get(), &BackgroundTask::failed, this, [this, result, wanted](const QString& sentence) {
        result->query = wanted;
        result->photoProblem = sentence;
        take(result);
    });
    const bool known =
        findings_ != nullptr && findings_->query.color == wanted.color && findings_->query.depth == wanted.depth;
    reading_->setVisible(!known);
    task_->start();
}

void NewPhotoDialog::take(const std::shared_ptr<const Findings>& findings) {
    reading_->hide();
    findings_ = findings;
    const Query wanted = query();
    if (findings->query.color == wanted.color) {
        showFindings(*findings);
        if (findings->beside && wanted.depth.isEmpty()) {
            beside_ = findings->beside;
            depth_->setText(QString::fromStdString(beside_->path));
        }
    }
    typing_->start(0);
}

std::shared_ptr<const core::PhotoFiles> NewPhotoDialog::files() const {
    if (!upToDate() || findings_ == nullptr || findings_->files == nullptr) return nullptr;
    const bool complete = findings_->files->depthPath == findings_->query.depth.toStdString();
    return complete ? findings_->files : nullptr;
}

core::CreateOptions NewPhotoDialog::options() const {
    const Query wanted = query();
    core::CreateOptions options;
    options.color = wanted.color.toStdString();
    options.depth = wanted.depth.toStdString();
    options.segments = segments_->text().trimmed().toStdString();
    options.depthKind = wanted.kind;
    options.depthUnit = wanted.unit;
    if (!wanted.unit && upToDate() && findings_ != nullptr && findings_->unitAssumed)
        options.depthUnit = findings_->unit;
    options.hfov = wanted.hfov;
    return options;
}

void NewPhotoDialog::readFiles(Findings& findings, const std::shared_ptr<const Findings>& before) {
    const Query& query = findings.query;
    const std::shared_ptr<const core::PhotoFiles> known = before != nullptr ? before->files : nullptr;
    const std::string color = query.color.toStdString();
    const std::string depth = query.depth.toStdString();
    if (known != nullptr && known->colorPath == color && known->depthPath == depth) {
        findings.files = known;
        findings.beside = before->beside;
        return;
    }
    auto files = std::make_shared<core::PhotoFiles>();
    try {
        *files = core::readStoredDepth(color, depth);
    } catch (const core::Error& error) {
        if (depth.empty()) throw;
        findings.depthProblem = translated(error);
        *files = core::readStoredDepth(color, {});
        files->depth = {};
    }
    if (known != nullptr && known->colorPath == color && known->imported.has_value() == files->imported.has_value()) {
        files->color = known->color;
        files->colorRemarks = known->colorRemarks;
    }
    core::readColor(*files);
    if (depth.empty() && !files->hasDepth()) findings.beside = core::findDepthBeside(color);
    findings.files = std::move(files);
}

void NewPhotoDialog::interpret(Findings& findings) {
    const Query& query = findings.query;
    const core::PhotoFiles& files = *findings.files;
    if (!files.hasDepth()) return;
    core::CreateOptions options;
    options.color = query.color.toStdString();
    options.depth = query.depth.toStdString();
    options.depthKind = query.kind;
    options.depthUnit = query.unit;
    options.hfov = query.hfov;
    findings.kind = query.kind.value_or(findings.contents->kind.value_or(core::DepthKind::Z));
    findings.unitAssumed = !query.unit && core::needsUnit(files, findings.kind);
    if (findings.unitAssumed) options.depthUnit = core::unitForMedian(files, findings.kind, kAssumedMiddle);
    try {
        const core::PhotoReading reading = core::interpretPhoto(files, core::photoRequest(options), nullptr);
        findings.unit = reading.source.depthUnit;
        findings.points =
            std::make_shared<const DepthPoints>(makeDepthPoints(files.color, reading.depth, reading.camera));
    } catch (const core::Error& error) {
        findings.depthProblem = translated(error);
    }
}

NewPhotoDialog::Findings NewPhotoDialog::look(const Query& query, const std::shared_ptr<const Findings>& before) {
    Findings findings;
    findings.query = query;
    try {
        readFiles(findings, before);
        findings.contents = core::contentsOf(*findings.files);
        interpret(findings);
    } catch (const core::Error& error) {
        findings.files = nullptr;
        findings.photoProblem = translated(error);
    }
    return findings;
}

QString NewPhotoDialog::contentsText(const Findings& findings) const {
    if (!findings.contents) return findings.photoProblem;
    const core::PhotoContents& contents = *findings.contents;
    QStringList parts;
    if (!contents.device.empty()) parts << QString::fromStdString(contents.device);
    parts << tr("%1 × %2 pixels").arg(contents.width).arg(contents.height);
    parts << (contents.hfov ? tr("field of view %1°").arg(degrees(*contents.hfov), 0, 'f', 1)
                            : tr("no field of view stated"));
    if (!contents.depthPlace.empty()) {
        parts << tr("depth inside, %1 × %2 pixels: %3")
                     .arg(contents.depthWidth)
                     .arg(contents.depthHeight)
                     .arg(translated(contents.depthPlace));
    } else if (contents.depthWidth > 0) {
        parts << tr("depth map, %1 × %2 pixels").arg(contents.depthWidth).arg(contents.depthHeight);
    } else {
        parts << tr("no depth inside");
    }
    return parts.join(QStringLiteral(" · "));
}

QString NewPhotoDialog::depthText(const Findings& findings) {
    if (findings.points == nullptr || findings.points->empty()) return {};
    const DepthPoints& points = *findings.points;
    const auto metres = [](float value) { return significant(static_cast<double>(value), 3); };
    QString text = tr("Depth from %1 to %2 m, half of it nearer than %3 m.")
                       .arg(metres(points.nearest), metres(points.farthest), metres(points.middle));
    if (findings.unitAssumed)
        text += QLatin1Char(' ') + tr("Nothing states the unit, so the middle is assumed to be 1 m away.");
    else if (points.middle < kLeastMiddle || points.middle > kMostMiddle)
        text += QLatin1Char(' ') + tr("The unit or the kind is probably wrong.");
    return text;
}

void NewPhotoDialog::showNothing(const QString& sentence) {
    found_->setText(color_->text().trimmed().isEmpty() ? QString() : sentence);
    view_->setPoints(nullptr, sentence);
    depthText_->clear();
    for (QWidget* widget : {static_cast<QWidget*>(depthKind_), static_cast<QWidget*>(exchange_),
                            static_cast<QWidget*>(depthUnit_), static_cast<QWidget*>(fieldOfView_)})
        widget->setEnabled(false);
    for (QToolButton* button : viewButtons_) button->setEnabled(false);
    // "0 m" would say something that nobody knows yet; an empty text would show it.
    for (QDoubleSpinBox* box : {depthUnit_, fieldOfView_}) box->setSpecialValueText(QStringLiteral(" "));
    depthKind_->setCurrentIndex(-1);
}

void NewPhotoDialog::showFindings(const Findings& findings) {
    found_->setText(contentsText(findings));
    const bool depth = findings.files != nullptr && findings.files->hasDepth();
    depthKind_->setEnabled(depth);
    exchange_->setEnabled(findings.points != nullptr);
    depthUnit_->setEnabled(depth);
    fieldOfView_->setEnabled(findings.contents.has_value());
    for (QToolButton* button : viewButtons_) button->setEnabled(findings.points != nullptr);
    depthKind_->setCurrentIndex(depth ? depthKind_->findData(static_cast<int>(findings.kind)) : -1);
    const std::optional<core::PhotoContents>& contents = findings.contents;
    const bool inside = contents && !contents->depthPlace.empty();
    depth_->setPlaceholderText(inside ? tr("inside the photograph") : QString());
    const bool assumed = findings.unitAssumed || (inside && !contents->unitStated);
    const QString unit = significant(inside ? contents->unit : findings.unit, 4);
    if (!depth || findings.query.unit)
        depthUnit_->setSpecialValueText(tr("automatic"));
    else
        depthUnit_->setSpecialValueText(assumed ? tr("automatic: %1 m, assumed").arg(unit)
                                                : tr("automatic: %1 m").arg(unit));
    fieldOfView_->setSpecialValueText(contents && contents->hfov
                                          ? tr("automatic: %1°").arg(degrees(*contents->hfov), 0, 'f', 1)
                                          : tr("automatic: 60°, assumed"));
    QString reason = findings.photoProblem.isEmpty() ? findings.depthProblem : findings.photoProblem;
    if (reason.isEmpty() && !depth)
        reason =
            tr("No depth found. Objects can be selected by their colour. To change materials, add a depth map: "
               "choose its file as \"Depth\", or open a photograph that has depth, such as the original of a "
               "phone's portrait photo.");
    view_->setPoints(findings.points, reason);
    depthText_->setText(depthText(findings));
}

}  // namespace ui
