// Which rough pixels send a ray in this frame (reuse.rate). The others take their light from the rays of neighbours
// (denoise/reuse) and from earlier frames. In every 2 x 2 pixels another pixel sends in each frame, so that each has a
// ray of its own in turn: Intel's and NVIDIA's checkerboards alternate likewise. docs/techniques/rough.md.
//
// Include after `rayRates`, a sampler2D: for `adaptive`, each tile's share of pixels that send a ray (denoise/rate).
#ifndef GLINT_DENOISE_RAY_RATE_GLSL
#define GLINT_DENOISE_RAY_RATE_GLSL

#include "denoise/history.glsl"
#include "denoise/lobe_surface.glsl"
#include "shared/denoise_constants.h"

/// Lobes narrower than this on screen, wherever their ray ends, send a ray in every frame: a neighbour's shows them another
/// place. Those narrower than three times that send one in every other frame at least.
const float kNarrowLobePixels = 4.0;

/// Of the pixel's tile, by the setting: full, checkerboard or quarter.
uint tileRate(ivec2 px) {
    DenoiseConstants denoise = frame.settings.denoise;
    if (denoise.rayRate != kRateAdaptive)
        return denoise.rayRate;
    if (!hasDenoiserHistory() || any(lessThan(px, ivec2(0))) || any(greaterThanEqual(px, ivec2(frame.constants.prevSize))))
        return kRateFull;
    float share = texelFetch(rayRates, px / int(kRateTile), 0).r;
    return share > 0.75 ? kRateFull : share > 0.375 ? kRateCheckerboard : kRateQuarter;
}

uint rateAt(ivec2 px, float perceptualRoughness) {
    uint rate = tileRate(px);
    float lobe = lobePixels(perceptualRoughness, 0.0, 0.0);
    if (lobe < kNarrowLobePixels)
        return kRateFull;
    return rate == kRateQuarter && lobe < 3.0 * kNarrowLobePixels ? kRateCheckerboard : rate;
}

/// The pixel of a quad whose turn it is in this frame: 0 to 3, row by row. The four turns visit diagonals first.
uint turnOfQuad() {
    const uint kTurns[4] = uint[](0u, 3u, 1u, 2u);
    return kTurns[frame.constants.frameIndex & 3u];
}

/// True in half of the pixels, in alternate frames.
bool isOnCheckerboard(ivec2 px) {
    return ((uint(px.x ^ px.y) ^ frame.constants.frameIndex) & 1u) == 0u;
}

bool hasTurn(ivec2 px, uint rate) {
    if (rate == kRateQuarter)
        return (uint(px.x & 1) | (uint(px.y & 1) << 1)) == turnOfQuad();
    return rate == kRateFull || isOnCheckerboard(px);
}

/// The pixel of the same quad whose turn it is: `px` itself, if it is one.
ivec2 senderAt(ivec2 px, float perceptualRoughness) {
    uint rate = rateAt(px, perceptualRoughness);
    if (rate == kRateQuarter) {
        uint turn = turnOfQuad();
        return (px & ~1) | ivec2(int(turn & 1u), int(turn >> 1));
    }
    return hasTurn(px, rate) ? px : ivec2(px.x ^ 1, px.y);
}

/// True where the ray of `sender` shows what `here` reflects: they are one surface, and their lobes overlap.
bool answersFor(ivec2 sender, LobeSurface here) {
    if (!isInFrame(sender))
        return false;
    LobeSurface there = lobeSurfaceAt(sender);
    float reflectivity = unpackSurface(texelFetch(surface, sender, 0).xy).reflectivity;
    bool sends = reflectivity > frame.settings.trace.threshold && !isMirror(there.perceptualRoughness);
    float apart = length(there.normalVS - here.normalVS);
    return sends && isSameSurface(here, there) && apart < 0.5 * lobeTangent(here.perceptualRoughness);
}

bool sendsRay(ivec2 px, float perceptualRoughness) {
    if (frame.settings.denoise.rayRate == kRateFull)
        return true;
    ivec2 sender = senderAt(px, perceptualRoughness);
    return sender == px || !answersFor(sender, lobeSurfaceAt(px));
}

#endif
