// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/adapter.h"
#include "gpu/device.h"
#include "gpu/instance.h"

namespace evaluate {

/// A device for one piece of work. Drivers keep what they compiled for a device as long as it lives (Mesa's software
/// device hundreds of MB after some renderings), so a long evaluation takes a new one for every edit.
[[nodiscard]] inline gpu::Device newDevice() {
    return gpu::Instance::create().requestAdapter({}).requestDevice({.label = "evaluate"});
}

}  // namespace evaluate
