// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "gpu/adapter.h"
#include "gpu/handle.h"

namespace gpu {

/// How much the Vulkan validation layer (core and synchronization checks) is listened to.
enum class ValidationMode {
    Off,
    On,     ///< warnings and errors go to the callback, or to stderr
    Fatal,  ///< the same, then abort(): for tests
};

/// PATINA_VALIDATION: unset or "0" is Off, "1" is On, "fatal" is Fatal. Any other value throws Error(Validation).
[[nodiscard]] ValidationMode validationModeFromEnvironment();

using ValidationCallback = std::function<void(std::string_view message)>;

struct InstanceDescriptor {
    ValidationMode validation = validationModeFromEnvironment();
    ValidationCallback validationCallback = {};  ///< called on the thread of the offending call, before abort()
};

/// The Vulkan loader with its drivers: the beginning of everything.
class Instance : public Handle<detail::InstanceImpl> {
  public:
    using Handle::Handle;

    /// Throws Error(NoAdapter) when the loader finds no Vulkan 1.1 driver, Error(Internal) when validation is asked for
    /// but the layer is not installed (the message says which package is missing).
    [[nodiscard]] static Instance create(const InstanceDescriptor& descriptor = {});

    /// Every adapter with Vulkan 1.1 and a queue for compute and graphics, in the loader's order; may be empty.
    [[nodiscard]] std::vector<Adapter> adapters() const;

    /// One adapter: `options.device` if given, else environment PATINA_DEVICE, else by kind (discrete, integrated,
    /// virtual, software). Throws Error(NoAdapter), listing what there is, when nothing fits.
    [[nodiscard]] Adapter requestAdapter(const RequestAdapterOptions& options = {}) const;

    /// Warnings and errors the validation layer has reported so far.
    [[nodiscard]] std::uint64_t validationMessageCount() const;
};

}  // namespace gpu
