#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Samples a texture at the centre of each of 4 output cells, with a combined and with a separate sampler.
layout(local_size_x = 4) in;
layout(set = 0, binding = 0) uniform sampler2D combined;
layout(set = 0, binding = 1) uniform texture2D separateTexture;
layout(set = 0, binding = 2) uniform sampler separateSampler;
layout(std430, set = 0, binding = 3) writeonly buffer Result { vec4 result[8]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    vec2 uv = vec2((float(i) + 0.5) / 4.0, 0.5);
    result[i] = textureLod(combined, uv, 0.0);
    result[4 + i] = textureLod(sampler2D(separateTexture, separateSampler), uv, 0.0);
}
