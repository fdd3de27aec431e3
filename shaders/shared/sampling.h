// SPDX-License-Identifier: GPL-3.0-or-later
// Directions from uniform numbers, and the shading frame.
#ifndef PATINA_SAMPLING_H
#define PATINA_SAMPLING_H

#include "shaders/shared/interop.h"

KERNEL_BEGIN

/// Unit direction with density cos θ / π around +z; z > 0 always.
KERNEL_FN vec3 sample_cosine_hemisphere(vec2 u) {
    float r = sqrt(u.x);
    float phi = 2.0f * kPi * u.y;
    return vec3(r * cos(phi), r * sin(phi), sqrt(max(1.0f - u.x, 1e-12f)));
}

/// First tangent of the shading frame of unit `n`: the camera's x axis projected onto the tangent plane, so that
/// anisotropy runs the same way over the whole picture (arbitrary where n = ±x). The second is `frame_v` = n × u.
KERNEL_FN vec3 frame_u(vec3 n) {
    float s = sqrt(n.y * n.y + n.z * n.z);
    if (s < 1e-6f) return vec3(0.0f, 0.0f, -sign(n.x));
    float a = -n.x / s;
    return vec3(s, n.y * a, n.z * a);
}
KERNEL_FN vec3 frame_v(vec3 n) {
    float s = sqrt(n.y * n.y + n.z * n.z);
    if (s < 1e-6f) return vec3(0.0f, 1.0f, 0.0f);
    return vec3(0.0f, n.z / s, -n.y / s);
}

/// A direction of the shading frame, seen from the frame turned by `degrees` about the normal (u towards v).
KERNEL_FN vec3 turn_frame(vec3 w, float degrees) {
    float a = degrees * (kPi / 180.0f);
    float c = cos(a);
    float s = sin(a);
    return vec3(c * w.x + s * w.y, c * w.y - s * w.x, w.z);
}

/// From camera space into the shading frame of normal `n` (n becomes +z), and back.
KERNEL_FN vec3 to_local(vec3 n, vec3 d) { return vec3(dot(d, frame_u(n)), dot(d, frame_v(n)), dot(d, n)); }
KERNEL_FN vec3 from_local(vec3 n, vec3 d) { return frame_u(n) * d.x + frame_v(n) * d.y + n * d.z; }

/// Least cosine between a shading normal and the direction it is seen from.
const float kMinShadingCosine = 0.01f;

/// The normal to shade with: `n`, tilted towards `wo` as far as needed for n·wo >= kMinShadingCosine. Normals that
/// point away from the viewer occur at silhouettes and on noisy depth; a hard flip there would flicker.
KERNEL_FN vec3 shading_normal(vec3 n, vec3 wo) {
    float c = dot(n, wo);
    if (c >= kMinShadingCosine) return n;
    vec3 t = n - wo * c;
    float l2 = dot(t, t);
    if (l2 < 1e-12f) return wo;
    return t * (sqrt((1.0f - kMinShadingCosine * kMinShadingCosine) / l2)) + wo * kMinShadingCosine;
}

KERNEL_END

#endif
