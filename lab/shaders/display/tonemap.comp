// Scene-referred linear radiance -> what a screen shows: exposure, tone map, sRGB curve, 8 bits.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/color.glsl"
#include "lib/tonemap.glsl"
#include "shared/display.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D radiance;
layout(set = 0, binding = 1, rgba8) uniform writeonly image2D display;
layout(push_constant, scalar) uniform PushBlock {
    DisplayConstants constants;
};

vec3 tonemap(vec3 color) {
    switch (constants.tonemap) {
    case kTonemapNeutral: return tonemapNeutral(color);
    case kTonemapAgx: return tonemapAgx(color);
    default: return color;
    }
}

void main() {
    uvec2 px = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(px, constants.size)))
        return;
    vec3 color = max(texelFetch(radiance, ivec2(px), 0).rgb, vec3(0.0)) * constants.exposure;
    imageStore(display, ivec2(px), vec4(encodeSrgb(clamp(tonemap(color), 0.0, 1.0)), 1.0));
}
