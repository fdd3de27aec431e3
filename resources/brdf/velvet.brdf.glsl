// SPDX-License-Identifier: GPL-3.0-or-later
// Velvet: a matt cloth whose fibres stand up and light up at grazing angles.
// Fibres: Estevez and Kulla, "Production friendly microfacet sheen BRDF", 2017, with the visibility term of Neubelt and
// Pettineo, 2013. docs/user-brdfs.md explains what a file like this consists of.

uniform vec3 albedo;
uniform float sheen = 0.6;       // 0 to 1, "Sheen"
uniform float roughness = 0.35;  // 0.15 to 1, "Fibre roughness"

// Density of fibres whose normal is h [1/sr].
float fibres(vec3 h) {
    float sine = sqrt(max(1.0 - h.z * h.z, 0.0));
    return (2.0 + 1.0 / roughness) * pow(sine, 1.0 / roughness) * 0.5 * kInvPi;
}

vec3 evaluate(vec3 wo, vec3 wi) {
    vec3 h = normalize(wo + wi);
    float cloth = fibres(h) / (4.0 * (wo.z + wi.z - wo.z * wi.z));
    // The pile is as bright as the cloth below, but paler.
    vec3 pile = mix(albedo, sqrt(albedo), 0.5);
    return albedo * kInvPi * (1.0 - sheen) + pile * sheen * cloth;
}

// Half of the sheen is spread evenly over the hemisphere, the rest follows the cosine.
float pdf(vec3 wo, vec3 wi) {
    return mix(wi.z * kInvPi, 0.5 * kInvPi, 0.5 * sheen);
}

vec3 sample(vec3 wo, vec2 u) {
    if (u.x >= 0.5 * sheen) {
        u.x = min((u.x - 0.5 * sheen) / (1.0 - 0.5 * sheen), 0.99999994);
        return sample_cosine_hemisphere(u);
    }
    float z = max(u.x / (0.5 * sheen), 1e-6);
    float r = sqrt(max(1.0 - z * z, 0.0));
    float phi = 2.0 * kPi * u.y;
    return vec3(r * cos(phi), r * sin(phi), z);
}
