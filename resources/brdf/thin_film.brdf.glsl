// SPDX-License-Identifier: GPL-3.0-or-later
// Thin film: a transparent layer some hundred nanometres thick on a dark, glossy base, whose two surfaces interfere:
// oil, a beetle, tempered steel. docs/user-brdfs.md explains what a file like this consists of.

uniform vec3 specular;
uniform float alpha = 0.08;       // 0.01 to 1, log, "Roughness"
uniform float thickness = 420.0;  // 50 to 1200 nm, "Film thickness"
uniform float film = 1.4;         // 1.05 to 2.5, "Film index"
uniform float base = 3.0;         // 1.05 to 4, "Base index"

// Wavelengths that stand for red, green and blue [nm].
const vec3 wavelengths = vec3(612.0, 549.0, 465.0);

// Amplitudes reflected where light passes from index a to b at cosines ca and cb, for both polarisations.
vec2 amplitudes(float a, float b, float ca, float cb) {
    return vec2((a * ca - b * cb) / (a * ca + b * cb), (b * ca - a * cb) / (b * ca + a * cb));
}

// Reflectance of the two surfaces with all reflections in between (Airy's sum).
vec3 reflectance(float cosine) {
    float sine2 = max(1.0 - cosine * cosine, 0.0);
    float inFilm = sqrt(max(1.0 - sine2 / (film * film), 0.0));
    float inBase = sqrt(max(1.0 - sine2 / (base * base), 0.0));
    vec2 outer = amplitudes(1.0, film, cosine, inFilm);
    vec2 inner = amplitudes(film, base, inFilm, inBase);
    vec3 c = cos(4.0 * kPi * film * thickness * inFilm / wavelengths);
    vec3 sum = vec3(0.0);
    for (int p = 0; p < 2; ++p) {
        float product = outer[p] * inner[p];
        float squares = outer[p] * outer[p] + inner[p] * inner[p];
        sum += (squares + 2.0 * product * c) / max(1.0 + product * product + 2.0 * product * c, vec3(1e-6));
    }
    return clamp(0.5 * sum, 0.0, 1.0);
}

vec3 evaluate(vec3 wo, vec3 wi) {
    vec3 h = normalize(wo + wi);
    return specular * reflectance(clamp(dot(wo, h), 0.0, 1.0)) * ggx_lobe(vec2(alpha), wo, wi);
}

float pdf(vec3 wo, vec3 wi) { return ggx_lobe_pdf(vec2(alpha), wo, wi); }

vec3 sample(vec3 wo, vec2 u) { return ggx_lobe_sample(vec2(alpha), wo, u); }
