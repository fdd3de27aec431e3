// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "gpu/adapter.h"
#include "gpu/handle.h"

namespace gpu {

/// Use of the Vulkan validation layer (core and synchronization checks).
enum class ValidationMode {
    Off,
    On,     ///< warnings and errors go to the callback, or to stderr
    Fatal,  ///< like On, then abort(): for tests
};

/// PATINA_VALIDATION: unset or "0" is Off, "1" is On, "fatal" is Fatal. Any other value throws Error(Validation).
[[nodiscard]] ValidationMode validationModeFromEnvironment();

using ValidationCallback = std::function<void(std::string_view message)>;

struct InstanceDescriptor {
    ValidationMode validation = validationModeFromEnvironment();
    ValidationCallback validationCallback = {};  ///< called on the thread of the offending call, before abort()
};

/// The Vulkan loader with its drivers; the first object to create.
class Instance : public Handle<detail::InstanceImpl> {
  public:
    using Handle::Handle;

    /// Throws Error(NoAdapter) when the loader finds no Vulkan 1.1 driver, Error(Internal) when validation is requested
    /// but the layer is not installed (the message says which package is missing).
    [[nodiscard]] static Instance create(const InstanceDescriptor& descriptor = {});

    /// Every adapter with Vulkan 1.1 and a queue for compute and graphics, in the loader's order; may be empty.
    [[nodiscard]] std::vector<Adapter> adapters() const;

    /// One adapter: `options.device` if given, otherwise environment PATINA_DEVICE, otherwise by kind (discrete,
    /// integrated, virtual, software). Throws Error(NoAdapter), listing the adapters, when none matches.
    [[nodiscard]] Adapter requestAdapter(const RequestAdapterOptions& options = {}) const;

    /// Warnings and errors the validation layer has reported so far.
    [[nodiscard]] std::uint64_t validationMessageCount() const;
};

}  // namespace gpu
