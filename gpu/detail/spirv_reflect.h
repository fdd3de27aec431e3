// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/shader_module.h"
#include "gpu/types.h"

namespace gpu::detail {

struct ReflectedBinding {
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
    BindingType type = BindingType::UniformBuffer;
    std::uint64_t minBindingSize = 0;  ///< bytes up to the last member; one element of an array without a length
    TextureFormat storageFormat = TextureFormat::Undefined;
    TextureSampleType sampleType = TextureSampleType::Any;
    std::string name;
};

enum class ConstantKind { Bool, Int, Uint, Float };

struct ReflectedConstant {
    std::uint32_t id = 0;  ///< constant_id
    std::string name;
    ConstantKind kind = ConstantKind::Float;
};

/// Interface of a SPIR-V module with one entry point.
struct Reflection {
    ShaderStage stage = ShaderStage::None;
    std::vector<ReflectedBinding> bindings;  ///< by set, then binding
    std::vector<BlockLayout> structs;        ///< every struct with member offsets
    std::uint32_t immediateSize = 0;
    std::vector<ReflectedConstant> constants;
    std::array<std::uint32_t, 3> workgroupSize = {1, 1, 1};
    std::array<std::optional<std::uint32_t>, 3> workgroupSizeConstants;  ///< constant_id of a dimension
    std::vector<std::uint32_t> capabilities;
};

/// Throws Error(Validation) naming `label` for anything else, and for features this library does not offer (arrays of
/// descriptors, images that are not two-dimensional).
[[nodiscard]] Reflection reflectSpirv(std::span<const std::uint32_t> words, const std::string& label);

}  // namespace gpu::detail
