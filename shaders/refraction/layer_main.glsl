// A layer of transparent surfaces over the frame so far: its transmitted light, refracted, absorbed and blurred, and
// its reflections. Each of the two rays walks through the same sources separately: screen, probes, sky.
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

/// A ray that leaves a surface or a body, and the spread of its light.
struct Leaving {
    vec3 originVS;
    vec3 directionVS; // unit
    float roughness;  // perceptual: of the lobe
    float travelled;  // metres over which the light has spread before
    vec3 centerWS;    // position that selects the probes
    float layerZ;     // viewZ of the surface
    ivec2 px;         // the pixel that shows the surface
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

vec4 marchedAnswer(Leaving ray) {
    vec2 endPX;
    float distance;
    uint outcome = marchFrom(ray.originVS, ray.directionVS, ray.mirrored ? ray.normalVS : -ray.directionVS,
                             ray.mirrored ? settings.maxDistance : kFar, endPX, distance);
    // Where the frame shows the background at the ray's end, the ray hits the background.
    bool answered = isAnswered(outcome) || outcome == kOutcomeSky;
    vec2 uv = endPX * frame.constants.invSize;
    if (!answered || !onScreen(endPX))
        return vec4(0.0);
    vec3 endVS = ray.originVS + ray.directionVS * distance;
    return vec4(pictureRadiance(ray, uv, distance, max(-endVS.z, 1e-4)), borderFade(ray, uv));
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

/// One depth sample, at the hit that the proxy gives.
vec4 projectedAnswer(Leaving ray) {
    float distance = proxyReach(ray);
    vec3 hitVS = ray.originVS + ray.directionVS * distance;
    vec4 hitH = frame.constants.viewToPixel * vec4(hitVS, 1.0);
    if (hitH.w <= 0.0 || -hitVS.z < frame.constants.nearZ)
        return vec4(0.0); // behind the camera
    vec2 px = hitH.xy / hitH.w;
    if (!onScreen(px))
        return vec4(0.0);
    if (texelFetch(viewZ, ivec2(px), 0).r <= ray.layerZ)
        px = vec2(ray.px) + 0.5; // an occluder before the surface: take the light straight behind it
    vec2 uv = px * frame.constants.invSize;
    return vec4(pictureRadiance(ray, uv, distance, max(-hitVS.z, 1e-4)), borderFade(ray, uv));
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

/// Weighted radiance and the weights of screen, probes and sky.
vec3 walkSources(Leaving ray, bool askScreen, bool proxy, out vec3 weights) {
    Walk walk = beginWalk();
    weights = vec3(0.0);
    if (askScreen)
        weights.x = take(walk, proxy ? projectedAnswer(ray) : marchedAnswer(ray));
    if (layerHas(kLayerProbes) && walk.taken < 1.0)
        weights.y = take(walk, probesAnswerFor(ray, remaining(walk)));
    if (layerHas(kLayerSky) && walk.taken < 1.0)
        weights.z = take(walk, vec4(environmentRadiance(environment, toWorld(ray.directionVS), distantRoughness(ray)), 1.0));
    return walk.radiance;
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

/// The ray that brings a pixel's light: its start, behind the body or on the surface, and its direction.
RayDifferential rayOf(LayerSurface s, bool mirrored) {
    if (mirrored)
        return RayDifferential(s.positionVS, reflect(-s.toEyeVS, s.here.normalVS));
    Refraction path = refractThrough(s.model, s.here.normalVS, s.toEyeVS, s.ior, s.thickness);
    return RayDifferential(s.positionVS + path.exit, path.direction);
}

/// Change to the ray of the next pixel along `step`. Takes the smaller difference of both sides, because across an edge
/// lies another surface. The neighbours' bodies are assumed to be this one.
RayDifferential differential(LayerSurface s, ivec2 px, ivec2 step, bool mirrored) {
    RayDifferential here = rayOf(s, mirrored);
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
        RayDifferential there = rayOf(next, mirrored);
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
    return Leaving(s.positionVS, direction, s.here.perceptualRoughness, 0.0, s.centerWS, s.here.viewZ, px, true,
                   s.here.normalVS, fade, true, differential(s, px, ivec2(1, 0), true),
                   differential(s, px, ivec2(0, 1), true));
}

vec3 reflectedRadiance(LayerSurface s, ivec2 px, out float weight) {
    Leaving ray = mirrorRay(s, px);
    bool askScreen = layerHas(kLayerScreen) && ray.fade > 0.0 && maxComponent(s.here.f0) > settings.threshold;
    vec3 weights;
    vec3 radiance = walkSources(ray, askScreen, false, weights);
    weight = weights.x + weights.y + weights.z;
    return radiance;
}

/// Mean transmitted radiance, absorbed along the path. The remaining weight takes the light straight behind.
vec3 transmittedLight(LayerSurface s, ivec2 px, out vec3 weights) {
    Refraction path = refractThrough(s.model, s.here.normalVS, s.toEyeVS, s.ior, s.thickness);
    float roughness = transmissionRoughness(s.here.perceptualRoughness, s.ior);
    vec3 left = pictureAt(px);
    weights = vec3(1.0, 0.0, 0.0);
    if (path.isTotal) {
        vec3 radiance = walkSources(mirrorRay(s, px), layerHas(kLayerScreen), false, weights);
        return radiance + (1.0 - weights.x - weights.y - weights.z) * left;
    }
    vec3 entryVS = s.positionVS;
    bool bent = path.pathLength > 0.0 && abs(s.ior - 1.0) > 1e-4;
    if (!bent && roughness <= 0.0) { // no march: the light is straight behind, or comes from inside the body
        float toSolid = (texelFetch(viewZ, px, 0).r - s.here.viewZ) / max(s.toEyeVS.z, 1e-4);
        return left *
               volumeTransmittance(min(path.pathLength, max(toSolid, 0.0)), s.attenuationColor, s.attenuationDistance);
    }
    // Another object may be inside the body, or reach into it.
    if (path.pathLength > 0.0 && layerHas(kLayerScreen)) {
        vec2 endPX;
        float distance;
        uint outcome = marchFrom(entryVS, path.insideDir, -path.insideDir, path.pathLength, endPX, distance);
        if (isAnswered(outcome) && onScreen(endPX)) {
            Leaving inside = Leaving(entryVS, path.insideDir, roughness, 0.0, s.centerWS, s.here.viewZ, px, false,
                                     s.here.normalVS, 1.0, bent, kNoDifferential, kNoDifferential);
            vec3 endVS = entryVS + path.insideDir * distance;
            return pictureRadiance(inside, endPX * frame.constants.invSize, distance, max(-endVS.z, 1e-4)) *
                   volumeTransmittance(distance, s.attenuationColor, s.attenuationDistance);
        }
    }
    vec3 transmittance = volumeTransmittance(path.pathLength, s.attenuationColor, s.attenuationDistance);
    Leaving ray = Leaving(entryVS + path.exit, path.direction, roughness, path.pathLength, s.centerWS, s.here.viewZ, px,
                          false, s.here.normalVS, 1.0, bent, differential(s, px, ivec2(1, 0), false),
                          differential(s, px, ivec2(0, 1), false));
    vec3 radiance = walkSources(ray, layerHas(kLayerScreen), layerHas(kLayerProxy), weights);
    return (radiance + (1.0 - weights.x - weights.y - weights.z) * left) * transmittance;
}

/// Each channel has its own index of refraction where the body disperses light.
vec3 transmittedRadiance(LayerSurface s, ivec2 px, out vec3 weights) {
    if (s.dispersion <= 0.0 || s.ior <= 0.0)
        return transmittedLight(s, px, weights);
    vec3 iors = dispersedIor(s.ior, s.dispersion);
    vec3 sum = vec3(0.0);
    weights = vec3(0.0);
    for (int channel = 0; channel < 3; ++channel) {
        LayerSurface colored = s;
        colored.ior = iors[channel];
        vec3 share;
        sum[channel] = transmittedLight(colored, px, share)[channel];
        weights += share / 3.0;
    }
    return sum;
}

vec3 layered(LayerSurface s, ivec2 px) {
    vec4 radiance = texelFetch(layerRadiance, px, 0);
    vec4 tint = texelFetch(layerTransmittance, px, 0);
    bool encoded = (frame.constants.flags & kInputGamma) != 0u;
    float coverage = saturate(sanitize(radiance.a));
    vec3 result = pictureAt(px) * (1.0 - coverage) + linearColor(radiance.rgb, encoded);
    vec2 argument = vec2(clamp(dot(s.here.normalVS, s.toEyeVS), 1e-3, 1.0), s.here.perceptualRoughness);
    float f90 = edgeReflectance(maxComponent(s.here.f0));
    vec3 response = specularResponse(s.here.f0, f90, textureLod(dfg, dfgUV(argument, textureSize(dfg, 0).x), 0.0).rg);
    vec3 through = sanitize(tint.rgb) * (1.0 - saturate(maxComponent(response)));
    vec3 weights = vec3(0.0);
    vec3 transmitted = vec3(0.0);
    if (maxComponent(through) > 0.0) {
        transmitted = transmittedRadiance(s, px, weights);
        result += through * transmitted;
    }
    if (layerHas(kLayerReflects) && maxComponent(s.here.f0) > 0.0 && tint.a > 0.0) {
        float weight;
        vec3 reflected = reflectedRadiance(s, px, weight);
        if (layerHas(kLayerFallback))
            result -= weight * linearColor(texelFetch(layerFallback, px, 0).rgb, encoded);
        result += reflected * response * (saturate(tint.a) * refraction.strength);
    }
    if (layerHas(kLayerViews)) {
        imageStore(refracted, px, vec4(transmitted, 1.0));
        imageStore(refractionWeights, px, vec4(weights, 1.0));
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
