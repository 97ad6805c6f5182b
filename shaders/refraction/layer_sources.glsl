// What the sources answer a layer's ray: screen, probes, sky, each with the weight that the sources before it leave.
#ifndef GLINT_REFRACTION_LAYER_SOURCES_GLSL
#define GLINT_REFRACTION_LAYER_SOURCES_GLSL

#include "hierarchy/environment_radiance.glsl"
#include "hierarchy/walk.glsl"
#include "lib/environment.glsl"
#include "refraction/layer_picture.glsl"
#ifdef GLINT_PROBES
#include "probes/probe_cubes.glsl"
#endif

/// 1 well inside the image, 0 at its border.
float borderFade(Leaving ray, vec2 uv) {
    if (!ray.mirrored)
        return ray.bent ? fadeBorderLinear(uv, settings.borderWidth) : 1.0;
    float weight = ray.fade;
    if (isOn(kFadeBorderSmooth))
        weight *= fadeBorderSmooth(uv);
    if (isOn(kFadeBorderLinear))
        weight *= fadeBorderLinear(uv, refraction.reflectionBorderWidth);
    return weight;
}

/// False if the march finds nothing that the frame shows.
bool marchedEnd(Leaving ray, out vec2 endPX, out float distance) {
    uint outcome = marchFrom(ray.originVS, ray.directionVS, ray.mirrored ? ray.normalVS : -ray.directionVS, ray.reach,
                             endPX, distance);
    // Where the frame shows the background at the ray's end, a ray that leaves hits the background.
    bool answered = isAnswered(outcome) || (outcome == kOutcomeSky && !ray.crosses);
    return answered && onScreen(endPX);
}

/// Distance at which the ray hits the proxy of the first probe that holds the object; without one, infinitely far.
float proxyReach(Leaving ray) {
#ifdef GLINT_PROBES
    vec3 originWS = (frame.constants.viewToWorld * vec4(ray.originVS, 1.0)).xyz;
    uvec2 range = probesAround(ray.centerWS);
    for (uint i = range.x; i < range.y; ++i) {
        ProbeRecord probe = probes.list[probeLists.probe[i]];
        if (probeWeightOfObject(probe, ray.centerWS) <= 0.0)
            continue;
        return probe.proxyShape == kProbeNoProxy ? kFar : proxyDistance(probe, originWS, toWorld(ray.directionVS));
    }
#endif
    return kFar;
}

/// One depth sample, at the hit that the proxy gives. False if the frame does not show that place.
bool projectedEnd(Leaving ray, out vec2 endPX, out float distance) {
    distance = proxyReach(ray);
    vec3 hitVS = ray.originVS + ray.directionVS * distance;
    vec4 hitH = frame.constants.viewToPixel * vec4(hitVS, 1.0);
    endPX = vec2(-1.0);
    if (hitH.w <= 0.0 || -hitVS.z < frame.constants.nearZ)
        return false; // behind the camera
    endPX = hitH.xy / hitH.w;
    if (!onScreen(endPX))
        return false;
    if (texelFetch(viewZ, ivec2(endPX), 0).r <= ray.layerZ)
        endPX = vec2(ray.px) + 0.5; // an occluder before the surface: take the light straight behind it
    return true;
}

/// `distance`: of the place whose colour it is, metres along the ray.
vec4 screenAnswer(Leaving ray, out float distance) {
    vec2 endPX;
    bool found = (ray.asks & kLayerProxy) != 0u ? projectedEnd(ray, endPX, distance) : marchedEnd(ray, endPX, distance);
    if (!found)
        return vec4(0.0);
    vec2 uv = endPX * frame.constants.invSize;
    vec3 endVS = ray.originVS + ray.directionVS * distance;
    return vec4(pictureRadiance(ray, uv, distance, max(-endVS.z, 1e-4)), borderFade(ray, uv));
}

vec4 probesAnswerFor(Leaving ray, float left) {
#ifdef GLINT_PROBES
    vec3 originWS = (frame.constants.viewToWorld * vec4(ray.originVS, 1.0)).xyz;
    if (ray.mirrored)
        return probesAnswer(originWS, toWorld(ray.normalVS), toWorld(ray.directionVS), distantRoughness(ray), left,
                            refraction.probeFlags);
    return probesAnswerOfObject(ray.centerWS, originWS, toWorld(ray.directionVS), distantRoughness(ray), left,
                                refraction.probeFlags);
#else
    return vec4(0.0);
#endif
}

/// What the sources answer a ray.
struct Answer {
    vec3 radiance;  // weighted
    vec3 weights;   // of screen, probes and sky
    float distance; // to the hit on screen, metres
};

Answer walkSources(Leaving ray) {
    Walk walk = beginWalk();
    Answer answer = Answer(vec3(0.0), vec3(0.0), 0.0);
    if ((ray.asks & kLayerScreen) != 0u)
        answer.weights.x = take(walk, screenAnswer(ray, answer.distance));
    if ((ray.asks & kLayerProbes) != 0u && walk.taken < 1.0)
        answer.weights.y = take(walk, probesAnswerFor(ray, remaining(walk)));
    if ((ray.asks & kLayerSky) != 0u && walk.taken < 1.0)
        answer.weights.z =
            take(walk, vec4(environmentRadiance(environment, toWorld(ray.directionVS), distantRoughness(ray)), 1.0));
    answer.radiance = walk.radiance;
    return answer;
}

#endif
