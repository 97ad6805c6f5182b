// A lit surface's light as the G-buffer holds it.
#ifndef GLINT_RENDER_LIT_OUTPUTS_GLSL
#define GLINT_RENDER_LIT_OUTPUTS_GLSL

#include "render/lighting_bindings.glsl"

/// Half floats end at 65504: an infinity would spread through every blur that comes after.
const vec3 kLargest = vec3(65000.0);

/// Unit `V` towards the eye.
Lighting shownLighting(MaterialSample surface, SurfacePoint point, vec3 V) {
    Lighting lighting = lightSurface(surface, point, V);
    if (view.constants.highlights == 0u)
        lighting.directSpecular = vec3(0.0);
    return lighting;
}

/// All of it, and in the alpha the mean of its channels without highlights (Conventions::highlightsInAlpha).
vec4 litRadiance(Lighting lighting) {
    vec3 total = totalRadiance(lighting);
    lighting.directSpecular = vec3(0.0);
    return vec4(min(total, kLargest), min(meanComponent(totalRadiance(lighting)), kLargest.r));
}

vec4 fallbackSpecular(Lighting lighting) {
    return vec4(min(lighting.environmentSpecular, kLargest), 1.0);
}

#endif
