// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace core {

// Ranges that files, the command line and drives accept in a material.
inline constexpr float kMaxSpecular = 100;  ///< an estimated ρ may exceed 1
inline constexpr float kMaxIndex = 20;      ///< metals at long wavelengths reach 10
inline constexpr float kMinIndex = 0.01f;   ///< silver reaches 0.05
inline constexpr float kMaxWeight = 100;

}  // namespace core
