#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Declares the block whose layout is compared with C++; writes its members out so that values are compared too.
#extension GL_GOOGLE_include_directive : require
#include "tests/gpu/kernels/test_parameters.h"
layout(local_size_x = 1) in;
layout(std140, set = 0, binding = 0) uniform Block { TestBlock block; };
layout(std430, set = 0, binding = 1) writeonly buffer Result { float result[12]; };
void main() {
    result[0] = block.inner.first.x;
    result[1] = block.inner.first.w;
    result[2] = block.inner.second.y;
    result[3] = block.inner.third;
    result[4] = float(block.inner.fourth);
    result[5] = block.direction.x;
    result[6] = block.direction.y;
    result[7] = block.step;
    result[8] = float(block.count);
    result[9] = block.color.z;
    result[10] = float(block.flag);
    result[11] = block.pad2;
}
