#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Half a sweep of red-black over-relaxation of Laplace's equation on the sphere: all texels of one colour, which depend
// on the other colour only. Twin of core::analysis::relaxMembrane.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/list.glsl"
#include "shaders/shared/relax_membrane_block.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Block { RelaxMembraneBlock block; };
layout(set = 0, binding = RELAX_MEMBRANE_ROWS) readonly buffer Rows { vec4 rows[]; };
layout(set = 0, binding = RELAX_MEMBRANE_VALUES) buffer Values { vec4 values[]; };

void main() {
    uint index = listIndex();
    uint width = block.width;
    uint y = index / (width / 2u);
    if (y >= block.height) return;
    uint x = 2u * (index % (width / 2u)) + ((y + block.parity) & 1u);
    vec4 value = values[y * width + x];
    if (value.w > 0.0) return;
    vec4 row = rows[y];
    vec3 sum = row.z * (values[y * width + (x + 1u) % width].xyz + values[y * width + (x + width - 1u) % width].xyz);
    if (y > 0u) sum += row.x * values[(y - 1u) * width + x].xyz;
    if (y + 1u < block.height) sum += row.y * values[(y + 1u) * width + x].xyz;
    values[y * width + x].xyz = value.xyz + block.overRelaxation * (row.w * sum - value.xyz);
}
