// SPDX-License-Identifier: GPL-3.0-or-later
// Memory, mapping, copies, lifetimes, completion, time: the object model's contracts.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <thread>

#include "gpu/pass_timer.h"
#include "kernels/test_feedback.h"
#include "kernels/test_show.h"
#include "kernels/test_sum.h"
#include "kernels/test_triangle.h"
#include "tests/support/gpu_fixture.h"

namespace {

using gpu::BufferUsage;
using gpu::MapAsyncStatus;
using gpu::TextureUsage;
using test::context;
using test::GpuTest;

class GpuObjects : public GpuTest {};

std::vector<std::uint32_t> counting(std::size_t count) {
    std::vector<std::uint32_t> values(count);
    std::iota(values.begin(), values.end(), 1u);
    return values;
}

TEST_F(GpuObjects, AdapterSaysWhatItIsAndIsFoundByNameAndIndex) {
    const std::vector<gpu::Adapter> all = context().instance.adapters();
    ASSERT_FALSE(all.empty());
    EXPECT_FALSE(all[0].info().name.empty());
    EXPECT_FALSE(all[0].info().driver.empty());
    EXPECT_GE(all[0].info().apiVersionMinor + 10 * all[0].info().apiVersionMajor, 11u);
    EXPECT_GE(all[0].limits().maxTextureDimension2D, 4096u);
    EXPECT_GE(all[0].limits().maxStorageBufferBindingSize, std::uint64_t{1} << 27);
    const std::string part = all[0].info().name.substr(0, 4);
    EXPECT_EQ(context().instance.requestAdapter({.device = part}).info().name, all[0].info().name);
    EXPECT_EQ(context().instance.requestAdapter({.device = "0"}).info().name, all[0].info().name);
    const gpu::Error error =
        test::errorOf([] { (void)context().instance.requestAdapter({.device = "no such device"}); });
    EXPECT_EQ(error.kind(), gpu::ErrorKind::NoAdapter);
    EXPECT_NE(std::string(error.what()).find(all[0].info().name), std::string::npos) << error.what();
}

TEST_F(GpuObjects, ALoaderWithoutDriversIsAnErrorThatSaysSo) {
    const char* drivers = std::getenv("VK_ICD_FILENAMES");
    const std::string before = drivers != nullptr ? drivers : "";
    setenv("VK_ICD_FILENAMES", "/nonexistent/driver.json", 1);
    const gpu::Error error = test::errorOf([] { (void)gpu::Instance::create().requestAdapter(); });
    if (drivers != nullptr) {
        setenv("VK_ICD_FILENAMES", before.c_str(), 1);
    } else {
        unsetenv("VK_ICD_FILENAMES");
    }
    EXPECT_EQ(error.kind(), gpu::ErrorKind::NoAdapter) << error.what();
    EXPECT_NE(std::string(error.what()).find("driver"), std::string::npos) << error.what();
    EXPECT_NO_THROW((void)gpu::Instance::create().requestAdapter());
}

TEST_F(GpuObjects, NewBuffersAndTexturesAreZero) {
    const gpu::Buffer buffer =
        device.createBuffer({.label = "fresh", .size = 1001, .usage = BufferUsage::Storage | BufferUsage::CopySrc});
    EXPECT_EQ(gpu::readBuffer<std::uint8_t>(device, buffer, 0, 1001), std::vector<std::uint8_t>(1001, 0));
    const gpu::Texture texture = device.createTexture({.label = "fresh",
                                                       .size = {7, 5},
                                                       .format = gpu::TextureFormat::RGBA16Float,
                                                       .usage = TextureUsage::CopySrc | TextureUsage::TextureBinding,
                                                       .mipLevelCount = 3});
    for (std::uint32_t level = 0; level < 3; ++level) {
        for (const std::byte byte : gpu::readTexture(device, texture, level)) ASSERT_EQ(byte, std::byte{0});
    }
}

TEST_F(GpuObjects, WritesOfAnySizeAndPlaceArrive) {
    std::vector<std::uint8_t> expected(3'000'001, 0);
    const gpu::Buffer buffer = device.createBuffer(
        {.label = "bytes", .size = expected.size(), .usage = BufferUsage::CopyDst | BufferUsage::CopySrc});
    const auto write = [&](std::size_t offset, std::size_t size, std::uint8_t value) {
        const std::vector<std::uint8_t> data(size, value);
        device.queue().writeBuffer(buffer, offset, data);
        std::fill_n(expected.begin() + static_cast<std::ptrdiff_t>(offset), size, value);
    };
    write(0, 1, 1);
    write(3, 5, 2);
    write(1000, 2'500'000, 3);
    write(3'000'000, 1, 4);
    write(4, 2, 5);
    EXPECT_EQ(gpu::readBuffer<std::uint8_t>(device, buffer, 0, expected.size()), expected);
    EXPECT_EQ(gpu::readBuffer<std::uint8_t>(device, buffer, 999, 2), (std::vector<std::uint8_t>{0, 3}));
}

TEST_F(GpuObjects, TextureLargerThanOneStagingPieceArrivesWhole) {
    // 2100 x 1100 texels of 16 bytes are 37 MB: two pieces of at most 32 MiB.
    constexpr std::uint32_t kWidth = 2100;
    constexpr std::uint32_t kHeight = 1100;
    const gpu::Texture texture = device.createTexture({.label = "large",
                                                       .size = {kWidth, kHeight},
                                                       .format = gpu::TextureFormat::RGBA32Uint,
                                                       .usage = TextureUsage::CopyDst | TextureUsage::CopySrc});
    const std::vector<std::uint32_t> texels = counting(std::size_t{4} * kWidth * kHeight);
    device.queue().writeTexture(texture, texels.data(), texels.size() * 4);
    EXPECT_TRUE(gpu::readTexture<std::uint32_t>(device, texture) == texels);
}

TEST_F(GpuObjects, RegionsAreCopiedBetweenBuffersAndTextures) {
    const auto textureOf = [&](const char* label) {
        return device.createTexture({.label = label,
                                     .size = {4, 4},
                                     .format = gpu::TextureFormat::R32Uint,
                                     .usage = TextureUsage::CopyDst | TextureUsage::CopySrc});
    };
    const gpu::Texture a = textureOf("a");
    const gpu::Texture b = textureOf("b");
    const gpu::Buffer source = bufferOf("source", counting(32));
    const gpu::Buffer result = bufferOf("result", std::vector<std::uint32_t>(8, 0));
    run([&](const gpu::CommandEncoder& encoder) {
        // Rows of 5 words, 2x2 texels from word 1: {2, 3}, {7, 8} to (1, 2) of a; from there to (0, 0) of b.
        encoder.copyBufferToTexture({.buffer = source, .layout = {.offset = 4, .bytesPerRow = 20}},
                                    {.texture = a, .origin = {1, 2}}, {2, 2});
        encoder.copyTextureToTexture({.texture = a, .origin = {1, 2}}, {.texture = b}, {2, 2});
        encoder.copyTextureToBuffer({.texture = b}, {.buffer = result, .layout = {.bytesPerRow = 16}}, {2, 2});
        encoder.clearTexture(a);
    });
    EXPECT_EQ(gpu::readBuffer<std::uint32_t>(device, result, 0, 8),
              (std::vector<std::uint32_t>{2, 3, 0, 0, 7, 8, 0, 0}));
    EXPECT_EQ(gpu::readTexture<std::uint32_t>(device, a), std::vector<std::uint32_t>(16, 0));
}

TEST_F(GpuObjects, MappedAtCreationFillsABufferOfAnyUsage) {
    for (const BufferUsage usage :
         {BufferUsage::Storage | BufferUsage::CopySrc, BufferUsage::MapWrite | BufferUsage::CopySrc}) {
        const gpu::Buffer buffer =
            device.createBuffer({.label = "initial", .size = 16, .usage = usage, .mappedAtCreation = true});
        EXPECT_EQ(buffer.mapState(), gpu::BufferMapState::Mapped);
        const std::vector<std::uint32_t> values = counting(4);
        std::memcpy(buffer.getMappedRange(), values.data(), 16);
        buffer.unmap();
        EXPECT_EQ(gpu::readBuffer<std::uint32_t>(device, buffer, 0, 4), values);
    }
}

TEST_F(GpuObjects, MapAsyncArrivesFromTickAfterTheWork) {
    const gpu::Buffer source = bufferOf("source", counting(4));
    const gpu::Buffer readable =
        device.createBuffer({.label = "readable", .size = 16, .usage = BufferUsage::MapRead | BufferUsage::CopyDst});
    run([&](const gpu::CommandEncoder& encoder) { encoder.copyBufferToBuffer(source, 0, readable, 0, 16); });
    int calls = 0;
    readable.mapAsync(gpu::MapMode::Read, 4, 8, [&](MapAsyncStatus status, std::string_view) {
        EXPECT_EQ(status, MapAsyncStatus::Success);
        ++calls;
    });
    EXPECT_EQ(calls, 0) << "the callback never comes from mapAsync itself";
    EXPECT_EQ(readable.mapState(), gpu::BufferMapState::Pending);
    test::expectRejected([&] { (void)readable.getConstMappedRange(); }, {"\"readable\"", "not mapped"});
    while (calls == 0) {
        device.tick();
        std::this_thread::yield();
    }
    EXPECT_EQ(*static_cast<const std::uint32_t*>(readable.getConstMappedRange(4, 4)), 2u);
    test::expectRejected([&] { (void)readable.getConstMappedRange(0, 4); }, {"\"readable\""});
    test::expectRejected([&] { (void)readable.getMappedRange(4, 4); }, {"\"readable\"", "reading"});
    test::expectRejected(
        [&] {
            run([&](const gpu::CommandEncoder& encoder) { encoder.copyBufferToBuffer(source, 0, readable, 0, 16); });
        },
        {"\"readable\"", "mapped"});
    readable.unmap();
    run([&](const gpu::CommandEncoder& encoder) { encoder.copyBufferToBuffer(source, 0, readable, 0, 16); });
}

TEST_F(GpuObjects, UnmapAbortsAPendingMapping) {
    const gpu::Buffer readable =
        device.createBuffer({.label = "readable", .size = 16, .usage = BufferUsage::MapRead | BufferUsage::CopyDst});
    std::vector<MapAsyncStatus> statuses;
    const auto note = [&](MapAsyncStatus status, std::string_view) { statuses.push_back(status); };
    readable.mapAsync(gpu::MapMode::Read, 0, gpu::kWholeSize, note);
    readable.unmap();
    readable.mapAsync(gpu::MapMode::Read, 0, gpu::kWholeSize, note);
    device.waitIdle();
    EXPECT_EQ(statuses, (std::vector<MapAsyncStatus>{MapAsyncStatus::Aborted, MapAsyncStatus::Success}));
    readable.unmap();
}

TEST_F(GpuObjects, EverythingMayBeDroppedRightAfterSubmit) {
    const std::uint64_t before = device.allocatedBytes();
    const gpu::Buffer sums = bufferOf("sums", std::vector<std::uint32_t>(16, 0));
    bool completed = false;
    std::uint64_t most = 0;
    for (int round = 0; round < 20; ++round) {
        const gpu::Buffer values = bufferOf("values", std::vector<std::uint32_t>(50'000, 1));
        const gpu::ComputePipeline pipeline = pipelineOf("sum", test_sum_spv);
        const gpu::CommandEncoder encoder = device.createCommandEncoder({.label = "dropped"});
        const auto pass = encoder.beginComputePass();
        pass.setPipeline(pipeline);
        pass.setBindGroup(
            0, device.createBindGroup({.label = "sum",
                                       .layout = pipeline.getBindGroupLayout(0),
                                       .entries = {{.binding = 0, .buffer = values}, {.binding = 1, .buffer = sums}}}));
        pass.setImmediates(0, std::uint32_t{50'000});
        pass.dispatchWorkgroups(782);
        pass.end();
        encoder.onCompleted([&] { completed = true; });
        device.queue().submit(encoder.finish());
        most = std::max(most, device.allocatedBytes());
    }
    EXPECT_GT(most, before + sums.size())
        << "what is in work is kept; a device may be done with the last round already";
    device.waitIdle();
    EXPECT_TRUE(completed);
    EXPECT_EQ(gpu::readBuffer<std::uint32_t>(device, sums, 0, 2)[1], 20u * 50'000u);
    device.waitIdle();
    EXPECT_LE(device.allocatedBytes(), before + 256) << "only the sums are left";
}

TEST_F(GpuObjects, DeviceMayBeDroppedWithWorkInFlight) {
    gpu::Device other = context().adapter.requestDevice({.label = "short-lived"});
    gpu::Buffer a = other.createBuffer({.label = "a", .size = 1 << 22, .usage = BufferUsage::CopySrc});
    gpu::Buffer b = other.createBuffer({.label = "b", .size = 1 << 22, .usage = BufferUsage::CopyDst});
    const gpu::CommandEncoder encoder = other.createCommandEncoder();
    encoder.copyBufferToBuffer(a, 0, b, 0, a.size());
    other.queue().submit(encoder.finish());
    other = {};
    a = {};
    EXPECT_EQ(b.size(), 1u << 22) << "a handle keeps the device alive";
}

TEST_F(GpuObjects, DestroyKillsEveryHandleAndSaysSo) {
    int lost = 0;
    gpu::Device other = context().adapter.requestDevice(
        {.label = "doomed", .deviceLost = [&](gpu::DeviceLostReason reason, std::string_view) {
             EXPECT_EQ(reason, gpu::DeviceLostReason::Destroyed);
             ++lost;
         }});
    const gpu::Buffer buffer =
        other.createBuffer({.label = "left", .size = 16, .usage = BufferUsage::MapRead | BufferUsage::CopyDst});
    bool aborted = false;
    buffer.mapAsync(gpu::MapMode::Read, 0, 16,
                    [&](MapAsyncStatus status, std::string_view) { aborted = status == MapAsyncStatus::Error; });
    bool done = false;
    other.queue().onSubmittedWorkDone([&] { done = true; });
    other.destroy();
    EXPECT_TRUE(aborted);
    EXPECT_TRUE(done);
    EXPECT_EQ(lost, 1);
    test::expectRejected([&] { (void)other.createCommandEncoder(); }, {"\"doomed\"", "destroyed"});
    other.destroy();
    EXPECT_EQ(lost, 1);
}

TEST_F(GpuObjects, WhatIsDoneWhenTheDeviceIsDestroyedCanStillBeRead) {
    gpu::Device other = context().adapter.requestDevice({.label = "doomed"});
    const gpu::Buffer buffer =
        other.createBuffer({.label = "left", .size = 16, .usage = BufferUsage::MapRead | BufferUsage::CopyDst});
    const std::vector<std::uint32_t> values = counting(4);
    other.queue().writeBuffer(buffer, 0, values);
    std::uint32_t last = 0;
    buffer.mapAsync(gpu::MapMode::Read, 0, 16, [&](MapAsyncStatus status, std::string_view) {
        EXPECT_EQ(status, MapAsyncStatus::Success);
        last = static_cast<const std::uint32_t*>(buffer.getConstMappedRange())[3];
        buffer.unmap();
    });
    for (int i = 0; i < 50; ++i) {  // submitting notices what is done, but callbacks come from tick
        other.queue().submit(other.createCommandEncoder().finish());
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(last, 0u);
    other.destroy();
    EXPECT_EQ(last, 4u);
}

TEST_F(GpuObjects, SubmittedWorkDoneComesOnceAfterTheWork) {
    int calls = 0;
    run([](const gpu::CommandEncoder&) {});
    device.queue().onSubmittedWorkDone([&] { ++calls; });
    EXPECT_EQ(calls, 0);
    device.waitIdle();
    device.tick();
    EXPECT_EQ(calls, 1);
}

TEST_F(GpuObjects, ManyBindGroupsGrowThePools) {
    const gpu::ComputePipeline pipeline = pipelineOf("sum", test_sum_spv);
    const gpu::Buffer values = bufferOf("values", counting(4));
    std::vector<gpu::BindGroup> groups;
    for (int i = 0; i < 500; ++i) {
        groups.push_back(device.createBindGroup(
            {.label = "one of many",
             .layout = pipeline.getBindGroupLayout(0),
             .entries = {{.binding = 0, .buffer = values},
                         {.binding = 1, .buffer = bufferOf("sums", std::vector<std::uint32_t>(16, 0))}}}));
    }
    EXPECT_EQ(groups.back().label(), "one of many");
}

TEST_F(GpuObjects, TimestampsRiseAndTheTimerReports) {
    if (!device.limits().timestamps) GTEST_SKIP() << "this device has no timestamps";
    const gpu::QuerySet queries = device.createQuerySet({.label = "times", .count = 4});
    const gpu::Buffer ticks =
        device.createBuffer({.label = "ticks", .size = 32, .usage = BufferUsage::QueryResolve | BufferUsage::CopySrc});
    const gpu::Buffer large = bufferOf("large", std::vector<std::uint32_t>(1 << 20, 1));
    gpu::PassTimer timer(device, 2);
    ASSERT_TRUE(timer.supported());
    run([&](const gpu::CommandEncoder& encoder) {
        encoder.writeTimestamp(queries, 0);
        {
            const gpu::PassTimer::Region region = timer.measure(encoder, "clear");
            encoder.clearBuffer(large);
        }
        encoder.beginComputePass({.label = "empty", .timestampWrites = gpu::PassTimestampWrites{queries, 1, 2}}).end();
        encoder.writeTimestamp(queries, 3);
        encoder.resolveQuerySet(queries, 0, 4, ticks, 0);
    });
    EXPECT_TRUE(timer.takeResults().empty()) << "results come from tick";
    const std::vector<std::uint64_t> values = gpu::readBuffer<std::uint64_t>(device, ticks, 0, 4);
    EXPECT_GT(values[0], 0u);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_GE(values[i], values[i - 1]);
    const std::vector<gpu::PassTimer::Timing> results = timer.takeResults();
    ASSERT_EQ(results.size(), 1u);
    EXPECT_EQ(results[0].label, "clear");
    const double seconds = static_cast<double>(values[3] - values[0]) * device.limits().timestampPeriod * 1e-9;
    EXPECT_GT(results[0].seconds, 0);
    EXPECT_LE(results[0].seconds, seconds);
    EXPECT_EQ(timer.dropped(), 0u);
}

TEST_F(GpuObjects, TheTimerTimesEveryDispatchForItself) {
    if (!device.limits().timestamps) GTEST_SKIP() << "this device has no timestamps";
    constexpr std::uint32_t kSide = 1024;
    const gpu::ComputePipeline pipeline = pipelineOf("feedback", test_feedback_spv);
    std::vector<gpu::BindGroup> groups;  // of different pictures, so that nothing else keeps the dispatches apart
    for (int i = 0; i < 2; ++i) {
        const gpu::Texture picture =
            device.createTexture({.label = "picture",
                                  .size = {kSide, kSide},
                                  .format = gpu::TextureFormat::RGBA32Float,
                                  .usage = TextureUsage::StorageBinding | TextureUsage::CopySrc});
        groups.push_back(device.createBindGroup({.label = "feedback",
                                                 .layout = pipeline.getBindGroupLayout(0),
                                                 .entries = {{.binding = 0, .textureView = picture.createView()}}}));
    }
    gpu::PassTimer timer(device, 4);
    const auto once = [&] {
        device.waitIdle();
        const auto start = std::chrono::steady_clock::now();
        run([&](const gpu::CommandEncoder& encoder) {
            for (std::size_t i = 0; i < groups.size(); ++i) {
                const auto region = timer.measure(encoder, std::to_string(i));
                const auto pass = encoder.beginComputePass();
                pass.setPipeline(pipeline);
                pass.setBindGroup(0, groups[i]);
                pass.dispatchWorkgroups(kSide / 8, i == 0 ? kSide / 8 : 1);
                pass.end();
            }
        });
        device.waitIdle();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    (void)once();  // the first use of a kernel takes longer
    (void)timer.takeResults();
    const double wall = once();
    const std::vector<gpu::PassTimer::Timing> times = timer.takeResults();
    ASSERT_EQ(times.size(), 2u);
    EXPECT_LE(times[0].seconds, wall);
    EXPECT_GT(times[0].seconds, 0.3 * wall) << "all but a hundredth of the work";
    EXPECT_LT(times[1].seconds, 0.3 * times[0].seconds);
}

TEST_F(GpuObjects, TheTimerCountsWhatItCannotHold) {
    if (!device.limits().timestamps) GTEST_SKIP() << "this device has no timestamps";
    gpu::PassTimer timer(device, 1);
    run([&](const gpu::CommandEncoder& encoder) {
        { const auto region = timer.measure(encoder, "first"); }
        { const auto region = timer.measure(encoder, "second"); }
    });
    EXPECT_EQ(timer.dropped(), 1u);
    device.waitIdle();
    EXPECT_EQ(timer.takeResults().size(), 1u);
    run([&](const gpu::CommandEncoder& encoder) { const auto region = timer.measure(encoder, "third"); });
    device.waitIdle();
    ASSERT_EQ(timer.takeResults().size(), 1u) << "the place of the first is free again";
}

TEST_F(GpuObjects, RenderPassDrawsWhatComputeAndCopiesLeft) {
    const gpu::Texture picture = device.createTexture({.label = "picture",
                                                       .size = {8, 8},
                                                       .format = gpu::TextureFormat::RGBA32Float,
                                                       .usage = TextureUsage::TextureBinding | TextureUsage::CopyDst});
    const gpu::Texture target = device.createTexture({.label = "target",
                                                      .size = {8, 8},
                                                      .format = gpu::TextureFormat::RGBA8Unorm,
                                                      .usage = TextureUsage::RenderAttachment | TextureUsage::CopySrc});
    std::vector<float> texels(8 * 8 * 4);
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<float>(i) / 255.0f;
    device.queue().writeTexture(picture, texels.data(), texels.size() * sizeof(float));
    const gpu::RenderPipeline pipeline = device.createRenderPipeline(
        {.label = "show",
         .vertex = device.createShaderModule({.label = "triangle", .code = test_triangle_spv}),
         .fragment = device.createShaderModule({.label = "show", .code = test_show_spv}),
         .targets = {{.format = gpu::TextureFormat::RGBA8Unorm}}});
    const gpu::BindGroup group =
        device.createBindGroup({.label = "show",
                                .layout = pipeline.getBindGroupLayout(0),
                                .entries = {{.binding = 0, .textureView = picture.createView()}}});
    run([&](const gpu::CommandEncoder& encoder) {
        const auto pass = encoder.beginRenderPass(
            {.label = "show", .colorAttachments = {{.view = target.createView(), .clearValue = {1, 0, 0, 1}}}});
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, group);
        pass.setImmediates(0, 0.5f);
        pass.setScissorRect(0, 0, 8, 4);
        pass.draw(3);
        pass.end();
    });
    const std::vector<std::uint8_t> pixels = gpu::readTexture<std::uint8_t>(device, target);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const double expected =
            i < pixels.size() / 2 ? 0.5 * static_cast<double>(i) : (i % 4 == 0 || i % 4 == 3 ? 255 : 0);
        ASSERT_NEAR(pixels[i], expected, 0.51) << i;
    }
}

TEST_F(GpuObjects, TwoDevicesWorkOnTwoThreads) {
    const auto work = [] {
        const gpu::Instance instance = gpu::Instance::create();
        const gpu::Device own = instance.requestAdapter().requestDevice({.label = "of a thread"});
        const std::vector<std::uint32_t> values = counting(10'000);
        for (int round = 0; round < 20; ++round) {
            const gpu::Buffer a = own.createBuffer(
                {.label = "a", .size = values.size() * 4, .usage = BufferUsage::CopyDst | BufferUsage::CopySrc});
            own.queue().writeBuffer(a, 0, values);
            if (gpu::readBuffer<std::uint32_t>(own, a, 0, values.size()) != values) return false;
        }
        return instance.validationMessageCount() == 0;
    };
    bool first = false;
    bool second = false;
    std::thread a([&] { first = work(); });
    std::thread b([&] { second = work(); });
    a.join();
    b.join();
    EXPECT_TRUE(first);
    EXPECT_TRUE(second);
}

}  // namespace
