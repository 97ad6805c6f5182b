// Conversions between pixels and view space, for both projections. Pure functions of FrameConstants.
#ifndef GLINT_LIB_CAMERA_GLSL
#define GLINT_LIB_CAMERA_GLSL

#include "shared/frame_constants.h"

bool isOrthographic(FrameConstants frame) {
    return (frame.flags & kInputOrthographic) != 0u;
}

/// View-space position of the point at `uv` whose distance along the view axis is `viewZ` metres.
vec3 viewPosition(FrameConstants frame, vec2 uv, float viewZ) {
    float scale = isOrthographic(frame) ? 1.0 : viewZ;
    return vec3((uv * frame.uvToView.xy + frame.uvToView.zw) * scale, -viewZ);
}

/// Unit direction from the eye to `positionVS`.
vec3 viewDirection(FrameConstants frame, vec3 positionVS) {
    return isOrthographic(frame) ? vec3(0.0, 0.0, -1.0) : normalize(positionVS);
}

/// Width and height of a pixel across the line of sight at `viewZ`, metres.
vec2 pixelExtent(FrameConstants frame, vec4 uvToView, float viewZ) {
    return abs(uvToView.xy) * frame.invSize * (isOrthographic(frame) ? 1.0 : viewZ);
}

/// As pixelExtent, of the previous frame's pixels.
vec2 prevPixelExtent(FrameConstants frame, float viewZ) {
    return abs(frame.prevUvToView.xy) * frame.prevInvSize * (isOrthographic(frame) ? 1.0 : viewZ);
}

/// Device depth as the host stores it -> metres along the view axis; kBackgroundZ where the host drew no surface.
float viewZFromDepth(FrameConstants frame, float depth) {
    if ((frame.flags & kInputLinearDepth) != 0u) {
        float z = depth * frame.depthScale;
        return z > 0.0 && z < kBackgroundZ ? z : kBackgroundZ;
    }
    bool reversed = (frame.flags & kInputReversedDepth) != 0u;
    if (reversed ? depth <= frame.farDepth : depth >= frame.farDepth)
        return kBackgroundZ;
    float ndc = depth * frame.depthScale + frame.depthOffset;
    return (ndc * frame.depthToViewZ.x + frame.depthToViewZ.y) / (ndc * frame.depthToViewZ.z + frame.depthToViewZ.w);
}

#endif
