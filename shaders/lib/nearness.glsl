// Nearness: depth as a number that is linear on screen, along lines and over planes, and larger for nearer points:
// 1/viewZ in perspective, -viewZ for an orthographic camera.
#ifndef GLINT_LIB_NEARNESS_GLSL
#define GLINT_LIB_NEARNESS_GLSL

#include "lib/camera.glsl"

float nearnessOf(bool orthographic, float viewZ) {
    return orthographic ? -viewZ : 1.0 / viewZ;
}

float nearnessOf(FrameConstants frame, float viewZ) {
    return nearnessOf(isOrthographic(frame), viewZ);
}

/// Change of nearness from pixel to pixel, in x and y, over the plane through `positionVS` with this normal; large
/// where the eye sees the plane edge-on.
vec2 nearnessSlope(FrameConstants frame, vec3 positionVS, vec3 normalVS) {
    float along = isOrthographic(frame) ? -normalVS.z : dot(normalVS, positionVS);
    float steepest = 1e-6 * (isOrthographic(frame) ? 1.0 : -positionVS.z);
    along = along < 0.0 ? min(along, -steepest) : max(along, steepest);
    return normalVS.xy * frame.uvToView.xy * frame.invSize / along;
}

/// The inverse of nearness; kBackgroundZ for every point farther than any surface.
float viewZOf(FrameConstants frame, float nearness) {
    if (isOrthographic(frame))
        return min(-nearness, kBackgroundZ);
    return nearness > 1.0 / kBackgroundZ ? 1.0 / nearness : kBackgroundZ;
}

#endif
