// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas_renderer.h"

#include <kernels/canvas.h>
#include <kernels/fullscreen.h>

#include <QVulkanDeviceFunctions>
#include <algorithm>
#include <array>
#include <cmath>

#include "gpu/adapter.h"
#include "gpu/adopt.h"
#include "gpu/error.h"
#include "ui/display.h"

namespace ui {

namespace {

/// Device time a slice of the renderer's work may take [s] (STYLE section 8).
constexpr double kSliceBudget = 0.03;

/// How often to ask for work that other threads prepare [ms].
constexpr int kWaitingInterval = 8;

/// Largest box filter when zoomed out, taps along one side.
constexpr int kMaxTaps = 8;

}  // namespace

CanvasRenderer::CanvasRenderer(CanvasWindow& window) : window_(window) {
    poll_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&poll_, &QTimer::timeout, &poll_, [this] { pollSlice(); });
}

void CanvasRenderer::initResources() {
    failed_ = false;
    try {
        device_ =
            gpu::Device::adopt({.label = "canvas",
                                .instance = window_.vulkanInstance()->vkInstance(),
                                .physicalDevice = window_.physicalDevice(),
                                .device = window_.device(),
                                .queue = window_.graphicsQueue(),
                                .queueFamilyIndex = window_.graphicsQueueFamilyIndex(),
                                .debugUtils = window_.vulkanInstance()->extensions().contains("VK_EXT_debug_utils")});
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
                                                                   .type = gpu::BindingType::SampledTexture}}});
        layout_ = device_.createPipelineLayout({.label = "canvas",
                                                .bindGroupLayouts = {groupLayout_},
                                                .pushConstantSize = sizeof(kernel::CanvasBlock),
                                                .pushConstantStages = gpu::ShaderStage::Fragment});
        black_ = device_.createTexture({.label = "canvas black",
                                        .size = {1, 1, 1},
                                        .format = gpu::TextureFormat::RGBA16Float,
                                        .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::CopyDst});
        noMask_ = device_.createTexture({.label = "canvas without mask",
                                         .size = {1, 1, 1},
                                         .format = gpu::TextureFormat::R32Float,
                                         .usage = gpu::TextureUsage::TextureBinding | gpu::TextureUsage::CopyDst});
        probe_ = device_.createBuffer({.label = "canvas probe",
                                       .size = 4 * sizeof(float),
                                       .usage = gpu::BufferUsage::MapRead | gpu::BufferUsage::CopyDst});
        sceneStale_ = true;
        deviceName_ = QString::fromStdString(device_.adapterInfo().name);
        emit window_.deviceReady(deviceName_);
    } catch (const std::exception& error) {
        fail(QString::fromUtf8(error.what()));
    }
}

void CanvasRenderer::releaseResources() { drop(); }

void CanvasRenderer::logicalDeviceLost() {
    fail(CanvasWindow::tr("The graphics device was lost and is being started again. Your edits are not affected."));
    emit window_.deviceLost();
}

void CanvasRenderer::physicalDeviceLost() {
    fail(CanvasWindow::tr("The graphics device is gone. Your edits are not affected: save, and start Patina again."));
}

void CanvasRenderer::drop() {
    poll_.stop();
    renderer_.reset();
    rendererPhoto_.reset();
    progress_ = {};
    hasResult_ = false;
    probeWanted_ = false;
    probePending_ = false;
    bindGroup_ = {};
    boundPicture_ = {};
    boundLabels_ = {};
    boundMask_ = {};
    boundRuler_ = {};
    rulerOf_ = {};
    ruler_ = {};
    mask_ = {};
    noMask_ = {};
    maskOf_.reset();
    probe_ = {};
    black_ = {};
    labels_ = {};
    labelsOf_.reset();
    original_ = {};
    layer_ = {};
    pipelines_.clear();
    layout_ = {};
    groupLayout_ = {};
    vertex_ = {};
    fragment_ = {};
    if (device_) {
        try {
            device_.destroy();
        } catch (const gpu::Error&) {
            // A lost device cannot be waited for; Qt destroys it next.
        }
    }
    device_ = {};
    slicePending_ = false;
}

void CanvasRenderer::fail(const QString& sentence) {
    failed_ = true;
    emit window_.failed(sentence);
}

void CanvasRenderer::retry() {
    if (!failed_) return;
    failed_ = false;
    renderer_.reset();
    hasResult_ = false;
    sceneStale_ = true;
}

void CanvasRenderer::startNextFrame() {
    drawn_ = false;
    attempt([this] { recordFrame(); });
    if (!drawn_) clear();
    window_.frameReady();
    emit window_.framePresented();
    attempt([this] { startSlice(); });
    if (frameHeld_ && !slicePending_) window_.requestUpdate();
}

void CanvasRenderer::attempt(const std::function<void()>& work) {
    if (failed_ || !device_) return;
    try {
        work();
    } catch (const std::exception& error) {
        fail(QString::fromUtf8(error.what()));
    }
}

void CanvasRenderer::startSlice() {
    if (slicePending_) return;
    const CanvasState& state = window_.state();
    if (state.scene != nullptr && sceneStale_) {
        if (renderer_ == nullptr) renderer_ = std::make_unique<render::Renderer>(device_);
        renderer_->setScene(*state.scene, state.analysis);
        renderedScene_ = state.sceneNumber;
        sceneStale_ = false;
    }
    if (renderer_ == nullptr || state.paused) return;
    gpu::CommandEncoder encoder = device_.createCommandEncoder({.label = "slice"});
    frameWanted_ = renderer_->record(encoder, kSliceBudget);
    encoder.onCompleted([this] { slicePending_ = false; });
    device_.queue().submit(encoder.finish());
    slicePending_ = true;
    hasResult_ = static_cast<bool>(renderer_->result());
    progress_ = renderer_->progress();
    emit window_.progressChanged();
    poll_.start(progress_.waiting ? kWaitingInterval : 1);
}

void CanvasRenderer::pollSlice() {
    attempt([this] { device_.tick(); });
    if (slicePending_ && !failed_) return;
    poll_.stop();
    if (progress_.waiting && !frameHeld_)
        attempt([this] { startSlice(); });
    else if ((frameWanted_ || frameHeld_) && window_.isExposed())
        window_.requestUpdate();
    frameHeld_ = false;
}

bool CanvasRenderer::holdFrame() {
    frameHeld_ = frameHeld_ || slicePending_;
    return slicePending_;
}

void CanvasRenderer::clear() {
    const QSize size = window_.swapChainImageSize();
    const std::array<VkClearValue, 2> values{};
    VkRenderPassBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
    begin.renderPass = window_.defaultRenderPass();
    begin.framebuffer = window_.currentFramebuffer();
    begin.renderArea.extent = {static_cast<std::uint32_t>(size.width()), static_cast<std::uint32_t>(size.height())};
    begin.clearValueCount = values.size();
    begin.pClearValues = values.data();
    QVulkanDeviceFunctions& vulkan = *window_.vulkanInstance()->deviceFunctions(window_.device());
    vulkan.vkCmdBeginRenderPass(window_.currentCommandBuffer(), &begin, VK_SUBPASS_CONTENTS_INLINE);
    vulkan.vkCmdEndRenderPass(window_.currentCommandBuffer());
}

void CanvasRenderer::recordFrame() {
    const CanvasState& state = window_.state();
    const gpu::CommandEncoder encoder =
        device_.beginAdoptedFrame(window_.currentCommandBuffer(), static_cast<std::uint32_t>(window_.currentFrame()));
    if (state.photo != rendererPhoto_) {
        // Another photograph: nothing of the old picture may be shown.
        renderer_.reset();
        rendererPhoto_ = state.photo;
        hasResult_ = false;
        progress_ = {};
        sceneStale_ = true;
    }
    updateLabels();
    updateMask();
    updateRuler();
    recordProbe(encoder);
    draw(encoder);
    if (hasResult_ && !progress_.waiting) shownScene_ = renderedScene_;
    encoder.finish();
    if (probePending_ && probe_.mapState() == gpu::BufferMapState::Unmapped) {
        const QPoint cursor = state.cursor;
        probe_.mapAsync(gpu::MapMode::Read, 0, gpu::kWholeSize,
                        [this, cursor](gpu::MapAsyncStatus status, std::string_view) {
                            if (status == gpu::MapAsyncStatus::Success) finishProbe(cursor.x(), cursor.y());
                            probePending_ = false;
                        });
    }
    frameHeld_ = probePending_ || probeWanted_;
}

void CanvasRenderer::updateLabels() {
    const CanvasState& state = window_.state();
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

void CanvasRenderer::updateMask() {
    const std::shared_ptr<const core::Mask>& mask = window_.state().mask;
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

void CanvasRenderer::updateRuler() {
    const CanvasState& state = window_.state();
    const double ratio = window_.devicePixelRatio();
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

QRect CanvasRenderer::rulerPlace() const {
    if (!ruler_) return {};
    const CanvasState& state = window_.state();
    const int margin = static_cast<int>(std::lround(16 * window_.devicePixelRatio()));
    const QSize view = window_.swapChainImageSize();
    const QPointF corner = state.view.toView(QPointF(0, state.photo->color.height()));
    const QSize size(static_cast<int>(ruler_.width()), static_cast<int>(ruler_.height()));
    const int left = std::clamp(static_cast<int>(std::ceil(corner.x())), 0, std::max(view.width() / 2, 0));
    const int bottom = std::clamp(static_cast<int>(std::floor(corner.y())), view.height() / 2, view.height());
    return {QPoint(left + margin, bottom - margin - size.height()), size};
}

const gpu::Texture& CanvasRenderer::upload(Upload& slot, const std::shared_ptr<const CanvasPicture>& picture) {
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

void CanvasRenderer::probeCursor() {
    if (!hasResult_) return;
    probeWanted_ = true;
    window_.redraw();
}

void CanvasRenderer::recordProbe(const gpu::CommandEncoder& encoder) {
    const CanvasState& state = window_.state();
    if (!probeWanted_ || probePending_ || !hasResult_ || probe_.mapState() != gpu::BufferMapState::Unmapped) return;
    probeWanted_ = false;
    const gpu::Texture result = renderer_->result();
    if (!state.cursorInside || state.cursor.x() >= static_cast<int>(result.width()) ||
        state.cursor.y() >= static_cast<int>(result.height())) {
        return;
    }
    encoder.copyTextureToBuffer(
        {.texture = result,
         .origin = {static_cast<std::uint32_t>(state.cursor.x()), static_cast<std::uint32_t>(state.cursor.y()), 0}},
        {.buffer = probe_, .layout = {}}, {1, 1, 1});
    probePending_ = true;
}

void CanvasRenderer::finishProbe(int x, int y) {
    const auto* rgba = static_cast<const float*>(probe_.getConstMappedRange());
    const core::Vector3f value(rgba[0], rgba[1], rgba[2]);
    probe_.unmap();
    const CanvasState& state = window_.state();
    if (!state.cursorInside || state.cursor != QPoint(x, y)) return;
    emit window_.cursorMoved({.x = x, .y = y, .inside = true, .hasResult = true, .result = value});
}

bool CanvasRenderer::targetEncodes() const {
    const VkFormat format = window_.colorFormat();
    return format == VK_FORMAT_B8G8R8A8_SRGB || format == VK_FORMAT_R8G8B8A8_SRGB ||
           format == VK_FORMAT_A8B8G8R8_SRGB_PACK32;
}

const gpu::RenderPipeline& CanvasRenderer::pipelineFor(int filter, unsigned flags) {
    gpu::RenderPipeline& pipeline = pipelines_[{filter, flags}];
    if (pipeline) return pipeline;
    const gpu::ExternalRenderTarget target{
        .renderPass = window_.defaultRenderPass(), .sampleCount = window_.sampleCountFlagBits(), .hasDepth = true};
    pipeline = device_.createRenderPipeline(
        {.label = "canvas",
         .layout = layout_,
         .vertex = vertex_,
         .fragment = fragment_,
         .targets = {{}},
         .externalTarget = &target,
         .fragmentConstants = {{.key = std::to_string(CANVAS_FILTER), .value = static_cast<double>(filter)},
                               {.key = std::to_string(CANVAS_FLAGS), .value = static_cast<double>(flags)}}});
    return pipeline;
}

void CanvasRenderer::drawPart(const gpu::RenderPassEncoder& pass, const QRectF& part, int filter, unsigned flags) {
    const CanvasState& state = window_.state();
    const QRect visible = part.toAlignedRect() & QRect(QPoint(0, 0), window_.swapChainImageSize());
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
    const QPoint ruler = rulerPlace().topLeft();
    values.ruler = kernel::vec2(static_cast<float>(ruler.x()), static_cast<float>(ruler.y()));
    pass.setPipeline(pipelineFor(filter, flags));
    pass.setBindGroup(0, bindGroup_);
    pass.setPushConstants(values);
    pass.setScissorRect(static_cast<std::uint32_t>(visible.x()), static_cast<std::uint32_t>(visible.y()),
                        static_cast<std::uint32_t>(visible.width()), static_cast<std::uint32_t>(visible.height()));
    pass.draw(3);
}

void CanvasRenderer::draw(const gpu::CommandEncoder& encoder) {
    const CanvasState& state = window_.state();
    gpu::Texture picture = black_;
    unsigned flags = targetEncodes() ? CANVAS_TARGET_ENCODES : 0u;
    bool shown = false;
    const bool showOriginal =
        state.comparing || state.layer == ViewLayer::Original || (state.layer == ViewLayer::Result && !hasResult_);
    if (state.photo != nullptr && showOriginal) {
        picture = upload(original_, state.original);
        shown = state.original != nullptr;
    } else if (state.photo != nullptr && state.layer == ViewLayer::Result) {
        picture = renderer_->result();
        shown = true;
    } else if (state.photo != nullptr) {
        const auto& source = state.layerPicture != nullptr ? state.layerPicture : state.original;
        picture = upload(layer_, source);
        shown = source != nullptr;
        if (shown && source->displayEncoded) flags |= CANVAS_PICTURE_ENCODED;
    }
    const gpu::Texture& mask = mask_ ? mask_ : noMask_;
    if (mask_ && state.brushRadius > 0) flags |= CANVAS_OVERLAY;
    const gpu::Texture& ruler = ruler_ ? ruler_ : black_;
    if (!bindGroup_ || !(picture == boundPicture_) || !(labels_ == boundLabels_) || !(mask == boundMask_) ||
        !(ruler == boundRuler_)) {
        bindGroup_ =
            device_.createBindGroup({.label = "canvas",
                                     .layout = groupLayout_,
                                     .entries = {{.binding = CANVAS_PICTURE, .textureView = picture.createView()},
                                                 {.binding = CANVAS_LABELS, .textureView = labels_.createView()},
                                                 {.binding = CANVAS_MASK, .textureView = mask.createView()},
                                                 {.binding = CANVAS_RULER_IMAGE, .textureView = ruler.createView()}}});
        boundMask_ = mask;
        boundRuler_ = ruler;
        boundPicture_ = picture;
        boundLabels_ = labels_;
    }
    const float surround = targetEncodes() ? kernel::kCanvasSurround : encodeSrgb(kernel::kCanvasSurround);
    VkClearValue color{};
    color.color = {{surround, surround, surround, 1.0f}};
    VkClearValue depth{};
    depth.depthStencil = {1.0f, 0};
    const QSize size = window_.swapChainImageSize();
    const gpu::RenderPassEncoder pass =
        encoder.beginRenderPass(gpu::ExternalRenderPassDescriptor{.label = "canvas",
                                                                  .renderPass = window_.defaultRenderPass(),
                                                                  .framebuffer = window_.currentFramebuffer(),
                                                                  .width = static_cast<std::uint32_t>(size.width()),
                                                                  .height = static_cast<std::uint32_t>(size.height()),
                                                                  .clearValues = {color, depth}});
    if (shown) {
        const double zoom = state.view.zoom();
        const int filter = zoom >= 2 ? 0 : zoom >= 1 ? 1 : std::min(static_cast<int>(std::ceil(1 / zoom)), kMaxTaps);
        const auto toView = [&](const QRect& r) {
            return QRectF(state.view.toView(r.topLeft()),
                          state.view.toView(r.topLeft() + QPoint(r.width(), r.height())));
        };
        drawPart(pass, toView(QRect(0, 0, state.photo->color.width(), state.photo->color.height())), filter, flags);
        if (state.outlineShown && !state.selectedBounds.isEmpty()) {
            constexpr double kReach = 3;
            const QRectF around = toView(state.selectedBounds).adjusted(-kReach, -kReach, kReach, kReach);
            flags |= CANVAS_OUTLINE;
            drawPart(pass, around, filter, flags);
        }
        drawPart(pass, rulerPlace(), filter, flags | CANVAS_RULER);
    }
    pass.end();
    drawn_ = true;
}

}  // namespace ui
