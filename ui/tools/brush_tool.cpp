// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/brush_tool.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/widgets/param_slider.h"

namespace ui {

namespace {

/// How far an outline moves when it is refined, in radii of the brush, and its limits [px].
constexpr float kRefineReach = 0.5f;
constexpr int kMinRefineReach = 2;
constexpr int kMaxRefineReach = 16;

core::BinaryMask exclusiveOr(const core::BinaryMask& a, const core::BinaryMask& b) {
    core::BinaryMask result = b;
    if (!a.empty())
        for (std::size_t i = 0; i < result.size(); ++i) result[i] ^= a[i];
    return result;
}

}  // namespace

void BrushOptions::set(const core::SelectionBrush& brush) {
    brush_ = brush;
    brush_.radius = std::clamp(brush.radius, kMinBrushRadius, maximum_);
    emit changed();
}

void BrushOptions::setMaximum(float radius) {
    maximum_ = radius;
    set(brush_);
}

BrushTool::BrushTool(SelectionSession& session, Kind kind, BrushOptions& options, QObject* parent)
    : Tool(session, parent), kind_(kind), options_(options) {
    connect(&options, &BrushOptions::changed, this, &Tool::pointerChanged);
    connect(&session.workspace(), &Workspace::documentReplaced, this, [this] {
        stroke_.reset();
        photo_.reset();
    });
}

Pointer BrushTool::pointer() const {
    return {.strokes = true, .brushRadius = options_.brush().radius, .shape = Qt::CrossCursor};
}

QString BrushTool::hint() const {
    if (kind_ == Kind::Paint) return tr("Paint over the object. Alt erases; [ and ] change the brush.");
    if (kind_ == Kind::Erase) return tr("Paint over what is selected wrongly. Alt paints; [ and ] change the brush.");
    return session().selection() == nullptr ? tr("Select something first; then paint over its outline.")
                                            : tr("Paint over the outline where it is wrong: it is found again there.");
}

QWidget* BrushTool::makeOptions(QWidget* parent) {
    auto* row = new QWidget(parent);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* radius = new ParamSlider({.key = QStringLiteral("selectionBrushRadius"),
                                    .label = tr("Size"),
                                    .unit = tr("px"),
                                    .toolTip = tr("Radius of the brush in pixels of the picture"),
                                    .minimum = 1,
                                    .maximum = static_cast<double>(options_.maximum()),
                                    .initial = 20,
                                    .logarithmic = true,
                                    .decimals = 1,
                                    .lowest = static_cast<double>(kMinBrushRadius),
                                    .compact = true},
                                   row);
    layout->addWidget(radius);
    connect(radius, &ParamSlider::valueChanged, this, [this](double value) {
        core::SelectionBrush brush = options_.brush();
        brush.radius = static_cast<float>(value);
        options_.set(brush);
    });
    const auto show = [this, radius] {
        radius->setMaximum(static_cast<double>(options_.maximum()));
        radius->setValue(static_cast<double>(options_.brush().radius));
    };
    connect(&options_, &BrushOptions::changed, radius, show);
    show();
    if (kind_ == Kind::Refine) return row;
    auto* hardness =
        new ParamSlider({.key = QStringLiteral("selectionBrushHardness"),
                         .label = tr("Hardness"),
                         .unit = tr("%"),
                         .toolTip = tr("Part of the brush that paints everything; the rim around it paints "
                                       "only what looks like the part inside"),
                         .minimum = 0,
                         .maximum = 100,
                         .initial = 100,
                         .decimals = 0,
                         .compact = true},
                        row);
    layout->addWidget(hardness);
    connect(hardness, &ParamSlider::valueChanged, this, [this](double value) {
        core::SelectionBrush brush = options_.brush();
        brush.hardness = static_cast<float>(value / 100);
        options_.set(brush);
    });
    auto* stops = new QCheckBox(tr("Stop at depth edges"), row);
    stops->setObjectName(QStringLiteral("selectionBrushStops"));
    stops->setToolTip(tr("Paint only the surface that is under the middle of the brush"));
    layout->addWidget(stops);
    connect(stops, &QCheckBox::toggled, this, [this](bool on) {
        core::SelectionBrush brush = options_.brush();
        brush.stopAtDepthEdges = on;
        options_.set(brush);
    });
    const auto showOthers = [this, hardness, stops] {
        hardness->setValue(std::round(static_cast<double>(options_.brush().hardness) * 100));
        const QSignalBlocker block(stops);
        stops->setChecked(options_.brush().stopAtDepthEdges);
        stops->setEnabled(session().hasDepth());
    };
    connect(&options_, &BrushOptions::changed, stops, showOthers);
    connect(&session(), &SelectionSession::changed, stops, showOthers);
    showOthers();
    return row;
}

void BrushTool::press(const ToolEvent& event) {
    photo_ = session().photo();
    if (photo_ == nullptr || (kind_ == Kind::Refine && session().selection() == nullptr)) return;
    core::SelectionBrush brush = options_.brush();
    erases_ = kind_ != Kind::Refine && (kind_ == Kind::Erase) != event.modifiers.testFlag(Qt::AltModifier);
    brush.erase = erases_;
    if (kind_ == Kind::Refine) brush.hardness = 1;
    core::BinaryMask before = kind_ == Kind::Refine ? core::BinaryMask() : session().selected();
    if (before.empty()) before = core::BinaryMask(photo_->color.width(), photo_->color.height());
    stroke_.emplace(std::move(before), brush, photo_->color, photo_->depth, photo_->camera.fx);
    drag(event.position);
}

void BrushTool::drag(const QPointF& position) {
    if (!stroke_) return;
    const core::PixelBox box = stroke_->moveTo(static_cast<float>(position.x()), static_cast<float>(position.y()));
    if (box.empty()) return;
    if (kind_ == Kind::Refine) {
        const core::BinaryMask shown = exclusiveOr(session().selected(), stroke_->mask());
        session().preview(&shown, &box);
    } else {
        session().preview(&stroke_->mask(), &box);
    }
}

void BrushTool::release() {
    if (!stroke_) return;
    const core::BinaryMask mask = stroke_->mask();
    stroke_.reset();
    photo_.reset();
    if (kind_ == Kind::Refine)
        refine(mask);
    else
        session().apply(erases_ ? tr("Erase selection") : tr("Paint selection"), mask, core::MaskUse::Replace);
}

void BrushTool::refine(const core::BinaryMask& painted) {
    const int reach = std::clamp(static_cast<int>(std::lround(kRefineReach * options_.brush().radius)), kMinRefineReach,
                                 kMaxRefineReach);
    session().preview(nullptr);
    session().refine(tr("Refine edge"),
                     [painted, reach](const core::Selector& selector, const core::BinaryMask& selected,
                                      const core::Progress& progress) {
                         core::BinaryMask refined = selector.refine(selected, reach, progress);
                         for (std::size_t i = 0; i < refined.size(); ++i)
                             if (painted[i] == 0) refined[i] = selected[i];
                         return refined;
                     });
}

bool BrushTool::finish() {
    if (!stroke_) return false;
    release();
    return true;
}

bool BrushTool::cancel() {
    if (!stroke_) return false;
    stroke_.reset();
    session().preview(nullptr);
    return true;
}

bool BrushTool::resize(float factor) {
    core::SelectionBrush brush = options_.brush();
    brush.radius *= factor;
    options_.set(brush);
    return true;
}

}  // namespace ui
