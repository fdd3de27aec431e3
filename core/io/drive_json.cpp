// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/drive_json.h"

#include <algorithm>
#include <vector>

#include "core/io/json_reader.h"
#include "core/material/drive_parameters.h"

namespace core {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

constexpr float kMaxFactor = 100;
constexpr float kMaxStrength = 100;

/// Value of a scalar; for a colour, [r, g, b] or a factor on the material's own.
std::optional<DriveEnd> readEnd(JsonReader& reader, const char* key, const DriveParameter& parameter) {
    const json* value = reader.find(key);
    if (value == nullptr) return std::nullopt;
    DriveEnd end;
    float number = 1;
    if (!parameter.color) {
        reader.read(key, number, parameter.min, parameter.max);
        end.factor = false;
        end.value.setConstant(number);
    } else if (value->is_number()) {
        reader.read(key, number, 0.0f, kMaxFactor);
        end.value.setConstant(number);
    } else {
        if (!value->is_array())
            reader.fail(key, Message("messages", "a color [r, g, b] or a number, the factor on the edit's own"),
                        *value);
        end.factor = false;
        reader.read(key, end.value, parameter.min, parameter.max);
    }
    return end;
}

/// Writes factors as such for colours only; scalars are multiplied out.
json writeEnd(const DriveEnd& end, const DriveParameter& parameter, const Material& material) {
    if (parameter.color) return end.factor ? json(toJson(end.value.x())) : toJson(end.value);
    const float own = ownValue(material, parameter, Vector3f::Ones()).x();
    return toJson(end.factor ? end.value.x() * own : end.value.x());
}

Drive readDrive(const json& value, const std::string& place, ErrorKind kind, MaskLoader& masks,
                const std::vector<DriveParameter>& parameters) {
    JsonReader reader(value, place, kind);
    std::vector<std::string> keys;
    keys.reserve(parameters.size());
    for (const DriveParameter& p : parameters) keys.push_back(p.key);
    reader.require("parameter");
    const DriveParameter& parameter = parameters[*reader.readChoice("parameter", keys)];
    Drive drive;
    drive.parameter = parameter.key;
    reader.readWord("source", drive.source);
    if (drive.source == DriveSource::Mask) {
        reader.require("mask");
        std::string path;
        reader.read("mask", path);
        if (path.empty())
            reader.fail(
                Message("messages", "\"%1\" is empty, expected the path of an image.").with(reader.place("mask")));
        drive.mask = masks.load(path);
    }
    drive.from = readEnd(reader, "from", parameter);
    drive.to = readEnd(reader, "to", parameter);
    if (drive.source == DriveSource::Mask && !drive.from && !drive.to)
        reader.fail(
            Message("messages", "\"%1\" needs \"from\" or \"to\": the values of \"%2\" where the mask is 0 and 1.")
                .with(place, drive.parameter));
    reader.read("invert", drive.invert);
    reader.read(drive.source == DriveSource::Mask ? "contrast" : "strength", drive.strength, 0.0f, kMaxStrength);
    reader.finish();
    return drive;
}

}  // namespace

void readDrives(const json& list, const std::string& place, ErrorKind kind, MaskLoader& masks, Material& material) {
    if (!list.is_array()) throw Error(kind, Message("messages", "\"%1\" is not a list [...].").with(place));
    const std::vector<DriveParameter> parameters = driveParameters(material);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string at = place + "[" + std::to_string(i) + "]";
        Drive drive = readDrive(list[i], at, kind, masks, parameters);
        if (std::ranges::find(material.drives, drive.parameter, &Drive::parameter) != material.drives.end())
            throw Error(kind, Message("messages", "\"%1.parameter\" is \"%2\", which has a drive already.")
                                  .with(at, drive.parameter));
        material.drives.push_back(std::move(drive));
    }
}

ordered_json writeDrives(const Material& material, const std::function<std::string(const std::string&)>& filePath) {
    const std::vector<DriveParameter> parameters = driveParameters(material);
    ordered_json list = ordered_json::array();
    for (const Drive& drive : material.drives) {
        const auto parameter = std::ranges::find(parameters, drive.parameter, &DriveParameter::key);
        if (parameter == parameters.end()) continue;
        ordered_json entry;
        entry["parameter"] = drive.parameter;
        entry["source"] = wordOf(drive.source);
        const bool mask = drive.source == DriveSource::Mask;
        if (mask && drive.mask != nullptr) entry["mask"] = filePath ? filePath(drive.mask->path()) : drive.mask->path();
        if (drive.from) entry["from"] = writeEnd(*drive.from, *parameter, material);
        if (drive.to) entry["to"] = writeEnd(*drive.to, *parameter, material);
        entry["invert"] = drive.invert;
        entry[mask ? "contrast" : "strength"] = toJson(drive.strength);
        list.push_back(std::move(entry));
    }
    return list;
}

}  // namespace core
