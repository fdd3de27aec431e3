// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <vector>

#include "gpu/adapter.h"
#include "gpu/detail/debug_labels.h"
#include "gpu/detail/descriptor_pools.h"
#include "gpu/detail/device_memory.h"
#include "gpu/detail/in_flight.h"
#include "gpu/detail/instance_impl.h"
#include "gpu/detail/object.h"
#include "gpu/detail/pipeline_compiler.h"
#include "gpu/device.h"

namespace gpu::detail {

/// Owns the Vulkan device (unless adopted) and what belongs to it as a whole: error scopes, the loss of the device, the
/// list of its objects. Memory, descriptor sets, work in flight and debug labels are members with files of their own.
///
/// Belongs to one thread at a time, as do all objects of the device. Only jobs of the compiler run elsewhere.
class DeviceImpl : public std::enable_shared_from_this<DeviceImpl> {
  public:
    struct Source {
        std::shared_ptr<InstanceImpl> instanceImpl;             ///< empty when adopted
        std::unique_ptr<ValidationListener> adoptedValidation;  ///< of an adopted instance
        VkInstance instance = VK_NULL_HANDLE;
        VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
        VkDevice device = VK_NULL_HANDLE;
        VkQueue queue = VK_NULL_HANDLE;
        std::uint32_t queueFamily = 0;
        bool owned = false;
        bool debugUtils = false;
        std::string label;
        DeviceLostCallback deviceLost;
    };

    explicit DeviceImpl(Source source);
    ~DeviceImpl();
    DeviceImpl(const DeviceImpl&) = delete;
    DeviceImpl& operator=(const DeviceImpl&) = delete;

    [[nodiscard]] VkDevice vk() const { return source_.device; }
    [[nodiscard]] VkPhysicalDevice physicalDevice() const { return source_.physicalDevice; }
    [[nodiscard]] VkQueue queue() const { return source_.queue; }
    [[nodiscard]] std::uint32_t queueFamily() const { return source_.queueFamily; }
    [[nodiscard]] const std::string& label() const { return source_.label; }
    [[nodiscard]] const AdapterInfo& info() const { return info_; }
    [[nodiscard]] const Limits& limits() const { return limits_; }
    [[nodiscard]] bool adopted() const { return !source_.owned; }
    [[nodiscard]] bool lost() const { return lost_; }
    [[nodiscard]] bool destroyed() const { return destroyed_; }
    [[nodiscard]] std::uint32_t timestampBits() const { return timestampBits_; }
    [[nodiscard]] VkPipelineCache pipelineCache() const { return pipelineCache_; }
    [[nodiscard]] PipelineCompiler& compiler() { return compiler_; }
    [[nodiscard]] const DebugLabels& labels() const { return labels_; }
    [[nodiscard]] DeviceMemory& memory() { return memory_; }
    [[nodiscard]] DescriptorPools& descriptorPools() { return descriptorPools_; }
    [[nodiscard]] InFlight& inFlight() { return inFlight_; }

    /// Throws when the device is lost or destroyed.
    void requireUsable() const;
    /// Throws the Error a failed result means; notices a lost device.
    void check(VkResult result, const char* call, const std::string& label);

    // Error scopes.
    void pushErrorScope(ErrorFilter filter) { scopes_.push_back({filter, std::nullopt}); }
    std::optional<Error> popErrorScope();
    [[nodiscard]] bool wouldCapture(const Error& error) const;
    bool capture(const Error& error);
    /// Runs a call of the public interface: an error an open scope wants goes there, and the call returns an empty
    /// value.
    template <class F>
    auto guarded(F&& call) -> std::invoke_result_t<F> {
        try {
            requireUsable();
            return call();
        } catch (const Error& error) {
            if (!capture(error)) throw;
        }
        return std::invoke_result_t<F>();
    }

    // Lifetimes.
    void add(Object* object) { live_.insert(object); }
    void remove(Object* object) { live_.erase(object); }
    void destroy();

  private:
    struct Scope {
        ErrorFilter filter;
        std::optional<Error> error;
    };

    void markLost(const std::string& message);
    void releaseAll() noexcept;

    Source source_;
    AdapterInfo info_;
    Limits limits_;
    std::uint32_t timestampBits_ = 0;
    /// Declared before the members that own objects, because objects remove themselves from it.
    std::unordered_set<Object*> live_;
    std::vector<Scope> scopes_;
    DebugLabels labels_;
    DeviceMemory memory_;
    DescriptorPools descriptorPools_;
    InFlight inFlight_;
    VkPipelineCache pipelineCache_ = VK_NULL_HANDLE;
    PipelineCompiler compiler_;
    bool lost_ = false;
    bool destroyed_ = false;
};

}  // namespace gpu::detail
