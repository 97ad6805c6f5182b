// What a surface reflects besides F0 and roughness (lab/renderer/gbuffer.hpp), where the G-buffer has images for it.
#ifndef GLINT_RENDER_LOBE_OUTPUTS_GLSL
#define GLINT_RENDER_LOBE_OUTPUTS_GLSL

#include "lib/clearcoat.glsl"
#include "lib/octahedral.glsl"

/// F0 as the G-buffer states it: with GLINT_LOBES the surface's own, which the coat dims elsewhere.
vec3 statedF0(MaterialSample surface, vec3 V) {
#ifdef GLINT_LOBES
    return surface.f0;
#else
    return reflectionF0(surface, V);
#endif
}

/// F90; strength and perceptual roughness of the clear coat.
vec4 lobes(MaterialSample surface) {
    return vec4(surface.f90, surface.clearcoat, surface.clearcoatPerceptualRoughness, 1.0);
}

#endif
