// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/scene/scene.h"

namespace core {

/// MurmurHash3, x86, 32 bit, seed 0: the hash of the Cryptomatte specification 1.2.
[[nodiscard]] std::uint32_t murmurHash3(std::string_view bytes);

/// Bits of the float that stands for a name in a Cryptomatte: its hash, with bit 23 flipped where the exponent would
/// make an infinity, a NaN or a denormal number.
[[nodiscard]] std::uint32_t cryptomatteId(std::string_view name);

/// The segments as a Cryptomatte 1.2 EXR: channels R, G, B, A (the photograph) and CryptoObject00.{r,g,b,a} with the
/// segment's id at rank 0, coverage 1 (labels are hard), manifest of the segments' names. Throws Error(Output), and
/// Error(Usage) when `path` does not end in .exr.
void saveCryptomatte(const Scene& scene, const std::string& path);

}  // namespace core
