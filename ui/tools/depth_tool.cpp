// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/depth_tool.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <memory>

#include "core/selection/mask_operations.h"
#include "ui/widgets/param_slider.h"

namespace ui {

QString DepthTool::hint() const {
    if (!session().hasDepth()) return tr("The photograph has no depth to select by.");
    return wanted_.shape == core::DepthShape::Plane ? tr("Click a plane, such as a wall or a table.")
                                                    : tr("Click something to select all that is as far away.");
}

QWidget* DepthTool::makeOptions(QWidget* parent) {
    auto* row = new QWidget(parent);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* shape = new QComboBox(row);
    shape->setObjectName(QStringLiteral("depthShape"));
    shape->setAccessibleName(tr("Kind of depth selection"));
    shape->setToolTip(tr("Select what is equally far away, or what lies on one plane"));
    shape->addItem(tr("Distance"));
    shape->addItem(tr("Plane"));
    connect(shape, &QComboBox::currentIndexChanged, this, [this](int index) {
        wanted_.shape = index == 1 ? core::DepthShape::Plane : core::DepthShape::Range;
        emit hintChanged();
    });
    layout->addWidget(shape);
    auto* tolerance = new ParamSlider({.key = QStringLiteral("depthTolerance"),
                                       .label = tr("Tolerance"),
                                       .unit = tr("%"),
                                       .toolTip = tr("How far depth may be off, in parts of the distance"),
                                       .minimum = 0.1,
                                       .maximum = 50,
                                       .initial = static_cast<double>(wanted_.tolerance) * 100,
                                       .logarithmic = true,
                                       .decimals = 1,
                                       .compact = true},
                                      row);
    tolerance->setValue(static_cast<double>(wanted_.tolerance) * 100);
    connect(tolerance, &ParamSlider::valueChanged, this,
            [this](double value) { wanted_.tolerance = static_cast<float>(value / 100); });
    layout->addWidget(tolerance);
    auto* softness = new ParamSlider({.key = QStringLiteral("depthSoftness"),
                                      .label = tr("Softness"),
                                      .unit = tr("px"),
                                      .toolTip = tr("Round the outline off over this many pixels, and drop specks"),
                                      .minimum = 0,
                                      .maximum = 20,
                                      .initial = 0,
                                      .decimals = 0,
                                      .compact = true},
                                     row);
    connect(softness, &ParamSlider::valueChanged, this, [this](double value) { smoothing_ = static_cast<int>(value); });
    layout->addWidget(softness);
    auto* connected = new QCheckBox(tr("Connected"), row);
    connected->setObjectName(QStringLiteral("depthConnected"));
    connected->setToolTip(tr("Select only the piece that is clicked"));
    connected->setChecked(wanted_.connected);
    connect(connected, &QCheckBox::toggled, this, [this](bool on) { wanted_.connected = on; });
    layout->addWidget(connected);
    return row;
}

void DepthTool::press(const ToolEvent& event) {
    const core::Pixel pixel = pixelAt(event.position);
    const auto photo = session().photo();
    if (!inPicture(pixel)) {
        emit session().message(tr("Click inside the picture."));
        return;
    }
    if (!(photo->depth.image()(pixel.x, pixel.y) > 0)) {
        emit session().message(tr("There is no depth at this pixel."));
        return;
    }
    const auto found = std::make_shared<core::BinaryMask>();
    const auto before = session().selection();
    const core::MaskUse use = session().useWith(event.modifiers);
    session().worker().change(
        [photo, pixel, found, wanted = wanted_, smoothing = smoothing_](const core::Selector&,
                                                                        const core::Progress& progress) {
            *found = core::smoothMask(core::selectByDepth(photo->depth, pixel, wanted, progress), smoothing);
        },
        [this, found, before, use] {
            if (session().selection() == before) session().apply(tr("Select by depth"), *found, use);
        });
}

void DepthTool::hover(const ToolEvent& event) {
    const core::Pixel pixel = pixelAt(event.position);
    const auto photo = session().photo();
    if (!inPicture(pixel)) {
        leave();
        return;
    }
    const auto before = session().selection();
    const auto result = std::make_shared<core::BinaryMask>();
    session().worker().preview(
        [photo, pixel, before, result, wanted = wanted_, smoothing = smoothing_,
         use = session().useWith(event.modifiers)](const core::Selector&, const core::Progress& progress) {
            static const core::BinaryMask kNothing;
            const core::BinaryMask found =
                core::smoothMask(core::selectByDepth(photo->depth, pixel, wanted, progress), smoothing);
            *result = core::combineMasks(before != nullptr ? before->mask : kNothing, found, use);
        },
        [this, before, result] {
            if (session().selection() == before) session().preview(result.get());
        });
}

void DepthTool::leave() {
    session().worker().dropPreview();
    session().preview(nullptr);
}

}  // namespace ui
