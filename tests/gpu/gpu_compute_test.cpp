// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels that need the encoder's barriers: each result is compared with plain C++.
#include <array>
#include <chrono>
#include <numeric>
#include <random>
#include <thread>

#include "kernels/test_affine.h"
#include "kernels/test_feedback.h"
#include "kernels/test_immediates.h"
#include "kernels/test_mip.h"
#include "kernels/test_sample.h"
#include "kernels/test_sum.h"
#include "tests/support/gpu_fixture.h"

namespace {

using gpu::BufferUsage;
using gpu::TextureUsage;
using test::context;
using test::GpuTest;

class GpuCompute : public GpuTest {};

struct AffineParams {
    std::uint32_t scale;
    std::uint32_t count;
    std::uint32_t pad[2];
};

std::vector<std::uint32_t> randomValues(std::size_t count, std::uint32_t limit) {
    std::mt19937 random(7);
    std::vector<std::uint32_t> values(count);
    for (std::uint32_t& value : values) value = static_cast<std::uint32_t>(random()) % limit;
    return values;
}

TEST_F(GpuCompute, ScatterWithAtomicsAddsUp) {
    const std::vector<std::uint32_t> values = randomValues(100'003, 1000);
    const auto count = static_cast<std::uint32_t>(values.size());
    const gpu::Buffer input = bufferOf("values", values);
    const gpu::Buffer sums =
        device.createBuffer({.label = "sums", .size = 64, .usage = BufferUsage::Storage | BufferUsage::CopySrc});
    const gpu::ComputePipeline pipeline = pipelineOf("sum", test_sum_spv);
    EXPECT_EQ(pipeline.workgroupSize(), (std::array<std::uint32_t, 3>{64, 1, 1}));
    const gpu::BindGroup group =
        device.createBindGroup({.label = "sum",
                                .layout = pipeline.getBindGroupLayout(0),
                                .entries = {{.binding = 0, .buffer = input}, {.binding = 1, .buffer = sums}}});
    run([&](const gpu::CommandEncoder& encoder) {
        const auto pass = encoder.beginComputePass({.label = "sum"});
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, group);
        pass.setImmediates(0, count);
        pass.dispatchWorkgroups((count + 63) / 64);
        pass.end();
    });
    std::vector<std::uint32_t> expected(16, 0);
    for (const std::uint32_t value : values) expected[value % 16] += value;
    EXPECT_EQ(gpu::readBuffer<std::uint32_t>(device, sums, 0, 16), expected);
}

TEST_F(GpuCompute, PingPongSeesEachDispatchBefore) {
    constexpr std::uint32_t kCount = 5000;
    std::vector<std::uint32_t> values = randomValues(kCount, 100);
    const gpu::Buffer a = bufferOf("a", values);
    const gpu::Buffer b = bufferOf("b", std::vector<std::uint32_t>(kCount, 0));
    const gpu::Buffer params = bufferOf("params", std::vector<AffineParams>{{3, kCount, {}}}, BufferUsage::Uniform);
    const gpu::ComputePipeline pipeline = pipelineOf("affine", test_affine_spv, {{"0", 128}, {"kOffset", 7}});
    EXPECT_EQ(pipeline.workgroupSize()[0], 128u);
    const auto groupOf = [&](const gpu::Buffer& from, const gpu::Buffer& to) {
        return device.createBindGroup(
            {.label = "affine",
             .layout = pipeline.getBindGroupLayout(0),
             .entries = {
                 {.binding = 0, .buffer = from}, {.binding = 1, .buffer = to}, {.binding = 2, .buffer = params}}});
    };
    const std::array groups = {groupOf(a, b), groupOf(b, a)};
    // 11 dispatches: some in one pass, some in passes of their own, some in another submission.
    int step = 0;
    const auto dispatches = [&](const gpu::CommandEncoder& encoder, int count) {
        const auto pass = encoder.beginComputePass({.label = "ping-pong"});
        pass.setPipeline(pipeline);
        for (int i = 0; i < count; ++i) {
            pass.setBindGroup(0, groups[static_cast<std::size_t>(step++ % 2)]);
            pass.dispatchWorkgroups((kCount + 127) / 128);
        }
        pass.end();
    };
    run([&](const gpu::CommandEncoder& encoder) {
        dispatches(encoder, 5);
        dispatches(encoder, 1);
    });
    run([&](const gpu::CommandEncoder& encoder) { dispatches(encoder, 5); });
    for (std::uint32_t& value : values) {
        for (int i = 0; i < step; ++i) value = value * 3 + 7;
    }
    EXPECT_EQ(gpu::readBuffer<std::uint32_t>(device, b, 0, kCount), values);
}

TEST_F(GpuCompute, EncoderWritesHoldForTheDispatchesBehindThem) {
    const gpu::Buffer source = bufferOf("source", std::vector<std::uint32_t>{1});
    const gpu::Buffer params = bufferOf("params", std::vector<AffineParams>(1), BufferUsage::Uniform);
    const gpu::Buffer history = bufferOf("history", std::vector<std::uint32_t>(3, 0));
    const gpu::Buffer target = bufferOf("target", std::vector<std::uint32_t>(1, 0));
    const gpu::ComputePipeline pipeline = pipelineOf("affine", test_affine_spv);
    const gpu::BindGroup group = device.createBindGroup(
        {.label = "affine",
         .layout = pipeline.getBindGroupLayout(0),
         .entries = {
             {.binding = 0, .buffer = source}, {.binding = 1, .buffer = target}, {.binding = 2, .buffer = params}}});
    run([&](const gpu::CommandEncoder& encoder) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const AffineParams values = {10 * (i + 1), 1, {}};
            encoder.writeBuffer(params, 0, &values, sizeof(values));
            const auto pass = encoder.beginComputePass();
            pass.setPipeline(pipeline);
            pass.setBindGroup(0, group);
            pass.dispatchWorkgroups(1);
            pass.end();
            encoder.copyBufferToBuffer(target, 0, history, 4 * i, 4);
        }
    });
    EXPECT_EQ(gpu::readBuffer<std::uint32_t>(device, history, 0, 3), (std::vector<std::uint32_t>{11, 21, 31}));
}

TEST_F(GpuCompute, MipPyramidReadsOneLevelAndWritesTheNext) {
    constexpr std::uint32_t kSize = 64;
    std::vector<float> texels(kSize * kSize);
    std::mt19937 random(3);
    for (float& texel : texels) texel = static_cast<float>(random() % 256);
    const gpu::Texture pyramid =
        device.createTexture({.label = "pyramid",
                              .size = {kSize, kSize},
                              .format = gpu::TextureFormat::R32Float,
                              .usage = TextureUsage::TextureBinding | TextureUsage::StorageBinding |
                                       TextureUsage::CopyDst | TextureUsage::CopySrc,
                              .mipLevelCount = gpu::fullMipLevelCount(kSize, kSize)});
    ASSERT_EQ(pyramid.mipLevelCount(), 7u);
    device.queue().writeTexture(pyramid, texels.data(), texels.size() * sizeof(float));
    const gpu::ComputePipeline pipeline = pipelineOf("mip", test_mip_spv);
    run([&](const gpu::CommandEncoder& encoder) {
        const auto pass = encoder.beginComputePass({.label = "pyramid"});
        pass.setPipeline(pipeline);
        for (std::uint32_t level = 1; level < pyramid.mipLevelCount(); ++level) {
            pass.setBindGroup(
                0, device.createBindGroup({.label = "level",
                                           .layout = pipeline.getBindGroupLayout(0),
                                           .entries = {{.binding = 0, .textureView = pyramid.mipView(level - 1)},
                                                       {.binding = 1, .textureView = pyramid.mipView(level)}}}));
            pass.dispatchWorkgroups(((kSize >> level) + 7) / 8, ((kSize >> level) + 7) / 8);
        }
        pass.end();
    });
    std::vector<float> expected = texels;
    for (std::uint32_t level = 1; level < pyramid.mipLevelCount(); ++level) {
        const std::size_t size = kSize >> level;
        std::vector<float> below(size * size);
        for (std::size_t y = 0; y < size; ++y) {
            for (std::size_t x = 0; x < size; ++x) {
                const float* row = expected.data() + (2 * y) * (2 * size) + 2 * x;
                below[y * size + x] = 0.25f * (row[0] + row[1] + row[2 * size] + row[2 * size + 1]);
            }
        }
        expected = below;
        const std::vector<float> actual = gpu::readTexture<float>(device, pyramid, level);
        ASSERT_EQ(actual.size(), expected.size());
        for (std::size_t i = 0; i < actual.size(); ++i) ASSERT_NEAR(actual[i], expected[i], 1e-3) << "level " << level;
    }
    EXPECT_EQ(gpu::readTexture<float>(device, pyramid), texels);
}

TEST_F(GpuCompute, StorageImageAccumulatesInPlace) {
    const gpu::Texture picture = device.createTexture({.label = "picture",
                                                       .size = {13, 9},
                                                       .format = gpu::TextureFormat::RGBA32Float,
                                                       .usage = TextureUsage::StorageBinding | TextureUsage::CopySrc});
    const gpu::ComputePipeline pipeline = pipelineOf("feedback", test_feedback_spv);
    const gpu::BindGroup group =
        device.createBindGroup({.label = "feedback",
                                .layout = pipeline.getBindGroupLayout(0),
                                .entries = {{.binding = 0, .textureView = picture.createView()}}});
    for (int submission = 0; submission < 3; ++submission) {
        run([&](const gpu::CommandEncoder& encoder) {
            const auto pass = encoder.beginComputePass();
            pass.setPipeline(pipeline);
            pass.setBindGroup(0, group);
            for (int i = 0; i < 4; ++i) pass.dispatchWorkgroups(2, 2);
            pass.end();
        });
    }
    EXPECT_EQ(gpu::readTexture<float>(device, picture), std::vector<float>(13 * 9 * 4, 12.0f));
}

TEST_F(GpuCompute, ImmediatesOfTheMaximumSizeReachTheShader) {
    struct Immediates {
        std::uint32_t index;
        std::uint32_t value;
        std::array<std::uint32_t, 14> more;
    };
    static_assert(sizeof(Immediates) == gpu::kMaxImmediateSize);
    const gpu::Buffer result = bufferOf("result", std::vector<std::uint32_t>(4, 0));
    const gpu::ComputePipeline pipeline = pipelineOf("immediates", test_immediates_spv);
    const gpu::BindGroup group = device.createBindGroup({.label = "immediates",
                                                         .layout = pipeline.getBindGroupLayout(0),
                                                         .entries = {{.binding = 0, .buffer = result}}});
    run([&](const gpu::CommandEncoder& encoder) {
        const auto pass = encoder.beginComputePass();
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, group);
        for (std::uint32_t i = 0; i < 4; ++i) {
            Immediates immediates = {i, 100 * i, {}};
            immediates.more[13] = i + 1;
            pass.setImmediates(0, immediates);
            pass.dispatchWorkgroups(1);
        }
        pass.end();
    });
    EXPECT_EQ(gpu::readBuffer<std::uint32_t>(device, result, 0, 4), (std::vector<std::uint32_t>{1, 102, 203, 304}));
}

TEST_F(GpuCompute, ImmediatesAreSetInPartsAndStaySet) {
    const gpu::Buffer result = bufferOf("result", std::vector<std::uint32_t>(4, 0));
    const gpu::ComputePipeline pipeline = pipelineOf("immediates", test_immediates_spv);
    const gpu::BindGroup group = device.createBindGroup({.label = "immediates",
                                                         .layout = pipeline.getBindGroupLayout(0),
                                                         .entries = {{.binding = 0, .buffer = result}}});
    run([&](const gpu::CommandEncoder& encoder) {
        const auto pass = encoder.beginComputePass();
        // Before any pipeline: index 0, value 100, last word 0.
        std::array<std::uint32_t, 16> block = {};
        block[1] = 100;
        pass.setImmediates(0, block);
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, group);
        for (std::uint32_t i = 0; i < 4; ++i) {
            pass.setImmediates(0, i);
            pass.setImmediates(60, 10 * i);
            pass.dispatchWorkgroups(1);
        }
        pass.end();
    });
    EXPECT_EQ(gpu::readBuffer<std::uint32_t>(device, result, 0, 4), (std::vector<std::uint32_t>{100, 110, 120, 130}));
}

TEST_F(GpuCompute, IndirectDispatchReadsCountsAnotherDispatchWrote) {
    // The affine kernel computes the counts: 2 * {1, 0, 0} + 1 = {3, 1, 1}.
    const gpu::Buffer seed = bufferOf("seed", std::vector<std::uint32_t>{1, 0, 0});
    const gpu::Buffer counts =
        bufferOf("counts", std::vector<std::uint32_t>(3, 0), BufferUsage::Storage | BufferUsage::Indirect);
    const gpu::Buffer params = bufferOf("params", std::vector<AffineParams>{{2, 3, {}}}, BufferUsage::Uniform);
    const gpu::ComputePipeline affine = pipelineOf("affine", test_affine_spv);
    const gpu::Buffer values = bufferOf("values", std::vector<std::uint32_t>(1000, 1));
    const gpu::Buffer sums = bufferOf("sums", std::vector<std::uint32_t>(16, 0));
    const gpu::ComputePipeline sum = pipelineOf("sum", test_sum_spv);
    run([&](const gpu::CommandEncoder& encoder) {
        const auto pass = encoder.beginComputePass();
        pass.setPipeline(affine);
        pass.setBindGroup(0, device.createBindGroup({.label = "affine",
                                                     .layout = affine.getBindGroupLayout(0),
                                                     .entries = {{.binding = 0, .buffer = seed},
                                                                 {.binding = 1, .buffer = counts},
                                                                 {.binding = 2, .buffer = params}}}));
        pass.dispatchWorkgroups(3);
        pass.setPipeline(sum);
        pass.setBindGroup(
            0, device.createBindGroup({.label = "sum",
                                       .layout = sum.getBindGroupLayout(0),
                                       .entries = {{.binding = 0, .buffer = values}, {.binding = 1, .buffer = sums}}}));
        pass.setImmediates(0, std::uint32_t{1000});
        pass.dispatchWorkgroupsIndirect(counts, 0);
        pass.end();
    });
    EXPECT_EQ(gpu::readBuffer<std::uint32_t>(device, counts, 0, 3), (std::vector<std::uint32_t>{3, 1, 1}));
    EXPECT_EQ(gpu::readBuffer<std::uint32_t>(device, sums, 0, 2)[1], 3u * 64u);
}

TEST_F(GpuCompute, SamplersFilterAndWrap) {
    const gpu::Texture texture = device.createTexture({.label = "two texels",
                                                       .size = {2, 1},
                                                       .format = gpu::TextureFormat::RGBA8Unorm,
                                                       .usage = TextureUsage::TextureBinding | TextureUsage::CopyDst});
    const std::array<std::uint8_t, 8> texels = {0, 0, 0, 255, 255, 255, 255, 255};
    device.queue().writeTexture(texture, texels.data(), texels.size());
    ASSERT_TRUE(device.supportsLinearFilter(gpu::TextureFormat::RGBA8Unorm));
    const gpu::Sampler clamped = device.createSampler(
        {.label = "linear", .magFilter = gpu::FilterMode::Linear, .minFilter = gpu::FilterMode::Linear});
    const gpu::Sampler repeated = device.createSampler({.label = "repeat",
                                                        .addressModeU = gpu::AddressMode::Repeat,
                                                        .magFilter = gpu::FilterMode::Linear,
                                                        .minFilter = gpu::FilterMode::Linear});
    const gpu::Buffer result = bufferOf("result", std::vector<float>(32, 0));
    const gpu::ComputePipeline pipeline = pipelineOf("sample", test_sample_spv);
    const gpu::BindGroup group =
        device.createBindGroup({.label = "sample",
                                .layout = pipeline.getBindGroupLayout(0),
                                .entries = {{.binding = 0, .textureView = texture.createView(), .sampler = clamped},
                                            {.binding = 1, .textureView = texture.createView()},
                                            {.binding = 2, .sampler = repeated},
                                            {.binding = 3, .buffer = result}}});
    run([&](const gpu::CommandEncoder& encoder) {
        const auto pass = encoder.beginComputePass();
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, group);
        pass.dispatchWorkgroups(1);
        pass.end();
    });
    // Centres of the texels are at u = 1/4 and 3/4; samples at 1/8, 3/8, 5/8, 7/8.
    const std::vector<float> values = gpu::readBuffer<float>(device, result, 0, 32);
    const std::array clampedExpected = {0.0f, 0.25f, 0.75f, 1.0f};
    const std::array repeatedExpected = {0.25f, 0.25f, 0.75f, 0.75f};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(values[4 * i], clampedExpected[i], 1.0f / 256) << i;
        EXPECT_NEAR(values[16 + 4 * i], repeatedExpected[i], 1.0f / 256) << i;
    }
}

TEST_F(GpuCompute, DynamicOffsetsPickThePartOfABuffer) {
    const std::uint32_t step =
        std::max<std::uint32_t>(sizeof(AffineParams), device.limits().minUniformBufferOffsetAlignment);
    const gpu::Buffer params = device.createBuffer(
        {.label = "params", .size = 2 * step, .usage = BufferUsage::Uniform | BufferUsage::CopyDst});
    for (std::uint32_t i = 0; i < 2; ++i) {
        const AffineParams values = {i == 0 ? 5u : 9u, 1, {}};
        device.queue().writeBuffer(params, i * step, &values, sizeof(values));
    }
    using gpu::BindingType;
    const gpu::BindGroupLayout layout = device.createBindGroupLayout(
        {.label = "dynamic",
         .entries = {
             {.binding = 0, .type = BindingType::ReadOnlyStorageBuffer},
             {.binding = 1, .type = BindingType::StorageBuffer},
             {.binding = 2, .type = BindingType::UniformBuffer, .hasDynamicOffset = true, .minBindingSize = 8}}});
    const gpu::ComputePipeline pipeline = device.createComputePipeline(
        {.label = "affine",
         .layout = device.createPipelineLayout({.label = "dynamic", .bindGroupLayouts = {layout}}),
         .module = device.createShaderModule({.label = "affine", .code = test_affine_spv})});
    const gpu::Buffer source = bufferOf("source", std::vector<std::uint32_t>{2});
    const gpu::Buffer target = bufferOf("target", std::vector<std::uint32_t>{0});
    const gpu::BindGroup group =
        device.createBindGroup({.label = "dynamic",
                                .layout = layout,
                                .entries = {{.binding = 0, .buffer = source},
                                            {.binding = 1, .buffer = target},
                                            {.binding = 2, .buffer = params, .size = sizeof(AffineParams)}}});
    for (std::uint32_t i = 0; i < 2; ++i) {
        const std::array offsets = {i * step};
        run([&](const gpu::CommandEncoder& encoder) {
            const auto pass = encoder.beginComputePass();
            pass.setPipeline(pipeline);
            pass.setBindGroup(0, group, offsets);
            pass.dispatchWorkgroups(1);
            pass.end();
        });
        EXPECT_EQ(gpu::readBuffer<std::uint32_t>(device, target, 0, 1)[0], i == 0 ? 11u : 19u);
    }
}

TEST_F(GpuCompute, PipelinesCompileInTheBackground) {
    const std::vector<std::uint32_t> values = randomValues(1000, 1000);
    const gpu::ShaderModule module = device.createShaderModule({.label = "sum", .code = test_sum_spv});
    test::expectRejected(
        [&] {
            static_cast<void>(device.createComputePipelineAsync(
                {.label = "sum", .module = module, .constants = {{.key = "no such", .value = 1}}}));
        },
        {"\"sum\"", "no such"});
    std::vector<gpu::ComputePipeline> pipelines;
    for (int i = 0; i < 8; ++i)
        pipelines.push_back(device.createComputePipelineAsync({.label = "sum", .module = module}));
    const gpu::ComputePipeline last = pipelines.back();
    pipelines.clear();
    // Used at once: recording waits for it.
    const gpu::Buffer sums =
        device.createBuffer({.label = "sums", .size = 64, .usage = BufferUsage::Storage | BufferUsage::CopySrc});
    const gpu::BindGroup group = device.createBindGroup(
        {.label = "sum",
         .layout = last.getBindGroupLayout(0),
         .entries = {{.binding = 0, .buffer = bufferOf("values", values)}, {.binding = 1, .buffer = sums}}});
    run([&](const gpu::CommandEncoder& encoder) {
        const auto pass = encoder.beginComputePass({.label = "sum"});
        pass.setPipeline(last);
        pass.setBindGroup(0, group);
        pass.setImmediates(0, static_cast<std::uint32_t>(values.size()));
        pass.dispatchWorkgroups(16);
        pass.end();
    });
    std::vector<std::uint32_t> expected(16, 0);
    for (const std::uint32_t value : values) expected[value % 16] += value;
    EXPECT_EQ(gpu::readBuffer<std::uint32_t>(device, sums, 0, 16), expected);
    for (int i = 0; i < 1000 && device.compiling(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_FALSE(device.compiling());

    // A device may be destroyed meanwhile: what has not begun is never compiled.
    const gpu::Device other = context().adapter.requestDevice({.label = "short-lived"});
    const gpu::ShaderModule its = other.createShaderModule({.label = "sum", .code = test_sum_spv});
    for (int i = 0; i < 100; ++i)
        pipelines.push_back(other.createComputePipelineAsync({.label = "sum", .module = its}));
    other.destroy();
    test::expectRejected([&] { static_cast<void>(other.createCommandEncoder()); }, {"destroyed"});
}

}  // namespace
