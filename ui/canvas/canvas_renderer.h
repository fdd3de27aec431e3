// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <QVulkanWindow>
#include <functional>
#include <memory>

#include "gpu/device.h"
#include "render/renderer.h"
#include "ui/canvas/canvas_painter.h"
#include "ui/canvas/canvas_state.h"

namespace ui {

/// The device side of the canvas: the window's device as gpu::Device, the progressive renderer and the painter on it.
/// Everything here can be lost and is made again from CanvasState.
///
/// Presenting a frame waits for everything submitted before it, on some drivers in the calling thread. So a frame only
/// copies a finished picture: a step (a slice of the renderer's work, and the view drawn into a picture) is submitted,
/// and the frame is requested once it has completed. The window's thread is free in the meantime.
class CanvasRenderer : public QObject, public QVulkanWindowRenderer {
    Q_OBJECT
  public:
    /// Draws `state` into `window`. Both outlive the renderer.
    CanvasRenderer(QVulkanWindow& window, const CanvasState& state);

    void initResources() override;
    void releaseResources() override;
    void startNextFrame() override;
    void logicalDeviceLost() override;
    void physicalDeviceLost() override;

    /// The scene in the state changed: the result follows soon.
    void sceneChanged();
    [[nodiscard]] bool upToDate() const { return !sceneStale_ && hasResult_; }
    [[nodiscard]] std::uint64_t shownScene() const { return shownScene_; }
    /// Forgets a failure, for example memory that a smaller photograph does not need.
    void retry();
    /// Draws the state after the current step, once for all changes until then.
    void paint();
    /// Reads the result under the cursor with the next step; cursorMoved delivers the answer.
    void probeCursor();

    /// The result, reduced until its longer side has about 2 × `side` pixels; empty without a result. Waits for the
    /// device.
    [[nodiscard]] core::ImageRgb reducedResult(int side);

    [[nodiscard]] render::Renderer::Progress progress() const { return progress_; }
    [[nodiscard]] const QString& deviceName() const { return deviceName_; }

  signals:
    void deviceReady(const QString& name);
    void progressChanged();
    /// A frame was handed to the display; it shows the state at its start.
    void framePresented();
    void failed(const QString& sentence);
    /// After `failed`: QVulkanWindow has given the device up and makes another one when it is next exposed.
    void deviceLost();
    void cursorMoved(const ui::CursorValue& value);

  private:
    void schedule();
    void step();
    /// Hands a new scene of the state to the renderer; returns the device time for the next slice [s].
    [[nodiscard]] double takeScene();
    void submitStep();
    void poll();
    /// Size of the next frame [device pixels]. While the window is being resized, its swapchain still has the old size.
    [[nodiscard]] QSize frameSize() const;
    void makePresentPipeline();
    [[nodiscard]] bool targetEncodes() const;
    void recordFrame();
    /// A frame that could not be recorded still has to be presentable.
    void clear();
    /// Runs `work` unless the canvas has failed; what it throws is a failure.
    void attempt(const std::function<void()>& work);
    void recordProbe(const gpu::CommandEncoder& encoder);
    void readProbe();
    void finishProbe(int x, int y);
    void fail(const QString& sentence);
    void drop();

    QVulkanWindow& window_;
    const CanvasState& state_;
    gpu::Device device_;
    QString deviceName_;
    std::unique_ptr<render::Renderer> renderer_;
    std::shared_ptr<const core::Photo> rendererPhoto_;
    render::Renderer::Progress progress_;
    std::unique_ptr<CanvasPainter> painter_;
    gpu::RenderPipeline presentPipeline_;
    gpu::Texture presented_;
    gpu::BindGroup presentGroup_;  ///< with `presented_`
    QTimer start_;                 ///< delays a step until all input that has arrived is processed
    QTimer poll_;                  ///< runs while a step is pending
    bool pending_ = false;         ///< the device is working on a step
    bool painted_ = false;         ///< the step draws
    bool workLeft_ = false;        ///< the renderer is not finished
    bool paintWanted_ = true;      ///< the state changed since it was drawn
    bool presenting_ = false;      ///< a frame was asked for
    bool sceneStale_ = true;
    std::uint64_t renderedScene_ = 0;  ///< CanvasState::sceneNumber of the renderer's scene
    std::uint64_t paintedScene_ = 0;   ///< number of the scene in the drawn picture
    std::uint64_t shownScene_ = 0;
    bool hasResult_ = false;
    bool failed_ = false;
    bool drawn_ = false;
    QSize frameWindow_;  ///< the window's size at the last frame
    gpu::Buffer probe_;
    bool probeWanted_ = false;
    bool probePending_ = false;
};

}  // namespace ui
