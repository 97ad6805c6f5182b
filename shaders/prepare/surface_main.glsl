// Converts the host's G-buffer into Glint's own conventions, once: every later pass reads viewZ in metres, one packed
// surface and a resolved material. include/glint/gbuffer.hpp lists what a host may declare.
//
// GLINT_CLASSIFIES: the pass also does the work of trace/classify, which otherwise reads again what this one has just
// written. For frames that trace every pixel and ask no neighbour: not while denoising.
//
// GLINT_COAT: for hosts that state a clear coat, which becomes a surface of its own (lib/coat.glsl).
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl"
#include "lib/host_surface.glsl"
#include "lib/math.glsl"
#include "lib/packed_coverage.glsl"
#include "lib/surface.glsl"
#ifdef GLINT_CLASSIFIES
#include "trace/ray_list.glsl"
#include "trace/starts_ray.glsl"
#endif

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 21) uniform sampler2D depth;
layout(set = 0, binding = 22) uniform sampler2D normal;
layout(set = 0, binding = 23) uniform sampler2D material;
layout(set = 0, binding = 24) uniform sampler2D baseColor;
layout(set = 0, binding = 25, r32f) uniform writeonly image2D viewZ;
layout(set = 0, binding = 26, rg32ui) uniform writeonly uimage2D surface;
layout(set = 0, binding = 27, rgba16f) uniform writeonly image2D resolvedMaterial;
// The images that hold the material's scalars; often one and the same.
layout(set = 0, binding = 28) uniform sampler2D roughness;
layout(set = 0, binding = 29) uniform sampler2D metallic;
layout(set = 0, binding = 30) uniform sampler2D specular;
layout(set = 0, binding = 31) uniform sampler2D f90;
#ifdef GLINT_COAT
layout(set = 0, binding = 32) uniform sampler2D coat;
layout(set = 0, binding = 33) uniform sampler2D coatRoughness;
layout(set = 0, binding = 34) uniform sampler2D coatNormal;
layout(set = 0, binding = 35, rg32ui) uniform writeonly uimage2D coatSurface;
#endif

#define GLINT_HOST_SAMPLER sampler2D
#include "lib/face_normal.glsl"
#include "prepare/load_material.glsl"

FacePoint facePoint(ivec2 px, float z, vec3 normalVS) {
    return FacePoint(viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z), normalVS,
                     z < kBackgroundZ);
}

FacePoint loadFacePoint(ivec2 px) {
    return facePoint(px, hostViewZ(frame.constants, texelFetch(depth, px, 0).r),
                     hostNormalVS(frame.constants, texelFetch(normal, px, 0).xyz));
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    bool needsRay = false;
    bool fromRough = false;
    if (all(lessThan(px, ivec2(frame.constants.size)))) {
        HostSurface here = hostSurface(frame.constants, texelFetch(depth, px, 0).r, texelFetch(normal, px, 0).xyz,
                                       loadMaterial(px, 0));
        float z = storedViewZ(frame.constants, here.viewZ);
        float reflectivity = z < kBackgroundZ ? maxComponent(here.f0) : 0.0;
        if (reflectivity > 0.0)
            here.normalVS = normalThatReflectsUp(px, facePoint(px, here.viewZ, here.normalVS));
        uvec2 packed = packSurface(Surface(here.normalVS, here.perceptualRoughness, reflectivity));
        imageStore(viewZ, px, vec4(z));
        imageStore(surface, px, uvec4(packed, 0u, 0u));
        if ((frame.constants.flags & kInputResolved) != 0u) // else the host's own image holds the same
            imageStore(resolvedMaterial, px, vec4(here.f0, packedCoverage(frame.constants, 1.0, here.f90)));
#ifdef GLINT_COAT
        imageStore(coatSurface, px, uvec4(packSurface(loadCoat(px, 0, here)), 0u, 0u));
#endif
#ifdef GLINT_CLASSIFIES
        // As packed: later passes compare the same numbers.
        needsRay = startsRay(px, px, z, unpackSurface(packed), fromRough);
#endif
    }
#ifdef GLINT_CLASSIFIES
    needRay(needsRay, fromRough);
#endif
}
