#version 450
#extension GL_EXT_samplerless_texture_functions : require
// SPDX-License-Identifier: GPL-3.0-or-later
// Shows a texture, scaled, texel for pixel.
layout(set = 0, binding = 0) uniform texture2D picture;
layout(push_constant) uniform Immediates { float gain; } immediates;
layout(location = 0) out vec4 color;
void main() { color = immediates.gain * texelFetch(picture, ivec2(gl_FragCoord.xy), 0); }
