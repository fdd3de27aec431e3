// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/query_set.h"

#include "gpu/detail/device_impl.h"
#include "gpu/detail/resources.h"

namespace gpu {

namespace detail {

QuerySetImpl::QuerySetImpl(DeviceImpl& owner, const QuerySetDescriptor& descriptor)
    : Object(owner, descriptor.label), count(descriptor.count) {
    require(owner.limits().timestamps, "Query set ", quoted(label()), " cannot be made: device \"", owner.info().name,
            "\" has no timestamps.");
    require(count > 0 && count <= 4096, "Query set ", quoted(label()), " has ", count,
            " queries; 1 to 4096 are allowed.");
    VkQueryPoolCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = count;
    owner.check(vkCreateQueryPool(owner.vk(), &info, nullptr, &vk), "vkCreateQueryPool", label());
    owner.labels().setName(VK_OBJECT_TYPE_QUERY_POOL, vk, label());
}

void QuerySetImpl::release() noexcept {
    if (vk == VK_NULL_HANDLE) return;
    vkDestroyQueryPool(device().vk(), vk, nullptr);
    vk = VK_NULL_HANDLE;
}

double QuerySetImpl::secondsBetween(std::uint32_t first, std::uint32_t second) const {
    constexpr double kUnavailable = -1;
    const auto read = [&](std::uint32_t index, std::uint64_t& ticks) {
        return vkGetQueryPoolResults(device().vk(), vk, index, 1, sizeof(ticks), &ticks, sizeof(ticks),
                                     VK_QUERY_RESULT_64_BIT) == VK_SUCCESS;
    };
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    if (vk == VK_NULL_HANDLE || !read(first, begin) || !read(second, end)) return kUnavailable;
    const std::uint32_t bits = device().timestampBits();
    const std::uint64_t mask = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
    return static_cast<double>((end - begin) & mask) * device().limits().timestampPeriod * 1e-9;
}

}  // namespace detail

std::uint32_t QuerySet::count() const {
    detail::require(impl_ != nullptr, "The query set is an empty handle.");
    return impl_->count;
}

const std::string& QuerySet::label() const {
    detail::require(impl_ != nullptr, "The query set is an empty handle.");
    return impl_->label();
}

}  // namespace gpu
