// Width of a reflection's blur: Babylon.js' SSRRenderingPipeline (after Godot's).
#ifndef GLINT_RESOLVE_BLUR_RADIUS_GLSL
#define GLINT_RESOLVE_BLUR_RADIUS_GLSL

#include "lib/math.glsl"

/// The farthest tap of the blur, in pixels of the frame. On screen the ray has the length `rayPX` and opens as a cone
/// whose angle grows with roughness. The blur is the circle inscribed in the triangle of the cone and its end, times
/// `strength`. Babylon.js writes o = 2 tan(angle) length and o (sqrt(o^2 + 4 length^2) - o) / (4 length): the same, but
/// this form has no difference of large numbers. `roughnessFactor` blurs smooth surfaces too.
float blurReach(float perceptualRoughness, float rayPX, float strength, float roughnessFactor) {
    float roughness = 1.0 - (1.0 - perceptualRoughness) * (1.0 - roughnessFactor);
    float s = sin(min(roughness, 0.999) * 0.5 * kPi);
    return 2.0 * strength * rayPX * s / (1.0 + s);
}

#endif
