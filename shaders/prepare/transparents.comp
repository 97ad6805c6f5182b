// Transparent surfaces in front of the frame's, for screen rays that meet them (screen.transparents). A host provides
// their depth alone: the normal follows from the depth around.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl"
#include "lib/camera.glsl"
#include "lib/host_surface.glsl"
#include "lib/surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 3) uniform sampler2D transparentDepth;
layout(set = 0, binding = 4, r32f) uniform writeonly image2D transparentViewZ;
layout(set = 0, binding = 5, rg32ui) uniform writeonly uimage2D transparentSurface;

float hostZ(ivec2 px) {
    px = clamp(px, ivec2(0), ivec2(frame.constants.size) - 1);
    return storedViewZ(frame.constants, hostViewZ(frame.constants, texelFetch(transparentDepth, px, 0).r));
}

vec3 positionOf(ivec2 px, float z) {
    return viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z);
}

/// Along `axis`, to the neighbour of more similar depth: the other may lie beyond an edge. Towards larger coordinates.
vec3 tangentVS(ivec2 px, float z, ivec2 axis) {
    float before = hostZ(px - axis);
    float after = hostZ(px + axis);
    if (abs(before - z) < abs(after - z))
        return positionOf(px, z) - positionOf(px - axis, before);
    return positionOf(px + axis, after) - positionOf(px, z);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    float z = hostZ(px);
    if (z >= texelFetch(viewZ, px, 0).r) { // none, or hidden
        imageStore(transparentViewZ, px, vec4(kBackgroundZ));
        imageStore(transparentSurface, px, uvec4(0u));
        return;
    }
    vec3 toEyeVS = -viewDirection(frame.constants, positionOf(px, z));
    vec3 normalVS = cross(tangentVS(px, z, ivec2(1, 0)), tangentVS(px, z, ivec2(0, 1)));
    float area = length(normalVS);
    normalVS = area > 0.0 ? normalVS / area : toEyeVS;
    normalVS = dot(normalVS, toEyeVS) < 0.0 ? -normalVS : normalVS;
    imageStore(transparentViewZ, px, vec4(z));
    imageStore(transparentSurface, px, uvec4(packSurface(Surface(normalVS, 0.0, 0.0)), 0u, 0u));
}
