// SPDX-License-Identifier: GPL-3.0-or-later
// Wrong calls are refused before Vulkan sees them, with a message that names what is wrong. Each case follows a control
// that passes.
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "kernels/test_affine.h"
#include "kernels/test_feedback.h"
#include "kernels/test_mip.h"
#include "kernels/test_sum.h"
#include "tests/support/gpu_fixture.h"

namespace {

using gpu::BufferUsage;
using gpu::TextureFormat;
using gpu::TextureUsage;
using test::context;
using test::errorOf;
using test::expectRejected;
using test::GpuTest;

class GpuValidation : public GpuTest {
  protected:
    [[nodiscard]] gpu::Buffer plainBuffer(const char* label, std::uint64_t size, BufferUsage usage) const {
        return device.createBuffer({.label = label, .size = size, .usage = usage});
    }
    [[nodiscard]] gpu::Texture plainTexture(const char* label, TextureFormat format, TextureUsage usage,
                                            std::uint32_t levels = 1) const {
        return device.createTexture(
            {.label = label, .size = {16, 16}, .format = format, .usage = usage, .mipLevelCount = levels});
    }
};

TEST_F(GpuValidation, Buffers) {
    EXPECT_NO_THROW((void)plainBuffer("fine", 16, BufferUsage::MapRead | BufferUsage::CopyDst));
    expectRejected([&] { (void)plainBuffer("nothing", 0, BufferUsage::Storage); }, {"\"nothing\"", "size 0"});
    expectRejected([&] { (void)plainBuffer("useless", 16, BufferUsage::None); }, {"\"useless\"", "no usage"});
    expectRejected([&] { (void)plainBuffer("both", 16, BufferUsage::MapRead | BufferUsage::Storage); },
                   {"\"both\"", "MapRead|Storage"});
    const std::uint64_t tooLarge = device.limits().maxBufferSize + 1;
    expectRejected([&] { (void)plainBuffer("huge", tooLarge, BufferUsage::Storage); },
                   {"\"huge\"", std::to_string(tooLarge), std::to_string(device.limits().maxBufferSize)});
}

TEST_F(GpuValidation, Textures) {
    EXPECT_NO_THROW((void)plainTexture("fine", TextureFormat::RGBA8Unorm, TextureUsage::TextureBinding, 5));
    expectRejected([&] { (void)plainTexture("deep", TextureFormat::RGBA8Unorm, TextureUsage::TextureBinding, 6); },
                   {"\"deep\"", "6 levels", "1 to 5"});
    expectRejected([&] { (void)plainTexture("srgb", TextureFormat::RGBA8UnormSrgb, TextureUsage::StorageBinding); },
                   {"\"srgb\"", "rgba8unorm-srgb", "StorageBinding"});
    const std::uint32_t wide = device.limits().maxTextureDimension2D + 1;
    expectRejected(
        [&] {
            (void)device.createTexture({.label = "wide",
                                        .size = {wide, 1},
                                        .format = TextureFormat::R32Float,
                                        .usage = TextureUsage::CopyDst});
        },
        {"\"wide\"", std::to_string(wide)});
}

TEST_F(GpuValidation, BindGroups) {
    const gpu::ComputePipeline pipeline = pipelineOf("affine", test_affine_spv);
    const gpu::BindGroupLayout layout = pipeline.getBindGroupLayout(0);
    const gpu::Buffer a = plainBuffer("a", 1024, BufferUsage::Storage);
    const gpu::Buffer b = plainBuffer("b", 1024, BufferUsage::Storage);
    const gpu::Buffer params = plainBuffer("params", 16, BufferUsage::Uniform);
    const gpu::Buffer tiny = plainBuffer("tiny", 4, BufferUsage::Uniform);
    const gpu::Texture texture = plainTexture("texture", TextureFormat::R32Float, TextureUsage::TextureBinding);
    const auto make = [&](std::vector<gpu::BindGroupEntry> entries) {
        (void)device.createBindGroup({.label = "group", .layout = layout, .entries = std::move(entries)});
    };
    EXPECT_NO_THROW(make({{.binding = 0, .buffer = a}, {.binding = 1, .buffer = b}, {.binding = 2, .buffer = params}}));
    expectRejected(
        [&] {
            make({{.binding = 0, .buffer = a}, {.binding = 1, .buffer = b}});
        },
        {"\"group\"", "binding 2", "uniform buffer"});
    expectRejected(
        [&] {
            make({{.binding = 0, .buffer = a},
                  {.binding = 1, .buffer = b},
                  {.binding = 2, .buffer = params},
                  {.binding = 3, .buffer = a}});
        },
        {"binding 3", "does not have"});
    expectRejected(
        [&] {
            make({{.binding = 0, .buffer = a}, {.binding = 0, .buffer = b}, {.binding = 2, .buffer = params}});
        },
        {"binding 0 twice"});
    expectRejected(
        [&] {
            make({{.binding = 0, .textureView = texture.createView()},
                  {.binding = 1, .buffer = b},
                  {.binding = 2, .buffer = params}});
        },
        {"binding 0", "read-only storage buffer", "no buffer"});
    expectRejected(
        [&] {
            make({{.binding = 0, .buffer = a}, {.binding = 1, .buffer = b}, {.binding = 2, .buffer = a}});
        },
        {"binding 2", "\"a\"", "Uniform is needed"});
    expectRejected(
        [&] {
            make({{.binding = 0, .buffer = a}, {.binding = 1, .buffer = b}, {.binding = 2, .buffer = tiny}});
        },
        {"\"tiny\"", "4 bytes", "needs 8"});
    expectRejected(
        [&] {
            make({{.binding = 0, .buffer = a, .offset = 1},
                  {.binding = 1, .buffer = b},
                  {.binding = 2, .buffer = params}});
        },
        {"\"a\"", "offset 1", "multiple"});
    expectRejected(
        [&] {
            make({{.binding = 0, .buffer = a, .size = 2048},
                  {.binding = 1, .buffer = b},
                  {.binding = 2, .buffer = params}});
        },
        {"\"a\"", "2048", "1024"});
    expectRejected(
        [&] {
            make({{.binding = 0, .buffer = gpu::Buffer()},
                  {.binding = 1, .buffer = b},
                  {.binding = 2, .buffer = params}});
        },
        {"binding 0", "no buffer"});
    const gpu::Device other = context().adapter.requestDevice({.label = "other"});
    const gpu::Buffer foreign = other.createBuffer({.label = "foreign", .size = 64, .usage = BufferUsage::Storage});
    expectRejected(
        [&] {
            make({{.binding = 0, .buffer = foreign}, {.binding = 1, .buffer = b}, {.binding = 2, .buffer = params}});
        },
        {"\"foreign\"", "another device"});
}

TEST_F(GpuValidation, BindingsOverTheRangeLimit) {
    const std::uint64_t limit = device.limits().maxUniformBufferBindingSize;
    const gpu::ComputePipeline pipeline = pipelineOf("affine", test_affine_spv);
    const gpu::Buffer a = plainBuffer("a", 64, BufferUsage::Storage);
    const gpu::Buffer b = plainBuffer("b", 64, BufferUsage::Storage);
    const gpu::Buffer large = plainBuffer("large", limit + 16, BufferUsage::Uniform);
    const auto make = [&](std::uint64_t size) {
        (void)device.createBindGroup({.label = "group",
                                      .layout = pipeline.getBindGroupLayout(0),
                                      .entries = {{.binding = 0, .buffer = a},
                                                  {.binding = 1, .buffer = b},
                                                  {.binding = 2, .buffer = large, .size = size}}});
    };
    EXPECT_NO_THROW(make(limit));
    expectRejected([&] { make(limit + 16); }, {"\"large\"", std::to_string(limit)});
}

TEST_F(GpuValidation, TextureBindings) {
    const gpu::ComputePipeline mip = pipelineOf("mip", test_mip_spv);
    constexpr TextureUsage kBoth = TextureUsage::TextureBinding | TextureUsage::StorageBinding;
    const gpu::Texture above = plainTexture("above", TextureFormat::R32Float, kBoth, 5);
    const gpu::Texture other = plainTexture("other", TextureFormat::RGBA32Float, kBoth);
    const gpu::Texture ids = plainTexture("ids", TextureFormat::R32Uint, kBoth);
    const gpu::Texture unbindable = plainTexture("unbindable", TextureFormat::R32Float, TextureUsage::StorageBinding);
    const auto make = [&](const gpu::TextureView& from, const gpu::TextureView& to) {
        return device.createBindGroup(
            {.label = "mip",
             .layout = mip.getBindGroupLayout(0),
             .entries = {{.binding = 0, .textureView = from}, {.binding = 1, .textureView = to}}});
    };
    EXPECT_NO_THROW((void)make(above.mipView(0), above.mipView(1)));
    expectRejected([&] { (void)make(above.mipView(0), above.createView()); }, {"\"above\"", "5 levels"});
    expectRejected([&] { (void)make(above.mipView(0), other.createView()); }, {"\"other\"", "rgba32float", "r32float"});
    expectRejected([&] { (void)make(ids.createView(), above.mipView(1)); }, {"\"ids\"", "integers"});
    expectRejected([&] { (void)make(unbindable.createView(), above.mipView(1)); },
                   {"\"unbindable\"", "TextureBinding"});
    expectRejected([&] { (void)above.mipView(5); }, {"\"above\"", "level 5"});
    const gpu::CommandEncoder encoder = device.createCommandEncoder({.label = "conflict"});
    const auto pass = encoder.beginComputePass({.label = "conflict"});
    pass.setPipeline(mip);
    pass.setBindGroup(0, make(above.mipView(0), above.mipView(1)));
    EXPECT_NO_THROW(pass.dispatchWorkgroups(1));
    pass.setBindGroup(0, make(above.mipView(1), above.mipView(1)));
    expectRejected([&] { pass.dispatchWorkgroups(1); }, {"\"above\"", "read and written", "\"mip\""});
}

TEST_F(GpuValidation, Passes) {
    const gpu::ComputePipeline sum = pipelineOf("sum", test_sum_spv);
    const gpu::ComputePipeline feedback = pipelineOf("feedback", test_feedback_spv);
    const gpu::Buffer values = plainBuffer("values", 64, BufferUsage::Storage);
    const gpu::Buffer sums = plainBuffer("sums", 64, BufferUsage::Storage);
    const gpu::BindGroup group =
        device.createBindGroup({.label = "sum group",
                                .layout = sum.getBindGroupLayout(0),
                                .entries = {{.binding = 0, .buffer = values}, {.binding = 1, .buffer = sums}}});
    const gpu::CommandEncoder encoder = device.createCommandEncoder({.label = "encoder"});
    const auto pass = encoder.beginComputePass({.label = "pass"});
    expectRejected([&] { pass.dispatchWorkgroups(1); }, {"\"pass\"", "without a pipeline"});
    pass.setPipeline(sum);
    expectRejected([&] { pass.dispatchWorkgroups(1); }, {"\"sum\"", "bind group at 0"});
    pass.setBindGroup(0, group);
    expectRejected([&] { pass.dispatchWorkgroups(1); }, {"\"sum\"", "4 bytes of immediates", "byte 0 is not set"});
    expectRejected([&] { pass.setImmediates(0, std::uint16_t{1}); }, {"\"pass\"", "2 bytes", "multiples of 4"});
    expectRejected([&] { pass.setImmediates(2, std::uint32_t{1}); }, {"\"pass\"", "at byte 2", "multiples of 4"});
    const std::array<std::uint32_t, 20> words = {};
    expectRejected([&] { pass.setImmediates(0, words.data(), sizeof(words)); }, {"\"pass\"", "80 bytes", "64 bytes"});
    expectRejected([&] { pass.setImmediates(60, words.data(), 8); }, {"\"pass\"", "at byte 60", "64 bytes"});
    pass.setImmediates(4, std::uint32_t{16});
    expectRejected([&] { pass.dispatchWorkgroups(1); }, {"\"sum\"", "byte 0 is not set"});
    pass.setImmediates(0, std::uint32_t{16});
    EXPECT_NO_THROW(pass.dispatchWorkgroups(1));
    const std::uint32_t tooMany = device.limits().maxComputeWorkgroupsPerDimension;
    if (tooMany != ~0u) {
        expectRejected([&] { pass.dispatchWorkgroups(tooMany + 1); }, {"\"pass\"", std::to_string(tooMany)});
    }
    expectRejected([&] { pass.dispatchWorkgroupsIndirect(values, 0); }, {"\"values\"", "Indirect"});
    expectRejected([&] { encoder.clearBuffer(values); }, {"\"encoder\"", "open pass"});
    expectRejected([&] { (void)encoder.finish(); }, {"\"encoder\"", "open"});
    pass.setPipeline(feedback);
    expectRejected([&] { pass.dispatchWorkgroups(1); }, {"\"sum group\"", "\"feedback\""});
    pass.end();
    expectRejected([&] { pass.end(); }, {"\"pass\"", "ended"});
    const gpu::CommandBuffer commands = encoder.finish();
    expectRejected([&] { encoder.clearBuffer(values); }, {"\"encoder\"", "finished"});
    EXPECT_NO_THROW(device.queue().submit(commands));
    expectRejected([&] { device.queue().submit(commands); }, {"\"encoder\"", "submitted already"});
    expectRejected([&] { device.queue().submit(gpu::CommandBuffer()); }, {"command buffer", "empty"});
}

TEST_F(GpuValidation, AnAbandonedPassLeavesTheEncoderUsable) {
    const gpu::Buffer buffer = plainBuffer("buffer", 64, BufferUsage::CopyDst);
    const gpu::CommandEncoder encoder = device.createCommandEncoder({.label = "encoder"});
    { const auto pass = encoder.beginComputePass({.label = "abandoned"}); }
    EXPECT_NO_THROW(encoder.clearBuffer(buffer));
    EXPECT_NO_THROW(device.queue().submit(encoder.finish()));
}

TEST_F(GpuValidation, Copies) {
    const gpu::Buffer from = plainBuffer("from", 64, BufferUsage::CopySrc);
    const gpu::Buffer to = plainBuffer("to", 64, BufferUsage::CopyDst);
    const gpu::Texture texture =
        plainTexture("texture", TextureFormat::R32Float, TextureUsage::CopyDst | TextureUsage::CopySrc);
    const gpu::CommandEncoder encoder = device.createCommandEncoder({.label = "copies"});
    EXPECT_NO_THROW(encoder.copyBufferToBuffer(from, 0, to, 32, 32));
    expectRejected([&] { encoder.copyBufferToBuffer(from, 0, to, 33, 32); }, {"\"to\"", "32 bytes at byte 33", "64"});
    expectRejected([&] { encoder.copyBufferToBuffer(from, ~std::uint64_t{0}, to, 0, 32); }, {"\"from\""});
    expectRejected([&] { encoder.copyBufferToBuffer(to, 0, from, 0, 32); }, {"\"to\"", "CopySrc"});
    EXPECT_NO_THROW(encoder.copyBufferToTexture({.buffer = from}, {.texture = texture, .origin = {12, 12}}, {4, 4}));
    expectRejected(
        [&] {
            encoder.copyBufferToTexture({.buffer = from}, {.texture = texture, .origin = {13, 12}}, {4, 4});
        },
        {"\"texture\"", "16x16"});
    expectRejected(
        [&] {
            encoder.copyBufferToTexture({.buffer = from}, {.texture = texture}, {4, 5});
        },
        {"\"from\"", "80 bytes"});
    expectRejected(
        [&] {
            encoder.copyBufferToTexture({.buffer = from, .layout = {.bytesPerRow = 10}}, {.texture = texture}, {2, 2});
        },
        {"\"from\"", "10 bytes per row"});
    const std::uint32_t word = 1;
    EXPECT_NO_THROW(device.queue().writeBuffer(to, 60, &word, 4));
    expectRejected([&] { device.queue().writeBuffer(to, 61, &word, 4); }, {"\"to\"", "64"});
    expectRejected([&] { device.queue().writeTexture(texture, &word, 4); }, {"\"texture\"", "1024", "4 are given"});
    device.queue().submit(encoder.finish());
}

TEST_F(GpuValidation, PipelineConstantsAndLayouts) {
    EXPECT_NO_THROW((void)pipelineOf("affine", test_affine_spv, {{"kOffset", 3}, {"0", 32}}));
    expectRejected([&] { (void)pipelineOf("affine", test_affine_spv, {{"kNoSuch", 3}}); }, {"\"affine\"", "kNoSuch"});
    expectRejected([&] { (void)pipelineOf("affine", test_affine_spv, {{"kOffset", -1}}); }, {"kOffset", "-1"});
    expectRejected([&] { (void)pipelineOf("affine", test_affine_spv, {{"kOffset", 1.5}}); }, {"kOffset", "1.5"});
    expectRejected(
        [&] {
            (void)pipelineOf("affine", test_affine_spv, {{"0", 1e9}});
        },
        {"\"affine\"", "1000000000", "workgroups"});
    const gpu::BindGroupLayout layout = device.createBindGroupLayout(
        {.label = "short", .entries = {{.binding = 0, .type = gpu::BindingType::StorageBuffer}}});
    expectRejected(
        [&] {
            (void)device.createComputePipeline(
                {.label = "affine",
                 .layout = device.createPipelineLayout({.label = "short", .bindGroupLayouts = {layout}}),
                 .module = device.createShaderModule({.label = "affine", .code = test_affine_spv})});
        },
        {"\"affine\"", "binding 1", "\"short\""});
}

/// In a process of its own whose address space has no room left: what creating a buffer of 512 MiB says.
[[noreturn]] void createWithoutRoom(const gpu::Device& device) {
    long pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t room = static_cast<rlim_t>(pages) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (rlim_t{64} << 20);
    const rlimit limit = {room, room};
    if (setrlimit(RLIMIT_AS, &limit) != 0) _exit(3);
    try {
        (void)device.createBuffer({.label = "giant", .size = std::uint64_t{512} << 20, .usage = BufferUsage::Storage});
    } catch (const gpu::Error& error) {
        const std::string message = error.what();
        const bool named =
            message.find("\"giant\"") != std::string::npos && message.find("536870912") != std::string::npos;
        _exit(error.kind() == gpu::ErrorKind::OutOfMemory && named ? 0 : 1);
    }
    _exit(2);
}

TEST_F(GpuValidation, OutOfMemoryNamesTheBuffer) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "AddressSanitizer needs all of the address space";
#endif
    if (device.adapterInfo().type != gpu::AdapterType::CPU)
        GTEST_SKIP() << "only a software device uses our own memory";
    EXPECT_NO_THROW((void)plainBuffer("small", 1 << 20, BufferUsage::Storage));
    EXPECT_EXIT(createWithoutRoom(device), ::testing::ExitedWithCode(0), "");
}

TEST_F(GpuValidation, ErrorScopesKeepTheFirstMatchingError) {
    device.pushErrorScope(gpu::ErrorFilter::Validation);
    EXPECT_FALSE(device.popErrorScope().has_value());

    device.pushErrorScope(gpu::ErrorFilter::Validation);
    device.pushErrorScope(gpu::ErrorFilter::OutOfMemory);
    const gpu::Buffer invalid = plainBuffer("first", 0, BufferUsage::Storage);
    EXPECT_FALSE(static_cast<bool>(invalid));
    (void)plainBuffer("second", 0, BufferUsage::Storage);
    EXPECT_FALSE(device.popErrorScope().has_value()) << "the inner scope wants another kind";
    const std::optional<gpu::Error> error = device.popErrorScope();
    ASSERT_TRUE(error.has_value());
    EXPECT_NE(std::string(error->what()).find("\"first\""), std::string::npos) << error->what();
    expectRejected([&] { (void)plainBuffer("third", 0, BufferUsage::Storage); }, {"\"third\""});
    expectRejected([&] { (void)device.popErrorScope(); }, {"no open error scope"});
}

TEST_F(GpuValidation, AnErrorInAScopeInvalidatesTheEncoder) {
    const gpu::Buffer buffer = plainBuffer("buffer", 64, BufferUsage::CopyDst);
    const gpu::CommandEncoder encoder = device.createCommandEncoder({.label = "encoder"});
    device.pushErrorScope(gpu::ErrorFilter::Validation);
    encoder.clearBuffer(buffer, 0, 128);
    EXPECT_TRUE(device.popErrorScope().has_value());
    expectRejected([&] { (void)encoder.finish(); }, {"\"encoder\"", "earlier call"});
}

}  // namespace
