// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/brdf.h"

#include <array>
#include <cstdio>
#include <string>

#include "core/material/measured_brdf.h"
#include "core/material/user_brdf.h"
#include "shaders/brdf/brdf.h"

namespace core {

namespace {

#define PATINA_BRDF_INFO(id, name)      \
    BrdfInfo{id,                        \
             #name,                     \
             name##_table.label,        \
             name##_table.params,       \
             name##_table.usesAlbedo,   \
             name##_table.usesSpecular, \
             static_cast<Fresnel>(name##_table.defaultFresnel)},
constexpr BrdfInfo kBrdfs[] = {BRDF_LIST(PATINA_BRDF_INFO)};
#undef PATINA_BRDF_INFO

static_assert(static_cast<int>(Fresnel::None) == kernel::kFresnelNone);
static_assert(static_cast<int>(Fresnel::Schlick) == kernel::kFresnelSchlick);
static_assert(static_cast<int>(Fresnel::Dielectric) == kernel::kFresnelDielectric);
static_assert(static_cast<int>(Fresnel::Conductor) == kernel::kFresnelConductor);

kernel::vec4 toVec4(const Vector3f& v, float w = 0) { return {v.x(), v.y(), v.z(), w}; }

}  // namespace

std::span<const BrdfInfo> brdfs() { return kBrdfs; }

const BrdfInfo* findBrdf(std::string_view key) {
    for (const BrdfInfo& info : kBrdfs)
        if (key == info.key) return &info;
    return nullptr;
}

const BrdfInfo* findBrdf(const Material& material) {
    return material.brdfFile ? &material.brdfFile->info : findBrdf(material.brdf);
}

bool usable(const Material& material) { return !material.brdfFile || material.brdfFile->problem.empty(); }

Material defaultMaterial(const BrdfInfo& brdf) {
    Material material;
    material.brdf = brdf.key;
    material.fresnel = brdf.defaultFresnel;
    for (std::size_t i = 0; i < brdf.params.size(); ++i) material.values[i] = brdf.params[i].initial;
    return material;
}

kernel::BrdfParams toKernel(const Material& material, const Vector3f& estimatedSpecular) {
    const BrdfInfo* info = findBrdf(material);
    if (!usable(material)) throw Error(ErrorKind::Input, material.brdfFile->problem);
    if (info == nullptr) {
        std::vector<Message> known;
        for (const BrdfInfo& other : kBrdfs) known.emplace_back(other.key);
        throw Error(ErrorKind::Usage,
                    Message("messages", "There is no BRDF \"%1\"; known are: %2.").with(material.brdf, listed(known)));
    }
    kernel::BrdfParams b;
    b.albedo = toVec4(material.albedo);
    b.specular = toVec4(material.specular.value_or(estimatedSpecular), static_cast<float>(material.fresnel));
    b.eta = toVec4(material.eta);
    b.k = toVec4(material.k);
    const auto& v = material.values;
    b.values = {v[0], v[1], v[2], v[3]};
    b.values2 = {v[4], v[5], v[6], v[7]};
    b.values3 = {v[8], v[9], v[10], v[11]};
    b.type = static_cast<kernel::uint>(info->id);
    b.file = material.brdfFile && material.brdfFile->user ? material.brdfFile->user->revision : 0;
    b.measured = material.brdfFile && material.brdfFile->measured ? material.brdfFile->measured->table.data() : nullptr;
    return b;
}

std::string brdfTableMarkdown() {
    std::string table = "| `brdf` | colours | parameters: range, initial value |\n| --- | --- | --- |\n";
    for (const BrdfInfo& info : kBrdfs) {
        table += std::string("| `") + info.key + "` | " +
                 (info.usesAlbedo     ? "`albedo`"
                  : info.usesSpecular ? std::string("`specular`; `fresnel`: `") + wordOf(info.defaultFresnel) + "`"
                                      : "") +
                 " | ";
        for (std::size_t i = 0; i < info.params.size(); ++i) {
            const ParamInfo& param = info.params[i];
            std::array<char, 160> row{};
            std::snprintf(row.data(), row.size(), "%s`%s`: %g to %g%s, %g", i == 0 ? "" : "; ", param.key,
                          static_cast<double>(param.min), static_cast<double>(param.max), param.unit,
                          static_cast<double>(param.initial));
            table += row.data();
        }
        table += " |\n";
    }
    return table;
}

}  // namespace core
