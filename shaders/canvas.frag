// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a scene-linear (or display-encoded) picture display-encoded: pan, zoom, exposure, sRGB, the selected segment's
// outline.
// Filtering is done here, in linear light, because 32-bit floats need not be filterable: nearest from 200 %, bilinear
// from 100 %, box filter below; which of them is a specialization constant.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

#include "shaders/shared/canvas_block.h"

layout(set = 0, binding = CANVAS_PICTURE) uniform texture2D picture;
layout(set = 0, binding = CANVAS_LABELS) uniform utexture2D labels;
layout(set = 0, binding = CANVAS_MASK) uniform texture2D mask;
layout(set = 0, binding = CANVAS_RULER_IMAGE) uniform texture2D rulerImage;
layout(set = 0, binding = CANVAS_SELECTION_CODES) uniform texture2D selectionCodes;
layout(push_constant) uniform Block { CanvasBlock block; };
layout(location = 0) out vec4 target;

layout(constant_id = CANVAS_FILTER) const int kFilter = 0;
layout(constant_id = CANVAS_FLAGS) const uint kFlags = 0;

vec3 texel(ivec2 p, ivec2 size) {
    return texelFetch(picture, clamp(p, ivec2(0), size - 1), 0).rgb;
}

vec3 filtered(vec2 p, ivec2 size) {
    if (kFilter == 0) return texel(ivec2(floor(p)), size);
    if (kFilter == 1) {
        vec2 q = p - 0.5;
        ivec2 i = ivec2(floor(q));
        vec2 f = q - vec2(i);
        vec3 top = mix(texel(i, size), texel(i + ivec2(1, 0), size), f.x);
        vec3 bottom = mix(texel(i + ivec2(0, 1), size), texel(i + ivec2(1, 1), size), f.x);
        return mix(top, bottom, f.y);
    }
    vec3 sum = vec3(0.0);
    for (int y = 0; y < kFilter; ++y) {
        for (int x = 0; x < kFilter; ++x) {
            vec2 offset = (vec2(x, y) + 0.5) / float(kFilter) - 0.5;
            sum += texel(ivec2(floor(p + offset * block.step)), size);
        }
    }
    return sum / float(kFilter * kFilter);
}

vec3 encode(vec3 c) {
    c = clamp(c, vec3(0.0), vec3(1.0));
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}

bool isSelected(vec2 p) {
    ivec2 size = textureSize(labels, 0);
    ivec2 i = ivec2(floor(p));
    if (any(lessThan(i, ivec2(0))) || any(greaterThanEqual(i, size))) return false;
    return texelFetch(labels, i, 0).r == block.selected;
}

uint selectionCode(vec2 p) {
    ivec2 size = textureSize(selectionCodes, 0);
    ivec2 i = ivec2(floor(p));
    if (any(lessThan(i, ivec2(0))) || any(greaterThanEqual(i, size))) return 0u;
    return uint(texelFetch(selectionCodes, i, 0).r * 255.0 + 0.5);
}

// The selection tinted blue in a dashed outline; what would join it tinted white and what would leave it red, both in a
// plain outline.
vec3 withSelection(vec3 display, vec2 p) {
    uint here = selectionCode(p);
    uint around = 0u;
    float reach = 1.25 * block.step;
    around |= selectionCode(p + vec2(reach, 0.0)) ^ here;
    around |= selectionCode(p - vec2(reach, 0.0)) ^ here;
    around |= selectionCode(p + vec2(0.0, reach)) ^ here;
    around |= selectionCode(p - vec2(0.0, reach)) ^ here;
    if ((here & SELECTION_JOINS) != 0u) display = mix(display, vec3(1.0), 0.22);
    if ((here & SELECTION_LEAVES) != 0u) display = mix(display, vec3(0.9, 0.1, 0.1), 0.45);
    if (here == SELECTION_IS) display = mix(display, vec3(0.20, 0.55, 1.0), 0.30);
    if ((around & (SELECTION_JOINS | SELECTION_LEAVES)) != 0u) return here == 0u ? vec3(0.05) : vec3(1.0, 0.95, 0.75);
    if ((around & SELECTION_IS) != 0u)
        return mod(gl_FragCoord.x + gl_FragCoord.y, 8.0) < 4.0 ? vec3(0.02) : vec3(1.0);
    return display;
}

void main() {
    ivec2 size = textureSize(picture, 0);
    vec2 p = block.origin + gl_FragCoord.xy * block.step;
    bool inside = all(greaterThanEqual(p, vec2(0.0))) && all(lessThan(p, vec2(size)));
    vec3 c = filtered(p, size);
    c = mix(c, vec3(0.0), isnan(c));
    vec3 display = (kFlags & CANVAS_PICTURE_ENCODED) != 0u ? clamp(c, vec3(0.0), vec3(1.0)) : encode(c * block.gain);
    if (!inside) display = encode(vec3(kCanvasSurround));
    if ((kFlags & CANVAS_OUTLINE) != 0u) {
        float reach = 1.5 * block.step;
        bool here = isSelected(p);
        bool border = isSelected(p + vec2(reach, 0.0)) != here || isSelected(p - vec2(reach, 0.0)) != here ||
                      isSelected(p + vec2(0.0, reach)) != here || isSelected(p - vec2(0.0, reach)) != here;
        if (border) display = here ? vec3(0.05) : vec3(1.0, 0.72, 0.30);
    }
    if ((kFlags & CANVAS_SELECTION) != 0u) display = withSelection(display, p);
    if ((kFlags & CANVAS_OVERLAY) != 0u && inside)
        display = mix(display, vec3(0.85, 0.12, 0.10), 0.6 * texelFetch(mask, ivec2(floor(p)), 0).r);
    if ((kFlags & CANVAS_BRUSH) != 0u) {
        float edge = abs(distance(p, block.brushCenter) - block.brushRadius) / block.step;
        if (edge < 1.5) display = edge < 0.75 ? vec3(1.0) : vec3(0.1);
    }
    if ((kFlags & CANVAS_RULER) != 0u) {
        vec4 ruler = texelFetch(rulerImage, ivec2(gl_FragCoord.xy - block.ruler), 0);
        display = ruler.rgb + (1.0 - ruler.a) * display;
    }
    target = vec4(display, 1.0);
}
