// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/step.h"

#include <variant>

#include "core/scene/params.h"

namespace core::analysis {

namespace {

template <class Owner>
Hash& addRows(Hash& hash, Stage stage, std::span<const Param<Owner>> params, const Owner& owner) {
    for (const Param<Owner>& param : params) {
        if (param.stage != stage) continue;
        const ParamValue value = param.get(owner);
        hash.add(value.index());
        if (!std::holds_alternative<std::monostate>(value))
            std::visit([&](const auto& typed) { hash.add(typed); }, value);
    }
    return hash;
}

}  // namespace

Hash& addParams(Hash& hash, Stage stage, const Scene& scene) { return addRows(hash, stage, sceneParams(), scene); }

Hash& addParams(Hash& hash, Stage stage, const Segment& segment) {
    return addRows(hash, stage, segmentParams(), segment);
}

}  // namespace core::analysis
