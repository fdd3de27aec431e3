// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "gpu/detail/text.h"

namespace gpu::detail {

class DeviceImpl;

/// Owner of Vulkan handles that belong to a device.
///
/// Two kinds of references keep it alive: user handles (`makeHandle`), which keep the device alive as well, and
/// recorded or submitted command buffers, which do not: the device owns those, and a reference back would be a cycle.
class Object : public std::enable_shared_from_this<Object> {
  public:
    Object(DeviceImpl& device, std::string label);
    virtual ~Object();
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;

    /// Destroys the Vulkan handles; may be called again. Every final class calls it from its destructor.
    virtual void release() noexcept = 0;

    [[nodiscard]] DeviceImpl& device() const { return device_; }
    [[nodiscard]] const std::string& label() const { return label_; }

  private:
    DeviceImpl& device_;
    std::string label_;
};

/// A user's reference to an object: also keeps the device alive, and releases the object first.
template <class T>
[[nodiscard]] std::shared_ptr<T> makeHandle(std::shared_ptr<DeviceImpl> device, std::shared_ptr<T> object) {
    struct Holder {
        std::shared_ptr<DeviceImpl> device;
        std::shared_ptr<T> object;
    };
    T* raw = object.get();
    return std::shared_ptr<T>(std::make_shared<Holder>(Holder{std::move(device), std::move(object)}), raw);
}

/// The reference a command buffer or another object keeps.
template <class T>
[[nodiscard]] std::shared_ptr<T> internalReference(T& object) {
    return std::static_pointer_cast<T>(object.shared_from_this());
}

/// The object behind a handle; throws Error(Validation) for an empty handle or one of another device.
template <class H>
auto& resolve(const H& handle, const DeviceImpl& device, const char* what) {
    require(static_cast<bool>(handle), "The ", what, " is an empty handle.");
    require(&handle.impl()->device() == &device, "The ", what, " ", quoted(handle.impl()->label()),
            " belongs to another device.");
    return *handle.impl();
}

}  // namespace gpu::detail
