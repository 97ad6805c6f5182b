// Depth as a number that is linear on screen, along lines and over planes, and larger for what is nearer: 1/viewZ in
// perspective, -viewZ for an orthographic camera.
#ifndef GLINT_LIB_NEARNESS_GLSL
#define GLINT_LIB_NEARNESS_GLSL

#include "lib/camera.glsl"

float nearnessOf(bool orthographic, float viewZ) {
    return orthographic ? -viewZ : 1.0 / viewZ;
}

float nearnessOf(FrameConstants frame, float viewZ) {
    return nearnessOf(isOrthographic(frame), viewZ);
}

/// The inverse; kBackgroundZ for all that is farther than any surface.
float viewZOf(FrameConstants frame, float nearness) {
    if (isOrthographic(frame))
        return min(-nearness, kBackgroundZ);
    return nearness > 1.0 / kBackgroundZ ? 1.0 / nearness : kBackgroundZ;
}

#endif
