// SPDX-License-Identifier: GPL-3.0-or-later
// A device and frames with another owner, as with QVulkanWindow, but in raw Vulkan.
#include <array>

#include "gpu/adopt.h"
#include "gpu/pass_timer.h"
#include "kernels/test_feedback.h"
#include "kernels/test_show.h"
#include "kernels/test_triangle.h"
#include "tests/support/gpu_fixture.h"

namespace {

using gpu::BufferUsage;
using gpu::TextureUsage;

/// Owns raw Vulkan objects like a window: an instance for 1.1, a device without features, two frame slots.
class Window {
  public:
    static constexpr std::uint32_t kSlots = 2;

    Window() {
        VkApplicationInfo application = {};
        application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
        application.apiVersion = VK_API_VERSION_1_1;
        const char* layer = "VK_LAYER_KHRONOS_validation";
        const std::array extensions = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
        const VkValidationFeatureEnableEXT synchronization =
            VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
        VkValidationFeaturesEXT features = {};
        features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
        features.enabledValidationFeatureCount = 1;
        features.pEnabledValidationFeatures = &synchronization;
        VkInstanceCreateInfo info = {};
        info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
        info.pApplicationInfo = &application;
        validated = gpu::validationModeFromEnvironment() != gpu::ValidationMode::Off;
        if (validated) {
            info.pNext = &features;
            info.enabledLayerCount = 1;
            info.ppEnabledLayerNames = &layer;
            info.enabledExtensionCount = extensions.size();
            info.ppEnabledExtensionNames = extensions.data();
        }
        EXPECT_EQ(vkCreateInstance(&info, nullptr, &instance), VK_SUCCESS);
        std::uint32_t count = 1;
        vkEnumeratePhysicalDevices(instance, &count, &physicalDevice);
        const float priority = 1;
        VkDeviceQueueCreateInfo queueInfo = {};
        queueInfo.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
        queueInfo.queueCount = 1;
        queueInfo.pQueuePriorities = &priority;
        VkDeviceCreateInfo deviceInfo = {};
        deviceInfo.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
        deviceInfo.queueCreateInfoCount = 1;
        deviceInfo.pQueueCreateInfos = &queueInfo;
        EXPECT_EQ(vkCreateDevice(physicalDevice, &deviceInfo, nullptr, &device), VK_SUCCESS);
        vkGetDeviceQueue(device, 0, 0, &queue);
        VkCommandPoolCreateInfo poolInfo = {};
        poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        poolInfo.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
        vkCreateCommandPool(device, &poolInfo, nullptr, &pool);
        VkCommandBufferAllocateInfo allocateInfo = {};
        allocateInfo.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        allocateInfo.commandPool = pool;
        allocateInfo.commandBufferCount = kSlots;
        vkAllocateCommandBuffers(device, &allocateInfo, commandBuffers.data());
        VkFenceCreateInfo fenceInfo = {};
        fenceInfo.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
        fenceInfo.flags = VK_FENCE_CREATE_SIGNALED_BIT;
        for (VkFence& fence : fences) vkCreateFence(device, &fenceInfo, nullptr, &fence);
    }
    ~Window() {
        vkDeviceWaitIdle(device);
        for (VkFence fence : fences) vkDestroyFence(device, fence, nullptr);
        vkDestroyCommandPool(device, pool, nullptr);
        vkDestroyDevice(device, nullptr);
        vkDestroyInstance(instance, nullptr);
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    [[nodiscard]] gpu::Device adopt() const {
        return gpu::Device::adopt({.label = "window",
                                   .instance = instance,
                                   .physicalDevice = physicalDevice,
                                   .device = device,
                                   .queue = queue,
                                   .queueFamilyIndex = 0,
                                   .debugUtils = validated});
    }
    /// One frame of a window: wait for the slot, begin, record, end, submit.
    template <class F>
    void frame(F&& record) {
        const std::uint32_t slot = next++ % kSlots;
        vkWaitForFences(device, 1, &fences[slot], VK_TRUE, ~std::uint64_t{0});
        vkResetFences(device, 1, &fences[slot]);
        VkCommandBufferBeginInfo begin = {};
        begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        vkBeginCommandBuffer(commandBuffers[slot], &begin);
        record(commandBuffers[slot], slot);
        vkEndCommandBuffer(commandBuffers[slot]);
        VkSubmitInfo submit = {};
        submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
        submit.commandBufferCount = 1;
        submit.pCommandBuffers = &commandBuffers[slot];
        EXPECT_EQ(vkQueueSubmit(queue, 1, &submit, fences[slot]), VK_SUCCESS);
    }

    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    VkCommandPool pool = VK_NULL_HANDLE;
    std::array<VkCommandBuffer, kSlots> commandBuffers = {};
    std::array<VkFence, kSlots> fences = {};
    std::uint32_t next = 0;
    bool validated = false;
};

/// Memory with all of `flags`; the caller binds and frees it.
VkDeviceMemory allocateRaw(const Window& window, const VkMemoryRequirements& requirements,
                           VkMemoryPropertyFlags flags) {
    VkPhysicalDeviceMemoryProperties properties;
    vkGetPhysicalDeviceMemoryProperties(window.physicalDevice, &properties);
    VkMemoryAllocateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = requirements.size;
    while ((requirements.memoryTypeBits & (1u << info.memoryTypeIndex)) == 0 ||
           (properties.memoryTypes[info.memoryTypeIndex].propertyFlags & flags) != flags) {
        ++info.memoryTypeIndex;
    }
    VkDeviceMemory memory = VK_NULL_HANDLE;
    EXPECT_EQ(vkAllocateMemory(window.device, &info, nullptr, &memory), VK_SUCCESS);
    return memory;
}

/// Image of a screen. The library never sees it, only its framebuffer.
class ScreenImage {
  public:
    ScreenImage(const Window& window, std::uint32_t size) : device_(window.device) {
        VkImageCreateInfo info = {};
        info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
        info.imageType = VK_IMAGE_TYPE_2D;
        info.format = VK_FORMAT_B8G8R8A8_UNORM;
        info.extent = {size, size, 1};
        info.mipLevels = info.arrayLayers = 1;
        info.samples = VK_SAMPLE_COUNT_1_BIT;
        info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
        EXPECT_EQ(vkCreateImage(device_, &info, nullptr, &image), VK_SUCCESS);
        VkMemoryRequirements requirements;
        vkGetImageMemoryRequirements(device_, image, &requirements);
        memory_ = allocateRaw(window, requirements, 0);
        vkBindImageMemory(device_, image, memory_, 0);
        VkImageViewCreateInfo viewInfo = {};
        viewInfo.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
        viewInfo.image = image;
        viewInfo.viewType = VK_IMAGE_VIEW_TYPE_2D;
        viewInfo.format = info.format;
        viewInfo.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        EXPECT_EQ(vkCreateImageView(device_, &viewInfo, nullptr, &view), VK_SUCCESS);
    }
    ~ScreenImage() {
        vkDestroyImageView(device_, view, nullptr);
        vkDestroyImage(device_, image, nullptr);
        vkFreeMemory(device_, memory_, nullptr);
    }
    ScreenImage(const ScreenImage&) = delete;
    ScreenImage& operator=(const ScreenImage&) = delete;

    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;

  private:
    VkDevice device_;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

/// Host-visible buffer for reading a screen image.
class HostBuffer {
  public:
    HostBuffer(const Window& window, VkDeviceSize size) : device_(window.device) {
        VkBufferCreateInfo info = {};
        info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
        info.size = size;
        info.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
        EXPECT_EQ(vkCreateBuffer(device_, &info, nullptr, &buffer), VK_SUCCESS);
        VkMemoryRequirements requirements;
        vkGetBufferMemoryRequirements(device_, buffer, &requirements);
        memory_ = allocateRaw(window, requirements,
                              VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
        vkBindBufferMemory(device_, buffer, memory_, 0);
    }
    ~HostBuffer() {
        vkDestroyBuffer(device_, buffer, nullptr);
        vkFreeMemory(device_, memory_, nullptr);
    }
    HostBuffer(const HostBuffer&) = delete;
    HostBuffer& operator=(const HostBuffer&) = delete;

    [[nodiscard]] const std::uint8_t* map() const {
        void* data = nullptr;
        EXPECT_EQ(vkMapMemory(device_, memory_, 0, VK_WHOLE_SIZE, 0, &data), VK_SUCCESS);
        return static_cast<const std::uint8_t*>(data);
    }

    VkBuffer buffer = VK_NULL_HANDLE;

  private:
    VkDevice device_;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

/// A framebuffer with another owner, like that of a swapchain image: bgra8unorm, cleared by its render pass.
class Screen {
  public:
    Screen(const Window& window, VkImageView view, std::uint32_t size) : device_(window.device) {
        VkAttachmentDescription attachment = {};
        attachment.format = VK_FORMAT_B8G8R8A8_UNORM;
        attachment.samples = VK_SAMPLE_COUNT_1_BIT;
        attachment.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
        attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
        attachment.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
        attachment.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
        attachment.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
        attachment.finalLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
        const VkAttachmentReference reference = {0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
        VkSubpassDescription subpass = {};
        subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
        subpass.colorAttachmentCount = 1;
        subpass.pColorAttachments = &reference;
        VkSubpassDependency after = {};
        after.srcSubpass = 0;
        after.dstSubpass = VK_SUBPASS_EXTERNAL;
        after.srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
        after.dstStageMask = VK_PIPELINE_STAGE_TRANSFER_BIT;
        after.srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
        after.dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
        VkRenderPassCreateInfo passInfo = {};
        passInfo.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
        passInfo.attachmentCount = 1;
        passInfo.pAttachments = &attachment;
        passInfo.subpassCount = 1;
        passInfo.pSubpasses = &subpass;
        passInfo.dependencyCount = 1;
        passInfo.pDependencies = &after;
        EXPECT_EQ(vkCreateRenderPass(device_, &passInfo, nullptr, &renderPass), VK_SUCCESS);
        VkFramebufferCreateInfo info = {};
        info.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
        info.renderPass = renderPass;
        info.attachmentCount = 1;
        info.pAttachments = &view;
        info.width = info.height = size;
        info.layers = 1;
        EXPECT_EQ(vkCreateFramebuffer(device_, &info, nullptr, &framebuffer), VK_SUCCESS);
    }
    ~Screen() {
        vkDestroyFramebuffer(device_, framebuffer, nullptr);
        vkDestroyRenderPass(device_, renderPass, nullptr);
    }
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    VkRenderPass renderPass = VK_NULL_HANDLE;
    VkFramebuffer framebuffer = VK_NULL_HANDLE;

  private:
    VkDevice device_;
};

TEST(GpuAdopted, FramesAccumulateAndReportWhenTheirSlotBeginsAgain) {
    Window window;
    const gpu::Device device = window.adopt();
    const gpu::Texture picture =
        device.createTexture({.label = "picture",
                              .size = {16, 16},
                              .format = gpu::TextureFormat::RGBA32Float,
                              .usage = TextureUsage::StorageBinding | TextureUsage::CopySrc | TextureUsage::CopyDst});
    const gpu::ComputePipeline pipeline = device.createComputePipeline(
        {.label = "feedback", .module = device.createShaderModule({.label = "feedback", .code = test_feedback_spv})});
    const gpu::BindGroup group =
        device.createBindGroup({.label = "feedback",
                                .layout = pipeline.getBindGroupLayout(0),
                                .entries = {{.binding = 0, .textureView = picture.createView()}}});
    const gpu::Buffer readable = device.createBuffer(
        {.label = "readable", .size = 16 * 16 * 16, .usage = BufferUsage::MapRead | BufferUsage::CopyDst});
    gpu::PassTimer timer(device, 8);
    int completed = 0;
    int mapped = 0;
    constexpr int kFrames = 6;
    for (int frame = 0; frame < kFrames; ++frame) {
        window.frame([&](VkCommandBuffer commandBuffer, std::uint32_t slot) {
            const gpu::CommandEncoder encoder = device.beginAdoptedFrame(commandBuffer, slot);
            EXPECT_EQ(completed, std::max(0, frame - 1)) << "a slot's frame is known to be done when the slot returns";
            {
                const gpu::PassTimer::Region region = timer.measure(encoder, "accumulate");
                const auto pass = encoder.beginComputePass({.label = "accumulate"});
                pass.setPipeline(pipeline);
                pass.setBindGroup(0, group);
                pass.dispatchWorkgroups(2, 2);
                pass.end();
            }
            if (frame == 3) {
                encoder.copyTextureToBuffer({.texture = picture}, {.buffer = readable}, {16, 16});
            }
            encoder.onCompleted([&] { ++completed; });
            EXPECT_FALSE(static_cast<bool>(encoder.finish()));
        });
        device.tick();
        if (frame == 3) {
            readable.mapAsync(gpu::MapMode::Read, 0, gpu::kWholeSize,
                              [&](gpu::MapAsyncStatus status, std::string_view) {
                                  EXPECT_EQ(status, gpu::MapAsyncStatus::Success);
                                  EXPECT_EQ(static_cast<const float*>(readable.getConstMappedRange())[0], 4.0f);
                                  ++mapped;
                              });
        }
        EXPECT_EQ(mapped, frame == 5 ? 1 : 0);
    }
    EXPECT_EQ(completed, kFrames - 2);
    if (timer.supported()) {
        EXPECT_EQ(timer.takeResults().size(), static_cast<std::size_t>(kFrames - 2));
    }
    // A blocking read goes through the same queue and sees every frame.
    EXPECT_EQ(gpu::readTexture<float>(device, picture)[0], static_cast<float>(kFrames));
    vkDeviceWaitIdle(window.device);
    device.destroy();
    EXPECT_EQ(completed, kFrames);
}

TEST(GpuAdopted, WritesMadeWhileAFrameIsRecordedComeBeforeIt) {
    Window window;
    const gpu::Device device = window.adopt();
    const gpu::Buffer buffer =
        device.createBuffer({.label = "buffer", .size = 4, .usage = BufferUsage::CopySrc | BufferUsage::CopyDst});
    const gpu::Buffer history =
        device.createBuffer({.label = "history", .size = 12, .usage = BufferUsage::CopySrc | BufferUsage::CopyDst});
    for (std::uint32_t frame = 0; frame < 3; ++frame) {
        window.frame([&](VkCommandBuffer commandBuffer, std::uint32_t slot) {
            const gpu::CommandEncoder encoder = device.beginAdoptedFrame(commandBuffer, slot);
            encoder.copyBufferToBuffer(buffer, 0, history, 4 * frame, 4);
            const std::uint32_t value = 10 + frame;
            device.queue().writeBuffer(buffer, 0, &value, 4);
            encoder.finish();
        });
    }
    EXPECT_EQ(gpu::readBuffer<std::uint32_t>(device, history, 0, 3), (std::vector<std::uint32_t>{10, 11, 12}));
    vkDeviceWaitIdle(window.device);
    device.destroy();
}

TEST(GpuAdopted, DrawsIntoAFramebufferOfAnotherOwner) {
    constexpr std::uint32_t kSize = 8;
    Window window;
    const gpu::Device device = window.adopt();
    const ScreenImage image(window, kSize);
    const HostBuffer buffer(window, kSize * kSize * 4);
    const Screen screen(window, image.view, kSize);
    const gpu::Texture picture = device.createTexture({.label = "picture",
                                                       .size = {kSize, kSize},
                                                       .format = gpu::TextureFormat::RGBA8Unorm,
                                                       .usage = TextureUsage::TextureBinding | TextureUsage::CopyDst});
    const std::vector<std::uint8_t> texels = [&] {
        std::vector<std::uint8_t> values;
        for (std::uint32_t i = 0; i < kSize * kSize; ++i)
            values.insert(values.end(), {static_cast<std::uint8_t>(i), 100, 200, 255});
        return values;
    }();
    device.queue().writeTexture(picture, texels.data(), texels.size());
    const gpu::ExternalRenderTarget target = {.renderPass = screen.renderPass, .hasDepth = false};
    const gpu::RenderPipeline pipeline = device.createRenderPipeline(
        {.label = "show",
         .vertex = device.createShaderModule({.label = "triangle", .code = test_triangle_spv}),
         .fragment = device.createShaderModule({.label = "show", .code = test_show_spv}),
         .targets = {{}},
         .externalTarget = &target});
    const gpu::BindGroup group =
        device.createBindGroup({.label = "show",
                                .layout = pipeline.getBindGroupLayout(0),
                                .entries = {{.binding = 0, .textureView = picture.createView()}}});
    window.frame([&](VkCommandBuffer commandBuffer, std::uint32_t slot) {
        const gpu::CommandEncoder encoder = device.beginAdoptedFrame(commandBuffer, slot);
        const auto pass = encoder.beginRenderPass(gpu::ExternalRenderPassDescriptor{.label = "show",
                                                                                    .renderPass = screen.renderPass,
                                                                                    .framebuffer = screen.framebuffer,
                                                                                    .width = kSize,
                                                                                    .height = kSize,
                                                                                    .clearValues = {VkClearValue{}}});
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, group);
        pass.setImmediates(0, 1.0f);
        pass.draw(3);
        pass.end();
        encoder.finish();
        VkBufferImageCopy region = {};
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageExtent = {kSize, kSize, 1};
        vkCmdCopyImageToBuffer(commandBuffer, image.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.buffer, 1,
                               &region);
    });
    vkDeviceWaitIdle(window.device);
    const std::uint8_t* pixels = buffer.map();
    for (std::size_t i = 0; i < kSize * kSize; ++i) {
        ASSERT_EQ(pixels[4 * i], 200) << i;
        ASSERT_EQ(pixels[4 * i + 1], 100) << i;
        ASSERT_EQ(pixels[4 * i + 2], i) << i;
    }
    device.destroy();
}

TEST(GpuAdopted, OwnDevicesHaveNoAdoptedFrames) {
    Window window;
    VkCommandBuffer commandBuffer = window.commandBuffers[0];
    test::expectRejected([&] { (void)test::context().device.beginAdoptedFrame(commandBuffer, 0); }, {"not adopted"});
    test::expectRejected([] { (void)gpu::Device::adopt({.label = "nothing"}); }, {"\"nothing\"", "null"});
}

}  // namespace
