#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Adds each value to one of 16 sums with integer atomics.
layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Values { uint values[]; };
layout(std430, set = 0, binding = 1) buffer Sums { uint sums[16]; };
layout(push_constant) uniform Immediates { uint count; } immediates;
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < immediates.count) atomicAdd(sums[values[i] % 16u], values[i]);
}
