// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/json_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace core {

using nlohmann::json;

namespace {

constexpr int kMaxNesting = 64;

std::string excerpt(const json& value) {
    std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    if (text.size() > 60) text = text.substr(0, 57) + "...";
    return text;
}

Message rangeText(double min, double max) {
    const bool unlimited = max >= static_cast<double>(std::numeric_limits<float>::max());
    return unlimited ? Message("messages", "a number of at least %1").with(min)
                     : Message("messages", "a number in [%1, %2]").with(min, max);
}

}  // namespace

std::string quotedList(const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "\"" : ", \"") + word + "\"";
    return list;
}

JsonReader::JsonReader(const json& value, std::string place, ErrorKind kind)
    : object_(&value), place_(std::move(place)), kind_(kind) {
    if (value.is_object()) return;
    if (place_.empty())
        throw Error(kind, Message("messages", "The value is %1, expected an object {...}.").with(excerpt(value)));
    throw Error(kind, Message("messages", "\"%1\" is %2, expected an object {...}.").with(place_, excerpt(value)));
}

std::string JsonReader::place(const std::string& key) const { return place_.empty() ? key : place_ + "." + key; }

void JsonReader::fail(const std::string& key, const Message& expected, const json& found) const {
    fail(Message("messages", "\"%1\" is %2, expected %3.").with(place(key), excerpt(found), expected));
}

void JsonReader::fail(const Message& sentence) const { throw Error(kind_, sentence); }

const json* JsonReader::find(const char* key) {
    known_.insert(key);
    const auto found = object_->find(key);
    return found == object_->end() ? nullptr : &*found;
}

double JsonReader::number(const std::string& key, const json& value, double min, double max) const {
    if (!value.is_number()) fail(key, rangeText(min, max), value);
    const auto result = value.get<double>();
    // 0.3 in the file is inside a range that ends at 0.3f.
    const bool inside = (result >= min && result <= max) || (static_cast<float>(result) >= static_cast<float>(min) &&
                                                             static_cast<float>(result) <= static_cast<float>(max));
    if (!inside) fail(key, rangeText(min, max), value);
    return result;
}

void JsonReader::read(const char* key, bool& target) {
    const json* value = find(key);
    if (value == nullptr) return;
    if (!value->is_boolean()) fail(key, Message("messages", "true or false"), *value);
    target = value->get<bool>();
}

void JsonReader::read(const char* key, std::string& target) {
    const json* value = find(key);
    if (value == nullptr) return;
    if (!value->is_string()) fail(key, Message("messages", "a text in quotes"), *value);
    target = value->get<std::string>();
    if (target.find('\0') != std::string::npos) fail(key, Message("messages", "a text without zero bytes"), *value);
}

void JsonReader::read(const char* key, float& target, float min, float max) {
    if (const json* value = find(key))
        target = static_cast<float>(number(key, *value, static_cast<double>(min), static_cast<double>(max)));
}

void JsonReader::read(const char* key, double& target, double min, double max) {
    if (const json* value = find(key)) target = number(key, *value, min, max);
}

void JsonReader::read(const char* key, int& target, int min, int max) {
    std::int64_t value = target;
    read(key, value, std::int64_t{min}, std::int64_t{max});
    target = static_cast<int>(value);
}

void JsonReader::read(const char* key, std::int64_t& target, std::int64_t min, std::int64_t max) {
    const json* value = find(key);
    if (value == nullptr) return;
    const Message expected = Message("messages", "a whole number from %1 to %2").with(min, max);
    if (!value->is_number_integer()) fail(key, expected, *value);
    const bool tooLarge = value->is_number_unsigned() && value->get<std::uint64_t>() > static_cast<std::uint64_t>(max);
    if (tooLarge || value->get<std::int64_t>() < min || value->get<std::int64_t>() > max) fail(key, expected, *value);
    target = value->get<std::int64_t>();
}

void JsonReader::read(const char* key, Vector3f& target, float min, float max) {
    const json* value = find(key);
    if (value == nullptr) return;
    if (!value->is_array() || value->size() != 3) fail(key, Message("messages", "three numbers [r, g, b]"), *value);
    for (std::size_t c = 0; c < 3; ++c)
        target[static_cast<int>(c)] =
            static_cast<float>(number(std::string(key) + "[" + std::to_string(c) + "]", (*value)[c],
                                      static_cast<double>(min), static_cast<double>(max)));
}

void JsonReader::readColorOrNumber(const char* key, Vector3f& target, float min, float max) {
    const json* value = find(key);
    if (value == nullptr || !value->is_number()) return read(key, target, min, max);
    target.setConstant(static_cast<float>(number(key, *value, static_cast<double>(min), static_cast<double>(max))));
}

std::optional<std::size_t> JsonReader::readChoice(const char* key, const std::vector<std::string>& words) {
    const json* value = find(key);
    if (value == nullptr) return std::nullopt;
    if (value->is_string()) {
        const auto found = std::ranges::find(words, value->get<std::string>());
        if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    }
    fail(key, Message("messages", "one of %1").with(quotedList(words)), *value);
}

void JsonReader::require(const char* key) const {
    if (!has(key)) fail(Message("messages", "The key \"%1\" is missing.").with(place(key)));
}

void JsonReader::finish(const Message& hint) const {
    for (const auto& [key, value] : object_->items()) {
        if (known_.contains(key)) continue;
        const Error error(kind_, Message("messages", "The key %1 is unknown, expected %2.")
                                     .with(excerpt(json(place(key))), quotedList({known_.begin(), known_.end()})));
        throw hint.empty() ? error : error.withContext(hint);
    }
}

double toJson(float value) {
    for (int digits = 6; digits <= 9; ++digits) {
        char text[32];
        std::snprintf(text, sizeof text, "%.*g", digits, static_cast<double>(value));
        const double parsed = std::strtod(text, nullptr);
        if (static_cast<float>(parsed) == value) return parsed;
    }
    return static_cast<double>(value);
}

json toJson(const Vector3f& v) { return json::array({toJson(v.x()), toJson(v.y()), toJson(v.z())}); }

json parseJson(std::string_view text, ErrorKind kind) {
    std::vector<std::set<std::string>> open;
    Message problem;
    const auto check = [&](int depth, json::parse_event_t event, json& parsed) {
        if (depth > kMaxNesting)
            problem = Message("messages", "The JSON text is nested deeper than %1.").with(kMaxNesting);
        if (event == json::parse_event_t::object_start) open.emplace_back();
        if (event == json::parse_event_t::object_end && !open.empty()) open.pop_back();
        if (event == json::parse_event_t::key && !open.empty() && !open.back().insert(parsed.get<std::string>()).second)
            problem = Message("messages", "The key \"%1\" occurs twice.").with(parsed.get<std::string>());
        if (!problem.empty()) throw Error(kind, problem);
        return true;
    };
    try {
        return json::parse(text, check);
    } catch (const json::exception& error) {
        std::string reason = error.what();
        if (const std::size_t at = reason.find("] "); at != std::string::npos) reason = reason.substr(at + 2);
        std::replace_if(
            reason.begin(), reason.end(), [](unsigned char c) { return c < 32; }, ' ');
        throw Error(kind, Message("messages", "The JSON text is damaged: %1.").with(reason));
    }
}

}  // namespace core
