// The radiance that the frame shows, as a ray may take it. Include after `litRadiance`.
#ifndef GLINT_TRACE_SHOWN_RADIANCE_GLSL
#define GLINT_TRACE_SHOWN_RADIANCE_GLSL

#include "lib/input_color.glsl"
#include "lib/math.glsl"
#include "lib/sanitize.glsl"

/// Radiance at `px` that a ray may take. The highlights of smooth surfaces are where the eye sees them and nowhere else;
/// those of rough surfaces are wide and visible from everywhere.
vec3 shownRadiance(ivec2 px, float perceptualRoughness) {
    vec4 stored = texelFetch(litRadiance, px, 0);
    vec3 radiance = linearColor(stored.rgb, (frame.constants.flags & kInputGamma) != 0u);
    float mean = meanComponent(radiance);
    if ((frame.constants.flags & kInputHighlights) == 0u || mean <= 0.0)
        return radiance;
    const float kSmooth = 0.2;
    const float kRough = 0.6;
    const float kHalves = 1.0 + 1.0 / 1024.0; // both are rounded; without a highlight the ratio is 1
    float share = clamp(kHalves * sanitize(stored.a) / mean, 0.0, 1.0);
    return radiance * mix(share, 1.0, smoothstep(kSmooth, kRough, perceptualRoughness));
}

#endif
