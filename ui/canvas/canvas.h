// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <cstdint>
#include <memory>

#include "render/renderer.h"
#include "ui/canvas/canvas_state.h"

class QLabel;
class QStackedLayout;
class QVulkanInstance;

namespace ui {

class CanvasWindow;

/// The picture: a QVulkanWindow in a widget, or a sentence if there is no Vulkan. It owns the progressive renderer and
/// runs slices of its work until it is finished. Everything set here survives the loss of the device and of the
/// window's surface.
class Canvas : public QWidget {
    Q_OBJECT
  public:
    /// `instance` may be nullptr: then the canvas shows `problem`. `device`: see gpu::RequestAdapterOptions.
    Canvas(QVulkanInstance* instance, const QString& problem, const QString& device, QWidget* parent = nullptr);
    ~Canvas() override;

    /// Whether pictures can be shown.
    [[nodiscard]] bool available() const { return window_ != nullptr; }
    /// Name of the device in use, "" before the first frame.
    [[nodiscard]] QString deviceName() const;

    /// Another photograph; drops result and pictures. nullptr = no project open.
    void setPhoto(std::shared_ptr<const core::Photo> photo);
    /// The same photograph with other labels: everything else stays as it is.
    void setLabels(std::shared_ptr<const core::Photo> photo);
    /// The photograph as picture, for comparison and until there is a result.
    void setOriginal(std::shared_ptr<const CanvasPicture> picture);
    /// Picture of a layer other than result and original.
    void setLayerPicture(std::shared_ptr<const CanvasPicture> picture);
    void setLayer(ViewLayer layer);
    /// The scene to render from the next frame on, and its analysis.
    void setScene(const core::Scene& scene, std::shared_ptr<const core::Analysis> analysis);
    /// No more slices until resumed; the picture stays.
    void setSuspended(bool suspended);
    /// False: changes are shown by their first picture, which is not refined until this is true again.
    void setRefining(bool refining);
    [[nodiscard]] bool refining() const;

    void setSelection(std::uint16_t label);
    void setOutlineShown(bool shown);
    /// A mask over the picture in red; nullptr = none.
    void setMask(std::shared_ptr<const core::Mask> mask);
    /// What the pointer does, and how it looks.
    void setPointer(const Pointer& pointer);
    /// While `held`, the left button moves the picture.
    void setHand(bool held);
    /// Marks what is selected and what it would become; nullptr: nothing is selected, nothing is previewed. With
    /// `part`, both are as before outside this box.
    void showSelection(const core::BinaryMask* selected, const core::BinaryMask* preview,
                       const core::PixelBox* part = nullptr);
    [[nodiscard]] const PixelOverlay* overlay() const;
    /// True: a click gives `pixelPicked` instead of selecting.
    void setPicking(bool picking);
    /// A ruler in a corner, for `millimetres` a picture pixel; 0 = none.
    void setRuler(double millimetres);
    void setExposure(float stops);
    void setComparing(bool comparing);
    void zoomToFit();
    void setZoom(double zoom);
    [[nodiscard]] double zoom() const;
    /// Centre of a picture pixel in this widget [logical pixels].
    [[nodiscard]] QPointF widgetPosition(int x, int y) const;

    [[nodiscard]] render::Renderer::Progress progress() const;
    /// Whether the renderer has begun with the latest scene; `progress` then refers to that scene.
    [[nodiscard]] bool upToDate() const;
    /// The result of the latest scene, reduced until its longer side has about 2 × `side` pixels; empty while it is not
    /// known. Waits for the device.
    [[nodiscard]] core::ImageRgb reducedResult(int side) const;
    /// Number of scenes set so far, and the number of the scene whose first results the last frame showed.
    [[nodiscard]] std::uint64_t sceneNumber() const;
    [[nodiscard]] std::uint64_t shownScene() const;

    [[nodiscard]] QSize sizeHint() const override { return {960, 640}; }

  signals:
    void deviceReady(const QString& name);
    /// After every frame that did work, and once when the renderer finishes.
    void progressChanged();
    void framePresented();
    void cursorMoved(const ui::CursorValue& value);
    void segmentClicked(quint16 label);
    void pixelPicked(int x, int y);
    void zoomChanged(double zoom);
    /// A stroke, in continuous picture coordinates, which may lie outside the picture.
    void strokeBegan(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void strokeMoved(const QPointF& position);
    void strokeEnded();
    /// The second press of a double click, in place of `strokeBegan`.
    void doubleClicked(const QPointF& position, Qt::KeyboardModifiers modifiers);
    /// The pointer moved over the picture's surroundings or the picture without a button, and it left them.
    void hovered(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void hoverEnded();
    /// The device failed; the canvas shows the sentence until the next deviceReady.
    void failed(const QString& sentence);

  private:
    void showMessage(const QString& text);
    /// Shows the window again, which makes it start a device; gives up after kMaxRestarts attempts.
    void restart();

    CanvasWindow* window_ = nullptr;  ///< owned by its container
    QWidget* container_ = nullptr;
    QStackedLayout* stack_ = nullptr;
    QLabel* message_ = nullptr;
    int restarts_ = 0;  ///< since the user last changed something
};

}  // namespace ui
