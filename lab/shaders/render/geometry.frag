// An opaque or masked surface without its light: the first half of gbuffer.mode geometry.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/clearcoat.glsl"
#include "lib/octahedral.glsl"
#include "render/surface_visible.glsl"

layout(location = 0) out vec2 outNormal;
layout(location = 1) out vec4 outMaterial;
layout(location = 2) out vec4 outMotion;

void main() {
    MaterialSample surface = visibleSurface(interpolatedPoint());
    outNormal = encodeOctahedral(surface.normalWS);
    outMaterial = vec4(reflectionF0(surface, viewVector()), surface.perceptualRoughness);
    outMotion = motion();
}
