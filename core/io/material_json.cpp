// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/material_json.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/io/drive_json.h"
#include "core/io/json_reader.h"
#include "core/io/param_json.h"
#include "core/material/brdf.h"
#include "core/material/brdf_file.h"
#include "core/material/material_ranges.h"
#include "core/material/metals.h"
#include "core/material/translucency.h"

namespace core {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

constexpr float kMaxCoefficient = 1e5f;  // [1/mm]
constexpr float kMaxFreePath = 1e5f;     // [mm]
constexpr float kMinFreePath = 1e-4f;    // [mm]

std::vector<std::string> brdfKeys() {
    std::vector<std::string> keys;
    for (const BrdfInfo& brdf : brdfs()) keys.emplace_back(brdf.key);
    return keys;
}

Message parameterHint(const BrdfInfo& brdf) {
    std::vector<std::string> names;
    for (const ParamInfo& param : brdf.params) names.emplace_back(param.key);
    if (names.empty()) return Message("messages", "The BRDF \"%1\" has no parameters of its own.").with(brdf.key);
    return Message("messages", "The BRDF \"%1\" has the parameters %2.").with(brdf.key, quotedList(names));
}

const TranslucencyPreset& readPreset(JsonReader& reader) {
    std::string name;
    reader.read("preset", name);
    if (const TranslucencyPreset* found = findTranslucencyPreset(name)) return *found;
    std::vector<std::string> names;
    for (const TranslucencyPreset& p : translucencyPresets()) names.emplace_back(p.key);
    reader.fail(Message("messages", "\"%1\" is \"%2\", expected one of %3.")
                    .with(reader.place("preset"), name, quotedList(names)));
}

/// How an object states absorption and scattering.
enum class Substance { Preset, Coefficients, Diffuse };

Substance findSubstance(JsonReader& reader, const std::string& place) {
    const bool preset = reader.has("preset");
    const bool coefficients = reader.has("sigma_a") || reader.has("sigma_s_prime");
    const bool diffuse = reader.has("diffuse_color") || reader.has("mean_free_path_mm");
    if (int{preset} + int{coefficients} + int{diffuse} != 1)
        reader.fail(Message("messages",
                            "\"%1\" needs exactly one of: \"preset\"; \"sigma_a\" with \"sigma_s_prime\"; "
                            "\"diffuse_color\" with \"mean_free_path_mm\".")
                        .with(place));
    return preset ? Substance::Preset : coefficients ? Substance::Coefficients : Substance::Diffuse;
}

Translucency readTranslucency(const json& value, const std::string& place, ErrorKind kind) {
    JsonReader reader(value, place, kind);
    Translucency result;
    for (const TranslucencyParam& param : translucencyParams()) readParam(reader, param, result);
    switch (findSubstance(reader, place)) {
        case Substance::Preset: {
            const TranslucencyPreset& preset = readPreset(reader);
            const Translucency measured = toTranslucency(preset);
            result.preset = preset.key;
            result.sigmaA = measured.sigmaA;
            result.sigmaSPrime = measured.sigmaSPrime;
            if (!reader.has("eta")) result.eta = measured.eta;
            break;
        }
        case Substance::Coefficients:
            reader.require("sigma_a");
            reader.require("sigma_s_prime");
            reader.read("sigma_a", result.sigmaA, 0.0f, kMaxCoefficient);
            reader.read("sigma_s_prime", result.sigmaSPrime, 0.0f, kMaxCoefficient);
            break;
        case Substance::Diffuse: {
            reader.require("diffuse_color");
            reader.require("mean_free_path_mm");
            Vector3f color(0, 0, 0);
            Vector3f freePath(1, 1, 1);
            reader.read("diffuse_color", color, 0.0f, 1.0f);
            reader.readColorOrNumber("mean_free_path_mm", freePath, kMinFreePath, kMaxFreePath);
            const Translucency inverted = translucencyFromDiffuse(color, freePath, result.eta, result.model);
            result.sigmaA = inverted.sigmaA;
            result.sigmaSPrime = inverted.sigmaSPrime;
            break;
        }
    }
    reader.finish();
    return result;
}

ordered_json writeTranslucency(const Translucency& t) {
    ordered_json result;
    const TranslucencyPreset* preset = t.preset.empty() ? nullptr : findTranslucencyPreset(t.preset);
    const bool unchanged = preset != nullptr && toTranslucency(*preset).sigmaA == t.sigmaA &&
                           toTranslucency(*preset).sigmaSPrime == t.sigmaSPrime;
    if (unchanged) {
        result["preset"] = t.preset;
    } else {
        result["sigma_a"] = toJson(t.sigmaA);
        result["sigma_s_prime"] = toJson(t.sigmaSPrime);
    }
    if (t.model != ScatteringModel::Dipole) result["model"] = wordOf(t.model);
    result["eta"] = toJson(t.eta);
    result["scale"] = toJson(t.scale);
    result["weight"] = toJson(t.weight);
    return result;
}

constexpr std::string_view kFilePrefix = "file:";

/// Names in an edit that may be parameters of its BRDF, because they have a number or a drive.
std::vector<std::string> namedParameters(const json& edit) {
    static const std::set<std::string, std::less<>> kOwn{"eta", "k", "albedo", "specular"};
    std::vector<std::string> names;
    const auto add = [&](const std::string& name) {
        if (!kOwn.contains(name) && name.find('.') == std::string::npos &&
            std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
    };
    for (const auto& [key, value] : edit.items())
        if (value.is_number()) add(key);
    const auto drives = edit.find("drives");
    if (drives == edit.end() || !drives->is_array()) return names;
    for (const json& drive : *drives)
        if (drive.is_object() && drive.contains("parameter") && drive["parameter"].is_string())
            add(drive["parameter"].get<std::string>());
    return names;
}

/// The material of the BRDF named in the edit, with its initial values.
Material readBrdf(JsonReader& reader, const json& edit, const std::string& folder, Notes* notes) {
    const json& name = *reader.find("brdf");
    if (!name.is_string() || !name.get<std::string>().starts_with(kFilePrefix))
        return defaultMaterial(brdfs()[*reader.readChoice("brdf", brdfKeys())]);
    const std::filesystem::path path(name.get<std::string>().substr(kFilePrefix.size()));
    if (path.empty()) reader.fail("brdf", Message("messages", "a path after \"file:\""), name);
    const std::string full = path.is_absolute() ? path.string() : (std::filesystem::path(folder) / path).string();
    if (notes == nullptr) return fileMaterial(loadBrdfFile(full));
    Material material = fileMaterial(loadBrdfFileOrProblem(full, namedParameters(edit)));
    if (!usable(material))
        notes->push_back(
            Message("messages", "\"%1\" is left out: %2").with(reader.place("brdf"), material.brdfFile->problem));
    return material;
}

}  // namespace

Material readMaterial(const json& value, const std::string& place, ErrorKind kind, MaskLoader& masks,
                      const std::string& folder, Notes* notes) {
    JsonReader reader(value, place, kind);
    reader.require("brdf");
    Material material = readBrdf(reader, value, folder, notes);
    const BrdfInfo& brdf = *findBrdf(material);
    reader.read("albedo", material.albedo, 0.0f, 1.0f);
    std::vector<std::string> metalKeys;
    for (const Metal& metal : metals()) metalKeys.emplace_back(metal.key);
    if (const auto metal = reader.readChoice("metal", metalKeys)) {
        if (!brdf.usesSpecular)
            reader.fail(Message("messages", "\"%1\" needs a BRDF with a Fresnel mode; \"%2\" has none.")
                            .with(reader.place("metal"), brdf.key));
        if (reader.has("eta") || reader.has("k"))
            reader.fail(
                Message("messages", "Give \"%1\", or \"eta\" and \"k\", not both.").with(reader.place("metal")));
        setMetal(material, metals()[*metal]);
    }
    if (const json* specular = reader.find("specular")) {
        if (specular->is_string()) {
            if (*specular != "estimated")
                reader.fail("specular", Message("messages", "[r, g, b] or \"estimated\""), *specular);
            material.specular.reset();
        } else {
            Vector3f color;
            reader.read("specular", color, 0.0f, kMaxSpecular);
            material.specular = color;
        }
    }
    for (std::size_t i = 0; i < brdf.params.size(); ++i)
        reader.read(brdf.params[i].key, material.values[i], brdf.params[i].min, brdf.params[i].max);
    reader.readWord("fresnel", material.fresnel);
    reader.readColorOrNumber("eta", material.eta, kMinIndex, kMaxIndex);
    reader.readColorOrNumber("k", material.k, 0.0f, kMaxIndex);
    readParams(reader, blendParams(), material);
    if (const json* translucency = reader.find("translucency"); translucency != nullptr && !translucency->is_null())
        material.translucency = readTranslucency(*translucency, reader.place("translucency"), kind);
    if (const json* drives = reader.find("drives")) readDrives(*drives, reader.place("drives"), kind, masks, material);
    reader.finish(parameterHint(brdf));
    return material;
}

ordered_json writeMaterial(const Material& material, const std::function<std::string(const std::string&)>& filePath) {
    ordered_json result;
    const BrdfInfo* brdf = findBrdf(material);
    CORE_ASSERT(brdf != nullptr, "a material's BRDF is one of the list");
    result["brdf"] = material.brdf;
    if (material.brdfFile)
        result["brdf"] =
            std::string(kFilePrefix) + (filePath ? filePath(material.brdfFile->path) : material.brdfFile->path);
    result["albedo"] = toJson(material.albedo);
    result["specular"] = material.specular ? toJson(*material.specular) : json("estimated");
    for (std::size_t i = 0; brdf != nullptr && i < brdf->params.size(); ++i)
        if (material.values[i] != kNoValue) result[brdf->params[i].key] = toJson(material.values[i]);
    result["fresnel"] = wordOf(material.fresnel);
    const Metal* metal = brdf != nullptr && brdf->usesSpecular ? metalOf(material) : nullptr;
    if (metal != nullptr) {
        result["metal"] = metal->key;
    } else {
        result["eta"] = toJson(material.eta);
        result["k"] = toJson(material.k);
    }
    writeParams(result, blendParams(), material);
    if (material.translucency) result["translucency"] = writeTranslucency(*material.translucency);
    if (!material.drives.empty()) result["drives"] = writeDrives(material, filePath);
    return result;
}

Material materialFromJson(const std::string& text) {
    MaskLoader masks;
    return readMaterial(parseJson(text, ErrorKind::Usage), "", ErrorKind::Usage, masks);
}

std::string materialToJson(const Material& material) { return writeMaterial(material).dump(); }

}  // namespace core
