// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "gpu/handle.h"
#include "gpu/types.h"

namespace gpu {

struct QuerySetDescriptor {
    std::string label = {};
    QueryType type = QueryType::Timestamp;
    std::uint32_t count = 0;
};

/// Slots for timestamps, in ticks of `Limits::timestampPeriod` nanoseconds; creating one on a device without
/// `Limits::timestamps` is a validation error.
class QuerySet : public Handle<detail::QuerySetImpl> {
  public:
    using Handle::Handle;

    [[nodiscard]] std::uint32_t count() const;
    [[nodiscard]] const std::string& label() const;
};

}  // namespace gpu
