// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

namespace gpu {

/// A cheap, copyable reference to an object of the GPU; empty when default constructed.
///
/// The object dies with its last handle, but never before the device has finished the commands that use it. Passing an
/// empty handle to a call is a validation error. All handles of one device belong to one thread at a time.
template <class Impl>
class Handle {
  public:
    Handle() = default;
    explicit Handle(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}

    explicit operator bool() const { return impl_ != nullptr; }
    friend bool operator==(const Handle& a, const Handle& b) { return a.impl_ == b.impl_; }

    /// The object behind the handle, for the library itself.
    [[nodiscard]] const std::shared_ptr<Impl>& impl() const { return impl_; }

  protected:
    std::shared_ptr<Impl> impl_;
};

namespace detail {
class InstanceImpl;
class AdapterImpl;
class DeviceImpl;
class BufferImpl;
class TextureImpl;
class TextureViewImpl;
class SamplerImpl;
class ShaderModuleImpl;
class BindGroupLayoutImpl;
class BindGroupImpl;
class PipelineLayoutImpl;
class ComputePipelineImpl;
class RenderPipelineImpl;
class CommandEncoderImpl;
class ComputePassImpl;
class RenderPassImpl;
class CommandBufferImpl;
class QuerySetImpl;
}  // namespace detail

}  // namespace gpu
