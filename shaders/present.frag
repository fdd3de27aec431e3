// SPDX-License-Identifier: GPL-3.0-or-later
// Copies the finished, display-encoded picture of the view into the window.
#version 450
#extension GL_EXT_samplerless_texture_functions : require

layout(set = 0, binding = 0) uniform texture2D screen;
layout(location = 0) out vec4 target;

// The swapchain's format is sRGB: the hardware applies the transfer function.
layout(constant_id = 0) const bool kTargetEncodes = false;

vec3 decode(vec3 c) {
    return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, lessThanEqual(c, vec3(0.04045)));
}

void main() {
    // While the window is being resized, the picture still has the old size.
    vec3 c = texelFetch(screen, min(ivec2(gl_FragCoord.xy), textureSize(screen, 0) - 1), 0).rgb;
    target = vec4(kTargetEncodes ? decode(c) : c, 1.0);
}
