// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels that walk a list in slices.
#ifndef PATINA_LIST_GLSL
#define PATINA_LIST_GLSL

// Index of this invocation in a list that a two-dimensional grid of workgroups covers (render::listGroups).
uint listIndex() { return gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x) + gl_GlobalInvocationID.x; }

// A value of a block or of the geometry that a branch or a loop of a sliced kernel depends on. As long as there is one
// that they can see, software drivers compile the kernel anew for every slice, whether the value changes or not;
// min(v, v | id) is v, but no constant. (gl_GlobalInvocationID is only there to be unknown.)
uint sliceValue(uint value) { return min(value, value | gl_GlobalInvocationID.x); }
float sliceValue(float value) { return uintBitsToFloat(sliceValue(floatBitsToUint(value))); }

#endif
