// Which of a coated pixel's two lobes sends the pixel's one sampled ray in this frame. The other takes its light from the
// rays of neighbours (denoise/reuse) and from earlier frames, as with reuse.rate. Mirrors are not sampled, and narrow lobes
// learn little from neighbours: both send a ray in every frame.
//
// Include after `rayRates` (denoise/ray_rate.glsl).
#ifndef GLINT_DENOISE_LOBE_TURN_GLSL
#define GLINT_DENOISE_LOBE_TURN_GLSL

#include "denoise/ray_rate.glsl"
#include "frame/lobe_surfaces.glsl"
#include "generate/lobe.glsl"
#include "lib/camera.glsl"
#include "lib/coat.glsl"
#include "lib/noise.glsl"

/// Fraction of a coated pixel's reflected light that the coat sends to the eye, if what both lobes reflect is as bright.
float coatShare(Surface below, Surface coat, vec3 toEyeVS) {
    float film = coatReflectance(coat.reflectivity, clamp(dot(coat.normalVS, toEyeVS), 1e-3, 1.0));
    float grazing = pow5(1.0 - clamp(dot(below.normalVS, toEyeVS), 0.0, 1.0));
    float energy = (1.0 - film) * mix(below.reflectivity, 1.0, grazing);
    return film / max(film + energy, 1e-6);
}

/// True if this lobe sends its ray. Of the four pixels of a quad, one at least sends the coat's and one the surface's.
bool hasLobesTurn(ivec2 px, vec2 uv) {
    if (!hasCoats() || frame.settings.denoise.reuseSamples == 0u)
        return true;
    Surface below = shownAt(px);
    Surface coat = coatAt(px);
    float threshold = frame.settings.trace.threshold;
    if (min(below.reflectivity, coat.reflectivity) <= threshold ||
        lobePixels(min(below.perceptualRoughness, coat.perceptualRoughness), 0.0, 0.0) < kNarrowLobePixels)
        return true;
    vec3 toEyeVS = -viewDirection(frame.constants, viewPosition(frame.constants, uv, 1.0));
    uint coats = uint(clamp(round(4.0 * coatShare(below, coat, toEyeVS)), 1.0, 3.0)); // of the quad's four rays
    uint turned = uint(4.0 * hashNoise(uvec2(px >> 1), frame.constants.frameIndex, frame.constants.seed).x);
    uint place = uint(px.x & 1) | uint((px.x ^ px.y) & 1) << 1; // neighbours on a diagonal follow each other
    bool coatsTurn = ((place + turned) & 3u) < coats;
    return coatsTurn == ((frame.constants.flags & kLobeCoat) != 0u);
}

#endif
