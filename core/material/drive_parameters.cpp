// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/drive_parameters.h"

#include <algorithm>

#include "core/material/brdf.h"
#include "core/material/material_ranges.h"

namespace core {

std::vector<DriveParameter> driveParameters(const Material& material) {
    std::vector<DriveParameter> result;
    const BrdfInfo* brdf = findBrdf(material);
    if (brdf == nullptr) return result;
    for (std::size_t i = 0; i < brdf->params.size(); ++i) {
        const ParamInfo& param = brdf->params[i];
        result.push_back({param.key, param.label, false, param.min, param.max, static_cast<kernel::uint>(i)});
    }
    if (brdf->usesAlbedo) result.push_back({"albedo", "Diffuse colour", true, 0, 1, kernel::kDriveAlbedo});
    if (brdf->usesSpecular) {
        result.push_back({"specular", "Specular colour", true, 0, kMaxSpecular, kernel::kDriveSpecular});
        result.push_back({"eta", "Index n", true, kMinIndex, kMaxIndex, kernel::kDriveEta});
        result.push_back({"k", "Extinction k", true, 0, kMaxIndex, kernel::kDriveK});
    }
    result.push_back({"blend.new", "New", false, 0, kMaxWeight, kernel::kDriveBlendNew});
    result.push_back({"blend.original", "Photograph", false, 0, kMaxWeight, kernel::kDriveBlendOriginal});
    if (material.translucency)
        result.push_back(
            {"translucency.weight", "Translucency", false, 0, kMaxWeight, kernel::kDriveTranslucentWeight});
    return result;
}

std::vector<Drive> knownDrives(const std::vector<Drive>& drives, const Material& material) {
    const std::vector<DriveParameter> known = driveParameters(material);
    std::vector<Drive> result;
    for (const Drive& drive : drives)
        if (std::ranges::find(known, drive.parameter, &DriveParameter::key) != known.end()) result.push_back(drive);
    return result;
}

Vector3f ownValue(const Material& material, const DriveParameter& parameter, const Vector3f& estimatedSpecular) {
    switch (parameter.slot) {
        case kernel::kDriveAlbedo:
            return material.albedo;
        case kernel::kDriveSpecular:
            return material.specular.value_or(estimatedSpecular);
        case kernel::kDriveEta:
            return material.eta;
        case kernel::kDriveK:
            return material.k;
        case kernel::kDriveBlendNew:
            return Vector3f::Constant(material.blendNew);
        case kernel::kDriveBlendOriginal:
            return Vector3f::Constant(material.blendOriginal);
        case kernel::kDriveTranslucentWeight:
            return Vector3f::Constant(material.translucency ? material.translucency->weight : 0.0f);
        default:
            return Vector3f::Constant(material.values.at(parameter.slot));
    }
}

bool drivenByLuminance(const Material& material) {
    return std::ranges::any_of(material.drives, [](const Drive& d) { return d.source == DriveSource::Luminance; });
}

}  // namespace core
