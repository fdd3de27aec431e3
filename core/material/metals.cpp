// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/metals.h"

#include "shaders/shared/param_info.h"

namespace core {

namespace {

// Ag, Au, Cu: doi 10.1103/PhysRevB.6.4370; Al: doi 10.1364/AO.34.004755; Cr, Fe: doi 10.1103/PhysRevB.9.5056
constexpr Metal kMetals[] = {
    {"silver", PARAM_LABEL("metals", "Silver"), {0.052f, 0.054f, 0.046f}, {4.409f, 3.583f, 2.645f}},
    {"gold", PARAM_LABEL("metals", "Gold"), {0.168f, 0.481f, 1.338f}, {3.592f, 2.464f, 1.903f}},
    {"copper", PARAM_LABEL("metals", "Copper"), {0.265f, 0.950f, 1.252f}, {3.603f, 2.651f, 2.380f}},
    {"aluminium", PARAM_LABEL("metals", "Aluminium"), {1.569f, 1.022f, 0.639f}, {7.695f, 6.624f, 5.450f}},
    {"chromium", PARAM_LABEL("metals", "Chromium"), {3.115f, 3.091f, 2.355f}, {3.334f, 3.317f, 3.119f}},
    {"iron", PARAM_LABEL("metals", "Iron"), {2.896f, 2.902f, 2.554f}, {3.095f, 2.944f, 2.758f}},
};

Vector3f toVector(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

}  // namespace

std::span<const Metal> metals() { return kMetals; }

const Metal* findMetal(std::string_view key) {
    for (const Metal& metal : kMetals)
        if (key == metal.key) return &metal;
    return nullptr;
}

const Metal* metalOf(const Material& material) {
    if (material.fresnel != Fresnel::Conductor) return nullptr;
    for (const Metal& metal : kMetals)
        if (material.eta == toVector(metal.n) && material.k == toVector(metal.k)) return &metal;
    return nullptr;
}

void setMetal(Material& material, const Metal& metal) {
    material.fresnel = Fresnel::Conductor;
    material.eta = toVector(metal.n);
    material.k = toVector(metal.k);
    material.specular = Vector3f(1, 1, 1);
}

}  // namespace core
