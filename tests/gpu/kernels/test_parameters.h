// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef PATINA_TEST_PARAMETERS_H
#define PATINA_TEST_PARAMETERS_H
#include "shaders/shared/interop.h"

KERNEL_BEGIN

struct TestInner {
    vec4 first;
    vec2 second;
    float third;
    uint fourth;
};
KERNEL_BLOCK(TestInner, 32)

struct TestBlock {
    TestInner inner;
    vec2 direction;
    float step;
    uint count;
    vec4 color;
    int flag;
    float pad0;
    float pad1;
    float pad2;
};
KERNEL_BLOCK(TestBlock, 80)

KERNEL_END

#endif
