// Makes a layer the nearest one where it is seen. A pass of its own, because rays of other pixels read the previous
// value.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl"
#include "lib/host_surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 2) uniform sampler2D layerDepth;
layout(set = 0, binding = 3, r32f) uniform writeonly image2D layersZ;

#include "refraction/layer_seen.glsl"

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    float z = seenLayerZ(px);
    if (z < kBackgroundZ)
        imageStore(layersZ, px, vec4(z));
}
