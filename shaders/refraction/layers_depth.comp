// Where a layer is seen it is now the nearest one. A pass of its own: rays of other pixels ask what was there before.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/host_surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
} frame;
layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 2) uniform sampler2D layerDepth;
layout(set = 0, binding = 3, r32f) uniform writeonly image2D layersZ;

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    float z = storedViewZ(frame.constants, hostViewZ(frame.constants, texelFetch(layerDepth, px, 0).r));
    if (z < kBackgroundZ && z <= texelFetch(viewZ, px, 0).r)
        imageStore(layersZ, px, vec4(z));
}
