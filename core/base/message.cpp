// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/message.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>

namespace core {

Message Message::about(Setting setting) const {
    Message result = *this;
    result.setting_ = setting;
    return result;
}

std::string Message::english() const {
    return text([](const char*, const std::string& pattern) { return pattern; });
}

std::string Message::text(const Translate& translate) const {
    if (context_ == nullptr) return pattern_;
    const std::string pattern = translate(context_, pattern_);
    std::string result;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const char next = i + 1 < pattern.size() ? pattern[i + 1] : ' ';
        const auto place = static_cast<std::size_t>(next - '1');
        if (pattern[i] == '%' && next >= '1' && next <= '9' && place < values_.size()) {
            result += values_[place].text(translate);
            ++i;
        } else {
            result += pattern[i];
        }
    }
    return result;
}

void Message::visitPatterns(const std::function<void(const char*, const std::string&)>& visit) const {
    if (context_ == nullptr) return;
    visit(context_, pattern_);
    for (const Message& value : values_) value.visitPatterns(visit);
}

std::string Message::shortNumber(double number) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%g", number);
    return text.data();
}

Message listed(std::span<const Message> items) {
    Message list;
    for (const Message& item : items) list = list.empty() ? item : Message("messages", "%1, %2").with(list, item);
    return list;
}

std::vector<std::string> english(std::span<const Message> messages) {
    std::vector<std::string> result;
    std::ranges::transform(messages, std::back_inserter(result), [](const Message& m) { return m.english(); });
    return result;
}

}  // namespace core
