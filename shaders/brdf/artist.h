// SPDX-License-Identifier: GPL-3.0-or-later
// A model for artists, with the parameters of Disney's [Bur12], but layered so that it is reciprocal and never
// reflects more than it receives: clear coat over sheen over a mixture of metal (GGX, F0 = base colour) and dielectric
// (GGX, F0 = 0.08 · specular, over a coupled diffuse part [SHH+97]). What a layer reflects is taken from those below.
#ifndef PATINA_BRDF_ARTIST_H
#define PATINA_BRDF_ARTIST_H

#include "shaders/brdf/microfacet.h"
#include "shaders/shared/brdf_params.h"
#include "shaders/shared/param_info.h"
#include "shaders/shared/sampling.h"

KERNEL_BEGIN

/// The parameters as the lobes need them.
struct ArtistLobes {
    vec2 alpha;       // of the base's specular lobe
    vec2 coatAlpha;   // of the clear coat
    vec3 f0;          // of the base's specular lobe
    vec3 diffuse;     // albedo of the diffuse part
    vec3 sheen;       // albedo of the sheen at grazing angles
    float f0Diffuse;  // of the boundary the diffuse part lies under
    float coat;       // strength of the clear coat, [0, 1]
};

KERNEL_FN ArtistLobes artist_lobes(BrdfParams b) {
    vec3 base = rgb(b.albedo);
    float metallic = clamp(b.values.x, 0.0f, 1.0f);
    float roughness = clamp(b.values.y, 0.0f, 1.0f);
    float specular = clamp(b.values.z, 0.0f, 1.0f);
    float aspect = sqrt(1.0f - 0.9f * clamp(b.values.w, 0.0f, 1.0f));
    float coatRoughness = clamp(b.values3.x, 0.0f, 1.0f);
    float alpha = roughness * roughness;
    ArtistLobes l;
    l.alpha = vec2(clamp(alpha / aspect, kGgxMinAlpha, 1.0f), max(alpha * aspect, kGgxMinAlpha));
    l.coatAlpha = vec2(max(coatRoughness * coatRoughness, kGgxMinAlpha));
    l.f0Diffuse = 0.08f * specular;
    l.f0 = mix(vec3(l.f0Diffuse), base, metallic);
    l.diffuse = base * (1.0f - metallic);
    vec3 tint = base / max(max(base.x, max(base.y, base.z)), 1e-4f);
    l.sheen = mix(vec3(1.0f), tint, clamp(b.values2.z, 0.0f, 1.0f)) * clamp(b.values2.y, 0.0f, 1.0f);
    l.coat = clamp(b.values2.w, 0.0f, 1.0f);
    return l;
}

/// Schlick's weight (1 − c)⁵ of grazing reflection.
KERNEL_FN float artist_grazing(float c) {
    float m = 1.0f - clamp(c, 0.0f, 1.0f);
    return m * m * m * m * m;
}

/// What the clear coat reflects at cosine `c`; index 1.5.
KERNEL_FN float artist_coat(ArtistLobes l, float c) { return l.coat * (0.04f + 0.96f * artist_grazing(c)); }

/// Share of the sheen's grazing albedo at cosine `c`: the lobe is separable, so this is its albedo exactly.
KERNEL_FN float artist_sheen(float c) {
    float m = 1.0f - clamp(c, 0.0f, 1.0f);
    return m * m * m * m;
}

/// What sheen and clear coat let pass at cosine `c`.
KERNEL_FN float artist_pass(ArtistLobes l, float c) {
    float sheen = max(l.sheen.x, max(l.sheen.y, l.sheen.z));
    return (1.0f - artist_coat(l, c)) * (1.0f - sheen * artist_sheen(c));
}

/// What the boundary over the diffuse part lets pass at cosine `c`.
KERNEL_FN float artist_transmission(ArtistLobes l, float c) {
    return 1.0f - (l.f0Diffuse + (1.0f - l.f0Diffuse) * artist_grazing(c));
}

/// Probabilities of sampling clear coat (x), base lobe (y), and diffuse with sheen (z).
KERNEL_FN vec3 artist_shares(ArtistLobes l, float c) {
    float coat = artist_coat(l, c);
    float g = artist_grazing(c);
    float f0 = (l.f0.x + l.f0.y + l.f0.z) / 3.0f;
    float specular = (1.0f - coat) * (f0 + (1.0f - f0) * g) + 0.01f;
    float diffuse = (l.diffuse.x + l.diffuse.y + l.diffuse.z) / 3.0f * artist_transmission(l, c);
    float sheen = (l.sheen.x + l.sheen.y + l.sheen.z) / 3.0f * artist_sheen(c);
    float body = (1.0f - coat) * (diffuse + sheen) + 0.01f;
    return vec3(coat, specular, body) / (coat + specular + body);
}

KERNEL_FN vec3 artist_eval_lobes(ArtistLobes l, vec3 wo, vec3 wi) {
    float hi = 0.5f * length(wo + wi);
    float g = artist_grazing(hi);
    // 21/20: ∫ (1 − Schlick) 2c dc = (1 − F0) 20/21
    float coupled = 1.05f * artist_transmission(l, wo.z) * artist_transmission(l, wi.z) / (1.0f - l.f0Diffuse);
    vec3 base = l.diffuse * (coupled * kInvPi);
    base += (l.f0 + (vec3(1.0f) - l.f0) * g) * ggx_lobe(l.alpha, wo, wi);
    base *= artist_pass(l, wo.z) * artist_pass(l, wi.z);
    float coatPass = (1.0f - artist_coat(l, wo.z)) * (1.0f - artist_coat(l, wi.z));
    // 15: ∫ (1 − c)⁴ 2c dc = 1/15
    vec3 sheen = l.sheen * (15.0f * kInvPi * artist_sheen(wo.z) * artist_sheen(wi.z) * coatPass);
    return base + sheen + vec3(artist_coat(l, hi) * ggx_lobe(l.coatAlpha, wo, wi));
}

KERNEL_FN float artist_pdf_lobes(ArtistLobes l, vec3 wo, vec3 wi) {
    vec3 share = artist_shares(l, wo.z);
    return share.x * ggx_lobe_pdf(l.coatAlpha, wo, wi) + share.y * ggx_lobe_pdf(l.alpha, wo, wi) +
           share.z * wi.z * kInvPi;
}

KERNEL_FN vec3 artist_eval(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    return artist_eval_lobes(artist_lobes(b), turn_frame(wo, b.values2.x), turn_frame(wi, b.values2.x));
}

KERNEL_FN float artist_pdf(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return 0.0f;
    return artist_pdf_lobes(artist_lobes(b), turn_frame(wo, b.values2.x), turn_frame(wi, b.values2.x));
}

KERNEL_FN vec3 artist_sample(BrdfParams b, vec3 wo, vec2 u) {
    if (wo.z <= 0.0f) return vec3(0.0f, 0.0f, -1.0f);
    ArtistLobes l = artist_lobes(b);
    vec3 share = artist_shares(l, wo.z);
    vec3 local = turn_frame(wo, b.values2.x);
    vec3 wi;
    if (u.x < share.x) {
        wi = ggx_lobe_sample(l.coatAlpha, local, vec2(u.x / share.x, u.y));
    } else if (u.x < share.x + share.y) {
        wi = ggx_lobe_sample(l.alpha, local, vec2(min((u.x - share.x) / share.y, 0.99999994f), u.y));
    } else {
        float x = (u.x - share.x - share.y) / share.z;
        wi = sample_cosine_hemisphere(vec2(clamp(x, 0.0f, 0.99999994f), u.y));
    }
    return turn_frame(wi, -b.values2.x);
}

KERNEL_FN vec3 artist_weight(BrdfParams b, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) return vec3(0.0f);
    ArtistLobes l = artist_lobes(b);
    vec3 o = turn_frame(wo, b.values2.x);
    vec3 i = turn_frame(wi, b.values2.x);
    return artist_eval_lobes(l, o, i) * (wi.z / max(artist_pdf_lobes(l, o, i), 1e-30f));
}

KERNEL_END

#ifdef __cplusplus
inline constexpr core::ParamInfo artist_params[] = {
    {"metallic", PARAM_LABEL("params", "Metallic"), "", 0.0f, 1.0f, 0.0f, false},
    {"roughness", PARAM_LABEL("params", "Roughness"), "", 0.1f, 1.0f, 0.4f, false},
    {"specular_level", PARAM_LABEL("params", "Specular"), "", 0.0f, 1.0f, 0.5f, false},
    {"anisotropy", PARAM_LABEL("params", "Anisotropy"), "", 0.0f, 1.0f, 0.0f, false},
    {"rotation", PARAM_LABEL("params", "Rotation"), "°", 0.0f, 180.0f, 0.0f, false},
    {"sheen", PARAM_LABEL("params", "Sheen"), "", 0.0f, 1.0f, 0.0f, false},
    {"sheen_tint", PARAM_LABEL("params", "Sheen tint"), "", 0.0f, 1.0f, 0.5f, false},
    {"clearcoat", PARAM_LABEL("params", "Clear coat"), "", 0.0f, 1.0f, 0.0f, false},
    {"clearcoat_roughness", PARAM_LABEL("params", "Clear coat roughness"), "", 0.1f, 1.0f, 0.1f, false}};
inline constexpr core::BrdfTable artist_table = {PARAM_LABEL("brdfs", "Artist"), artist_params, true, false, 0};
#endif

#endif
