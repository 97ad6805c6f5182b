// An opaque or masked surface, lit, and the G-buffer that reflections start from (lab/renderer/gbuffer.hpp), in one pass:
// gbuffer.mode prepass. geometry.frag and shading.frag are the two halves of this pass.
//
// GLINT_LOBES: also F90 and clear coats.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/octahedral.glsl"
#include "render/lighting_bindings.glsl"
#include "render/lit_outputs.glsl"
#include "render/lobe_outputs.glsl"
#include "render/surface_visible.glsl"

layout(location = 0) out vec2 outNormal;
layout(location = 1) out vec4 outMaterial;
layout(location = 2) out vec4 outMotion;
layout(location = 3) out vec4 outLitRadiance;
layout(location = 4) out vec4 outFallbackSpecular;
layout(location = 5) out vec4 outAlbedo;
#ifdef GLINT_LOBES
layout(location = 6) out vec4 outLobes;
layout(location = 7) out vec2 outCoatNormal;
#endif

void main() {
    beginLighting();
    SurfacePoint point = interpolatedPoint();
    MaterialSample surface = visibleSurface(point);
    vec3 V = viewVector();
    Lighting lighting = shownLighting(surface, point, V);

    outNormal = encodeOctahedral(surface.normalWS);
    outMaterial = vec4(statedF0(surface, V), surface.perceptualRoughness);
    outMotion = motion();
    outLitRadiance = litRadiance(lighting);
    outFallbackSpecular = fallbackSpecular(lighting);
    outAlbedo = vec4(surface.baseColor, 1.0);
#ifdef GLINT_LOBES
    outLobes = lobes(surface);
    outCoatNormal = encodeOctahedral(surface.clearcoatNormalWS);
#endif
}
