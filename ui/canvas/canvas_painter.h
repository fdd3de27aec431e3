// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "gpu/device.h"
#include "shaders/shared/canvas_block.h"
#include "ui/canvas/canvas_state.h"
#include "ui/canvas/ruler.h"

namespace ui {

/// Draws what the canvas shows, display-encoded, into a picture of the view's size: photograph, result or layer, with
/// outline, mask, brush and ruler. Recreated after the device was lost.
class CanvasPainter {
  public:
    explicit CanvasPainter(gpu::Device device);

    /// Draws `state` for a view of `size` [device pixels] with `ratio` device pixels per logical one. `result` is the
    /// renderer's picture, an empty handle when there is none. `changed`: the part of the picture
    /// that contains all differences from the last call.
    void record(const gpu::CommandEncoder& encoder, const CanvasState& state, QSize size, double ratio,
                const gpu::Texture& result, const std::optional<QRect>& changed = std::nullopt);
    /// The picture drawn last: rgba8unorm, usage TextureBinding; an empty handle before the first.
    [[nodiscard]] const gpu::Texture& screen() const { return screen_; }

  private:
    /// A picture to draw and how.
    struct Source {
        gpu::Texture texture;
        bool shown = false;
        unsigned flags = 0;  ///< CANVAS_*
    };
    /// Chooses result, photograph or layer, as the state asks and as far as they are known.
    [[nodiscard]] Source sourceOf(const CanvasState& state, const gpu::Texture& result);
    /// Fits the screen to the view; returns whether it is a new one.
    bool resizeScreen(QSize size);
    /// Binds the picture with labels, mask and ruler; returns whether the bindings are new.
    bool bind(const gpu::Texture& picture);
    /// Draws the picture in the view, apart from `drawn_`'s outside: the part inside the outline with it, the ruler on
    /// top.
    void drawPicture(const gpu::RenderPassEncoder& pass, const CanvasState& state, unsigned flags);
    void updateLabels(const CanvasState& state);
    void updateMask(const CanvasState& state);
    void updateSelection(const CanvasState& state);
    void updateRuler(const CanvasState& state, double ratio);
    /// Place of the ruler in the view [device pixels]; empty without one.
    [[nodiscard]] QRect rulerPlace(const CanvasState& state) const;
    /// Draws the picture into a rectangle of the view, clipped to `drawn_`, with a pipeline specialised for the filter
    /// and the CANVAS_* flags.
    void drawPart(const gpu::RenderPassEncoder& pass, const CanvasState& state, const QRect& part, int filter,
                  unsigned flags);
    [[nodiscard]] const gpu::RenderPipeline& pipelineFor(int filter, unsigned flags);
    /// The texture of a CPU picture, uploaded when the picture differs from the last one.
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
    QRect drawn_;  ///< part of it to redraw
    double ratio_ = 1;
    Upload original_;
    Upload layer_;
    std::shared_ptr<const core::Photo> labelsOf_;
    gpu::Texture labels_;
    std::shared_ptr<const core::Mask> maskOf_;
    gpu::Texture mask_;
    gpu::Texture noMask_;
    gpu::Texture selection_;
    Ruler rulerOf_;
    gpu::Texture ruler_;  ///< empty without one
    gpu::Texture black_;
    gpu::Texture boundPicture_;
    gpu::Texture boundLabels_;
    gpu::Texture boundMask_;
    gpu::Texture boundRuler_;
    gpu::Texture boundSelection_;
    gpu::BindGroup bindGroup_;
};

}  // namespace ui
