#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Writes one value where the push constants say; the block is as large as push constants may be.
layout(local_size_x = 1) in;
layout(std430, set = 0, binding = 0) writeonly buffer Result { uint result[]; };
layout(push_constant) uniform Push { uint index; uint value; uint more[30]; } push;
void main() { result[push.index] = push.value + push.more[29]; }
