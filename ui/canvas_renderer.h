// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QVulkanWindowRenderer>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "core/render/renderer.h"
#include "gpu/device.h"
#include "shaders/shared/canvas_block.h"
#include "ui/canvas_window.h"
#include "ui/ruler.h"

namespace ui {

/// The device side of the canvas: the window's device as gpu::Device, the progressive renderer on it, one draw a frame.
/// Everything here can be lost and is made again from CanvasState.
///
/// Presenting a frame waits for everything submitted before it, on some drivers in the calling thread. So the
/// renderer's work is no part of a frame: a frame is drawn, a slice of work is submitted, and the next frame is asked
/// for when the slice has completed. Between the two the window's thread is free.
class CanvasRenderer : public QVulkanWindowRenderer {
  public:
    explicit CanvasRenderer(CanvasWindow& window);

    void initResources() override;
    void releaseResources() override;
    void startNextFrame() override;
    void logicalDeviceLost() override;
    void physicalDeviceLost() override;

    /// The scene in the state changed.
    void sceneChanged() { sceneStale_ = true; }
    [[nodiscard]] bool upToDate() const { return !sceneStale_ && hasResult_; }
    [[nodiscard]] std::uint64_t shownScene() const { return shownScene_; }
    /// Forgets a failure, for example memory that a smaller photograph does not need.
    void retry();
    /// True while a slice is in work: a frame begun now would wait for it, so it is begun afterwards.
    [[nodiscard]] bool holdFrame();
    /// Reads the result under the cursor with the next frame; the answer comes as CanvasWindow::cursorMoved.
    void probeCursor();

    [[nodiscard]] render::Renderer::Progress progress() const { return progress_; }
    [[nodiscard]] const QString& deviceName() const { return deviceName_; }

  private:
    void recordFrame();
    void startSlice();
    void pollSlice();
    /// Runs `work` unless the canvas has failed; what it throws is a failure.
    void attempt(const std::function<void()>& work);
    void updateLabels();
    void updateMask();
    void updateRuler();
    void recordProbe(const gpu::CommandEncoder& encoder);
    void finishProbe(int x, int y);
    void draw(const gpu::CommandEncoder& encoder);
    /// Where the ruler goes in the view [device pixels]; empty without one.
    [[nodiscard]] QRect rulerPlace() const;
    /// Draws the picture into a rectangle of the view, made for exactly this filter and these CANVAS_* flags.
    void drawPart(const gpu::RenderPassEncoder& pass, const QRectF& part, int filter, unsigned flags);
    [[nodiscard]] const gpu::RenderPipeline& pipelineFor(int filter, unsigned flags);
    [[nodiscard]] bool targetEncodes() const;
    /// The texture of a CPU picture, uploaded when it is another one than last time.
    struct Upload {
        std::shared_ptr<const CanvasPicture> picture;
        gpu::Texture texture;
    };
    [[nodiscard]] const gpu::Texture& upload(Upload& slot, const std::shared_ptr<const CanvasPicture>& picture);
    /// A frame that could not be recorded still has to be presentable.
    void clear();
    void fail(const QString& sentence);
    void drop();

    CanvasWindow& window_;
    gpu::Device device_;
    QString deviceName_;
    gpu::ShaderModule vertex_;
    gpu::ShaderModule fragment_;
    gpu::PipelineLayout layout_;
    std::map<std::pair<int, unsigned>, gpu::RenderPipeline> pipelines_;
    std::unique_ptr<render::Renderer> renderer_;
    std::shared_ptr<const core::Photo> rendererPhoto_;
    render::Renderer::Progress progress_;
    QTimer poll_;                ///< runs while a slice is in work
    bool slicePending_ = false;  ///< a slice is in work on the device
    bool frameWanted_ = false;   ///< the slice changes the picture
    bool frameHeld_ = false;     ///< another frame was asked for, to be begun when no slice is in work
    bool sceneStale_ = true;
    std::uint64_t renderedScene_ = 0;  ///< CanvasState::sceneNumber of the renderer's scene
    std::uint64_t shownScene_ = 0;
    bool hasResult_ = false;
    bool failed_ = false;
    bool drawn_ = false;
    Upload original_;
    Upload layer_;
    std::shared_ptr<const core::Photo> labelsOf_;
    gpu::Texture labels_;
    std::shared_ptr<const core::Mask> maskOf_;
    gpu::Texture mask_;
    gpu::Texture noMask_;
    Ruler rulerOf_;
    gpu::Texture ruler_;  ///< empty without one
    gpu::Texture black_;
    gpu::Texture boundPicture_;
    gpu::Texture boundLabels_;
    gpu::Texture boundMask_;
    gpu::Texture boundRuler_;
    gpu::BindGroupLayout groupLayout_;
    gpu::BindGroup bindGroup_;
    gpu::Buffer probe_;
    bool probeWanted_ = false;
    bool probePending_ = false;
};

}  // namespace ui
