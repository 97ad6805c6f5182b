// The `proxy` marcher, which does not march. The ray intersects the proxy volume of the first probe that influences its
// pixel, and one depth sample is fetched where the frame shows the intersection. The result is as right as the volume.
// The model is Unity HDRP's projection model "proxy"; docs/techniques/proxy.md says which hits the one sample may
// reject.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#define GLINT_ONE_TEXEL_A_HIT // trace/hit_color.glsl
#include "trace/ray_inputs.glsl"

#include "trace/hit_test.glsl"

#include "probes/probe_lists.glsl"

/// A surface nearer to the camera than all of the ray is not a hit. A volume may be wrong by this fraction of the ray's
/// length.
const float kVolumeSlack = 0.1;

/// Where the ray is assumed to end.
struct Projection {
    uint probe;     // in the host's list; kNoProbe
    uint shape;     // kProbe*
    float distance; // metres; kBackgroundZ: infinitely far
};

/// The projection of the smallest volume that influences the pixel. Without a volume or without a proxy: infinitely
/// far.
Projection projectionOf(Ray r) {
    vec3 positionWS = (frame.constants.viewToWorld * vec4(r.originVS, 1.0)).xyz;
    vec3 normalWS = mat3(frame.constants.viewToWorld) * r.originNormalVS;
    vec3 directionWS = mat3(frame.constants.viewToWorld) * r.directionVS;
    uvec2 around = probesAround(positionWS);
    for (uint i = around.x; i < around.y; ++i) {
        uint index = probeLists.probe[i];
        ProbeRecord probe = probes.list[index];
        if (probeWeight(probe, positionWS, normalWS, directionWS) <= 0.0)
            continue;
        bool infinite = probe.proxyShape == kProbeNoProxy;
        float distance = infinite ? kBackgroundZ : proxyDistance(probe, positionWS, directionWS);
        return Projection(index, probe.proxyShape, distance);
    }
    return Projection(kNoProbe, kProbeNoProxy, kBackgroundZ);
}

/// Judges the end point by its one sample. Rejects what the ray certainly did not hit: a surface nearer than all of the
/// ray, and the surface that the ray leaves.
uint judge(Ray r, Sample s, bool infinite, float distance) {
    if (s.sceneZ >= kBackgroundZ)
        return kOutcomeSky;
    vec3 normalVS = normalAt(s.px);
    vec3 surfaceVS = viewPosition(frame.constants, (floor(s.px) + 0.5) * frame.constants.invSize, s.sceneZ);
    float startZ = -r.originVS.z;
    float nearest = infinite ? startZ : min(startZ, s.rayZ - kVolumeSlack * distance);
    float cosine = abs(dot(normalVS, viewDirection(frame.constants, surfaceVS)));
    float withinPixel = planeSlack(normalVS, s.sceneZ) / max(cosine, 0.01);
    if (s.sceneZ + withinPixel < nearest * (1.0 - kAtSurface))
        return kOutcomeHidden;
    bool own = isOwnSurface(surfaceVS, normalVS, r);
    if (!facesRay(normalVS, own, r)) {
        logDecision(s.px, own ? kSampleGrazes : kSampleBackFace);
        return own ? kOutcomeHidden : kOutcomeBackFace;
    }
    logDecision(s.px, kSampleHit);
    return kOutcomeHit;
}

March march(Ray r) {
    ScreenRay ray = r.screen;
    Projection projection = projectionOf(r);
    logProjection(projection.probe, projection.shape, projection.distance);
    bool infinite = projection.distance >= kBackgroundZ;
    March result = startMarch(ray);
    result.share = 1.0;
    // A direction has no length for screen.maxDistance to cut, but it may lead back past the camera.
    if (infinite ? r.directionVS.z >= 0.0 : ray.clippedNear && projection.distance >= ray.lengthVS) {
        result.outcome = kOutcomeBehindCamera;
        return result;
    }
    if (!infinite && projection.distance > ray.lengthVS) {
        result.outcome = kOutcomeMaxDistance;
        return result;
    }
    if (!infinite)
        result.share = shareAtDistance(ray, projection.distance);
    vec4 endVS = infinite ? vec4(r.directionVS, 0.0) : vec4(r.originVS + r.directionVS * projection.distance, 1.0);
    vec4 endH = frame.constants.viewToPixel * endVS;
    vec2 endPX = endH.xy / endH.w;
    if (endH.w <= 0.0 || !onScreen(endPX)) { // parallel rays never reach infinity on screen: w is 0
        result.outcome = kOutcomeOffScreen;
        return result;
    }
    Sample s = Sample(result.share, endPX, rayViewZ(ray, result.share), loadSceneZ(ivec2(endPX)));
    result.lookups = 1u;
    logSample(ray, s.share, s.px, s.rayZ, s.sceneZ);
    result.hitPX = endPX;
    result.outcome = judge(r, s, infinite, projection.distance);
    result.passedBehind = true; // the path was not tested: rays through the scene know better
    return result;
}

#include "trace/trace_main.glsl"
