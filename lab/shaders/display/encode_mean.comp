// The mean of displayed frames (display/add_to_mean) as a screen takes it: sRGB curve, 8 bits.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/color.glsl"
#include "shared/display.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D mean; // linear
layout(set = 0, binding = 1, rgba8) uniform writeonly image2D display;
layout(push_constant, scalar) uniform PushBlock {
    MeanConstants constants;
};

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(constants.size))))
        return;
    imageStore(display, px, vec4(encodeSrgb(clamp(texelFetch(mean, px, 0).rgb, 0.0, 1.0)), 1.0));
}
