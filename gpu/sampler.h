// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "gpu/handle.h"
#include "gpu/types.h"

namespace gpu {

struct SamplerDescriptor {
    std::string label = {};
    AddressMode addressModeU = AddressMode::ClampToEdge;
    AddressMode addressModeV = AddressMode::ClampToEdge;
    FilterMode magFilter = FilterMode::Nearest;
    FilterMode minFilter = FilterMode::Nearest;
    FilterMode mipmapFilter = FilterMode::Nearest;
    float lodMinClamp = 0;
    float lodMaxClamp = 32;
};

/// How a shader filters a texture.
class Sampler : public Handle<detail::SamplerImpl> {
  public:
    using Handle::Handle;
    [[nodiscard]] const std::string& label() const;
};

}  // namespace gpu
