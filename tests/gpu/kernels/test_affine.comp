#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// out = scale * in + offset: the ping-pong step.
layout(local_size_x_id = 0) in;
layout(constant_id = 1) const uint kOffset = 1u;
layout(std430, set = 0, binding = 0) readonly buffer Source { uint source[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Target { uint target[]; };
layout(std140, set = 0, binding = 2) uniform Params { uint scale; uint count; } params;
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < params.count) target[i] = source[i] * params.scale + kOffset;
}
