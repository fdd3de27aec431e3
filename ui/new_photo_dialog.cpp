// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/new_photo_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <numbers>

namespace ui {

NewPhotoDialog::NewPhotoDialog(QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("newPhotoDialog"));
    setWindowTitle(tr("New from photograph and depth"));
    setMinimumWidth(520);
    auto* form = new QFormLayout;
    const QString pictures = tr("Pictures (*.exr *.png *.jpg *.jpeg *.tif *.tiff *.hdr *.pfm);;All files (*)");
    const QString photographs =
        tr("Photographs (*.exr *.png *.jpg *.jpeg *.heic *.heif *.tif *.tiff *.hdr *.pfm *.pcd);;All files (*)");
    color_ = addFileRow(*form, QStringLiteral("newColor"), tr("Photograph"),
                        tr("Colour picture; EXR and HDR files are read as linear light"), photographs);
    depth_ = addFileRow(*form, QStringLiteral("newDepth"), tr("Depth"),
                        tr("Depth map of the same view. Leave empty if the photograph contains depth (portrait photos "
                           "of phones, EXR with "
                           "a Z channel, point clouds)."),
                        pictures);
    depthKind_ = new QComboBox(this);
    depthKind_->setObjectName(QStringLiteral("newDepthKind"));
    depthKind_->setToolTip(tr("Meaning of the numbers in the depth file"));
    depthKind_->addItem(tr("Depth along the viewing axis"), static_cast<int>(core::DepthKind::Z));
    depthKind_->addItem(tr("Distance from the camera"), static_cast<int>(core::DepthKind::Distance));
    depthKind_->addItem(tr("Disparity (phones)"), static_cast<int>(core::DepthKind::Disparity));
    depthKind_->addItem(tr("Inverse depth (networks)"), static_cast<int>(core::DepthKind::Inverse));
    form->addRow(tr("Depth is"), depthKind_);
    depthUnit_ = new QDoubleSpinBox(this);
    depthUnit_->setObjectName(QStringLiteral("newDepthUnit"));
    depthUnit_->setToolTip(tr(
        "Metres per stored unit. Automatic uses what the photograph states, otherwise 1 for floating-point files and "
        "0.001 for 16-bit files."));
    depthUnit_->setRange(0, 1000);
    depthUnit_->setDecimals(6);
    depthUnit_->setSpecialValueText(tr("automatic"));
    depthUnit_->setSuffix(tr(" m"));
    form->addRow(tr("Depth unit"), depthUnit_);
    segments_ = addFileRow(*form, QStringLiteral("newSegments"), tr("Segments"),
                           tr("Label map: one number per object, 0 for none"), pictures);
    fieldOfView_ = new QDoubleSpinBox(this);
    fieldOfView_->setObjectName(QStringLiteral("newFieldOfView"));
    fieldOfView_->setToolTip(
        tr("Horizontal field of view. Automatic reads it from the photograph, otherwise assumes 60°."));
    fieldOfView_->setRange(0, 170);
    fieldOfView_->setDecimals(2);
    fieldOfView_->setSpecialValueText(tr("automatic"));
    fieldOfView_->setSuffix(tr("°"));
    form->addRow(tr("Field of view"), fieldOfView_);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    ok_ = buttons->button(QDialogButtonBox::Ok);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(buttons);
    updateOk();
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
    auto* row = new QHBoxLayout;
    row->addWidget(edit, 1);
    row->addWidget(browse);
    form.addRow(label, row);
    connect(browse, &QPushButton::clicked, this, [this, edit, label, filter] {
        const QString path = QFileDialog::getOpenFileName(this, label, edit->text(), filter);
        if (!path.isEmpty()) edit->setText(path);
    });
    connect(edit, &QLineEdit::textChanged, this, &NewPhotoDialog::updateOk);
    return edit;
}

void NewPhotoDialog::setColorFile(const QString& path) { color_->setText(path); }

void NewPhotoDialog::updateOk() {
    if (ok_ != nullptr) ok_->setEnabled(!color_->text().trimmed().isEmpty());
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
