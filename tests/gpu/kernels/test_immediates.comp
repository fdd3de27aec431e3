#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Writes one value to the index given in the immediates, which have the maximum size.
layout(local_size_x = 1) in;
layout(std430, set = 0, binding = 0) writeonly buffer Result { uint result[]; };
layout(push_constant) uniform Immediates { uint index; uint value; uint more[14]; } immediates;
void main() { result[immediates.index] = immediates.value + immediates.more[13]; }
