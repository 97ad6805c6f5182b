// An opaque or masked surface without its light: the first half of gbuffer.mode geometry.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/octahedral.glsl"
#include "render/lobe_outputs.glsl"
#include "render/surface_visible.glsl"

layout(location = 0) out vec2 outNormal;
layout(location = 1) out vec4 outMaterial;
layout(location = 2) out vec4 outMotion;
#ifdef GLINT_LOBES
layout(location = 3) out vec4 outLobes;
layout(location = 4) out vec2 outCoatNormal;
#endif

void main() {
    MaterialSample surface = visibleSurface(interpolatedPoint());
    outNormal = encodeOctahedral(surface.normalWS);
    outMaterial = vec4(statedF0(surface, viewVector()), surface.perceptualRoughness);
    outMotion = motion();
#ifdef GLINT_LOBES
    outLobes = lobes(surface);
    outCoatNormal = encodeOctahedral(surface.clearcoatNormalWS);
#endif
}
