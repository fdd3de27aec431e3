// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/session.h"
#include "gpu/device.h"

namespace cli {

/// The device the user asked for, or the best there is; says on stderr which it took. Throws gpu::Error(NoAdapter).
[[nodiscard]] gpu::Device openDevice(const Session& session);

}  // namespace cli
