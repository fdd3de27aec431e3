// SPDX-License-Identifier: GPL-3.0-or-later
// What the SPIR-V says about a shared block is what the C++ compiler does with it.
#include <cstddef>

#include "kernels/test_affine.h"
#include "kernels/test_block.h"
#include "kernels/test_immediates.h"
#include "tests/gpu/kernels/test_parameters.h"
#include "tests/support/gpu_fixture.h"

namespace {

using gpu::BlockMember;
using gpu::BufferUsage;
using kernel::TestBlock;
using kernel::TestInner;
using test::expectRejected;
using test::GpuTest;

class GpuBlockLayout : public GpuTest {};

TEST_F(GpuBlockLayout, OffsetsAgreeWithCpp) {
    const gpu::ShaderModule module = device.createShaderModule({.label = "block", .code = test_block_spv});
    const gpu::BlockLayout block = module.blockLayout("TestBlock");
    const std::vector<BlockMember> expected = {{"inner", offsetof(TestBlock, inner), sizeof(TestInner)},
                                               {"direction", offsetof(TestBlock, direction), 8},
                                               {"step", offsetof(TestBlock, step), 4},
                                               {"count", offsetof(TestBlock, count), 4},
                                               {"color", offsetof(TestBlock, color), 16},
                                               {"flag", offsetof(TestBlock, flag), 4},
                                               {"pad0", offsetof(TestBlock, pad0), 4},
                                               {"pad1", offsetof(TestBlock, pad1), 4},
                                               {"pad2", offsetof(TestBlock, pad2), 4}};
    EXPECT_EQ(block.members, expected);
    EXPECT_EQ(block.size, sizeof(TestBlock));
    const std::vector<BlockMember> inner = {{"first", offsetof(TestInner, first), 16},
                                            {"second", offsetof(TestInner, second), 8},
                                            {"third", offsetof(TestInner, third), 4},
                                            {"fourth", offsetof(TestInner, fourth), 4}};
    EXPECT_EQ(module.blockLayout("TestInner").members, inner);
    expectRejected([&] { (void)module.blockLayout("NoSuchBlock"); }, {"\"block\"", "NoSuchBlock", "TestBlock"});
}

TEST_F(GpuBlockLayout, ValuesArriveWhereCppPutThem) {
    TestBlock block;
    block.inner.first = {1, 2, 3, 4};
    block.inner.second = {5, 6};
    block.inner.third = 7;
    block.inner.fourth = 8;
    block.direction = {9, 10};
    block.step = 11;
    block.count = 12;
    block.color = {13, 14, 15, 16};
    block.flag = -17;
    block.pad2 = 18;
    const gpu::Buffer uniform = bufferOf("block", std::vector<TestBlock>{block}, BufferUsage::Uniform);
    const gpu::Buffer result = bufferOf("result", std::vector<float>(12, 0));
    const gpu::ComputePipeline pipeline = pipelineOf("block", test_block_spv);
    run([&](const gpu::CommandEncoder& encoder) {
        const auto pass = encoder.beginComputePass();
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, device.createBindGroup(
                                 {.label = "block",
                                  .layout = pipeline.getBindGroupLayout(0),
                                  .entries = {{.binding = 0, .buffer = uniform}, {.binding = 1, .buffer = result}}}));
        pass.dispatchWorkgroups(1);
        pass.end();
    });
    EXPECT_EQ(gpu::readBuffer<float>(device, result, 0, 12),
              (std::vector<float>{1, 4, 6, 7, 8, 9, 10, 11, 12, 15, -17, 18}));
}

TEST_F(GpuBlockLayout, DerivedLayoutsSayWhatTheShaderNeeds) {
    const auto entries = pipelineOf("affine", test_affine_spv).getBindGroupLayout(0).entries();
    ASSERT_EQ(entries.size(), 3u);
    EXPECT_EQ(entries[0].type, gpu::BindingType::ReadOnlyStorageBuffer);
    EXPECT_EQ(entries[0].minBindingSize, 4u);
    EXPECT_EQ(entries[1].type, gpu::BindingType::StorageBuffer);
    EXPECT_EQ(entries[2].type, gpu::BindingType::UniformBuffer);
    EXPECT_EQ(entries[2].minBindingSize, 8u);
    const gpu::ShaderModule immediates =
        device.createShaderModule({.label = "immediates", .code = test_immediates_spv});
    EXPECT_EQ(immediates.immediateSize(), gpu::kMaxImmediateSize);
    EXPECT_EQ(immediates.stage(), gpu::ShaderStage::Compute);
}

TEST_F(GpuBlockLayout, DamagedModulesAreRejected) {
    const std::vector<std::uint32_t> good(std::begin(test_affine_spv), std::end(test_affine_spv));
    EXPECT_NO_THROW((void)device.createShaderModule({.label = "good", .code = good}));
    const std::vector<std::uint32_t> noise(64, 0xdeadbeefu);
    expectRejected([&] { (void)device.createShaderModule({.label = "noise", .code = noise}); },
                   {"\"noise\"", "SPIR-V"});
    expectRejected([&] { (void)device.createShaderModule({.label = "empty", .code = {}}); }, {"\"empty\"", "0 words"});
    std::vector<std::uint32_t> cut(good.begin(), good.end() - 1);
    expectRejected([&] { (void)device.createShaderModule({.label = "cut", .code = cut}); }, {"\"cut\"", "damaged"});
}

}  // namespace
