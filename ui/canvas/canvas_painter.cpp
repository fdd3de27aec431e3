// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas_painter.h"

#include <kernels/canvas.h>
#include <kernels/fullscreen.h>

#include <QRegion>
#include <algorithm>
#include <cmath>

#include "ui/canvas/display.h"

namespace ui {

namespace {

/// Taps along one side of the largest box filter, for zooming out.
constexpr int kMaxTaps = 8;

/// Reach of the outline, and of any filter below 200 % [view pixels].
constexpr double kReach = 3;

QRectF toView(const ViewTransform& view, const QRect& r) {
    return {view.toView(r.topLeft()), view.toView(r.topLeft() + QPoint(r.width(), r.height()))};
}

/// View pixels that a part of the view influences.
QRect reachOf(const QRectF& part) { return part.adjusted(-kReach, -kReach, kReach, kReach).toAlignedRect(); }

constexpr gpu::TextureFormat kScreenFormat = gpu::TextureFormat::RGBA8Unorm;

}  // namespace

CanvasPainter::CanvasPainter(gpu::Device device) : device_(std::move(device)) {
    vertex_ = device_.createShaderModule({.label = "fullscreen.vert", .code = fullscreen_spv});
    fragment_ = device_.createShaderModule({.label = "canvas.frag", .code = canvas_spv});
    // One layout for all variants: what a variant leaves out must not change what is bound.
    groupLayout_ = device_.createBindGroupLayout({.label = "canvas",
                                                  .entries = {{.binding = CANVAS_PICTURE,
                                                               .visibility = gpu::ShaderStage::Fragment,
                                                               .type = gpu::BindingType::SampledTexture},
                                                              {.binding = CANVAS_LABELS,
                                                               .visibility = gpu::ShaderStage::Fragment,
                                                               .type = gpu::BindingType::SampledTexture},
                                                              {.binding = CANVAS_MASK,
                                                               .visibility = gpu::ShaderStage::Fragment,
                                                               .type = gpu::BindingType::SampledTexture},
                                                              {.binding = CANVAS_RULER_IMAGE,
                                                               .visibility = gpu::ShaderStage::Fragment,
                                                               .type = gpu::BindingType::SampledTexture},
                                                              {.binding = CANVAS_SELECTION_CODES,
                                                               .visibility = gpu::ShaderStage::Fragment,
                                                               .type = gpu::BindingType::SampledTexture}}});
    layout_ = device_.createPipelineLayout(
        {.label = "canvas", .bindGroupLayouts = {groupLayout_}, .immediateSize = sizeof(kernel::CanvasBlock)});
    black_ = device_.createTexture({.label = "canvas black",
                                    .size = {1, 1, 1},
                                    .format = gpu::TextureFormat::RGBA16Float,
                                    .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::CopyDst});
    noMask_ = device_.createTexture({.label = "canvas without mask",
                                     .size = {1, 1, 1},
                                     .format = gpu::TextureFormat::R32Float,
                                     .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::CopyDst});
}

void CanvasPainter::record(const gpu::CommandEncoder& encoder, const CanvasState& state, QSize size, double ratio,
                           const gpu::Texture& result, const std::optional<QRect>& changed) {
    const bool resized = resizeScreen(size);
    updateLabels(state);
    updateMask(state);
    updateSelection(state);
    updateRuler(state, ratio);
    const Source source = sourceOf(state, result);
    const bool rebound = bind(source.texture);
    const bool all = !changed || resized || rebound;
    drawn_ = {QPoint(0, 0), size};
    if (!all) drawn_ &= reachOf(toView(state.view, *changed));
    const double surround = encodeSrgb(kernel::kCanvasSurround);
    const gpu::RenderPassEncoder pass =
        encoder.beginRenderPass({.label = "canvas",
                                 .colorAttachments = {{.view = screen_.createView(),
                                                       .loadOp = all ? gpu::LoadOp::Clear : gpu::LoadOp::Load,
                                                       .clearValue = {surround, surround, surround, 1.0}}}});
    if (source.shown) drawPicture(pass, state, source.flags);
    pass.end();
}

bool CanvasPainter::resizeScreen(QSize size) {
    if (screen_ && static_cast<int>(screen_.width()) == size.width() &&
        static_cast<int>(screen_.height()) == size.height())
        return false;
    screen_ = device_.createTexture(
        {.label = "canvas screen",
         .size = {static_cast<std::uint32_t>(size.width()), static_cast<std::uint32_t>(size.height()), 1},
         .format = kScreenFormat,
         .usage = gpu::TextureUsage::RenderAttachment | gpu::TextureUsage::TextureBinding});
    return true;
}

CanvasPainter::Source CanvasPainter::sourceOf(const CanvasState& state, const gpu::Texture& result) {
    const unsigned overlay =
        (mask_ ? CANVAS_OVERLAY : 0U) | (state.brushShown && state.brushRadius > 0 ? CANVAS_BRUSH : 0U);
    if (state.photo == nullptr) return {black_, false, overlay};
    const bool asResult = state.layer == ViewLayer::Result;
    if (state.comparing || state.layer == ViewLayer::Original || (asResult && !result))
        return {upload(original_, state.original), state.original != nullptr, overlay};
    if (asResult) return {result, true, overlay};
    const auto& picture = state.layerPicture != nullptr ? state.layerPicture : state.original;
    const bool encoded = picture != nullptr && picture->displayEncoded;
    return {upload(layer_, picture), picture != nullptr, overlay | (encoded ? CANVAS_PICTURE_ENCODED : 0U)};
}

bool CanvasPainter::bind(const gpu::Texture& picture) {
    const gpu::Texture& mask = mask_ ? mask_ : noMask_;
    const gpu::Texture& ruler = ruler_ ? ruler_ : black_;
    const gpu::Texture& selection = selection_ ? selection_ : black_;
    if (bindGroup_ && picture == boundPicture_ && labels_ == boundLabels_ && mask == boundMask_ &&
        ruler == boundRuler_ && selection == boundSelection_)
        return false;
    bindGroup_ = device_.createBindGroup(
        {.label = "canvas",
         .layout = groupLayout_,
         .entries = {{.binding = CANVAS_PICTURE, .textureView = picture.createView()},
                     {.binding = CANVAS_LABELS, .textureView = labels_.createView()},
                     {.binding = CANVAS_MASK, .textureView = mask.createView()},
                     {.binding = CANVAS_RULER_IMAGE, .textureView = ruler.createView()},
                     {.binding = CANVAS_SELECTION_CODES, .textureView = selection.createView()}}});
    boundSelection_ = selection;
    boundMask_ = mask;
    boundRuler_ = ruler;
    boundPicture_ = picture;
    boundLabels_ = labels_;
    return true;
}

void CanvasPainter::drawPicture(const gpu::RenderPassEncoder& pass, const CanvasState& state, unsigned flags) {
    const double zoom = state.view.zoom();
    const int filter = zoom >= 2 ? 0 : zoom >= 1 ? 1 : std::min(static_cast<int>(std::ceil(1 / zoom)), kMaxTaps);
    const QRect whole(0, 0, state.photo->color.width(), state.photo->color.height());
    unsigned marks = 0;
    QRect marked;
    if (state.outlineShown && !state.selectedBounds.isEmpty()) {
        marked = reachOf(toView(state.view, state.selectedBounds));
        marks |= CANVAS_OUTLINE;
    }
    if (const core::PixelBox& box = state.overlay.bounds(); !box.empty()) {
        marked |= reachOf(toView(state.view, QRect(QPoint(box.x0, box.y0), QPoint(box.x1, box.y1))));
        marks |= CANVAS_SELECTION;
    }
    for (const QRect& part : QRegion(toView(state.view, whole).toAlignedRect()).subtracted(marked))
        drawPart(pass, state, part, filter, flags);
    if (!marked.isEmpty()) drawPart(pass, state, marked, filter, flags |= marks);
    drawPart(pass, state, rulerPlace(state), filter, flags | CANVAS_RULER);
}

void CanvasPainter::updateLabels(const CanvasState& state) {
    if (labels_ && labelsOf_ == state.photo) return;
    labelsOf_ = state.photo;
    const bool known = state.photo != nullptr && !state.photo->labels.empty();
    const core::LabelImage none(1, 1);
    const core::LabelImage& source = known ? state.photo->labels : none;
    labels_ = device_.createTexture(
        {.label = "canvas labels",
         .size = {static_cast<std::uint32_t>(source.width()), static_cast<std::uint32_t>(source.height()), 1},
         .format = gpu::TextureFormat::R32Uint,
         .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::CopyDst});
    const std::vector<std::uint32_t> wide(source.pixels().begin(), source.pixels().end());
    device_.queue().writeTexture(labels_, wide.data(), wide.size() * sizeof(std::uint32_t));
}

void CanvasPainter::updateMask(const CanvasState& state) {
    const std::shared_ptr<const core::Mask>& mask = state.mask;
    if (mask == maskOf_) return;
    const auto width = static_cast<std::uint32_t>(mask != nullptr ? mask->width() : 0);
    const auto height = static_cast<std::uint32_t>(mask != nullptr ? mask->height() : 0);
    const bool inPlace =
        mask != nullptr && maskOf_ != nullptr && mask_ && mask_.width() == width && mask_.height() == height;
    const auto [first, last] = inPlace ? mask->changedRows(*maskOf_) : std::make_pair(0, static_cast<int>(height));
    if (mask == nullptr) {
        mask_ = {};
    } else if (!inPlace) {
        mask_ = device_.createTexture({.label = "canvas mask",
                                       .size = {width, height, 1},
                                       .format = gpu::TextureFormat::R32Float,
                                       .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::CopyDst});
    }
    maskOf_ = mask;
    if (first >= last) return;
    std::vector<float> rows;
    rows.reserve(std::size_t{width} * static_cast<std::size_t>(last - first));
    for (int y = first; y < last; ++y)
        for (int x = 0; x < mask->width(); ++x) rows.push_back(mask->value(x, y));
    device_.queue().writeTexture({.texture = mask_, .origin = {0, static_cast<std::uint32_t>(first), 0}}, rows.data(),
                                 rows.size() * sizeof(float), {}, {width, static_cast<std::uint32_t>(last - first), 1});
}

void CanvasPainter::updateSelection(const CanvasState& state) {
    const core::Image<std::uint8_t>& codes = state.overlay.codes();
    if (codes.empty()) return;
    const auto width = static_cast<std::uint32_t>(codes.width()), height = static_cast<std::uint32_t>(codes.height());
    auto [first, last] = state.overlay.takeChangedRows();
    // Without marks the texture is not drawn, so it need not exist.
    if (!selection_ && state.overlay.bounds().empty()) return;
    if (!selection_ || selection_.width() != width || selection_.height() != height) {
        selection_ = device_.createTexture({.label = "canvas selection",
                                            .size = {width, height, 1},
                                            .format = gpu::TextureFormat::R8Unorm,
                                            .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::CopyDst});
        first = 0;
        last = codes.height();
    }
    if (first >= last) return;
    const std::size_t begin = codes.index(0, first);
    const std::size_t bytes = std::size_t{width} * static_cast<std::size_t>(last - first);
    device_.queue().writeTexture({.texture = selection_, .origin = {0, static_cast<std::uint32_t>(first), 0}},
                                 codes.data() + begin, bytes, {}, {width, static_cast<std::uint32_t>(last - first), 1});
}

void CanvasPainter::updateRuler(const CanvasState& state, double ratio) {
    ratio_ = ratio;
    const Ruler ruler = roundRuler(state.rulerMillimetres / state.view.zoom(), ratio);
    if (ruler == rulerOf_) return;
    rulerOf_ = ruler;
    ruler_ = {};
    const QImage image = rulerImage(ruler, ratio);
    if (image.isNull()) return;
    const auto width = static_cast<std::uint32_t>(image.width());
    const auto height = static_cast<std::uint32_t>(image.height());
    ruler_ = device_.createTexture({.label = "canvas ruler",
                                    .size = {width, height, 1},
                                    .format = gpu::TextureFormat::RGBA8Unorm,
                                    .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::CopyDst});
    device_.queue().writeTexture(ruler_, image.constBits(), static_cast<std::size_t>(image.sizeInBytes()));
}

QRect CanvasPainter::rulerPlace(const CanvasState& state) const {
    if (!ruler_) return {};
    const int margin = static_cast<int>(std::lround(16 * ratio_));
    const QSize view(static_cast<int>(screen_.width()), static_cast<int>(screen_.height()));
    const QPointF corner = state.view.toView(QPointF(0, state.photo->color.height()));
    const QSize size(static_cast<int>(ruler_.width()), static_cast<int>(ruler_.height()));
    const int left = std::clamp(static_cast<int>(std::ceil(corner.x())), 0, std::max(view.width() / 2, 0));
    const int bottom = std::clamp(static_cast<int>(std::floor(corner.y())), view.height() / 2, view.height());
    return {QPoint(left + margin, bottom - margin - size.height()), size};
}

const gpu::Texture& CanvasPainter::upload(Upload& slot, const std::shared_ptr<const CanvasPicture>& picture) {
    if (picture == nullptr) return black_;
    if (slot.texture && slot.picture == picture) return slot.texture;
    slot.picture = picture;
    slot.texture = device_.createTexture(
        {.label = "canvas picture",
         .size = {static_cast<std::uint32_t>(picture->width), static_cast<std::uint32_t>(picture->height), 1},
         .format = gpu::TextureFormat::RGBA16Float,
         .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::CopyDst});
    device_.queue().writeTexture(slot.texture, picture->rgba.data(), picture->rgba.size() * sizeof(std::uint16_t));
    return slot.texture;
}

const gpu::RenderPipeline& CanvasPainter::pipelineFor(int filter, unsigned flags) {
    gpu::RenderPipeline& pipeline = pipelines_[{filter, flags}];
    if (pipeline) return pipeline;
    pipeline = device_.createRenderPipeline(
        {.label = "canvas",
         .layout = layout_,
         .vertex = vertex_,
         .fragment = fragment_,
         .targets = {{.format = kScreenFormat}},
         .fragmentConstants = {{.key = std::to_string(CANVAS_FILTER), .value = static_cast<double>(filter)},
                               {.key = std::to_string(CANVAS_FLAGS), .value = static_cast<double>(flags)}}});
    return pipeline;
}

void CanvasPainter::drawPart(const gpu::RenderPassEncoder& pass, const CanvasState& state, const QRect& part,
                             int filter, unsigned flags) {
    const QRect visible = part & drawn_;
    if (visible.isEmpty()) return;
    const QPointF origin = state.view.origin();
    kernel::CanvasBlock values{};
    values.origin = kernel::vec2(static_cast<float>(origin.x()), static_cast<float>(origin.y()));
    values.step = static_cast<float>(1 / state.view.zoom());
    values.gain = std::exp2(state.exposureStops);
    values.selected = state.selected;
    values.brushRadius = state.brushRadius;
    values.brushCenter =
        kernel::vec2(static_cast<float>(state.brushCenter.x()), static_cast<float>(state.brushCenter.y()));
    const QPoint ruler = rulerPlace(state).topLeft();
    values.ruler = kernel::vec2(static_cast<float>(ruler.x()), static_cast<float>(ruler.y()));
    pass.setPipeline(pipelineFor(filter, flags));
    pass.setBindGroup(0, bindGroup_);
    pass.setImmediates(0, values);
    pass.setScissorRect(static_cast<std::uint32_t>(visible.x()), static_cast<std::uint32_t>(visible.y()),
                        static_cast<std::uint32_t>(visible.width()), static_cast<std::uint32_t>(visible.height()));
    pass.draw(3);
}

}  // namespace ui
