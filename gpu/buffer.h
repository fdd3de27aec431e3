// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "gpu/handle.h"
#include "gpu/types.h"

namespace gpu {

struct BufferDescriptor {
    std::string label = {};
    std::uint64_t size = 0;  ///< bytes, > 0
    BufferUsage usage = BufferUsage::None;
    bool mappedAtCreation = false;  ///< mapped for writing until the first unmap(), whatever the usage
};

using BufferMapCallback = std::function<void(MapAsyncStatus status, std::string_view message)>;

/// A block of device memory, zero when new.
class Buffer : public Handle<detail::BufferImpl> {
  public:
    using Handle::Handle;

    [[nodiscard]] std::uint64_t size() const;  ///< bytes
    [[nodiscard]] BufferUsage usage() const;
    [[nodiscard]] const std::string& label() const;
    [[nodiscard]] BufferMapState mapState() const;

    /// Requests access for the CPU once the submitted work that uses the buffer has completed. The callback runs inside
    /// tick() or a later call on this thread, never inside mapAsync itself; an earlier unmap() aborts it. `size` may be
    /// kWholeSize. Submissions cannot use a buffer that is mapped or about to be.
    void mapAsync(MapMode mode, std::uint64_t offset, std::uint64_t size, BufferMapCallback callback) const;
    /// The mapped bytes from `offset` (of the buffer); within the mapped range only.
    [[nodiscard]] void* getMappedRange(std::uint64_t offset = 0, std::uint64_t size = kWholeSize) const;
    [[nodiscard]] const void* getConstMappedRange(std::uint64_t offset = 0, std::uint64_t size = kWholeSize) const;
    /// Ends the mapping, or aborts one that is pending; pointers into it are invalid afterwards.
    void unmap() const;
};

}  // namespace gpu
