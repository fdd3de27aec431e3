// SPDX-License-Identifier: GPL-3.0-or-later
// Shows a scene-linear (or display-encoded) picture: pan, zoom, exposure, sRGB, the selected segment's outline.
// Filtering is done here, in linear light, because 32-bit floats need not be filterable: nearest from 200 %, bilinear
// from 100 %, box filter below.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

#include "shaders/shared/canvas_block.h"

layout(set = 0, binding = CANVAS_PICTURE) uniform texture2D picture;
layout(set = 0, binding = CANVAS_LABELS) uniform utexture2D labels;
layout(push_constant) uniform Block { CanvasBlock block; };
layout(location = 0) out vec4 target;

const vec3 kSurround = vec3(0.033);  // linear; a neutral dark grey

const int kMaxTaps = 8;

vec3 texel(ivec2 p, ivec2 size) {
    vec3 c = texelFetch(picture, clamp(p, ivec2(0), size - 1), 0).rgb;
    return mix(c, vec3(0.0), isnan(c));
}

vec3 filtered(vec2 p, ivec2 size) {
    if (block.step <= 0.5) return texel(ivec2(floor(p)), size);
    if (block.step <= 1.0) {
        vec2 q = p - 0.5;
        ivec2 i = ivec2(floor(q));
        vec2 f = q - vec2(i);
        vec3 top = mix(texel(i, size), texel(i + ivec2(1, 0), size), f.x);
        vec3 bottom = mix(texel(i + ivec2(0, 1), size), texel(i + ivec2(1, 1), size), f.x);
        return mix(top, bottom, f.y);
    }
    int taps = min(int(ceil(block.step)), kMaxTaps);
    vec3 sum = vec3(0.0);
    for (int y = 0; y < taps; ++y) {
        for (int x = 0; x < taps; ++x) {
            vec2 offset = (vec2(x, y) + 0.5) / float(taps) - 0.5;
            sum += texel(ivec2(floor(p + offset * block.step)), size);
        }
    }
    return sum / float(taps * taps);
}

vec3 encode(vec3 c) {
    c = clamp(c, vec3(0.0), vec3(1.0));
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}

vec3 decode(vec3 c) {
    return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, lessThanEqual(c, vec3(0.04045)));
}

bool isSelected(vec2 p) {
    ivec2 size = textureSize(labels, 0);
    ivec2 i = ivec2(floor(p));
    if (any(lessThan(i, ivec2(0))) || any(greaterThanEqual(i, size))) return false;
    return texelFetch(labels, i, 0).r == block.selected;
}

void main() {
    ivec2 size = textureSize(picture, 0);
    vec2 p = block.origin + gl_FragCoord.xy * block.step;
    bool inside = all(greaterThanEqual(p, vec2(0.0))) && all(lessThan(p, vec2(size)));
    vec3 display = encode(kSurround);
    if (inside) {
        vec3 c = filtered(p, size);
        display = (block.flags & CANVAS_PICTURE_ENCODED) != 0u ? clamp(c, vec3(0.0), vec3(1.0)) : encode(c * block.gain);
    }
    if ((block.flags & CANVAS_OUTLINE) != 0u) {
        bool here = isSelected(p);
        float reach = 1.5 * block.step;
        bool border = false;
        for (int i = 0; i < 8; ++i) {
            float angle = float(i) * (kPi / 4.0);
            border = border || isSelected(p + reach * vec2(cos(angle), sin(angle))) != here;
        }
        if (border) display = here ? vec3(0.05) : vec3(1.0, 0.72, 0.30);
    }
    if ((block.flags & CANVAS_TARGET_ENCODES) != 0u) display = decode(display);
    target = vec4(display, 1.0);
}
