// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace render {

struct CompiledGlsl {
    std::vector<std::uint32_t> code;  ///< SPIR-V for Vulkan 1.1; empty when it did not compile
    std::string log;                  ///< one message a line: "ERROR: STRING:LINE: REASON"
};

/// Compiles a preprocessed compute shader. Integers must not be divided in strings (#line) below `trustedString`: some
/// software drivers let the processor trap on −2³¹ / −1. Any thread, a few tenths of a second for the largest kernels.
[[nodiscard]] CompiledGlsl compileGlsl(const std::string& text, int trustedString);

}  // namespace render
