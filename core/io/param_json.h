// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "core/io/json_reader.h"
#include "core/scene/params.h"

namespace core {

/// Reads one parameter from the object that holds it.
template <class Owner>
void readParam(JsonReader& reader, const Param<Owner>& param, Owner& owner);

/// Reads the parameters of an owner from its object in a project file and from the objects inside that one. Absent keys
/// leave a parameter as it is; null = automatic, where that is possible. Errors name the key, the value and the range
/// or words expected. `more` may read further keys of an inner object, which it gets by name.
template <class Owner>
void readParams(JsonReader& reader, std::span<const Param<Owner>> params, Owner& owner,
                const std::function<void(std::string_view object, JsonReader&)>& more = {});

/// Writes all parameters in the table's order, inner objects included; automatic ones are left out.
template <class Owner>
void writeParams(nlohmann::ordered_json& target, std::span<const Param<Owner>> params, const Owner& owner);

}  // namespace core
