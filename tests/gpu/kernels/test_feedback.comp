#version 450
// SPDX-License-Identifier: GPL-3.0-or-later
// Adds 1 to every texel in place: reads and writes one storage image.
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) uniform image2D picture;
void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, imageSize(picture)))) return;
    imageStore(picture, p, imageLoad(picture, p) + vec4(1.0));
}
