// What the previous frame's picture showed of a surface. Include after frame/prepared.glsl and declarations of `motion`
// (lib/previous_place.glsl) and of the previous frame's `prevColor` and `prevViewZ`.
#ifndef GLINT_LIB_PREVIOUS_RADIANCE_GLSL
#define GLINT_LIB_PREVIOUS_RADIANCE_GLSL

#include "lib/history.glsl"
#include "lib/input_color.glsl"
#include "lib/previous_place.glsl"

/// A surface was at its previous place, within this fraction of its distance and a quarter of a pixel. Where motion does
/// not tell its depth, that is known roughly.
const float kPlaceBefore = 0.002;
const float kDepthBefore = 0.1;

/// True if the previous frame's texel shows the surface of `before`. Of transparent surfaces only what hid them is known.
bool showedIt(PreviousPlace before, bool transparent, ivec2 texel) {
    float z = texelFetch(prevViewZ, texel, 0).r;
    if (transparent)
        return z >= -before.positionVS.z;
    if (z >= kBackgroundZ)
        return false;
    float expectedZ = -before.positionVS.z;
    if (!before.knowsDepth)
        return abs(z - expectedZ) <= kDepthBefore * expectedZ;
    vec3 between = previousPosition((vec2(texel) + 0.5) * frame.constants.prevInvSize, z) - before.positionVS;
    float slack = kPlaceBefore * expectedZ + 0.25 * prevPixelExtent(frame.constants, expectedZ).y;
    return abs(dot(before.normalVS, between)) <= slack;
}

/// Bilinear over those of the four texels that showed the same surface, so no colour bleeds in from occluders. False if
/// the previous frame did not show the surface.
bool radianceBefore(PreviousPlace before, bool transparent, out vec3 radiance) {
    radiance = vec3(0.0);
    bool onScreen = all(greaterThanEqual(before.px, vec2(0.0))) && all(lessThan(before.px, frame.constants.prevSize));
    if (!onScreen)
        return false;
    const float kNoShare = 1.0 / 64.0; // at rest, rounding leaves a small weight on the neighbours
    vec2 corner = floor(before.px - 0.5);
    vec2 share = before.px - 0.5 - corner;
    bool encoded = (frame.constants.flags & kHistoryGamma) != 0u;
    float total = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i & 1, i >> 1);
        vec2 shares = mix(1.0 - share, share, vec2(offset));
        float weight = shares.x * shares.y;
        ivec2 texel = floorToInt(corner) + offset;
        bool inside = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, ivec2(frame.constants.prevSize)));
        if (weight < kNoShare || !inside || !showedIt(before, transparent, texel))
            continue;
        radiance += weight * linearColor(texelFetch(prevColor, texel, 0).rgb, encoded);
        total += weight;
    }
    radiance /= max(total, kNoShare);
    return total > 0.0;
}

#endif
