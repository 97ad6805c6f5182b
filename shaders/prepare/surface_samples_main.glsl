// prepare/surface for hosts with several samples a pixel. A pixel's samples may lie on different surfaces, whose mean
// is a surface that does not exist: a wall and the floor far behind it average to a depth without a surface and a
// normal that faces nowhere, and mirrors show both as a rim. So one sample represents the pixel, with its depth, normal
// and material together: a sample of the surface that most samples show, of the nearest surface in a tie. (The nearest
// sample of all, the other sensible rule, widens objects by a pixel; measured against an image with sixteen times the
// pixels it is farther off.) The surface's fraction of the pixel is its coverage. The nearest of the other samples is
// kept as the pixel's second surface, whose reflection composite finds beside it.
//
// GLINT_COAT: for hosts that state a clear coat, which becomes a surface of its own (lib/coat.glsl).
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl"
#include "lib/edge.glsl"
#include "lib/host_surface.glsl"
#include "lib/math.glsl"
#include "lib/packed_coverage.glsl"
#include "lib/surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2DMS depth;
layout(set = 0, binding = 2) uniform sampler2DMS normal;
layout(set = 0, binding = 3) uniform sampler2DMS material;
layout(set = 0, binding = 4) uniform sampler2DMS baseColor;
layout(set = 0, binding = 5, r32f) uniform writeonly image2D viewZ;
layout(set = 0, binding = 6, rg32ui) uniform writeonly uimage2D surface;
layout(set = 0, binding = 7, rgba16f) uniform writeonly image2D resolvedMaterial;
layout(set = 0, binding = 8, rgba32ui) uniform writeonly uimage2D edge;
// The images that hold the material's scalars; often one and the same.
layout(set = 0, binding = 9) uniform sampler2DMS roughness;
layout(set = 0, binding = 10) uniform sampler2DMS metallic;
layout(set = 0, binding = 11) uniform sampler2DMS specular;
layout(set = 0, binding = 12) uniform sampler2DMS f90;
#ifdef GLINT_COAT
layout(set = 0, binding = 13) uniform sampler2DMS coat;
layout(set = 0, binding = 14) uniform sampler2DMS coatRoughness;
layout(set = 0, binding = 15) uniform sampler2DMS coatNormal;
layout(set = 0, binding = 16, rg32ui) uniform writeonly uimage2D coatSurface;
#endif

#define GLINT_HOST_SAMPLER sampler2DMS
#include "prepare/load_material.glsl"

HostSurface loadSample(ivec2 px, int index) {
    return hostSurface(frame.constants, texelFetch(depth, px, index).r, texelFetch(normal, px, index).xyz,
                       loadMaterial(px, index));
}

/// Change of the surface's plane away from the eye over one pixel, metres.
float slopeOverPixel(ivec2 px, HostSurface here) {
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    bool orthographic = isOrthographic(frame.constants);
    vec3 positionVS = viewPosition(frame.constants, uv, here.viewZ);
    vec3 ray = orthographic ? vec3(0.0, 0.0, -1.0) : positionVS / here.viewZ;
    vec2 pixel = abs(frame.constants.uvToView.xy) * frame.constants.invSize * (orthographic ? 1.0 : here.viewZ);
    return dot(abs(here.normalVS.xy), pixel) / max(abs(dot(here.normalVS, ray)), 0.02);
}

/// Being too strict is harmless: a surface split in two finds its own reflection again.
bool sameSurface(HostSurface a, HostSurface b, float depthTolerance) {
    return abs(a.viewZ - b.viewZ) <= depthTolerance && dot(a.normalVS, b.normalVS) > 0.95 &&
           maxComponent(abs(a.f0 - b.f0)) < 1.0 / 128.0 && abs(a.f90 - b.f90) < 1.0 / 16.0 &&
           abs(a.perceptualRoughness - b.perceptualRoughness) < 1.0 / 64.0;
}

float depthTolerance(ivec2 px, HostSurface here) {
    return 2.0 * slopeOverPixel(px, here) + 1e-3 * here.viewZ;
}

/// The samples that show one surface.
struct Group {
    HostSurface surface;
    int index; // of the sample that stands for them
    float depthTolerance;
    int members;    // 0: the background
    float depthSum; // of a value that is linear on screen over a plane: 1 / viewZ, or viewZ of an orthographic camera
};

Group groupOf(ivec2 px, int index, int count) {
    HostSurface surface = loadSample(px, index);
    Group group = Group(surface, index, depthTolerance(px, surface), 0, 0.0);
    for (int i = 0; surface.viewZ < kBackgroundZ && i < count; ++i) {
        HostSurface other = loadSample(px, i);
        if (other.viewZ < kBackgroundZ && sameSurface(surface, other, group.depthTolerance)) {
            ++group.members;
            group.depthSum += isOrthographic(frame.constants) ? other.viewZ : 1.0 / other.viewZ;
        }
    }
    return group;
}

Group mostSeen(ivec2 px, int count) {
    Group best = groupOf(px, 0, count);
    for (int i = 1; best.members < count && i < count; ++i) {
        Group group = groupOf(px, i, count);
        if (group.members > best.members ||
            (group.members == best.members && group.surface.viewZ < best.surface.viewZ))
            best = group;
    }
    return best;
}

/// The samples outside `front`, represented by the nearest of them.
Edge secondSurface(ivec2 px, Group front, int count) {
    HostSurface nearest = front.surface;
    nearest.viewZ = kBackgroundZ;
    int members = 0;
    for (int i = 0; i < count; ++i) {
        HostSurface other = loadSample(px, i);
        if (other.viewZ >= kBackgroundZ || sameSurface(front.surface, other, front.depthTolerance))
            continue;
        ++members;
        if (other.viewZ < nearest.viewZ)
            nearest = other;
    }
    return Edge(nearest.f0, float(members) / float(count), nearest.viewZ, nearest.normalVS);
}

/// Where one surface fills the pixel, its samples lie around the centre, and so its depth there is their mean.
float depthOf(Group group, int count) {
    if (group.members < count)
        return group.surface.viewZ;
    float mean = group.depthSum / float(count);
    return isOrthographic(frame.constants) ? mean : 1.0 / mean;
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    int count = textureSamples(depth);
    Group front = mostSeen(px, count);
    HostSurface here = front.surface;
    float coverage = front.members > 0 && front.members < count ? float(front.members) / float(count) : 1.0;
    imageStore(viewZ, px, vec4(storedViewZ(frame.constants, depthOf(front, count))));
    float reflectivity = here.viewZ < kBackgroundZ ? maxComponent(here.f0) : 0.0;
    uvec2 packed = packSurface(Surface(here.normalVS, here.perceptualRoughness, reflectivity));
    imageStore(surface, px, uvec4(packed, 0u, 0u));
    imageStore(resolvedMaterial, px, vec4(here.f0, packedCoverage(frame.constants, coverage, here.f90)));
#ifdef GLINT_COAT
    imageStore(coatSurface, px, uvec4(packSurface(loadCoat(px, front.index, here)), 0u, 0u));
#endif
    if (coverage < 1.0)
        imageStore(edge, px, packEdge(secondSurface(px, front, count)));
}
