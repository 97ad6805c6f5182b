// A layer of transparent surfaces over the frame so far: its transmitted light, refracted, absorbed and blurred, and
// its reflections. Each ray walks through the same sources separately: screen, probes, sky.
// docs/techniques/refraction.md.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#define GLINT_REFRACTION
#include "shared/refraction.h"

#include "trace/hiz_march.glsl"

#include "hierarchy/environment_radiance.glsl"
#include "hierarchy/walk.glsl"
#include "lib/blurred_picture.glsl"
#include "lib/brdf.glsl"
#include "lib/environment.glsl"
#include "lib/fades.glsl"
#include "lib/host_surface.glsl"
#include "lib/input_color.glsl"
#include "lib/refraction.glsl"
#include "lib/transmission.glsl"
#include "lib/user_response.glsl"
#ifdef GLINT_PROBES
#include "probes/probe_cubes.glsl"
#endif

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 23) uniform sampler2D layerDepth;
layout(set = 0, binding = 24) uniform sampler2D layerNormal;
layout(set = 0, binding = 25) uniform sampler2D layerMaterial;
layout(set = 0, binding = 26) uniform sampler2D layerRadiance;
layout(set = 0, binding = 27) uniform sampler2D layerFallback;
layout(set = 0, binding = 28) uniform sampler2D layerTransmittance;
layout(set = 0, binding = 29) uniform sampler2D layerAbsorption;
layout(set = 0, binding = 30) uniform sampler2D layerBody;
layout(set = 0, binding = 31) uniform sampler2D layerCenter;
layout(set = 0, binding = 40) uniform sampler2D layerCoverage;
layout(set = 0, binding = 32) uniform sampler2D behind;  // the frame so far, with mips
layout(set = 0, binding = 38) uniform sampler2D solid;   // the frame without layers, with mips
layout(set = 0, binding = 39) uniform sampler2D layersZ; // viewZ of the nearest layer that `behind` shows
layout(set = 0, binding = 33) uniform samplerCube environment;
layout(set = 0, binding = 34) uniform sampler2D dfg;
layout(set = 0, binding = 35, rgba16f) uniform writeonly image2D composite;
layout(set = 0, binding = 36, rgba16f) uniform writeonly image2D refracted;         // of the nearest layer, for views
layout(set = 0, binding = 37, rgba16f) uniform writeonly image2D refractionWeights; // screen, probes, sky

layout(push_constant, scalar) uniform PushBlock {
    uint layerImages; // kLayer* of the images that are bound
};
RefractionConstants refraction = frame.settings.refraction;

#include "refraction/layer_seen.glsl"

/// A hit farther away than this counts as infinitely far, metres.
const float kFar = 1e4;

bool layerHas(uint flag) {
    return ((refraction.flags | layerImages) & flag) != 0u;
}

/// Change of a ray to that of the next pixel, view space. Igehy 1999, "Tracing Ray Differentials".
struct RayDifferential {
    vec3 origin;
    vec3 direction;
};

const RayDifferential kNoDifferential = RayDifferential(vec3(0.0), vec3(0.0));

/// A ray that leaves a surface or a body, or crosses a body, and the spread of its light.
struct Leaving {
    vec3 originVS;
    vec3 directionVS; // unit
    float reach;      // metres, of the march on screen
    float roughness;  // perceptual: of the lobe
    float travelled;  // metres over which the light has spread before
    vec3 centerWS;    // position that selects the probes
    float layerZ;     // viewZ of the surface
    ivec2 px;         // the pixel that shows the surface
    uint asks;        // kLayerScreen, kLayerProxy, kLayerProbes and kLayerSky: the sources
    bool crosses;     // inside the body, in search of objects there: the background is no answer
    bool mirrored;    // a reflection about this normal
    vec3 normalVS;
    float fade;         // of the screen's answer, [0, 1]
    bool bent;          // false: it is seen in place, up to the image's border
    RayDifferential dx; // to the pixels beside this one and below it
    RayDifferential dy;
};

/// Taps along the longer axis of a footprint.
const float kMostTaps = 8.0;

/// Distance in pixels of the frame between the ends of this pixel's ray and the next one's, both `distance` metres
/// long.
vec2 footprintPX(Leaving ray, RayDifferential d, float distance) {
    vec3 hitVS = ray.originVS + ray.directionVS * distance;
    vec3 nextVS = hitVS + d.origin + d.direction * distance;
    vec4 hitH = frame.constants.viewToPixel * vec4(hitVS, 1.0);
    vec4 nextH = frame.constants.viewToPixel * vec4(nextVS, 1.0);
    if (hitH.w <= 0.0 || nextH.w <= 0.0)
        return vec2(0.0);
    vec2 way = nextH.xy / nextH.w - hitH.xy / hitH.w;
    float most = 0.25 * min(frame.constants.size.x, frame.constants.size.y);
    return way * min(1.0, most / max(length(way), 1e-6));
}

/// Roughness with which to sample a distant environment: covers the lobe and the pixel's footprint together. A GGX lobe
/// spreads directions by twice alpha, a footprint by half its angle.
float distantRoughness(Leaving ray) {
    float angle = 0.5 * (length(ray.dx.direction) + length(ray.dy.direction));
    return sqrt(min(length(vec2(square(ray.roughness), angle / 4.0)), 1.0));
}

/// Radiance of the frame at `uv`, which shows the surface `distance` metres along the ray at `hitZ`. A transparent
/// surface there is assumed to be in the ray's path if it is farther from the eye than the ray's start. Otherwise it is
/// the body itself, or a surface beside it.
vec3 pictureRadiance(Leaving ray, vec2 uv, float distance, float hitZ) {
    // The lobe is a cone about as wide as that of normals; for far surfaces it covers a constant angle.
    float lobe = square(ray.roughness) * (distance + ray.travelled);
    float pixel = pixelExtent(frame.constants, frame.constants.uvToView, hitZ).y;
    ivec2 px = min(ivec2(uv * frame.constants.size), ivec2(frame.constants.size) - 1);
    float otherZ = texelFetch(layersZ, px, 0).r;
    bool through = otherZ < kBackgroundZ && otherZ > -ray.originVS.z;
    // A curved surface shrinks its refracted image: the pixel's footprint in the frame is an ellipse, longer than a
    // pixel. Taps along its longer axis, each blurred as far as the next one.
    vec2 along = footprintPX(ray, ray.dx, distance);
    vec2 across = footprintPX(ray, ray.dy, distance);
    if (dot(across, across) > dot(along, along)) {
        vec2 shorter = along;
        along = across;
        across = shorter;
    }
    float taps = clamp(ceil(length(along) / max(length(across), 1.0)), 1.0, kMostTaps);
    float tapPX = max(length(across), length(along) / taps);
    // A pixel is a box, of standard deviation 1 / sqrt(12); the frame contains one such box already.
    float radius = sqrt(square(lobe / pixel) + max(square(tapPX) - 1.0, 0.0) / 12.0);
    vec3 stored = vec3(0.0);
    for (float tap = 0.5; tap < taps; tap += 1.0) {
        vec2 at = uv + along * ((tap / taps - 0.5) * frame.constants.invSize);
        stored += through ? blurredPicture(behind, at, radius) : blurredPicture(solid, at, radius);
    }
    return linearColor(stored / taps, (frame.constants.flags & kOutputGamma) != 0u);
}

vec3 toWorld(vec3 directionVS) {
    return mat3(frame.constants.viewToWorld) * directionVS;
}

// ---------------------------------------------------------------- sources

/// True if the ray ends in the pixel that it starts from. The march begins behind that pixel.
bool endsInOwnPixel(Ray r, out float share) {
    bool overX;
    share = min(leaveCell(makeLine(r.screen), vec2(r.px), 1.0, overX), 1.0);
    float sceneZ = texelFetch(viewZ, r.px, 0).r;
    return rayViewZ(r.screen, share) >= sceneZ;
}

/// Marches through the depth pyramid. `maxDistance` in metres; `found` is where the march ended.
uint marchFrom(vec3 originVS, vec3 directionVS, vec3 normalVS, float maxDistance, out vec2 endPX, out float distance) {
    Ray r;
    r.originVS = originVS;
    r.originNormalVS = normalVS;
    r.directionVS = directionVS;
    r.screen = makeScreenRay(frame.constants, originVS, directionVS, maxDistance);
    endPX = r.screen.startPX;
    distance = 0.0;
    if (-originVS.z < frame.constants.nearZ)
        return kOutcomeBehindCamera;
    if (!onScreen(endPX))
        return kOutcomeOffScreen;
    r.px = ivec2(endPX);
    float startZ = texelFetch(viewZ, r.px, 0).r;
    if (rayViewZ(r.screen, 0.0) > startZ * (1.0 + kAtSurface))
        return kOutcomeHidden; // it starts behind a surface
    float share;
    if (endsInOwnPixel(r, share)) {
        endPX = clamp(r.screen.startPX + r.screen.deltaPX * share, vec2(r.px), vec2(r.px) + 0.999);
        distance = max(startZ + originVS.z, 0.0) / max(-directionVS.z, 1e-3);
        return kOutcomeHit;
    }
    passedBehind = false;
    March end = march(r);
    distance = rayDistance(r.screen, end.share);
    endPX = isAnswered(end.outcome) ? end.hitPX : r.screen.startPX + r.screen.deltaPX * end.share;
    return end.outcome;
}

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

// ---------------------------------------------------------------- the layer

/// The host's layer at the pixel, with the user's overrides.
struct LayerSurface {
    HostSurface here;
    vec3 positionVS;
    vec3 toEyeVS;
    uint model;
    float ior;
    float thickness;
    vec3 attenuationColor;
    float attenuationDistance;
    float dispersion;
    vec3 centerWS;
};

LayerSurface loadLayer(ivec2 px, float z) {
    LayerSurface s;
    s.here.viewZ = z;
    s.here.normalVS = hostNormalVS(frame.constants, texelFetch(layerNormal, px, 0).xyz);
    vec4 material = texelFetch(layerMaterial, px, 0);
    s.here.f0 = clamp(sanitize(material.rgb), 0.0, 1.0);
    s.here.perceptualRoughness = clamp(sanitize(material.a), 0.0, 1.0);
    s.positionVS = viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z);
    s.toEyeVS = -viewDirection(frame.constants, s.positionVS);
    s.here.normalVS = facingNormal(s.here.normalVS, s.toEyeVS);

    vec4 stored = texelFetch(layerBody, px, 0);
    vec3 body = sanitize(stored.xyz);
    vec4 absorption = texelFetch(layerAbsorption, px, 0);
    uint asked = refraction.flags & kLayerModelMask;
    s.model = asked != 0u ? asked - 1u : min(uint(body.z + 0.5), kRefractionThin);
    s.ior = body.x;
    s.dispersion = refraction.dispersion >= 0.0 ? refraction.dispersion : sanitize(stored.w);
    if (refraction.ior > 0.0 && maxComponent(texelFetch(layerTransmittance, px, 0).rgb) > 0.0) {
        // reflectance follows the overriding index
        s.ior = refraction.ior;
        s.here.f0 = vec3(dielectricF0(s.ior));
    }
    s.thickness = (refraction.thickness >= 0.0 ? refraction.thickness : body.y) * refraction.thicknessMultiplier;
    vec3 override = vec3(unpackHalf2x16(refraction.transmittance.x), unpackHalf2x16(refraction.transmittance.y).x);
    s.attenuationColor = mix(clamp(sanitize(absorption.rgb), 0.0, 1.0), override, greaterThanEqual(override, vec3(0.0)));
    s.attenuationDistance =
        refraction.absorptionDistance >= 0.0 ? refraction.absorptionDistance : sanitize(absorption.a);
    s.centerWS = (frame.constants.viewToWorld * vec4(s.positionVS, 1.0)).xyz;
    if (layerHas(kLayerCenters))
        s.centerWS = texelFetch(layerCenter, px, 0).xyz;
    return s;
}

vec3 pictureAt(ivec2 px) {
    return linearColor(texelFetch(behind, px, 0).rgb, (frame.constants.flags & kOutputGamma) != 0u);
}

/// The ray that brings a pixel's light: its start, behind the body or on the surface, and its direction. `inner`:
/// reflections inside the body.
RayDifferential rayOf(LayerSurface s, bool mirrored, uint inner) {
    if (mirrored)
        return RayDifferential(s.positionVS, reflect(-s.toEyeVS, s.here.normalVS));
    Refraction path = refractThrough(s.model, s.here.normalVS, s.toEyeVS, s.ior, s.thickness, inner);
    return RayDifferential(s.positionVS + path.exit, path.direction);
}

/// Change to the ray of the next pixel along `step`. Takes the smaller difference of both sides, because across an edge
/// lies another surface. The neighbours' bodies are assumed to be this one.
RayDifferential differential(LayerSurface s, ivec2 px, ivec2 step, bool mirrored, uint inner) {
    RayDifferential here = rayOf(s, mirrored, inner);
    RayDifferential least = kNoDifferential;
    float leastTurn = 2.0;
    for (int side = -1; side <= 1; side += 2) {
        ivec2 at = px + side * step;
        if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, ivec2(frame.constants.size))))
            continue;
        LayerSurface next = s;
        next.here.viewZ = storedViewZ(frame.constants, hostViewZ(frame.constants, texelFetch(layerDepth, at, 0).r));
        if (next.here.viewZ >= kBackgroundZ)
            continue;
        next.positionVS = viewPosition(frame.constants, (vec2(at) + 0.5) * frame.constants.invSize, next.here.viewZ);
        next.toEyeVS = -viewDirection(frame.constants, next.positionVS);
        next.here.normalVS =
            facingNormal(hostNormalVS(frame.constants, texelFetch(layerNormal, at, 0).xyz), next.toEyeVS);
        RayDifferential there = rayOf(next, mirrored, inner);
        vec3 turn = (there.direction - here.direction) * float(side);
        if (length(turn) < leastTurn) {
            leastTurn = length(turn);
            least = RayDifferential((there.origin - here.origin) * float(side), turn);
        }
    }
    return least;
}

Leaving mirrorRay(LayerSurface s, ivec2 px) {
    vec3 direction = reflect(-s.toEyeVS, s.here.normalVS);
    float fade = fadeRoughness(s.here.perceptualRoughness, settings.roughnessFadeStart, settings.maxRoughness);
    uint asks = refraction.flags & (kLayerScreen | kLayerProbes | kLayerSky);
    return Leaving(s.positionVS, direction, settings.maxDistance, s.here.perceptualRoughness, 0.0, s.centerWS,
                   s.here.viewZ, px, asks, false, true, s.here.normalVS, fade, true, kNoDifferential, kNoDifferential);
}

/// The surface's own reflection.
Leaving reflectionRay(LayerSurface s, ivec2 px) {
    Leaving ray = mirrorRay(s, px);
    if (ray.fade <= 0.0 || maxComponent(s.here.f0) <= settings.threshold)
        ray.asks &= ~kLayerScreen;
    return ray;
}

bool isBent(LayerSurface s, Refraction path) {
    return path.pathLength > 0.0 && abs(s.ior - 1.0) > 1e-4;
}

/// Roughness of the lobe that leaves the body. Each reflection inside widens it as the surface's own reflection does.
float leavingRoughness(LayerSurface s, uint inner) {
    float roughness = transmissionRoughness(s.here.perceptualRoughness, s.ior);
    if (inner == 0u)
        return roughness;
    float alpha = square(s.here.perceptualRoughness);
    return min(sqrt(length(vec2(square(roughness), alpha * sqrt(float(inner))))), 1.0);
}

/// Across the body, in search of another object that is inside it, or reaches into it.
Leaving crossingRay(LayerSurface s, ivec2 px, Refraction path) {
    return Leaving(s.positionVS, path.insideDir, path.pathLength, leavingRoughness(s, 0u), 0.0, s.centerWS,
                   s.here.viewZ, px, kLayerScreen, true, false, s.here.normalVS, 1.0, false, kNoDifferential,
                   kNoDifferential);
}

Leaving leavingRay(LayerSurface s, ivec2 px, Refraction path, uint inner) {
    uint asks = refraction.flags & (kLayerScreen | kLayerProxy | kLayerProbes | kLayerSky);
    return Leaving(s.positionVS + path.exit, path.direction, kFar, leavingRoughness(s, inner), path.pathLength,
                   s.centerWS, s.here.viewZ, px, asks, false, false, s.here.normalVS, 1.0, isBent(s, path),
                   kNoDifferential, kNoDifferential);
}

/// A body at a pixel, for one channel where it disperses light.
struct Body {
    LayerSurface s;
    bvec3 channels;
    float left; // fraction of the light that has not left the body yet
    vec3 seen;  // what the last path out of the body showed, without absorption
};

Body bodyFor(LayerSurface s, uint channel, bool disperses, vec3 straightBehind) {
    if (!disperses)
        return Body(s, bvec3(true), 1.0, straightBehind);
    s.ior = dispersedIor(s.ior, s.dispersion)[channel];
    return Body(s, equal(uvec3(channel), uvec3(0u, 1u, 2u)), 1.0, straightBehind);
}

/// What the rays of a pixel bring.
struct Light {
    vec3 transmitted; // mean, absorbed along its paths
    vec3 weights;     // of its sources: screen, probes, sky
    vec3 reflected;   // weighted
    float reflectedWeight;
};

/// `fraction` of the light leaves the body towards what has this radiance.
void leave(inout Body body, inout Light light, float fraction, vec3 radiance, vec3 weights) {
    light.transmitted = mix(light.transmitted, light.transmitted + fraction * radiance, body.channels);
    light.weights += fraction * weights / (all(body.channels) ? 1.0 : 3.0);
    body.left -= fraction;
}

vec3 absorbed(LayerSurface s, vec3 radiance, float pathLength) {
    return radiance * volumeTransmittance(pathLength, s.attenuationColor, s.attenuationDistance);
}

/// True if there is nothing to march across: then light comes from straight behind, or from inside the body.
bool skipsCrossing(inout Body body, inout Light light, ivec2 px, Refraction path) {
    if (path.isTotal)
        return true;
    if (!isBent(body.s, path) && leavingRoughness(body.s, 0u) <= 0.0) {
        float toSolid = (texelFetch(viewZ, px, 0).r - body.s.here.viewZ) / max(body.s.toEyeVS.z, 1e-4);
        float inside = min(path.pathLength, max(toSolid, 0.0));
        leave(body, light, body.left, absorbed(body.s, body.seen, inside), vec3(1.0, 0.0, 0.0));
        return true;
    }
    return path.pathLength <= 0.0 || !layerHas(kLayerScreen);
}

/// Follows the rays of a pixel: through the body, for each channel where it disperses light, and the surface's own
/// reflection. `exitReflectance`: fraction that a surface reflects back into the body. One loop over all rays: compilers
/// inline all of the walk through the sources at each call.
Light followRays(LayerSurface s, ivec2 px, float exitReflectance, bool transmits, bool reflects) {
    Light light = Light(vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    bool disperses = s.dispersion > 0.0 && s.ior > 0.0;
    uint inners = exitReflectance > 0.0 ? refraction.innerReflections : 0u;
    uint stages = 2u + inners; // of a body: 0 is across it, n is out of it after n - 1 reflections inside
    uint last = transmits ? stages * (disperses ? 3u : 1u) : 0u; // the surface's own reflection
    vec3 straightBehind = pictureAt(px);
    Body body = bodyFor(s, 0u, false, straightBehind);
    for (uint i = 0u; i < last + (reflects ? 1u : 0u); ++i) {
        bool mirrors = i == last;
        uint stage = mirrors ? 0u : i % stages;
        uint inner = max(stage, 1u) - 1u;
        bool crosses = stage == 0u && !mirrors;
        if (stage == 0u)
            body = bodyFor(s, i / stages, disperses && !mirrors, straightBehind);
        Refraction path =
            refractThrough(body.s.model, s.here.normalVS, s.toEyeVS, body.s.ior, body.s.thickness, inner);
        if (body.left <= 0.0 || (crosses && skipsCrossing(body, light, px, path)))
            continue;
        Leaving ray;
        if (mirrors)
            ray = reflectionRay(s, px);
        else if (crosses)
            ray = crossingRay(body.s, px, path);
        else if (path.isTotal)
            ray = mirrorRay(s, px);
        else
            ray = leavingRay(body.s, px, path, inner);
        if (!crosses) {
            ray.dx = differential(body.s, px, ivec2(1, 0), ray.mirrored, inner);
            ray.dy = differential(body.s, px, ivec2(0, 1), ray.mirrored, inner);
        }
        Answer answer = walkSources(ray);
        float weight = answer.weights.x + answer.weights.y + answer.weights.z;
        if (mirrors) {
            light.reflected = answer.radiance;
            light.reflectedWeight = weight;
        } else if (!crosses) {
            // The remaining weight takes what the last path showed, of the first path what is straight behind.
            body.seen = answer.radiance + (1.0 - weight) * body.seen;
            bool isLast = path.isTotal || path.pathLength <= 0.0 || inner == inners;
            float fraction = isLast ? body.left : body.left * (1.0 - exitReflectance);
            vec3 seen = path.isTotal ? body.seen : absorbed(s, body.seen, path.pathLength);
            leave(body, light, fraction, seen, answer.weights);
        } else if (weight > 0.0) {
            leave(body, light, body.left, absorbed(s, answer.radiance, answer.distance), answer.weights);
        }
    }
    return light;
}

/// Fraction of reflected light that the surface sends to the eye. The rest is transmitted.
vec3 surfaceResponse(LayerSurface s) {
    if (frame.settings.composite.fresnel == 0u)
        return s.here.f0;
    float NoV = clamp(dot(s.here.normalVS, s.toEyeVS), 1e-3, 1.0);
    float f90 = edgeReflectance(maxComponent(s.here.f0));
    return specularResponse(s.here.f0, f90, dfgAt(dfg, NoV, s.here.perceptualRoughness));
}

vec3 layered(LayerSurface s, ivec2 px) {
    vec4 radiance = texelFetch(layerRadiance, px, 0);
    vec4 tint = texelFetch(layerTransmittance, px, 0);
    bool encoded = (frame.constants.flags & kInputGamma) != 0u;
    float coverage = saturate(sanitize(radiance.a));
    vec3 result = pictureAt(px) * (1.0 - coverage) + linearColor(radiance.rgb, encoded);
    vec3 response = surfaceResponse(s);
    float reflectance = saturate(maxComponent(response));
    CompositeConstants composited = frame.settings.composite;
    bool lerps = composited.model != 0u; // transmitted light is a part of what the reflection is lerped over
    vec3 through = sanitize(tint.rgb) * (lerps ? 1.0 : 1.0 - reflectance);
    bool reflects = layerHas(kLayerReflects) && maxComponent(s.here.f0) > 0.0 && tint.a > 0.0;
    Light light = followRays(s, px, reflectance, maxComponent(through) > 0.0, reflects);
    result += through * light.transmitted;
    if (reflects && lerps) {
        vec4 reflection = vec4(light.reflected, light.reflectedWeight);
        float NoV = clamp(dot(s.here.normalVS, s.toEyeVS), 0.0, 1.0);
        float f90 = edgeReflectance(maxComponent(s.here.f0));
        vec3 lerped = lerpedReflection(composited, result, reflection, s.here.f0, f90, NoV);
        result = mix(result, lerped, saturate(tint.a));
    } else if (reflects) {
        Response given = userResponse(composited, response);
        if (layerHas(kLayerFallback))
            result -= light.reflectedWeight * given.taken * linearColor(texelFetch(layerFallback, px, 0).rgb, encoded);
        result += light.reflected * given.value * saturate(tint.a);
    }
    if (layerHas(kLayerViews)) {
        imageStore(refracted, px, vec4(light.transmitted, 1.0));
        imageStore(refractionWeights, px, vec4(light.weights, 1.0));
    }
    return sanitize(result);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    float z = seenLayerZ(px);
    if (z >= kBackgroundZ)
        return; // the layer is not seen here
    vec3 result = layered(loadLayer(px, z), px);
    if (layerHas(kLayerCoverage))
        result = mix(pictureAt(px), result, saturate(sanitize(texelFetch(layerCoverage, px, 0).r)));
    if ((frame.constants.flags & kOutputGamma) != 0u)
        result = encodeSrgb(result);
    imageStore(composite, px, vec4(result, texelFetch(behind, px, 0).a));
}
