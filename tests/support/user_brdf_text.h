// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of .brdf.glsl files, made by replacing parts of a valid one.
#pragma once

#include <stdexcept>
#include <string>

namespace test {

inline const std::string kMattBrdf = R"(uniform vec3 albedo;
vec3 evaluate(vec3 wo, vec3 wi) { return albedo * kInvPi; }
float pdf(vec3 wo, vec3 wi) { return wi.z * kInvPi; }
vec3 sample(vec3 wo, vec2 u) { return sample_cosine_hemisphere(u); }
)";

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    if (at == std::string::npos) throw std::logic_error("\"" + what + "\" is not in the text");
    return text.replace(at, what.size(), by);
}

/// With this body of evaluate(), in line 2; pdf(), in line 3; or sample(), in line 4.
inline std::string evaluating(const std::string& body) { return replaced(kMattBrdf, "return albedo * kInvPi;", body); }
inline std::string withPdf(const std::string& body) { return replaced(kMattBrdf, "return wi.z * kInvPi;", body); }
inline std::string sampling(const std::string& body) {
    return replaced(kMattBrdf, "return sample_cosine_hemisphere(u);", body);
}

}  // namespace test
