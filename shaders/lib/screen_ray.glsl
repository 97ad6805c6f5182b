// A view-space ray as a line on screen, with perspective-correct depth. McGuire and Mara 2014, "Efficient GPU
// Screen-Space Ray Tracing", JCGT 3(4): 1/w and z/w are linear on screen.
#ifndef GLINT_LIB_SCREEN_RAY_GLSL
#define GLINT_LIB_SCREEN_RAY_GLSL

#include "lib/camera.glsl"

struct ScreenRay {
    vec2 startPX;
    vec2 deltaPX;       // from start to end
    float startInvW;
    float endInvW;
    float startZOverW;  // viewZ / w
    float endZOverW;
    float lengthVS;     // metres
    float screenEnd;    // fraction of the line that lies on screen, [0, 1]; 1 if all of it
    bool clippedNear;   // the ray was cut at the near plane
};

/// Fraction of the segment from `start` along `delta` that stays in [low, high].
float shareInside(float start, float delta, float low, float high) {
    if (delta > 0.0)
        return (high - start) / delta;
    return delta < 0.0 ? (low - start) / delta : 1.0;
}

/// `maxDistance` in metres; the direction is a unit vector. The ray is cut before the near plane, where 1/w has a pole.
ScreenRay makeScreenRay(FrameConstants frame, vec3 originVS, vec3 directionVS, float maxDistance) {
    ScreenRay ray;
    // directionVS.z > 0 points toward the camera. The plane itself is excluded, because its points project to infinity.
    float toNear = (-frame.nearZ * 1.001 - originVS.z) / max(directionVS.z, 1e-9);
    ray.clippedNear = directionVS.z > 0.0 && toNear < maxDistance;
    ray.lengthVS = max(ray.clippedNear ? toNear : maxDistance, 0.0);

    vec3 endVS = originVS + directionVS * ray.lengthVS;
    vec4 startH = frame.viewToPixel * vec4(originVS, 1.0);
    vec4 endH = frame.viewToPixel * vec4(endVS, 1.0);
    ray.startInvW = 1.0 / startH.w;
    ray.endInvW = 1.0 / endH.w;
    ray.startZOverW = -originVS.z * ray.startInvW;
    ray.endZOverW = -endVS.z * ray.endInvW;
    ray.startPX = startH.xy * ray.startInvW;
    ray.deltaPX = endH.xy * ray.endInvW - ray.startPX;

    // Half a pixel inside, so that the last sample has a texel of its own.
    float share = min(shareInside(ray.startPX.x, ray.deltaPX.x, 0.5, frame.size.x - 0.5),
                      shareInside(ray.startPX.y, ray.deltaPX.y, 0.5, frame.size.y - 0.5));
    ray.screenEnd = clamp(share, 0.0, 1.0);
    return ray;
}

/// Length of the whole line along its longer axis; never 0.
float screenPixels(ScreenRay ray) {
    return max(max(abs(ray.deltaPX.x), abs(ray.deltaPX.y)), 1e-6);
}

/// viewZ of the ray in metres, at fraction `share` of the line on screen.
float rayViewZ(ScreenRay ray, float share) {
    return mix(ray.startZOverW, ray.endZOverW, share) / mix(ray.startInvW, ray.endInvW, share);
}

/// Nearness (lib/nearness.glsl) of the ray at fraction `share` of the line on screen; linear in `share`.
float rayNearness(FrameConstants frame, ScreenRay ray, float share) {
    return isOrthographic(frame) ? -mix(ray.startZOverW, ray.endZOverW, share)
                                 : mix(ray.startInvW, ray.endInvW, share);
}

/// Metres travelled from the origin, at fraction `share` of the line on screen.
float rayDistance(ScreenRay ray, float share) {
    return ray.lengthVS * share * ray.endInvW / mix(ray.startInvW, ray.endInvW, share);
}

/// The inverse of rayDistance: `metres` from 0 to the ray's length.
float shareAtDistance(ScreenRay ray, float metres) {
    return metres * ray.startInvW / (ray.lengthVS * ray.endInvW + metres * (ray.startInvW - ray.endInvW));
}

#endif
