// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "gpu/instance.h"
#include "gpu/readback.h"

namespace test {

/// One instance and device per process; the environment sets validation (CTest: fatal).
struct Context {
    gpu::Instance instance = gpu::Instance::create();
    gpu::Adapter adapter = instance.requestAdapter();
    gpu::Device device = adapter.requestDevice({.label = "test device"});
};

inline Context& context() {
    static Context shared;
    return shared;
}

/// A test with a device that must leave it idle and the validation layer silent.
class GpuTest : public ::testing::Test {
  protected:
    GpuTest() : device(context().device), messagesBefore_(context().instance.validationMessageCount()) {}
    void TearDown() override {
        device.waitIdle();
        EXPECT_EQ(context().instance.validationMessageCount(), messagesBefore_);
    }

    template <class T>
    gpu::Buffer bufferOf(const std::string& label, const std::vector<T>& values,
                         gpu::BufferUsage usage = gpu::BufferUsage::Storage) const {
        gpu::Buffer buffer =
            device.createBuffer({.label = label,
                                 .size = values.size() * sizeof(T),
                                 .usage = usage | gpu::BufferUsage::CopyDst | gpu::BufferUsage::CopySrc});
        device.queue().writeBuffer(buffer, 0, values);
        return buffer;
    }
    [[nodiscard]] gpu::ComputePipeline pipelineOf(const std::string& label, std::span<const std::uint32_t> code,
                                                  std::vector<gpu::ConstantEntry> constants = {}) const {
        const gpu::ShaderModule module = device.createShaderModule({.label = label, .code = code});
        return device.createComputePipeline({.label = label, .module = module, .constants = std::move(constants)});
    }
    /// Records with `record` and submits.
    void run(const std::function<void(const gpu::CommandEncoder&)>& record) const {
        const gpu::CommandEncoder encoder = device.createCommandEncoder({.label = "test"});
        record(encoder);
        device.queue().submit(encoder.finish());
    }

    gpu::Device device;

  private:
    std::uint64_t messagesBefore_;
};

/// The error a call throws; a test failure if it throws none.
inline gpu::Error errorOf(const std::function<void()>& call) {
    try {
        call();
    } catch (const gpu::Error& error) {
        return error;
    }
    ADD_FAILURE() << "no error was thrown";
    return gpu::Error(gpu::ErrorKind::Internal, "");
}

/// Expects a validation error whose message contains all of `parts`.
inline void expectRejected(const std::function<void()>& call, const std::vector<std::string>& parts) {
    const gpu::Error error = errorOf(call);
    EXPECT_EQ(error.kind(), gpu::ErrorKind::Validation) << error.what();
    for (const std::string& part : parts)
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
}

}  // namespace test
