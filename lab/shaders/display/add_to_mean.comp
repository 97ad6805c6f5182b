// Adds a frame to the means of a still view's frames, whose camera is shifted within the pixel. Radiance has one mean.
// What a screen shows has another: of a pixel that a lamp half covers, the mean of radiance is as white as the lamp, so
// the lamp's edge would keep its steps.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/color.glsl"
#include "shared/display.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D radiance;
layout(set = 0, binding = 1) uniform sampler2D opacity;   // in alpha
layout(set = 0, binding = 2) uniform sampler2D displayed; // sRGB-encoded
layout(set = 0, binding = 3, rgba32f) uniform image2D meanRadiance; // a: opacity
layout(set = 0, binding = 4, rgba32f) uniform image2D meanDisplayed; // linear
layout(push_constant, scalar) uniform PushBlock {
    MeanConstants constants;
};

vec4 meanWith(vec4 mean, vec4 value) {
    return constants.frames == 1u ? value : mean + (value - mean) / float(constants.frames);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(constants.size))))
        return;
    vec4 radianceNow = vec4(texelFetch(radiance, px, 0).rgb, texelFetch(opacity, px, 0).a);
    vec4 displayedNow = vec4(decodeSrgb(texelFetch(displayed, px, 0).rgb), 1.0);
    imageStore(meanRadiance, px, meanWith(imageLoad(meanRadiance, px), radianceNow));
    imageStore(meanDisplayed, px, meanWith(imageLoad(meanDisplayed, px), displayedNow));
}
