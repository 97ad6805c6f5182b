// The surface whose lobe the denoiser averages in a pixel: the pixel's own, or on a mirror the surface that the mirror shows
// (lib/mirrored.glsl). That is the surface itself and not its image: neighbours' rays are weighed by true places and
// directions, whatever the mirror's shape.
// Include after `mirroredSurface`, a usampler2D.
#ifndef GLINT_DENOISE_AVERAGED_SURFACE_GLSL
#define GLINT_DENOISE_AVERAGED_SURFACE_GLSL

#include "denoise/lobe_surface.glsl"
#include "lib/mirrored.glsl"

/// What the mirror `at` shows in its pixel: distance 0 if nothing of that is averaged.
MirroredSurface mirroredAt(ivec2 px, LobeSurface at) {
    if (frame.settings.denoise.mirrored == 0u || !isMirror(at.perceptualRoughness))
        return MirroredSurface(0.0, vec3(0.0, 0.0, 1.0), 0.0, 0.0, 0.0);
    return unpackMirroredSurface(texelFetch(mirroredSurface, px, 0));
}

LobeSurface averagedSurfaceAt(ivec2 px) {
    LobeSurface at = lobeSurfaceAt(px);
    MirroredSurface met = mirroredAt(px, at);
    if (met.distance <= 0.0)
        return at;
    vec3 onward = reflect(-at.toEyeVS, at.normalVS);
    LobeSurface behind;
    behind.positionVS = at.positionVS + onward * met.distance;
    behind.normalVS = met.normalVS;
    behind.shownNormalVS = reflect(met.normalVS, at.normalVS);
    behind.toEyeVS = -onward;
    behind.viewZ = met.viewZ;
    behind.perceptualRoughness = met.perceptualRoughness;
    behind.isMirrored = true;
    return behind;
}

#endif
