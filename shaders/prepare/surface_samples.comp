// prepare/surface for hosts with several samples a pixel. A pixel's samples may lie on different surfaces, whose mean is
// a surface that does not exist: a wall and the floor far behind it average to a depth where nothing is and a normal
// that faces nowhere, and mirrors show both as a rim. So one sample speaks for the pixel, depth, normal and material
// together: the nearest. Rays then meet thin things at their full width, and what it hides goes on beside it, where
// composite finds its reflection. The other samples are counted: those of the same surface are its coverage; of the rest
// the nearest is kept as the pixel's second surface.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/edge.glsl"
#include "lib/host_surface.glsl"
#include "lib/math.glsl"
#include "lib/surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
} frame;
layout(set = 0, binding = 1) uniform sampler2DMS depth;
layout(set = 0, binding = 2) uniform sampler2DMS normal;
layout(set = 0, binding = 3) uniform sampler2DMS material;
layout(set = 0, binding = 4) uniform sampler2DMS baseColor;
layout(set = 0, binding = 5, r32f) uniform writeonly image2D viewZ;
layout(set = 0, binding = 6, rg32ui) uniform writeonly uimage2D surface;
layout(set = 0, binding = 7, rgba16f) uniform writeonly image2D resolvedMaterial;
layout(set = 0, binding = 8, rgba32ui) uniform writeonly uimage2D edge;

HostSurface loadSample(ivec2 px, int index) {
    return hostSurface(frame.constants, texelFetch(depth, px, index).r, texelFetch(normal, px, index).xyz,
                       texelFetch(material, px, index), texelFetch(baseColor, px, index).rgb);
}

int nearestSample(ivec2 px, int count) {
    int nearest = 0;
    float nearestZ = kBackgroundZ;
    for (int i = 0; i < count; ++i) {
        float z = hostViewZ(frame.constants, texelFetch(depth, px, i).r);
        if (z < nearestZ) {
            nearestZ = z;
            nearest = i;
        }
    }
    return nearest;
}

/// How far the surface's plane goes away from the eye over one pixel, metres.
float slopeOverPixel(ivec2 px, HostSurface here) {
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    bool orthographic = isOrthographic(frame.constants);
    vec3 positionVS = viewPosition(frame.constants, uv, here.viewZ);
    vec3 ray = orthographic ? vec3(0.0, 0.0, -1.0) : positionVS / here.viewZ;
    vec2 pixel = abs(frame.constants.uvToView.xy) * frame.constants.invSize * (orthographic ? 1.0 : here.viewZ);
    return dot(abs(here.normalVS.xy), pixel) / max(abs(dot(here.normalVS, ray)), 0.02);
}

/// May be too strict at no harm: a surface cut in two finds its own reflection again.
bool sameSurface(HostSurface a, HostSurface b, float depthTolerance) {
    return abs(a.viewZ - b.viewZ) <= depthTolerance && dot(a.normalVS, b.normalVS) > 0.95 &&
           maxComponent(abs(a.f0 - b.f0)) < 1.0 / 128.0 && abs(a.perceptualRoughness - b.perceptualRoughness) < 1.0 / 64.0;
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    int count = textureSamples(depth);
    int nearest = nearestSample(px, count);
    HostSurface front = loadSample(px, nearest);
    float depthTolerance = 2.0 * slopeOverPixel(px, front) + 1e-3 * front.viewZ;
    bool orthographic = isOrthographic(frame.constants);
    int same = 0;
    int other = 0;
    float depthSum = 0.0; // of what a plane is linear in on the screen: 1 / viewZ, or viewZ of an orthographic camera
    HostSurface second = front;
    second.viewZ = kBackgroundZ;
    for (int i = 0; i < count; ++i) {
        HostSurface here = loadSample(px, i);
        if (here.viewZ >= kBackgroundZ)
            continue;
        if (sameSurface(front, here, depthTolerance)) {
            ++same;
            depthSum += orthographic ? here.viewZ : 1.0 / here.viewZ;
        } else {
            ++other;
            if (here.viewZ < second.viewZ)
                second = here;
        }
    }
    float z = front.viewZ;
    if (same == count) { // one surface: its samples lie around the pixel's centre, and so its depth there is their mean
        float mean = depthSum / float(count);
        z = orthographic ? mean : 1.0 / mean;
    }
    float coverage = z < kBackgroundZ ? float(same) / float(count) : 1.0;
    imageStore(viewZ, px, vec4(storedViewZ(frame.constants, z)));
    imageStore(surface, px,
               uvec4(packSurface(Surface(front.normalVS, front.perceptualRoughness, maxComponent(front.f0))), 0u, 0u));
    imageStore(resolvedMaterial, px, vec4(front.f0, coverage));
    if (coverage < 1.0)
        imageStore(edge, px, packEdge(Edge(second.f0, float(other) / float(count), second.viewZ, second.normalVS)));
}
