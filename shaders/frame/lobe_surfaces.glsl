// The surfaces of a pixel whose host states a clear coat: what the pixel shows, and the coat over it. Rays start from one of
// the two lobes and meet both.
#ifndef GLINT_FRAME_LOBE_SURFACES_GLSL
#define GLINT_FRAME_LOBE_SURFACES_GLSL

#include "frame/prepared.glsl"
#include "lib/surface.glsl"

/// Of the coat, or with kLobeCoat of the surface below; not read without kInputCoat.
layout(set = 0, binding = 17) uniform usampler2D otherLobe;

/// What the pixel shows, as rays meet it.
Surface shownAt(ivec2 px) {
    return unpackSurface((frame.constants.flags & kLobeCoat) != 0u ? texelFetch(otherLobe, px, 0).xy
                                                                   : texelFetch(surface, px, 0).xy);
}

bool hasCoats() {
    return (frame.constants.flags & kInputCoat) != 0u;
}

/// The coat of the pixel, with reflectivity 0 where it has none. Only with hasCoats().
Surface coatAt(ivec2 px) {
    return unpackSurface((frame.constants.flags & kLobeCoat) != 0u ? texelFetch(surface, px, 0).xy
                                                                   : texelFetch(otherLobe, px, 0).xy);
}

#endif
