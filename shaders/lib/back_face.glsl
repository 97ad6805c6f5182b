// The back of what a pixel shows, from a texel of the host's back faces that was drawn at the pixel's centre.
#ifndef GLINT_LIB_BACK_FACE_GLSL
#define GLINT_LIB_BACK_FACE_GLSL

#include "lib/host_surface.glsl"

/// By rounding, a back face may lie this far before the front, as a fraction of its depth: the back of a sheet.
const float kAtFront = 0.999;

/// viewZ of the back of the surface at `z`, metres; kBackgroundZ if that surface is open. `depth`: the host's, as stored.
float backViewZOf(FrameConstants frame, float depth, float z) {
    float back = hostViewZ(frame, depth);
    return back < kBackgroundZ && back >= kAtFront * z ? max(back, z) : kBackgroundZ;
}

#endif
