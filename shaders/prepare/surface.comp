// Converts the host's G-buffer into Glint's own conventions, once: every later pass reads viewZ in metres, one packed
// surface and a resolved material. include/glint/gbuffer.hpp lists what a host may declare.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl"
#include "lib/host_surface.glsl"
#include "lib/math.glsl"
#include "lib/surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D depth;
layout(set = 0, binding = 2) uniform sampler2D normal;
layout(set = 0, binding = 3) uniform sampler2D material;
layout(set = 0, binding = 4) uniform sampler2D baseColor;
layout(set = 0, binding = 5, r32f) uniform writeonly image2D viewZ;
layout(set = 0, binding = 6, rg32ui) uniform writeonly uimage2D surface;
layout(set = 0, binding = 7, rgba16f) uniform writeonly image2D resolvedMaterial;
// The images that hold the material's scalars; often one and the same.
layout(set = 0, binding = 8) uniform sampler2D roughness;
layout(set = 0, binding = 9) uniform sampler2D metallic;
layout(set = 0, binding = 10) uniform sampler2D specular;

#define GLINT_HOST_SAMPLER sampler2D
#include "prepare/load_material.glsl"

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    HostSurface here =
        hostSurface(frame.constants, texelFetch(depth, px, 0).r, texelFetch(normal, px, 0).xyz,
                    loadMaterial(px, 0));
    imageStore(viewZ, px, vec4(storedViewZ(frame.constants, here.viewZ)));
    imageStore(surface, px,
               uvec4(packSurface(Surface(here.normalVS, here.perceptualRoughness, maxComponent(here.f0))), 0u, 0u));
    if ((frame.constants.flags & kInputResolved) != 0u) // else the host's own image holds the same
        imageStore(resolvedMaterial, px, vec4(here.f0, 1.0));
}
