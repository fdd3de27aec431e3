// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas_renderer.h"

#include <kernels/fullscreen.h>
#include <kernels/present.h>

#include <QVulkanDeviceFunctions>
#include <array>

#include "gpu/adapter.h"
#include "gpu/adopt.h"
#include "gpu/error.h"
#include "ui/canvas/display.h"
#include "ui/words.h"

namespace ui {

namespace {

/// Device time of a slice of the renderer's work [s].
constexpr double kSliceBudget = 0.03;
/// Device time of the first slice that shows a change [s]; shorter, because the user waits for it.
constexpr double kFirstSliceBudget = 0.015;

/// Interval at which work prepared by other threads is polled [ms].
constexpr int kWaitingInterval = 8;

}  // namespace

CanvasRenderer::CanvasRenderer(QVulkanWindow& window, const CanvasState& state) : window_(window), state_(state) {
    poll_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&poll_, &QTimer::timeout, &poll_, [this] { poll(); });
    start_.setSingleShot(true);
    QObject::connect(&start_, &QTimer::timeout, &start_, [this] { step(); });
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
        painter_ = std::make_unique<CanvasPainter>(device_);
        makePresentPipeline();
        probe_ = device_.createBuffer({.label = "canvas probe",
                                       .size = 4 * sizeof(float),
                                       .usage = gpu::BufferUsage::MapRead | gpu::BufferUsage::CopyDst});
        sceneStale_ = true;
        paintWanted_ = true;
        deviceName_ = QString::fromStdString(device_.adapterInfo().name);
        emit deviceReady(deviceName_);
    } catch (const std::exception& error) {
        fail(translated(error));
    }
}

void CanvasRenderer::releaseResources() { drop(); }

void CanvasRenderer::logicalDeviceLost() {
    fail(tr("The graphics device was lost and is being restarted. Your edits are safe."));
    emit deviceLost();
}

void CanvasRenderer::physicalDeviceLost() {
    fail(tr("The graphics device is gone. Your edits are safe: save them and restart Patina."));
}

void CanvasRenderer::drop() {
    poll_.stop();
    start_.stop();
    renderer_.reset();
    rendererPhoto_.reset();
    progress_ = {};
    hasResult_ = false;
    probeWanted_ = false;
    probePending_ = false;
    probe_ = {};
    painter_.reset();
    presented_ = {};
    presentGroup_ = {};
    presentPipeline_ = {};
    if (device_) {
        try {
            device_.destroy();
        } catch (const gpu::Error&) {
            // A lost device cannot be waited for; Qt destroys it next.
        }
    }
    device_ = {};
    pending_ = false;
    presenting_ = false;
}

void CanvasRenderer::fail(const QString& sentence) {
    failed_ = true;
    emit failed(sentence);
}

void CanvasRenderer::retry() {
    if (!failed_) return;
    failed_ = false;
    renderer_.reset();
    hasResult_ = false;
    sceneStale_ = true;
}

void CanvasRenderer::paint() {
    paintWanted_ = true;
    schedule();
}

void CanvasRenderer::sceneChanged() {
    sceneStale_ = true;
    schedule();
}

void CanvasRenderer::schedule() {
    if (!pending_ && !presenting_) start_.start(0);
}

void CanvasRenderer::step() {
    if (pending_ || !window_.isExposed()) return;
    start_.stop();
    attempt([this] { submitStep(); });
}

double CanvasRenderer::takeScene() {
    const bool otherPicture =
        rendererPhoto_ == nullptr || state_.photo == nullptr || !state_.photo->color.shares(rendererPhoto_->color);
    if (otherPicture && state_.photo != rendererPhoto_) {
        // The old photograph's picture must not be shown any longer.
        renderer_.reset();
        rendererPhoto_ = state_.photo;
        hasResult_ = false;
        progress_ = {};
        sceneStale_ = true;
    }
    if (state_.scene == nullptr || !sceneStale_) return kSliceBudget;
    if (renderer_ == nullptr) renderer_ = std::make_unique<render::Renderer>(device_);
    renderer_->setScene(*state_.scene, state_.analysis);
    renderedScene_ = state_.sceneNumber;
    sceneStale_ = false;
    return kFirstSliceBudget;
}

void CanvasRenderer::submitStep() {
    const double budget = takeScene();
    gpu::CommandEncoder encoder = device_.createCommandEncoder({.label = "canvas step"});
    if (renderer_ != nullptr) renderer_->setRefining(state_.refining);
    workLeft_ = renderer_ != nullptr && !state_.suspended && renderer_->record(encoder, budget);
    if (renderer_ != nullptr) {
        hasResult_ = static_cast<bool>(renderer_->result());
        progress_ = renderer_->progress();
    }
    const bool resultShown = hasResult_ && state_.layer == ViewLayer::Result && !state_.comparing;
    const core::PixelBox changed = hasResult_ ? renderer_->changed() : core::PixelBox();
    painted_ = paintWanted_ || (resultShown && !changed.empty());
    if (painted_) {
        std::optional<QRect> part;
        if (!paintWanted_) part = QRect(QPoint(changed.x0, changed.y0), QPoint(changed.x1, changed.y1));
        painter_->record(encoder, state_, frameSize(), window_.devicePixelRatio(),
                         hasResult_ ? renderer_->result() : gpu::Texture(), part);
        if (hasResult_ && !progress_.waiting) paintedScene_ = renderedScene_;
        paintWanted_ = false;
    }
    recordProbe(encoder);
    encoder.onCompleted([this] { pending_ = false; });
    device_.queue().submit(encoder.finish());
    pending_ = true;
    readProbe();
    if (renderer_ != nullptr) emit progressChanged();
    poll_.start(progress_.waiting ? kWaitingInterval : 1);
}

void CanvasRenderer::poll() {
    attempt([this] { device_.tick(); });
    if ((pending_ || probePending_) && !failed_) return;
    poll_.stop();
    if (painted_ && window_.isExposed()) {
        presenting_ = true;
        window_.requestUpdate();
    } else if (workLeft_ || sceneStale_ || paintWanted_ || probeWanted_) {
        step();
    }
}

void CanvasRenderer::startNextFrame() {
    presenting_ = false;
    drawn_ = false;
    frameWindow_ = window_.size();
    attempt([this] { recordFrame(); });
    if (!drawn_) clear();
    window_.frameReady();
    shownScene_ = paintedScene_;
    emit framePresented();
    if (workLeft_ || sceneStale_ || paintWanted_ || probeWanted_) step();
}

QSize CanvasRenderer::frameSize() const {
    if (window_.size() == frameWindow_) return window_.swapChainImageSize();
    return window_.size() * window_.devicePixelRatio();
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

bool CanvasRenderer::targetEncodes() const {
    const VkFormat format = window_.colorFormat();
    return format == VK_FORMAT_B8G8R8A8_SRGB || format == VK_FORMAT_R8G8B8A8_SRGB ||
           format == VK_FORMAT_A8B8G8R8_SRGB_PACK32;
}

void CanvasRenderer::makePresentPipeline() {
    const gpu::ExternalRenderTarget target{
        .renderPass = window_.defaultRenderPass(), .sampleCount = window_.sampleCountFlagBits(), .hasDepth = true};
    presentPipeline_ = device_.createRenderPipeline(
        {.label = "present",
         .vertex = device_.createShaderModule({.label = "fullscreen.vert", .code = fullscreen_spv}),
         .fragment = device_.createShaderModule({.label = "present.frag", .code = present_spv}),
         .targets = {{}},
         .externalTarget = &target,
         .fragmentConstants = {{.key = "kTargetEncodes", .value = targetEncodes() ? 1.0 : 0.0}}});
}

void CanvasRenderer::recordFrame() {
    const gpu::CommandEncoder encoder =
        device_.beginAdoptedFrame(window_.currentCommandBuffer(), static_cast<std::uint32_t>(window_.currentFrame()));
    const gpu::Texture& screen = painter_->screen();
    if (screen && !(screen == presented_)) {
        presentGroup_ = device_.createBindGroup({.label = "present",
                                                 .layout = presentPipeline_.getBindGroupLayout(0),
                                                 .entries = {{.binding = 0, .textureView = screen.createView()}}});
        presented_ = screen;
    }
    VkClearValue depth{};
    depth.depthStencil = {1.0f, 0};
    const QSize size = window_.swapChainImageSize();
    if (screen) {
        const gpu::RenderPassEncoder pass = encoder.beginRenderPass(
            gpu::ExternalRenderPassDescriptor{.label = "present",
                                              .renderPass = window_.defaultRenderPass(),
                                              .framebuffer = window_.currentFramebuffer(),
                                              .width = static_cast<std::uint32_t>(size.width()),
                                              .height = static_cast<std::uint32_t>(size.height()),
                                              .clearValues = {VkClearValue{}, depth}});
        pass.setPipeline(presentPipeline_);
        pass.setBindGroup(0, presentGroup_);
        pass.draw(3);
        pass.end();
        drawn_ = true;
        // The window was resized after the picture had been drawn for this frame.
        if (QSize(static_cast<int>(screen.width()), static_cast<int>(screen.height())) != size) paintWanted_ = true;
    }
    encoder.finish();
}

void CanvasRenderer::probeCursor() {
    if (!hasResult_) return;
    probeWanted_ = true;
    schedule();
}

void CanvasRenderer::recordProbe(const gpu::CommandEncoder& encoder) {
    if (!probeWanted_ || probePending_ || !hasResult_) return;
    probeWanted_ = false;
    const gpu::Texture result = renderer_->result();
    if (!state_.cursorInside || state_.cursor.x() >= static_cast<int>(result.width()) ||
        state_.cursor.y() >= static_cast<int>(result.height())) {
        return;
    }
    encoder.copyTextureToBuffer(
        {.texture = result,
         .origin = {static_cast<std::uint32_t>(state_.cursor.x()), static_cast<std::uint32_t>(state_.cursor.y()), 0}},
        {.buffer = probe_, .layout = {}}, {1, 1, 1});
    probePending_ = true;
}

void CanvasRenderer::readProbe() {
    if (!probePending_ || probe_.mapState() != gpu::BufferMapState::Unmapped) return;
    const QPoint cursor = state_.cursor;
    probe_.mapAsync(gpu::MapMode::Read, 0, gpu::kWholeSize,
                    [this, cursor](gpu::MapAsyncStatus status, std::string_view) {
                        probePending_ = false;
                        if (status == gpu::MapAsyncStatus::Success) finishProbe(cursor.x(), cursor.y());
                    });
}

core::ImageRgb CanvasRenderer::reducedResult(int side) {
    core::ImageRgb reduced;
    if (!hasResult_) return reduced;
    attempt([&] {
        const gpu::Texture result = renderer_->result();
        const std::uint32_t width = result.width(), height = result.height();
        const std::uint32_t step = std::max(1U, std::max(width, height) / static_cast<std::uint32_t>(2 * side));
        const std::uint32_t columns = std::max(1U, width / step), rows = std::max(1U, height / step);
        const std::uint64_t rowBytes = std::uint64_t{width} * 4 * sizeof(float);
        const gpu::Buffer buffer =
            device_.createBuffer({.label = "reduced result",
                                  .size = rowBytes * rows,
                                  .usage = gpu::BufferUsage::MapRead | gpu::BufferUsage::CopyDst});
        const gpu::CommandEncoder encoder = device_.createCommandEncoder({.label = "reduced result"});
        for (std::uint32_t y = 0; y < rows; ++y)
            encoder.copyTextureToBuffer(
                {.texture = result, .origin = {0, std::min(y * step + step / 2, height - 1), 0}},
                {.buffer = buffer, .layout = {.offset = rowBytes * y}}, {width, 1, 1});
        device_.queue().submit(encoder.finish());
        bool mapped = false;
        buffer.mapAsync(gpu::MapMode::Read, 0, gpu::kWholeSize, [&](gpu::MapAsyncStatus status, std::string_view) {
            mapped = status == gpu::MapAsyncStatus::Success;
        });
        device_.waitIdle();
        if (!mapped) return;
        const auto* rgba = static_cast<const float*>(buffer.getConstMappedRange());
        reduced = core::ImageRgb(static_cast<int>(columns), static_cast<int>(rows));
        for (std::uint32_t y = 0; y < rows; ++y)
            for (std::uint32_t x = 0; x < columns; ++x) {
                core::Vector3f sum(0, 0, 0);
                for (std::uint32_t u = 0; u < step; ++u) {
                    const float* texel = rgba + (std::size_t{y} * width + x * step + u) * 4;
                    sum += core::Vector3f(texel[0], texel[1], texel[2]);
                }
                reduced(static_cast<int>(x), static_cast<int>(y)) = sum / static_cast<float>(step);
            }
        buffer.unmap();
    });
    return reduced;
}

void CanvasRenderer::attempt(const std::function<void()>& work) {
    if (failed_ || !device_) return;
    try {
        work();
    } catch (const std::exception& error) {
        fail(translated(error));
    }
}

void CanvasRenderer::finishProbe(int x, int y) {
    const auto* rgba = static_cast<const float*>(probe_.getConstMappedRange());
    const core::Vector3f value(rgba[0], rgba[1], rgba[2]);
    probe_.unmap();
    if (!state_.cursorInside || state_.cursor != QPoint(x, y)) return;
    emit cursorMoved({.x = x, .y = y, .inside = true, .hasResult = true, .result = value});
}

}  // namespace ui
