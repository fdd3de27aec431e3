// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/drive_list.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/io/mask_io.h"
#include "core/material/brdf.h"
#include "core/material/drive_parameters.h"
#include "core/shading/segment_shading.h"
#include "ui/background_task.h"
#include "ui/brush_size.h"
#include "ui/recent_files.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/param_slider.h"

namespace ui {

namespace {

const QString kPainted = QStringLiteral("painted");
const QString kImage = QStringLiteral("image");
const QString kTexture = QStringLiteral("texture");
const QString kSharedPrefix = QStringLiteral("same:");

/// Maximum of the sliders of weights.
constexpr double kMaxWeightShown = 2;

QString labelOf(const core::DriveParameter& parameter) {
    const char* context = parameter.slot < kernel::kDriveAlbedo ? "params" : "drives";
    return QCoreApplication::translate(context, parameter.label.c_str());
}

// For lupdate; the texts are in core/material/drive_parameters.cpp.
[[maybe_unused]] constexpr const char* kLabels[] = {QT_TRANSLATE_NOOP("drives", "Diffuse colour"),
                                                    QT_TRANSLATE_NOOP("drives", "Specular colour"),
                                                    QT_TRANSLATE_NOOP("drives", "Index n"),
                                                    QT_TRANSLATE_NOOP("drives", "Extinction k"),
                                                    QT_TRANSLATE_NOOP("drives", "New"),
                                                    QT_TRANSLATE_NOOP("drives", "Photograph"),
                                                    QT_TRANSLATE_NOOP("drives", "Translucency")};

core::DriveEnd absolute(const core::Vector3f& value) { return {.value = value, .factor = false}; }

core::Vector3f valueOf(const std::optional<core::DriveEnd>& end, const core::Vector3f& own) {
    if (!end) return own;
    return end->factor ? core::Vector3f(end->value.cwiseProduct(own)) : end->value;
}

}  // namespace

DriveList::DriveList(Workspace& workspace, QWidget* parent)
    : QGroupBox(tr("Variation"), parent), workspace_(workspace) {
    setObjectName(QStringLiteral("drives"));
    setAccessibleName(tr("Variation"));
    add_ = new QComboBox(this);
    add_->setObjectName(QStringLiteral("driveAdd"));
    add_->setAccessibleName(tr("Vary a parameter"));
    add_->setToolTip(tr("Let a parameter follow a painted mask, an image or the photograph's texture"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(add_);
    rowLayout_ = new QVBoxLayout;
    layout->addLayout(rowLayout_);
    makeBrush(layout);
    connect(add_, &QComboBox::activated, this, [this](int index) {
        const std::string key = add_->itemData(index).toString().toStdString();
        if (!key.empty()) add(key);
    });
    connect(&workspace, &Workspace::sceneChanged, this, &DriveList::refresh);
    connect(&workspace, &Workspace::selectionChanged, this, &DriveList::refresh);
    connect(&workspace, &Workspace::analysisChanged, this, &DriveList::refresh);
    connect(&workspace, &Workspace::paintingChanged, this, &DriveList::refresh);
    refresh();
}

DriveList::~DriveList() = default;

void DriveList::makeBrush(QVBoxLayout* layout) {
    brush_ = new QWidget(this);
    auto* column = new QVBoxLayout(brush_);
    column->setContentsMargins(0, 0, 0, 0);
    const auto slider = [&](const ParamSpec& spec, float core::Brush::*member) {
        auto* result = new ParamSlider(spec, brush_);
        connect(result, &ParamSlider::valueChanged, this, [this, member](double value) {
            core::Brush brush = workspace_.brush();
            brush.*member = static_cast<float>(value);
            workspace_.setBrush(brush);
        });
        column->addWidget(result);
        return result;
    };
    radius_ = slider({.key = "brushRadius",
                      .label = tr("Brush size"),
                      .unit = tr("px"),
                      .toolTip = tr("Radius in pixels of the photograph"),
                      .minimum = 1,
                      .maximum = static_cast<double>(kLeastMaxBrushRadius),
                      .initial = 20,
                      .logarithmic = true,
                      .decimals = 0},
                     &core::Brush::radius);
    hardness_ = slider({.key = "brushHardness",
                        .label = tr("Hardness"),
                        .unit = {},
                        .toolTip = tr("Fraction of the radius at full strength"),
                        .minimum = 0,
                        .maximum = 1,
                        .initial = 0.5,
                        .decimals = 2},
                       &core::Brush::hardness);
    strength_ = slider({.key = "brushStrength",
                        .label = tr("Strength"),
                        .unit = {},
                        .toolTip = tr("Opacity of one stroke"),
                        .minimum = 0,
                        .maximum = 1,
                        .initial = 1,
                        .decimals = 2},
                       &core::Brush::strength);
    erase_ = new QCheckBox(tr("Erase"), brush_);
    erase_->setObjectName(QStringLiteral("brushErase"));
    erase_->setToolTip(tr("Paint the start value; hold Shift to do so for one stroke"));
    column->addWidget(erase_);
    connect(erase_, &QCheckBox::clicked, this, [this](bool on) {
        core::Brush brush = workspace_.brush();
        brush.erase = on;
        workspace_.setBrush(brush);
    });
    layout->addWidget(brush_);
}

const core::Material* DriveList::material() const {
    const core::Segment* segment = workspace_.selectedSegment();
    return segment != nullptr && segment->edit ? &*segment->edit : nullptr;
}

void DriveList::edit(const QString& label, const std::string& parameter,
                     const std::function<void(core::Drive&)>& change, const QString& mergeKey) {
    if (material() == nullptr) return;
    workspace_.editSelected(
        label,
        [&](core::Segment& segment) {
            for (core::Drive& drive : segment.edit->drives)
                if (drive.parameter == parameter) change(drive);
        },
        mergeKey.isEmpty() ? mergeKey : mergeKey + QString::fromStdString(parameter));
}

std::shared_ptr<const core::Mask> DriveList::emptyMask() const {
    const core::ImageRgb& picture = workspace_.scene().photo->color;
    return std::make_shared<core::Mask>(picture.width(), picture.height());
}

void DriveList::follow(core::Drive& drive, std::shared_ptr<const core::Mask> mask) const {
    drive.source = core::DriveSource::Mask;
    drive.mask = std::move(mask);
    if (drive.from || drive.to) return;
    drive.strength = 1;
    const core::Material& current = *material();
    const std::vector<core::DriveParameter> known = core::driveParameters(current);
    const auto info = std::ranges::find(known, drive.parameter, &core::DriveParameter::key);
    if (info == known.end()) return;
    if (info->color) {
        drive.from = core::DriveEnd{};
        drive.to = core::DriveEnd{.value = core::Vector3f::Constant(0.25f), .factor = true};
        return;
    }
    // The other end of the range, so that paint is visible.
    const core::Vector3f own = core::ownValue(current, *info, core::Vector3f::Ones());
    const float most = info->slot >= kernel::kDriveBlendNew ? 1.0f : info->max;
    drive.from = absolute(own);
    drive.to = absolute(core::Vector3f::Constant(own.x() > 0.5f * (info->min + most) ? info->min : most));
}

void DriveList::add(const std::string& parameter) {
    const core::Material* current = material();
    if (current == nullptr) return;
    const std::vector<core::DriveParameter> known = core::driveParameters(*current);
    const auto info = std::ranges::find(known, parameter, &core::DriveParameter::key);
    if (info == known.end()) return;
    core::Drive drive;
    drive.parameter = parameter;
    follow(drive, emptyMask());
    workspace_.editSelected(tr("Vary %1").arg(labelOf(*info)),
                            [&](core::Segment& segment) { segment.edit->drives.push_back(drive); });
    setPainting(parameter);
    const auto row = std::ranges::find(rows_, parameter, &Row::parameter);
    if (row != rows_.end()) emit rowAdded(row->widget);
}

void DriveList::setPainting(const std::string& parameter) { workspace_.setPaintedParameter(parameter); }

void DriveList::chooseSource(const std::string& parameter, const QString& source) {
    if (source == kImage) return chooseImage(parameter);
    if (source == kTexture) {
        edit(tr("Follow the photograph's texture"), parameter, [](core::Drive& drive) {
            drive.source = core::DriveSource::Luminance;
            drive.mask.reset();
            drive.from.reset();
            drive.to.reset();
            drive.invert = false;
            drive.strength = 1;
        });
        return;
    }
    std::shared_ptr<const core::Mask> mask = emptyMask();
    if (source.startsWith(kSharedPrefix)) {
        const std::string other = source.mid(kSharedPrefix.size()).toStdString();
        for (const core::Drive& drive : material()->drives)
            if (drive.parameter == other && drive.mask) mask = drive.mask;
    }
    edit(tr("Change mask"), parameter, [&](core::Drive& drive) { follow(drive, mask); });
    if (source == kPainted) setPainting(parameter);
}

void DriveList::chooseImage(const std::string& parameter) {
    const QString path = QFileDialog::getOpenFileName(this, tr("Load mask"), RecentFiles::folder(workspace_.document()),
                                                      tr("Images (*.png *.tif *.jpg *.exr);;All files (*)"));
    if (path.isEmpty())
        refresh();
    else
        loadMask(QString::fromStdString(parameter), path);
}

void DriveList::loadMask(const QString& parameter, const QString& path) {
    emit message(tr("Loading %1").arg(path));
    auto mask = std::make_shared<std::shared_ptr<const core::Mask>>();
    const auto photo = workspace_.scene().photo;
    const std::uint16_t label = workspace_.selectedLabel();
    loading_ = std::make_unique<BackgroundTask>(
        [path, mask](const core::Progress&) { *mask = core::loadMask(path.toStdString()); });
    connect(loading_.get(), &BackgroundTask::failed, this, [this](const QString& sentence) {
        refresh();
        emit error(sentence);
    });
    connect(loading_.get(), &BackgroundTask::succeeded, this, [this, parameter, path, mask, photo, label] {
        emit message({});
        refresh();
        if (workspace_.scene().photo != photo || workspace_.selectedLabel() != label) return;
        if ((*mask)->width() != photo->color.width() || (*mask)->height() != photo->color.height()) {
            emit error(tr("The mask \"%1\" is %2x%3 pixels, expected the photograph's size %4x%5.")
                           .arg(path)
                           .arg((*mask)->width())
                           .arg((*mask)->height())
                           .arg(photo->color.width())
                           .arg(photo->color.height()));
            return;
        }
        edit(tr("Load mask"), parameter.toStdString(), [&](core::Drive& drive) { follow(drive, *mask); });
    });
    loading_->start();
}

void DriveList::makeEnds(Row& row, QVBoxLayout* layout) {
    const std::string parameter = row.parameter;
    const QString key = QStringLiteral("drive_") + QString::fromStdString(parameter);
    const auto set = [this, parameter](bool start, const core::Vector3f& value) {
        edit(
            start ? tr("Change start value") : tr("Change end value"), parameter,
            [&](core::Drive& drive) { (start ? drive.from : drive.to) = absolute(value); },
            start ? QStringLiteral("driveFrom") : QStringLiteral("driveTo"));
    };
    for (const bool start : {true, false}) {
        const QString part = start ? QStringLiteral("_from") : QStringLiteral("_to");
        const QString title = start ? tr("from") : tr("to");
        if (row.info.color) {
            auto* button = new ColorButton(key + part, labelOf(row.info) + ' ' + title, row.widget);
            auto* line = new QHBoxLayout;
            line->addWidget(new QLabel(title, row.widget));
            line->addWidget(button, 1);
            layout->addLayout(line);
            (start ? row.fromColor : row.toColor) = button;
            connect(button, &ColorButton::colorChanged, this,
                    [set, start](const core::Vector3f& color) { set(start, color); });
            connect(button, &ColorButton::editingFinished, &workspace_, &Workspace::endMerge);
            continue;
        }
        const bool weight = row.info.slot >= kernel::kDriveBlendNew;
        const core::BrdfInfo* brdf = core::findBrdf(*material());
        const bool own = row.info.slot < brdf->params.size();
        auto* slider =
            new ParamSlider({.key = key + part,
                             .label = title,
                             .unit = own ? QString::fromUtf8(brdf->params[row.info.slot].unit) : QString(),
                             .toolTip = start ? tr("Where the mask is black") : tr("Where the mask is white"),
                             .minimum = static_cast<double>(row.info.min),
                             .maximum = weight ? kMaxWeightShown : static_cast<double>(row.info.max),
                             .initial = weight ? 1.0 : static_cast<double>(start ? row.info.min : row.info.max),
                             .logarithmic = own && brdf->params[row.info.slot].logScale,
                             .decimals = row.info.max >= 100 && !weight ? 1 : 3},
                            row.widget);
        layout->addWidget(slider);
        (start ? row.from : row.to) = slider;
        connect(slider, &ParamSlider::valueChanged, this,
                [set, start](double value) { set(start, core::Vector3f::Constant(static_cast<float>(value))); });
        connect(slider, &ParamSlider::editingFinished, &workspace_, &Workspace::endMerge);
    }
}

DriveList::Row DriveList::makeRow(const core::DriveParameter& parameter) {
    Row row{.parameter = parameter.key, .info = parameter};
    const QString key = QStringLiteral("drive_") + QString::fromStdString(parameter.key);
    const QString title = labelOf(parameter);
    auto* frame = new QFrame(this);
    frame->setFrameShape(QFrame::StyledPanel);
    row.widget = frame;
    auto* layout = new QVBoxLayout(frame);
    layout->setContentsMargins(6, 4, 6, 4);
    auto* remove = new QToolButton(frame);
    remove->setObjectName(key + QStringLiteral("_remove"));
    remove->setText(QStringLiteral("×"));
    remove->setAccessibleName(tr("Remove %1").arg(title));
    remove->setToolTip(tr("Use one value for the whole segment"));
    row.source = new QComboBox(frame);
    row.source->setObjectName(key + QStringLiteral("_source"));
    row.source->setAccessibleName(tr("Source of %1").arg(title));
    row.source->setToolTip(tr("Choose what the parameter follows"));
    row.source->setMinimumContentsLength(8);
    row.source->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    row.paint = new QToolButton(frame);
    row.paint->setObjectName(key + QStringLiteral("_paint"));
    row.paint->setText(tr("Paint"));
    row.paint->setAccessibleName(tr("Paint %1").arg(title));
    row.paint->setToolTip(tr("Paint the mask in the picture"));
    row.paint->setCheckable(true);
    auto* head = new QHBoxLayout;
    head->addWidget(new QLabel(title, frame), 1);
    head->addWidget(remove);
    auto* sourceLine = new QHBoxLayout;
    sourceLine->addWidget(row.source, 1);
    sourceLine->addWidget(row.paint);
    layout->addLayout(head);
    layout->addLayout(sourceLine);
    makeEnds(row, layout);
    row.strength = new ParamSlider({.key = key + QStringLiteral("_strength"),
                                    .label = tr("Contrast"),
                                    .unit = {},
                                    .toolTip = tr("Contrast of the mask, or strength of the texture"),
                                    .minimum = 0,
                                    .maximum = 4,
                                    .initial = 1,
                                    .decimals = 2},
                                   frame);
    row.invert = new QCheckBox(tr("Inverted"), frame);
    row.invert->setObjectName(key + QStringLiteral("_invert"));
    layout->addWidget(row.strength);
    layout->addWidget(row.invert);
    const std::string name = parameter.key;
    connect(remove, &QToolButton::clicked, this, [this, name, title] {
        workspace_.editSelected(tr("Do not vary %1").arg(title), [&](core::Segment& segment) {
            std::erase_if(segment.edit->drives, [&](const core::Drive& d) { return d.parameter == name; });
        });
    });
    connect(row.source, &QComboBox::activated, this,
            [this, name, box = row.source](int index) { chooseSource(name, box->itemData(index).toString()); });
    connect(row.paint, &QToolButton::clicked, this, [this, name](bool on) { setPainting(on ? name : std::string()); });
    connect(row.strength, &ParamSlider::valueChanged, this, [this, name](double value) {
        edit(
            tr("Change contrast"), name, [&](core::Drive& d) { d.strength = static_cast<float>(value); },
            QStringLiteral("driveStrength"));
    });
    connect(row.strength, &ParamSlider::editingFinished, &workspace_, &Workspace::endMerge);
    connect(row.invert, &QCheckBox::clicked, this,
            [this, name](bool on) { edit(tr("Invert"), name, [on](core::Drive& d) { d.invert = on; }); });
    rowLayout_->addWidget(frame);
    return row;
}

void DriveList::rebuild(const core::Material& material) {
    std::string wanted = material.brdf + (material.translucency ? "+" : "-");
    for (const core::Drive& drive : material.drives) wanted += drive.parameter + ' ';
    if (wanted == rowsOf_) return;
    rowsOf_ = wanted;
    for (const Row& row : rows_) {
        // Until it is deleted it would keep its place.
        rowLayout_->removeWidget(row.widget);
        row.widget->hide();
        row.widget->deleteLater();
    }
    rows_.clear();
    const QSignalBlocker block(add_);
    add_->clear();
    add_->addItem(tr("Vary a parameter…"), QString());
    for (const core::DriveParameter& parameter : core::driveParameters(material)) {
        const auto drive = std::ranges::find(material.drives, parameter.key, &core::Drive::parameter);
        if (drive == material.drives.end())
            add_->addItem(labelOf(parameter), QString::fromStdString(parameter.key));
        else
            rows_.push_back(makeRow(parameter));
    }
}

void DriveList::fillSources(Row& row, const core::Material& material) const {
    const auto drive = std::ranges::find(material.drives, row.parameter, &core::Drive::parameter);
    const QSignalBlocker block(row.source);
    row.source->clear();
    const bool file = drive->mask != nullptr && !drive->mask->path().empty();
    row.source->addItem(tr("Painted mask"), kPainted);
    row.source->addItem(
        file ? tr("Image %1").arg(QString::fromStdString(drive->mask->path()).section('/', -1)) : tr("Image…"), kImage);
    row.source->addItem(tr("Photograph's texture"), kTexture);
    for (const Row& other : rows_) {
        const auto d = std::ranges::find(material.drives, other.parameter, &core::Drive::parameter);
        if (other.parameter != row.parameter && d->mask != nullptr)
            row.source->addItem(tr("Mask of %1").arg(labelOf(other.info)),
                                kSharedPrefix + QString::fromStdString(other.parameter));
    }
    row.source->setCurrentIndex(row.source->findData(drive->mask == nullptr ? kTexture : file ? kImage : kPainted));
}

void DriveList::show(Row& row, const core::Drive& drive, const core::Material& material,
                     const core::Vector3f& estimated) {
    fillSources(row, material);
    const bool mask = drive.source == core::DriveSource::Mask;
    const core::Vector3f own = core::ownValue(material, row.info, estimated);
    const core::Vector3f from = valueOf(drive.from, own);
    const core::Vector3f to = valueOf(drive.to, own);
    for (QWidget* widget : {static_cast<QWidget*>(row.from), static_cast<QWidget*>(row.to),
                            static_cast<QWidget*>(row.fromColor), static_cast<QWidget*>(row.toColor)})
        if (widget != nullptr) widget->setEnabled(mask);
    if (row.from != nullptr) row.from->setValue(static_cast<double>(from.x()));
    if (row.to != nullptr) row.to->setValue(static_cast<double>(to.x()));
    if (row.fromColor != nullptr) row.fromColor->setColor(from);
    if (row.toColor != nullptr) row.toColor->setColor(to);
    row.strength->setValue(static_cast<double>(drive.strength));
    row.invert->setChecked(drive.invert);
    row.paint->setVisible(mask);
    row.paint->setChecked(workspace_.paintedParameter() == row.parameter);
}

void DriveList::refresh() {
    const core::Material* current = material();
    brush_->setVisible(current != nullptr && !workspace_.paintedParameter().empty());
    const core::Brush& brush = workspace_.brush();
    radius_->setMaximum(static_cast<double>(maxBrushRadius(workspace_.scene())));
    radius_->setValue(static_cast<double>(brush.radius));
    hardness_->setValue(static_cast<double>(brush.hardness));
    strength_->setValue(static_cast<double>(brush.strength));
    erase_->setChecked(brush.erase);
    if (current == nullptr) return;
    rebuild(*current);
    add_->setCurrentIndex(0);
    const core::Segment& segment = *workspace_.selectedSegment();
    const auto& analysis = workspace_.analysis();
    const core::Vector3f estimated =
        analysis != nullptr ? core::specularOf(segment, *analysis) : core::Vector3f(core::Vector3f::Ones());
    for (Row& row : rows_) {
        const auto drive = std::ranges::find(current->drives, row.parameter, &core::Drive::parameter);
        if (drive != current->drives.end()) show(row, *drive, *current, estimated);
    }
}

}  // namespace ui
