// Converts the host's back-face depth into metres along the view axis, as prepare/surface does with depth. The image
// has a size of its own.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/camera.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
} frame;
layout(set = 0, binding = 1) uniform sampler2D backDepth;
layout(set = 0, binding = 2, r32f) uniform writeonly image2D backViewZ;

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, imageSize(backViewZ))))
        return;
    float z = viewZFromDepth(frame.constants, texelFetch(backDepth, px, 0).r);
    imageStore(backViewZ, px, vec4(z > 0.0 ? z : kBackgroundZ)); // a NaN depth is none too
}
