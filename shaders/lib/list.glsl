// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels that process a list in slices.
#ifndef PATINA_LIST_GLSL
#define PATINA_LIST_GLSL

// Index of this invocation in a list that a two-dimensional grid of workgroups covers (render::listGroups).
uint listIndex() { return gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x) + gl_GlobalInvocationID.x; }

// A value of a block or of the geometry that controls a branch or loop of a sliced kernel. Software drivers recompile a
// kernel for every slice as long as they recognise such a value as constant, whether it changes or not. min(v, v | id)
// equals v without being recognisable; gl_GlobalInvocationID merely serves as an unknown.
uint sliceValue(uint value) { return min(value, value | gl_GlobalInvocationID.x); }
float sliceValue(float value) { return uintBitsToFloat(sliceValue(floatBitsToUint(value))); }

#endif
