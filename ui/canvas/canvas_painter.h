// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "gpu/device.h"
#include "shaders/shared/canvas_block.h"
#include "ui/canvas/canvas_window.h"
#include "ui/canvas/ruler.h"

namespace ui {

/// Draws what the canvas shows, display-encoded, into a picture of the view's size: photograph, result or layer, with
/// outline, mask, brush and ruler. Made again when the device was lost.
class CanvasPainter {
  public:
    explicit CanvasPainter(gpu::Device device);

    /// Draws `state` for a view of `size` [device pixels] with `ratio` device pixels per logical one. `result` is the
    /// renderer's picture, an empty handle when there is none. `changed`: all that is different from what was drawn
    /// last is in this part of the picture.
    void record(const gpu::CommandEncoder& encoder, const CanvasState& state, QSize size, double ratio,
                const gpu::Texture& result, const std::optional<QRect>& changed = std::nullopt);
    /// What was drawn last: rgba8unorm, usage TextureBinding; an empty handle before.
    [[nodiscard]] const gpu::Texture& screen() const { return screen_; }

  private:
    void updateLabels(const CanvasState& state);
    void updateMask(const CanvasState& state);
    void updateRuler(const CanvasState& state, double ratio);
    /// Where the ruler goes in the view [device pixels]; empty without one.
    [[nodiscard]] QRect rulerPlace(const CanvasState& state) const;
    /// Draws the picture into a rectangle of the view, as far as it is to be drawn, made for exactly this filter and
    /// these CANVAS_* flags.
    void drawPart(const gpu::RenderPassEncoder& pass, const CanvasState& state, const QRect& part, int filter,
                  unsigned flags);
    [[nodiscard]] const gpu::RenderPipeline& pipelineFor(int filter, unsigned flags);
    /// The texture of a CPU picture, uploaded when it is another one than last time.
    struct Upload {
        std::shared_ptr<const CanvasPicture> picture;
        gpu::Texture texture;
    };
    [[nodiscard]] const gpu::Texture& upload(Upload& slot, const std::shared_ptr<const CanvasPicture>& picture);

    gpu::Device device_;
    gpu::ShaderModule vertex_;
    gpu::ShaderModule fragment_;
    gpu::BindGroupLayout groupLayout_;
    gpu::PipelineLayout layout_;
    std::map<std::pair<int, unsigned>, gpu::RenderPipeline> pipelines_;
    gpu::Texture screen_;
    QRect drawn_;  ///< what is to be drawn of it
    double ratio_ = 1;
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
    gpu::BindGroup bindGroup_;
};

}  // namespace ui
