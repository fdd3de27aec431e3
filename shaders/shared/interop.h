// SPDX-License-Identifier: GPL-3.0-or-later
// The vocabulary shared by GLSL and C++: what is written with it is compiled by glslang *and* by the C++ compiler.
//
// Common subset: no swizzles beyond single components, literals with f, functions marked KERNEL_FN, everything between
// KERNEL_BEGIN and KERNEL_END (namespace kernel in C++), no vec3, bool or arrays inside parameter blocks.
#ifndef PATINA_INTEROP_H
#define PATINA_INTEROP_H

#ifdef __cplusplus

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#define KERNEL_BEGIN namespace kernel {
#define KERNEL_END }
#define KERNEL_FN inline
#define KERNEL_OUT(type) type&
/// Checks that a parameter block has the size both languages agree on (std140: a multiple of 16).
#define KERNEL_BLOCK(type, size) static_assert(sizeof(type) == (size) && (size) % 16 == 0, "layout of " #type);

namespace kernel {

using uint = std::uint32_t;

struct alignas(8) vec2 {
    float x = 0, y = 0;
    vec2() = default;
    vec2(float x_, float y_) : x(x_), y(y_) {}
    explicit vec2(float s) : x(s), y(s) {}
};
struct vec3 {
    float x = 0, y = 0, z = 0;
    vec3() = default;
    vec3(float x_, float y_, float z_) : x(x_), y(y_), z(z_) {}
    explicit vec3(float s) : x(s), y(s), z(s) {}
};
struct alignas(16) vec4 {
    float x = 0, y = 0, z = 0, w = 0;
    vec4() = default;
    vec4(float x_, float y_, float z_, float w_) : x(x_), y(y_), z(z_), w(w_) {}
    vec4(vec3 v, float w_) : x(v.x), y(v.y), z(v.z), w(w_) {}
    explicit vec4(float s) : x(s), y(s), z(s), w(s) {}
};
struct alignas(8) uvec2 {
    uint x = 0, y = 0;
    uvec2() = default;
    uvec2(uint x_, uint y_) : x(x_), y(y_) {}
};
struct uvec3 {
    uint x = 0, y = 0, z = 0;
    uvec3() = default;
    uvec3(uint x_, uint y_, uint z_) : x(x_), y(y_), z(z_) {}
};
struct alignas(16) uvec4 {
    uint x = 0, y = 0, z = 0, w = 0;
    uvec4() = default;
    uvec4(uint x_, uint y_, uint z_, uint w_) : x(x_), y(y_), z(z_), w(w_) {}
};

inline vec2 operator+(vec2 a, vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline vec2 operator-(vec2 a, vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline vec2 operator*(vec2 a, float s) { return {a.x * s, a.y * s}; }
inline vec2 operator*(float s, vec2 a) { return a * s; }
inline vec3 operator-(vec3 a) { return {-a.x, -a.y, -a.z}; }
inline vec3 operator+(vec3 a, vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline vec3 operator-(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline vec3 operator*(vec3 a, vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline vec3 operator/(vec3 a, vec3 b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
inline vec3 operator*(vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
inline vec3 operator*(float s, vec3 a) { return a * s; }
inline vec3 operator/(vec3 a, float s) { return {a.x / s, a.y / s, a.z / s}; }
inline vec3& operator+=(vec3& a, vec3 b) { return a = a + b; }
inline vec3& operator*=(vec3& a, vec3 b) { return a = a * b; }
inline vec3& operator*=(vec3& a, float s) { return a = a * s; }

inline float dot(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }
inline float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline vec3 cross(vec3 a, vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline float length(vec3 a) { return std::sqrt(dot(a, a)); }
inline vec3 normalize(vec3 a) { return a / length(a); }

using std::abs;
using std::acos;
using std::asin;
using std::atan;
using std::ceil;
using std::cos;
using std::exp;
using std::floor;
using std::log;
using std::max;
using std::min;
using std::pow;
using std::sin;
using std::sqrt;
using std::tan;

inline float atan(float y, float x) { return std::atan2(y, x); }
inline float clamp(float v, float lo, float hi) { return std::min(std::max(v, lo), hi); }
inline float mix(float a, float b, float t) { return a + (b - a) * t; }
inline vec3 mix(vec3 a, vec3 b, float t) { return a + (b - a) * t; }
inline float fract(float v) { return v - std::floor(v); }
inline float sign(float v) { return v > 0 ? 1.0f : v < 0 ? -1.0f : 0.0f; }
inline vec3 max(vec3 a, vec3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }
inline vec3 min(vec3 a, vec3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
inline vec3 sqrt(vec3 a) { return {std::sqrt(a.x), std::sqrt(a.y), std::sqrt(a.z)}; }
inline vec3 exp(vec3 a) { return {std::exp(a.x), std::exp(a.y), std::exp(a.z)}; }

}  // namespace kernel

#else

#define KERNEL_BEGIN
#define KERNEL_END
#define KERNEL_FN
#define KERNEL_OUT(type) out type
#define KERNEL_BLOCK(type, size)

#endif

KERNEL_BEGIN
const float kPi = 3.14159265358979f;
const float kInvPi = 0.318309886183791f;

KERNEL_FN vec3 rgb(vec4 v) { return vec3(v.x, v.y, v.z); }
/// Rec.709 luminance of a scene-linear colour.
KERNEL_FN float luminance(vec3 c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }
KERNEL_END

#endif
