// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/pass_timer.h"

#include <utility>

#include "gpu/detail/commands.h"
#include "gpu/detail/device_impl.h"
#include "gpu/detail/resources.h"

namespace gpu {

struct PassTimer::State {
    QuerySet queries;                        // empty without timestamps
    std::vector<std::uint32_t> freeRegions;  // region i uses queries 2i and 2i+1
    std::vector<Timing> results;
    std::uint64_t dropped = 0;
};

struct PassTimer::Region::Data {
    std::shared_ptr<State> state;
    CommandEncoder encoder;
    std::string label;
    std::uint32_t index = 0;
};

PassTimer::PassTimer(const Device& device, std::uint32_t capacity) : state_(std::make_shared<State>()) {
    if (!device.limits().timestamps || capacity == 0) return;
    state_->queries =
        device.createQuerySet({.label = "pass timer", .type = QueryType::Timestamp, .count = 2 * capacity});
    for (std::uint32_t i = capacity; i > 0; --i) state_->freeRegions.push_back(i - 1);
}

bool PassTimer::supported() const { return static_cast<bool>(state_->queries); }

PassTimer::Region PassTimer::measure(const CommandEncoder& encoder, std::string label) {
    if (!supported()) return Region(nullptr);
    if (state_->freeRegions.empty()) {
        ++state_->dropped;
        return Region(nullptr);
    }
    const std::uint32_t index = state_->freeRegions.back();
    encoder.writeTimestamp(state_->queries, 2 * index);
    encoder.impl()->executionBarrier();
    state_->freeRegions.pop_back();
    return Region(std::make_unique<Region::Data>(Region::Data{state_, encoder, std::move(label), index}));
}

std::vector<PassTimer::Timing> PassTimer::takeResults() { return std::exchange(state_->results, {}); }

std::uint64_t PassTimer::dropped() const { return state_->dropped; }

PassTimer::Region::Region(std::unique_ptr<Data> data) : data_(std::move(data)) {}
PassTimer::Region::Region(Region&& other) noexcept = default;

PassTimer::Region::~Region() {
    try {
        end();
    } catch (const Error&) {
        // Left by an exception with an open pass: the region is lost and its queries are never reused.
    }
}

void PassTimer::Region::end() {
    if (!data_) return;
    const std::unique_ptr<Data> data = std::move(data_);
    data->encoder.writeTimestamp(data->state->queries, 2 * data->index + 1);
    // Weak, because the timer may die before the device is done, and a strong reference would keep the device alive
    // through its own list of callbacks.
    const std::weak_ptr<State> state = data->state;
    data->encoder.onCompleted([state, label = std::move(data->label), index = data->index] {
        const std::shared_ptr<State> timer = state.lock();
        if (!timer) return;
        const double seconds = timer->queries.impl()->secondsBetween(2 * index, 2 * index + 1);
        if (seconds >= 0) timer->results.push_back({label, seconds});
        timer->freeRegions.push_back(index);
    });
}

}  // namespace gpu
