// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas.h"

#include <qfloat16.h>
#include <QLabel>
#include <QStackedLayout>
#include <QTimer>
#include <QVulkanInstance>
#include <algorithm>
#include <cmath>

#include "gpu/error.h"
#include "ui/canvas/canvas_renderer.h"
#include "ui/canvas/canvas_window.h"
#include "ui/vulkan_support.h"
#include "ui/words.h"

namespace ui {

namespace {

/// Time for reading the sentence about a lost device [ms].
constexpr int kRestartDelay = 1000;
constexpr int kMaxRestarts = 3;

}  // namespace

std::shared_ptr<const CanvasPicture> makeCanvasPicture(const LayerPicture& picture) {
    constexpr float kMaxHalf = 65504;
    auto result = std::make_shared<CanvasPicture>();
    result->width = picture.pixels.width();
    result->height = picture.pixels.height();
    result->displayEncoded = picture.displayEncoded;
    result->rgba.resize(picture.pixels.size() * 4);
    std::vector<float> row(static_cast<std::size_t>(result->width) * 4, 1.0f);
    static_assert(sizeof(qfloat16) == sizeof(std::uint16_t));
    for (int y = 0; y < result->height; ++y) {
        for (int x = 0; x < result->width; ++x) {
            const core::Vector3f& c = picture.pixels(x, y);
            for (std::size_t i = 0; i < 3; ++i) {
                row[static_cast<std::size_t>(x) * 4 + i] =
                    std::clamp(c[static_cast<Eigen::Index>(i)], -kMaxHalf, kMaxHalf);
            }
        }
        auto* target = reinterpret_cast<qfloat16*>(result->rgba.data() + static_cast<std::size_t>(y) * row.size());
        qFloatToFloat16(target, row.data(), static_cast<qsizetype>(row.size()));
    }
    return result;
}

Canvas::Canvas(QVulkanInstance* instance, const QString& problem, const QString& device, QWidget* parent)
    : QWidget(parent) {
    qRegisterMetaType<CursorValue>();
    setObjectName(QStringLiteral("canvas"));
    setAccessibleName(tr("Picture"));
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    message_ = new QLabel(this);
    message_->setObjectName(QStringLiteral("canvasMessage"));
    message_->setAlignment(Qt::AlignCenter);
    message_->setWordWrap(true);
    message_->setMargin(24);
    stack_ = new QStackedLayout(this);
    stack_->setContentsMargins(0, 0, 0, 0);
    stack_->addWidget(message_);
    if (instance == nullptr) {
        showMessage(problem);
        return;
    }
    window_ = new CanvasWindow;
    window_->setVulkanInstance(instance);
    try {
        selectPhysicalDevice(*window_, device);
    } catch (const gpu::Error& error) {
        delete window_;
        window_ = nullptr;
        showMessage(translated(error));
        return;
    }
    container_ = QWidget::createWindowContainer(window_, this);
    container_->setFocusPolicy(Qt::NoFocus);
    stack_->addWidget(container_);
    stack_->setCurrentWidget(container_);
    connect(window_, &CanvasWindow::deviceReady, this, [this](const QString& name) {
        stack_->setCurrentWidget(container_);
        emit deviceReady(name);
    });
    connect(window_, &CanvasWindow::progressChanged, this, &Canvas::progressChanged);
    connect(window_, &CanvasWindow::framePresented, this, &Canvas::framePresented);
    connect(window_, &CanvasWindow::cursorMoved, this, &Canvas::cursorMoved);
    connect(window_, &CanvasWindow::segmentClicked, this, &Canvas::segmentClicked);
    connect(window_, &CanvasWindow::pixelPicked, this, &Canvas::pixelPicked);
    connect(window_, &CanvasWindow::zoomChanged, this, &Canvas::zoomChanged);
    connect(window_, &CanvasWindow::strokeBegan, this, &Canvas::strokeBegan);
    connect(window_, &CanvasWindow::strokeMoved, this, &Canvas::strokeMoved);
    connect(window_, &CanvasWindow::strokeEnded, this, &Canvas::strokeEnded);
    connect(window_, &CanvasWindow::doubleClicked, this, &Canvas::doubleClicked);
    connect(window_, &CanvasWindow::hovered, this, &Canvas::hovered);
    connect(window_, &CanvasWindow::hoverEnded, this, &Canvas::hoverEnded);
    connect(window_, &CanvasWindow::pressed, this, [this] { setFocus(Qt::MouseFocusReason); });
    // Queued, because the window must not be hidden while it draws.
    connect(
        window_, &CanvasWindow::failed, this,
        [this](const QString& sentence) {
            showMessage(sentence);
            emit failed(sentence);
        },
        Qt::QueuedConnection);
    connect(
        window_, &CanvasWindow::deviceLost, this, [this] { QTimer::singleShot(kRestartDelay, this, &Canvas::restart); },
        Qt::QueuedConnection);
}

Canvas::~Canvas() = default;

void Canvas::showMessage(const QString& text) {
    message_->setText(text);
    stack_->setCurrentWidget(message_);
}

void Canvas::restart() {
    if (++restarts_ > kMaxRestarts) {
        showMessage(
            tr("The graphics device is lost whenever this picture is drawn. Your edits are safe: undo the last one, or "
               "save and restart Patina with another device."));
        return;
    }
    window_->renderer()->retry();
    stack_->setCurrentWidget(container_);
    window_->redraw();
}

QString Canvas::deviceName() const {
    return window_ != nullptr && window_->renderer() != nullptr ? window_->renderer()->deviceName() : QString();
}

void Canvas::setPhoto(std::shared_ptr<const core::Photo> photo) {
    if (window_ == nullptr) return;
    CanvasState& state = window_->state();
    state.photo = std::move(photo);
    state.original.reset();
    state.layerPicture.reset();
    state.scene.reset();
    state.analysis.reset();
    state.selected = 0;
    state.mask.reset();
    state.cursorInside = false;
    if (state.photo != nullptr) state.overlay.reset(state.photo->color.width(), state.photo->color.height());
    state.view.fit();
    restarts_ = 0;
    if (window_->renderer() != nullptr) window_->renderer()->retry();
    stack_->setCurrentWidget(container_);
    window_->updateSizes();
}

void Canvas::setLabels(std::shared_ptr<const core::Photo> photo) {
    if (window_ == nullptr || window_->state().photo == photo) return;
    CORE_ASSERT(photo != nullptr && window_->state().photo != nullptr, "a photograph");
    window_->state().photo = std::move(photo);
    setSelection(window_->state().selected);
}

void Canvas::setOriginal(std::shared_ptr<const CanvasPicture> picture) {
    if (window_ == nullptr) return;
    window_->state().original = std::move(picture);
    window_->redraw();
}

void Canvas::setLayerPicture(std::shared_ptr<const CanvasPicture> picture) {
    if (window_ == nullptr) return;
    window_->state().layerPicture = std::move(picture);
    window_->redraw();
}

void Canvas::setLayer(ViewLayer layer) {
    if (window_ == nullptr) return;
    window_->state().layer = layer;
    window_->redraw();
}

void Canvas::setScene(const core::Scene& scene, std::shared_ptr<const core::Analysis> analysis) {
    if (window_ == nullptr) return;
    window_->state().scene = std::make_shared<const core::Scene>(scene);
    window_->state().analysis = std::move(analysis);
    ++window_->state().sceneNumber;
    if (window_->renderer() != nullptr) window_->renderer()->sceneChanged();
    // The device may survive the next edit.
    if (restarts_ > kMaxRestarts) QTimer::singleShot(kRestartDelay, this, &Canvas::restart);
    restarts_ = 0;
}

void Canvas::setSuspended(bool suspended) {
    if (window_ == nullptr) return;
    window_->state().suspended = suspended;
    window_->redraw();
}

void Canvas::setRefining(bool refining) {
    if (window_ == nullptr) return;
    window_->state().refining = refining;
    window_->redraw();
}

bool Canvas::refining() const { return window_ == nullptr || window_->state().refining; }

void Canvas::setSelection(std::uint16_t label) {
    if (window_ == nullptr) return;
    CanvasState& state = window_->state();
    state.selected = label;
    state.selectedBounds = {};
    if (state.photo != nullptr && label != 0) {
        const core::LabelImage& labels = state.photo->labels;
        for (int y = 0; y < labels.height(); ++y) {
            for (int x = 0; x < labels.width(); ++x) {
                if (labels(x, y) == label) state.selectedBounds |= QRect(x, y, 1, 1);
            }
        }
    }
    window_->redraw();
}

void Canvas::setOutlineShown(bool shown) {
    if (window_ == nullptr) return;
    window_->state().outlineShown = shown;
    window_->redraw();
}

void Canvas::setMask(std::shared_ptr<const core::Mask> mask) {
    if (window_ == nullptr || window_->state().mask == mask) return;
    window_->state().mask = std::move(mask);
    window_->redraw();
}

void Canvas::setPointer(const Pointer& pointer) {
    if (window_ == nullptr) return;
    window_->setPointer(pointer);
}

void Canvas::setHand(bool held) {
    if (window_ == nullptr) return;
    window_->setHand(held);
}

void Canvas::showSelection(const core::BinaryMask* selected, const core::BinaryMask* preview,
                           const core::PixelBox* part) {
    if (window_ == nullptr || window_->state().photo == nullptr) return;
    PixelOverlay& overlay = window_->state().overlay;
    if (part != nullptr)
        overlay.showPart(selected, preview, *part);
    else
        overlay.show(selected, preview);
    window_->redraw();
}

const PixelOverlay* Canvas::overlay() const { return window_ != nullptr ? &window_->state().overlay : nullptr; }

void Canvas::setPicking(bool picking) {
    if (window_ == nullptr) return;
    window_->setPicking(picking);
}

void Canvas::setRuler(double millimetres) {
    if (window_ == nullptr || window_->state().rulerMillimetres == millimetres) return;
    window_->state().rulerMillimetres = millimetres;
    window_->redraw();
}

void Canvas::setExposure(float stops) {
    if (window_ == nullptr) return;
    window_->state().exposureStops = stops;
    window_->redraw();
}

void Canvas::setComparing(bool comparing) {
    if (window_ == nullptr) return;
    window_->state().comparing = comparing;
    window_->redraw();
}

void Canvas::zoomToFit() {
    if (window_ == nullptr) return;
    window_->state().view.fit();
    emit zoomChanged(zoom());
    window_->redraw();
}

void Canvas::setZoom(double zoom) {
    if (window_ == nullptr) return;
    window_->state().view.zoomCentered(zoom);
    emit zoomChanged(this->zoom());
    window_->redraw();
}

double Canvas::zoom() const { return window_ != nullptr ? window_->state().view.zoom() : 1; }

QPointF Canvas::widgetPosition(int x, int y) const {
    if (window_ == nullptr) return {};
    return window_->state().view.toView(QPointF(x + 0.5, y + 0.5)) / window_->devicePixelRatio();
}

render::Renderer::Progress Canvas::progress() const {
    return window_ != nullptr && window_->renderer() != nullptr ? window_->renderer()->progress()
                                                                : render::Renderer::Progress();
}

std::uint64_t Canvas::sceneNumber() const { return window_ != nullptr ? window_->state().sceneNumber : 0; }

std::uint64_t Canvas::shownScene() const {
    return window_ != nullptr && window_->renderer() != nullptr ? window_->renderer()->shownScene() : 0;
}

core::ImageRgb Canvas::reducedResult(int side) const {
    return available() && upToDate() && window_->renderer() != nullptr ? window_->renderer()->reducedResult(side)
                                                                       : core::ImageRgb();
}

bool Canvas::upToDate() const {
    return window_ != nullptr && window_->renderer() != nullptr && window_->renderer()->upToDate();
}

}  // namespace ui
