// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/handle.h"
#include "gpu/types.h"

namespace gpu {

struct ShaderModuleDescriptor {
    std::string label = {};
    std::span<const std::uint32_t> code = {};  ///< SPIR-V for Vulkan 1.1 with one entry point, "main"
};

/// A member of a block, as laid out by the shader compiler.
struct BlockMember {
    std::string name;
    std::uint32_t offset = 0;  ///< bytes
    std::uint32_t size = 0;    ///< bytes without padding; 0 for an array without a length
    friend bool operator==(const BlockMember&, const BlockMember&) = default;
};

/// A struct with explicit layout: a uniform, storage or push_constant block, or a struct inside one.
struct BlockLayout {
    std::string name;
    std::uint32_t size = 0;  ///< end of the last member [bytes]; C++ rounds up to the alignment
    std::vector<BlockMember> members;
};

/// Compiled code of one shader stage, and its reflected interface.
class ShaderModule : public Handle<detail::ShaderModuleImpl> {
  public:
    using Handle::Handle;

    [[nodiscard]] const std::string& label() const;
    [[nodiscard]] ShaderStage stage() const;
    /// Offsets of a struct's members, by the struct's type name in GLSL. Throws Error(Validation), naming the
    /// existing structs, for an unknown name or one that has two different layouts in the module.
    [[nodiscard]] BlockLayout blockLayout(std::string_view structName) const;
    /// Local size of a compute shader, before specialization.
    [[nodiscard]] std::array<std::uint32_t, 3> workgroupSize() const;
    /// Bytes of immediates (GLSL: the push_constant block) the shader declares; 0 without.
    [[nodiscard]] std::uint32_t immediateSize() const;
};

}  // namespace gpu
