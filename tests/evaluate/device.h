// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/adapter.h"
#include "gpu/device.h"
#include "gpu/instance.h"

namespace evaluate {

/// A device for one task. Drivers keep compiled kernels for the lifetime of a device (hundreds of MB after some
/// renderings with Mesa's software device), so a long evaluation creates a new device for every edit.
[[nodiscard]] inline gpu::Device newDevice() {
    return gpu::Instance::create().requestAdapter({}).requestDevice({.label = "evaluate"});
}

}  // namespace evaluate
