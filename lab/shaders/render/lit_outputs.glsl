// A lit surface's light in the G-buffer's format.
#ifndef GLINT_RENDER_LIT_OUTPUTS_GLSL
#define GLINT_RENDER_LIT_OUTPUTS_GLSL

#include "render/lighting_bindings.glsl"

/// The largest half is 65504: an infinity would spread through every later blur.
const vec3 kLargest = vec3(65000.0);

/// All light; alpha: the mean of its channels without highlights (Conventions::highlightsInAlpha).
vec4 litRadiance(Lighting lighting) {
    vec3 total = totalRadiance(lighting);
    lighting.directSpecular = vec3(0.0);
    return vec4(min(total, kLargest), min(meanComponent(totalRadiance(lighting)), kLargest.r));
}

/// The environment's light that reflections replace: with GLINT_LOBES also the clear coat's.
vec4 fallbackSpecular(Lighting lighting) {
#ifdef GLINT_LOBES
    lighting.environmentSpecular += lighting.coatSpecular;
#endif
    return vec4(min(lighting.environmentSpecular, kLargest), 1.0);
}

#endif
