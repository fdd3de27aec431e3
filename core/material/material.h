// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/image.h"
#include "core/base/words.h"
#include "shaders/shared/param_info.h"

namespace core {

/// Fresnel factor of the specular lobe. None = `specular` at every angle; Schlick with F0 = `specular`; Dielectric and
/// Conductor from `eta` (and `k`), scaled by `specular`. The values are those of shaders/brdf/fresnel.h.
enum class Fresnel { None = 0, Schlick = 1, Dielectric = 2, Conductor = 3 };

template <>
struct Words<Fresnel> {
    static constexpr Word<Fresnel> table[] = {{Fresnel::None, "none"},
                                              {Fresnel::Schlick, "schlick"},
                                              {Fresnel::Dielectric, "dielectric"},
                                              {Fresnel::Conductor, "conductor"}};
};

/// Model of light below a surface: the dipole of [JMLH01], or the better dipole of [dEon12], which adds fluence to the
/// exitance and remains valid for absorbing media.
enum class ScatteringModel : std::uint8_t { Dipole, BetterDipole };

template <>
struct Words<ScatteringModel> {
    static constexpr Word<ScatteringModel> table[] = {
        {ScatteringModel::Dipole, "dipole", PARAM_LABEL("scene", "Dipole")},
        {ScatteringModel::BetterDipole, "better_dipole", PARAM_LABEL("scene", "Better dipole")}};
};

/// Multiple scattering below the surface, dipole diffusion (docs/method.md#translucency, [JMLH01]). Coefficients in
/// 1/mm as published; converted to 1/m once, in `profileFromTranslucency`.
struct Translucency {
    ScatteringModel model = ScatteringModel::Dipole;
    std::string preset;                          ///< name it was filled from, "" when set directly
    Vector3f sigmaA{0.0021f, 0.0041f, 0.0071f};  ///< absorption [1/mm]; default: marble
    Vector3f sigmaSPrime{2.19f, 2.62f, 3.00f};   ///< reduced scattering [1/mm]
    float eta = 1.3f;                            ///< relative index of refraction; 1 = index-matched (A = 1, F_t = 1)
    float scale = 1;   ///< multiplies every length of the object (2 = twice as large, less translucent)
    float weight = 1;  ///< factor on the translucent radiance

    bool operator==(const Translucency&) const = default;
};

class Mask;  // core/scene/mask.h

/// Source of a driven parameter: a mask, or how much brighter the photograph is than its surroundings
/// (core/analysis/texture_detail.cpp).
enum class DriveSource { Mask, Luminance };

template <>
struct Words<DriveSource> {
    static constexpr Word<DriveSource> table[] = {{DriveSource::Mask, "mask"}, {DriveSource::Luminance, "luminance"}};
};

/// Value of a parameter at one end of its source's range.
struct DriveEnd {
    Vector3f value{1, 1, 1};  ///< scalar parameters: three equal values
    bool factor = true;       ///< `value` multiplies the material's own value instead of replacing it

    bool operator==(const DriveEnd&) const = default;
};

/// One parameter that varies over the segment (core/shading/drive_table.h).
struct Drive {
    std::string parameter;  ///< key of core::driveParameters
    DriveSource source = DriveSource::Mask;
    std::shared_ptr<const Mask> mask;  ///< Mask only; may be shared by drives
    /// Values where the source is 0 and 1; nullopt = the material's own value. Luminance is 0.5 at its mean; with
    /// neither end set it multiplies the material's own value and preserves its mean over the segment.
    std::optional<DriveEnd> from, to;
    bool invert = false;
    float strength = 1;  ///< Mask: contrast around 0.5; Luminance: amplitude of the detail; >= 0

    bool operator==(const Drive&) const = default;
};

/// Material::brdf of a BRDF defined by a file.
inline constexpr const char* kFileBrdf = "file";

/// Maximum number of scalar parameters in a BRDF's table (shaders/brdf/*.h).
inline constexpr int kBrdfValueCount = 12;

struct BrdfFile;

/// The material that an edit gives a segment.
struct Material {
    std::string brdf = "ggx";  ///< key in shaders/brdf/registry.h; "none" reflects nothing
    /// The file that defines the BRDF where `brdf` is kFileBrdf.
    std::shared_ptr<const BrdfFile> brdfFile;
    Vector3f albedo{0.5f, 0.5f, 0.5f};            ///< diffuse albedo, [0, 1]
    std::optional<Vector3f> specular;             ///< specular colour; nullopt = the segment's estimated reflectance ρ
    std::array<float, kBrdfValueCount> values{};  ///< the BRDF's own parameters, in its table's order
    Fresnel fresnel = Fresnel::None;
    Vector3f eta{1.5f, 1.5f, 1.5f};  ///< index of refraction (real part), for Dielectric and Conductor
    Vector3f k{0, 0, 0};             ///< extinction coefficient, for Conductor
    float blendNew = 1;              ///< weight of the re-shaded radiance
    float blendOriginal = 0;         ///< weight of the photograph
    std::optional<Translucency> translucency;
    std::vector<Drive> drives;  ///< at most one per parameter

    bool operator==(const Material&) const = default;
};

}  // namespace core
