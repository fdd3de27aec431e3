// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/param_json.h"

#include <algorithm>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace core {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

std::int64_t readWord(JsonReader& reader, const ParamRow& row) {
    std::vector<std::string> keys;
    for (const Word<std::int64_t>& word : row.words) keys.emplace_back(word.key);
    return row.words[*reader.readChoice(paramName(row), keys)].value;
}

json writeValue(const ParamRow& row, const ParamValue& value) {
    return std::visit(
        [&](const auto& typed) -> json {
            using Type = std::remove_cvref_t<decltype(typed)>;
            if constexpr (std::is_same_v<Type, std::monostate>)
                return nullptr;
            else if constexpr (std::is_same_v<Type, float> || std::is_same_v<Type, Vector3f>)
                return toJson(typed);
            else if constexpr (std::is_same_v<Type, std::int64_t>)
                if (row.words.empty())
                    return typed;
                else
                    return std::ranges::find(row.words, typed, &Word<std::int64_t>::value)->key;
            else
                return typed;
        },
        value);
}

}  // namespace

template <class Owner>
void readParam(JsonReader& reader, const Param<Owner>& param, Owner& owner) {
    const char* key = paramName(param);
    const json* found = reader.find(key);
    if (found == nullptr) return;
    if (param.automatic && found->is_null()) return param.set(owner, ParamValue());
    if (!param.words.empty()) return param.set(owner, readWord(reader, param));
    std::visit(
        [&]<class Type>(Type value) {
            if constexpr (std::is_same_v<Type, bool>) {
                reader.read(key, value);
            } else if constexpr (std::is_same_v<Type, std::int64_t> || std::is_same_v<Type, double>) {
                reader.read(key, value, static_cast<Type>(param.legal.min), static_cast<Type>(param.legal.max));
            } else if constexpr (!std::is_same_v<Type, std::monostate>) {
                reader.read(key, value, static_cast<float>(param.legal.min), static_cast<float>(param.legal.max));
            }
            param.set(owner, value);
        },
        param.initial);
}

template <class Owner>
void readParams(JsonReader& reader, std::span<const Param<Owner>> params, Owner& owner,
                const std::function<void(std::string_view object, JsonReader&)>& more) {
    std::set<std::string> objects;
    for (const Param<Owner>& param : params) objects.emplace(paramObject(param));
    for (const std::string& object : objects) {
        const auto readAll = [&](JsonReader& place) {
            for (const Param<Owner>& param : params)
                if (paramObject(param) == object) readParam(place, param, owner);
        };
        if (object.empty()) {
            readAll(reader);
        } else if (const json* value = reader.find(object.c_str())) {
            JsonReader inner(*value, reader.place(object), reader.kind());
            readAll(inner);
            if (more) more(object, inner);
            inner.finish();
        }
    }
}

template <class Owner>
void writeParams(ordered_json& target, std::span<const Param<Owner>> params, const Owner& owner) {
    for (const Param<Owner>& param : params) {
        const std::string object(paramObject(param));
        const ParamValue value = param.get(owner);
        if (std::holds_alternative<std::monostate>(value)) continue;
        (object.empty() ? target : target[object])[paramName(param)] = writeValue(param, value);
    }
}

using MoreKeys = std::function<void(std::string_view, JsonReader&)>;
template void readParams(JsonReader&, std::span<const SegmentParam>, Segment&, const MoreKeys&);
template void readParams(JsonReader&, std::span<const SceneParam>, Scene&, const MoreKeys&);
template void readParams(JsonReader&, std::span<const MaterialParam>, Material&, const MoreKeys&);
template void readParam(JsonReader&, const TranslucencyParam&, Translucency&);
template void writeParams(ordered_json&, std::span<const SegmentParam>, const Segment&);
template void writeParams(ordered_json&, std::span<const SceneParam>, const Scene&);
template void writeParams(ordered_json&, std::span<const MaterialParam>, const Material&);

}  // namespace core
