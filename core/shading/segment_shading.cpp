// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shading/segment_shading.h"

#include "core/base/kernel_types.h"
#include "core/material/brdf.h"
#include "core/material/diffusion_profile.h"
#include "core/material/translucency.h"

namespace core {
namespace {

kernel::SegmentShading shadingOf(const Segment& segment, const Analysis& analysis) {
    kernel::SegmentShading s;
    s.blend = {1, 0, 0, 0};
    if (!segment.edit || !usable(*segment.edit)) {
        if (!segment.glossy) return s;
        Material mirror = defaultMaterial(*findBrdf("ggx"));
        const Reflectance* found = analysis.findReflectance(segment.label);
        mirror.values[0] = found != nullptr ? found->alpha : Reflectance().alpha;
        mirror.fresnel = Fresnel::None;
        s.brdf = toKernel(mirror, specularOf(segment, analysis));
        s.blend.w = 1;
        return s;
    }
    const Material& material = *segment.edit;
    s.brdf = toKernel(material, specularOf(segment, analysis));
    s.blend = {material.blendNew, material.blendOriginal, 0, 1};
    s.diffuse.w = 1;
    if (material.translucency) {
        const Vector3f albedo = translucentAlbedo(*material.translucency) * material.translucency->weight;
        s.diffuse = kernel::vec4(toKernel(albedo), 1);
        s.blend.z = material.brdf == "none" ? 1.0f : 0.5f;
    }
    return s;
}

}  // namespace

Vector3f translucentAlbedo(const Translucency& translucency) {
    // Light crosses the boundary twice; its mean transmission is η²(1 − F_dr) by reciprocity.
    const auto eta = static_cast<double>(profileFromTranslucency(translucency).eta);
    const auto transmission = static_cast<float>(eta * eta * (1 - internalDiffuseFresnel(eta)));
    return diffuseReflectance(translucency) * (transmission * transmission);
}

Vector3f specularOf(const Segment& segment, const Analysis& analysis) {
    if (segment.reflectance) return *segment.reflectance;
    const Reflectance* estimated = analysis.findReflectance(segment.label);
    return estimated != nullptr ? estimated->rho : Vector3f(1, 1, 1);
}

std::vector<kernel::SegmentShading> buildSegmentShading(const Scene& scene, const Analysis& analysis) {
    const std::size_t count = scene.segments.empty() ? 1 : std::size_t{scene.segments.back().label} + 1;
    kernel::SegmentShading untouched;
    untouched.blend = {1, 0, 0, 0};
    std::vector<kernel::SegmentShading> result(count, untouched);
    for (const Segment& segment : scene.segments) result[segment.label] = shadingOf(segment, analysis);
    return result;
}

std::vector<std::uint8_t> editedLabels(std::span<const kernel::SegmentShading> shading) {
    std::vector<std::uint8_t> edited(shading.size());
    for (std::size_t label = 0; label < edited.size(); ++label) edited[label] = shading[label].diffuse.w != 0 ? 1 : 0;
    return edited;
}

}  // namespace core
