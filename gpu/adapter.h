// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "gpu/device.h"
#include "gpu/handle.h"
#include "gpu/types.h"

namespace gpu {

/// Which adapter `Instance::requestAdapter` takes.
struct RequestAdapterOptions {
    std::string device = {};  ///< part of a name, case ignored, or an index into `adapters()`; empty = no preference
};

/// Description of an adapter.
struct AdapterInfo {
    std::string name;    ///< for example "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string driver;  ///< name and version of the driver
    std::string vendor;  ///< name if known, otherwise the number in hexadecimal
    AdapterType type = AdapterType::Unknown;
    std::uint32_t vendorId = 0;
    std::uint32_t deviceId = 0;
    std::uint32_t apiVersionMajor = 0;
    std::uint32_t apiVersionMinor = 0;
};

/// One physical device with one driver.
class Adapter : public Handle<detail::AdapterImpl> {
  public:
    using Handle::Handle;

    [[nodiscard]] const AdapterInfo& info() const;
    [[nodiscard]] const Limits& limits() const;

    /// A device with one queue for compute and graphics and no optional feature.
    [[nodiscard]] Device requestDevice(const DeviceDescriptor& descriptor = {}) const;
};

}  // namespace gpu
