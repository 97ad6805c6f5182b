// Where a pixel's surface was in the previous frame, by both cameras and the host's motion. Include after
// frame/prepared.glsl and a declaration of `motion`: previous UV - current UV and, if motionDepthScale is not 0, previous
// viewZ - current viewZ, after scaling.
#ifndef GLINT_LIB_PREVIOUS_PLACE_GLSL
#define GLINT_LIB_PREVIOUS_PLACE_GLSL

#include "lib/camera.glsl"
#include "lib/surface.glsl"

/// A surface moved if motion puts it farther than this from where a surface at rest would have been: in pixels, and in
/// depth as a fraction of its viewZ.
const float kMovedPX = 0.5;
const float kMovedDepth = 0.001;

struct PreviousPlace {
    vec3 positionVS; // in the previous frame's view space
    vec3 normalVS;   // of a surface that did not turn
    vec2 px;
    bool moved;
    bool movedOnScreen;
    bool knowsDepth; // false: it moved, and motion did not tell how far it was from the camera
};

/// The pixel of the previous frame that shows `positionVS` of its view space; far outside if none does.
vec2 previousPixel(vec3 positionVS) {
    vec4 pixelH = frame.constants.prevViewToPixel * vec4(positionVS, 1.0);
    return pixelH.w > 0.0 ? pixelH.xy / pixelH.w : vec2(-1e4);
}

/// The point at `uv` of the previous frame, in its view space.
vec3 previousPosition(vec2 uv, float z) {
    float scale = isOrthographic(frame.constants) ? 1.0 : z;
    return vec3((uv * frame.constants.prevUvToView.xy + frame.constants.prevUvToView.zw) * scale, -z);
}

/// Change of UV by the cameras' jitter alone, which motion leaves out.
vec2 jitterChange() {
    vec4 nowH = frame.constants.viewToPixel * vec4(0.0, 0.0, -1.0, 1.0);
    vec4 beforeH = frame.constants.prevViewToPixel * vec4(0.0, 0.0, -1.0, 1.0);
    return beforeH.xy / beforeH.w * frame.constants.prevInvSize - nowH.xy / nowH.w * frame.constants.invSize;
}

/// Of a point at rest, at `uv` and `z` of this frame.
vec3 restingPosition(vec2 uv, float z) {
    return (frame.constants.viewToPrevView * vec4(viewPosition(frame.constants, uv, z), 1.0)).xyz;
}

vec2 middleUV(ivec2 px) {
    return (vec2(px) + 0.5) * frame.constants.invSize;
}

/// Of a surface at `px`: at rest or, if `moves`, with the motion that the host gives there. Without a motion in depth, the
/// surface is taken to have moved at an even distance from the previous camera.
PreviousPlace previousPlace(ivec2 px, float z, vec3 normalVS, bool moves) {
    vec2 uv = middleUV(px);
    PreviousPlace before;
    before.positionVS = restingPosition(uv, z);
    before.normalVS = mat3(frame.constants.viewToPrevView) * normalVS;
    before.px = previousPixel(before.positionVS);
    before.moved = before.movedOnScreen = false;
    before.knowsDepth = true;
    if (moves && (frame.constants.flags & kInputMotion) != 0u) {
        vec3 moved = texelFetch(motion, px, 0).rgb * vec3(frame.constants.motionScale, frame.constants.motionDepthScale);
        vec2 movedUV = uv + moved.xy + jitterChange();
        vec2 movedPX = movedUV * frame.constants.prevSize;
        bool tellsDepth = frame.constants.motionDepthScale != 0.0;
        float restingZ = -before.positionVS.z;
        float movedZ = tellsDepth ? z + moved.z : restingZ;
        before.movedOnScreen = distance(movedPX, before.px) > kMovedPX;
        before.moved = before.movedOnScreen || abs(movedZ - restingZ) > kMovedDepth * restingZ;
        if (before.moved) {
            before.px = movedPX;
            before.positionVS = previousPosition(movedUV, movedZ);
            before.knowsDepth = tellsDepth;
        }
    }
    return before;
}

/// Of the surface that the frame shows at `px`.
PreviousPlace previousPlace(ivec2 px, float z) {
    return previousPlace(px, z, unpackSurface(texelFetch(surface, px, 0).xy).normalVS, true);
}

/// Where the surface at `px` was, as a displacement from where it is now: 0 at rest. Metres, this frame's view space.
vec3 displacementVS(ivec2 px, float z) {
    PreviousPlace before = previousPlace(px, z);
    if (!before.moved)
        return vec3(0.0);
    return transpose(mat3(frame.constants.viewToPrevView)) * (before.positionVS - restingPosition(middleUV(px), z));
}

#endif
