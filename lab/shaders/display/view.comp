// Maps a view's raw values to display colours: displayColor of lab/session/views.cpp, on the GPU for windows.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shared/display.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D values;
layout(set = 0, binding = 1, rgba8) uniform writeonly image2D display;
layout(push_constant, scalar) uniform PushBlock {
    ViewConstants constants;
};

/// Blue, cyan, green, yellow, red for t in [0, 1]; 0 itself is black.
vec3 heat(float t) {
    float x = t * 4.0;
    return t <= 0.0 ? vec3(0.0) : clamp(vec3(x - 2.0, 2.0 - abs(x - 2.0), 2.0 - x), 0.0, 1.0);
}

vec3 displayColor(vec3 value) {
    switch (constants.kind) {
    case kViewDirection: return value * 0.5 + 0.5;
    case kViewDistance: return vec3(value.x > 0.0 ? kViewHalfWhite / (kViewHalfWhite + value.x) : 0.0);
    case kViewMotion: return 0.5 + 0.5 * sign(value) * sqrt(abs(value) / kViewLargestMotion);
    case kViewCount: return heat(log2(1.0 + max(value.x, 0.0)) / log2(1.0 + kViewRedCount));
    default: return value;
    }
}

void main() {
    uvec2 px = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(px, constants.size)))
        return;
    vec3 color = displayColor(texelFetch(values, ivec2(px), 0).rgb);
    if (any(isnan(color)))
        color = vec3(1.0, 0.0, 1.0);
    imageStore(display, ivec2(px), vec4(clamp(color, 0.0, 1.0), 1.0));
}
