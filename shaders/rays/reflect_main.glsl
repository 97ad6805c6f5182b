// The source `rays`: the reflections of the listed pixels, traced through the host's triangles. A ray that hits a
// surface adds the surface's light and continues from there for up to rays.bounces bounces. The last surface reflects
// the environment, as in the host's own frames. docs/techniques/ray-reflections.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "rays/surface_table.glsl"

#include "rays/back_end.glsl"
#include "rays/rays_inputs.glsl"

#include "rays/hit_lighting.glsl"
#include "rays/pixel_rays.glsl"
#include "rays/regularization.glsl"
#include "rays/shown_surface.glsl"
#include "rays/transparents.glsl"

#include "rays/after_screen.glsl"

layout(local_size_x = 64) in; // kRaysPerGroup

layout(set = 0, binding = 7, rgba16f) uniform writeonly image2D raysRadianceWeight;
layout(set = 0, binding = 8, rgba32ui) uniform writeonly uimage2D raysRecord;
layout(set = 0, binding = 11, rgba32f) uniform image2D raysSum;  // all samples: weighted radiance, known weight
layout(set = 0, binding = 12, r32f) uniform image2D raysWeights; // all samples: weight (both: kRaysAccumulate)

/// Paths with less throughput end: half of what an 8-bit image can show.
const float kLeastThroughput = 1.0 / 512.0;

// ---------------------------------------------------------------- a path

struct Path {
    vec3 radiance;
    float weight;      // 0: the path's radiance is unknown
    float hitDistance; // metres, of the first ray
    vec3 hitWS;
    bool hit;    // the first ray hit a surface
    uint rays;   // rays traced, without shadow rays
    uint reused; // hits lit from the frame's colour

    // how the path continues
    bool ended;
    vec3 throughput;
    Ray ray;
    Cone cone;
    PathSpread spread;
    float regularization; // fraction of the spread by which hits are blurred
    Medium medium;
    uint transparents; // transparent surfaces that it may still pass through
};

/// `lobeRoughness`: perceptual, of the lobe that the direction was drawn from.
Path startPath(vec3 originWS, vec3 directionWS, Cone cone, float lobeRoughness, float regularization) {
    return Path(vec3(0.0), 1.0, 0.0, originWS, false, 0u, 0u, false, vec3(1.0), viewRay(originWS, directionWS), cone,
                PathSpread(0.0, lobeAngle(sampledRoughness(lobeRoughness))), regularization, kAir,
                isOn(kRaysTransparents) ? settings.transparents : 0u);
}

LitSurface litSurface(HitSurface met, vec3 V, float share, float spread) {
    MaterialSample m = sampleMaterial(met.material, met.point);
    float ownRoughness = m.perceptualRoughness;
    m.perceptualRoughness = regularized(ownRoughness, share, spread);
    m.clearcoatPerceptualRoughness = regularized(m.clearcoatPerceptualRoughness, share, spread);
    litFaceNormalWS = met.faceNormalWS;
    Lighting lighting = lightSurface(m, met.point, V);
    LitSurface lit;
    lit.positionWS = met.point.positionWS;
    lit.faceNormalWS = met.faceNormalWS;
    lit.normalWS = m.normalWS;
    lit.perceptualRoughness = ownRoughness;
    lit.lobeRoughness = m.perceptualRoughness;
    lit.bend = met.bend;
    lit.own = lighting.diffuse + lighting.directSpecular + lighting.coatSpecular + lighting.emission;
    float coat = m.clearcoat > 0.0 ? coatReflectance(m, V) : 0.0;
    lit.response =
        specularResponse(m.f0, m.f90, loadDfg(clampedNoV(m.normalWS, V), m.perceptualRoughness)) * (1.0 - coat);
    lit.environmentSpecular = lighting.environmentSpecular;
    return lit;
}

/// The hit, lit from the frame where the frame shows it, else from the host's table.
LitSurface surfaceAt(Hit hit, inout Path path) {
    HitSurface met =
        hitSurface(hit.instance, hit.primitive, hit.barycentrics, hit.frontFace, path.ray.directionWS, path.cone.width);
    float spread = halfVectorSpread(path.spread, met.bend);
    if (isOn(kRaysReuseLight)) {
        ivec2 px = pixelThatShows(met.point.positionWS, met.faceNormalWS, path.ray.directionWS, path.cone.width);
        if (px.x >= 0) {
            ++path.reused;
            LitSurface shown = shownSurface(px, met.point.positionWS, met.faceNormalWS, path.ray.directionWS,
                                            path.regularization, spread);
            shown.bend = met.bend;
            return shown;
        }
    }
    return litSurface(met, -path.ray.directionWS, path.regularization, spread);
}

/// Adds the light of the surface that bounce number `bounce` hit, and continues from there while bounces remain.
void leaveSurface(LitSurface met, uint bounce, ivec2 px, uint sampleIndex, inout Path path) {
    bool last = bounce + 1u == settings.bounces || met.perceptualRoughness > settings.maxRoughness ||
                maxComponent(path.throughput * met.response) < kLeastThroughput;
    Direction next = Direction(vec3(0.0), 0.0);
    if (!last)
        next = sampleLobe(met.normalWS, -path.ray.directionWS, sampledRoughness(met.lobeRoughness),
                          laterBounceNoise(px, sampleIndex, bounce, frame.constants.seed));
    path.ended = next.weight <= 0.0;
    path.radiance += path.throughput * (met.own + (path.ended ? met.environmentSpecular : vec3(0.0)));
    path.throughput *= met.response;
    path.spread = reflected(path.spread, met.bend, sampledRoughness(met.lobeRoughness));
    float offset = settings.tMin > 0.0 ? 0.0 : hitUncertainty(met.positionWS);
    path.ray = viewRay(met.positionWS + met.faceNormalWS * offset, aboveSurface(next.ws, met.faceNormalWS));
    if (path.medium.body != kNoInstance && path.transparents > 0u)
        path.ray.flags &= ~kRayCullBackFaces;
}

void leaveScene(uint bounce, inout Path path) {
    path.ended = true;
    if (isOn(kRaysEnvironment))
        path.radiance +=
            path.throughput * loadEnvironmentRadiance(path.ray.directionWS,
                                                      regularized(0.0, path.regularization, 0.5 * path.spread.angle));
    else if (!path.hit)
        path.weight = 0.0;
}

void meetFirst(vec3 hitWS, float distance, inout Path path) {
    path.hit = true;
    path.hitDistance = distance;
    path.hitWS = hitWS;
}

/// Adds the light of a transparent surface and continues behind it.
void passTransparent(Hit hit, vec2 noise, inout Path path) {
    HitSurface met =
        hitSurface(hit.instance, hit.primitive, hit.barycentrics, hit.frontFace, path.ray.directionWS, path.cone.width);
    bool leaves = path.medium.body == hit.instance && !hit.frontFace;
    Passage p;
    if (leaves)
        p = leaveBody(met, path.medium, path.ray.directionWS, noise);
    else
        p = passSurface(met, hit.instance, path.medium, path.ray.directionWS, noise, path.regularization,
                        halfVectorSpread(path.spread, met.bend));
    if (!path.hit)
        meetFirst(met.point.positionWS, hit.distance, path);
    path.radiance += path.throughput * p.own;
    path.throughput *= p.through;
    path.ended = maxComponent(path.throughput) < kLeastThroughput;
    path.medium = p.medium;
    --path.transparents;
    path.cone.spread += p.power * met.bend * path.cone.width;
    path.spread.angle =
        length(vec2(path.spread.angle + p.power * met.bend * path.spread.width, p.power * lobeAngle(p.lobeRoughness)));
    float offset = hitUncertainty(met.point.positionWS);
    path.ray = viewRay(met.point.positionWS + met.faceNormalWS * (p.isReflected ? offset : -offset), p.directionWS);
    if (path.medium.body != kNoInstance && path.transparents > 0u)
        path.ray.flags &= ~kRayCullBackFaces; // to hit the body's far side
}

/// The next surface that is not transparent or that ends the path.
Hit traceThrough(uint bounce, ivec2 px, uint sampleIndex, inout Path path) {
    Hit hit;
    bool transparent;
    do {
        rayMeetsTransparents = path.transparents > 0u;
        hit = traceRay(path.ray);
        ++path.rays;
        bool met = isHit(hit);
        transparent = met && rayMeetsTransparents && isTransparent(instanceMaterial(hit.instance));
        rayMeetsTransparents = false;
        path.throughput *= mediumTransmittance(path.medium, hit.distance, met && hit.instance == path.medium.body);
        if (met) {
            path.cone.width += path.cone.spread * hit.distance;
            path.spread = travelled(path.spread, hit.distance);
        }
        if (transparent)
            passTransparent(hit, laterBounceNoise(px, sampleIndex, bounce, ~frame.constants.seed - path.transparents),
                            path);
    } while (transparent && !path.ended);
    return hit;
}

/// `bounce`: number of surfaces that the path has hit already.
void followPath(uint bounce, ivec2 px, uint sampleIndex, inout Path path) {
    for (; bounce < settings.bounces && !path.ended; ++bounce) {
        Hit hit = traceThrough(bounce, px, sampleIndex, path);
        if (path.ended)
            return;
        if (!isHit(hit)) {
            leaveScene(bounce, path);
            return;
        }
        LitSurface met = surfaceAt(hit, path);
        if (!path.hit)
            meetFirst(met.positionWS, hit.distance, path);
        leaveSurface(met, bounce, px, sampleIndex, path);
    }
}

/// A path whose first hit is the hit of the screen's ray.
Path pathFromScreen(PixelRays from, RayRecord screen, uint i, float regularization) {
    Path path = startPath(from.originWS, reflect(-from.V, from.N), from.cone, 0.0, regularization);
    ivec2 px = hitPixel(screen);
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    vec3 shownVS = viewPosition(frame.constants, uv, texelFetch(viewZ, px, 0).r);
    vec3 shownWS = (frame.constants.viewToWorld * vec4(shownVS, 1.0)).xyz;
    vec3 normalWS = mat3(frame.constants.viewToWorld) * unpackSurface(texelFetch(surface, px, 0).xy).normalVS;
    // The record's distance has eleven bits. The pixel's plane gives a more exact one, unless the ray runs along the
    // plane.
    float distance = dot(shownWS - from.originWS, normalWS) / min(dot(path.ray.directionWS, normalWS), -1e-3);
    if (abs(distance - screen.hitDistance) > 0.05 * screen.hitDistance)
        distance = screen.hitDistance;
    vec3 hitWS = from.originWS + path.ray.directionWS * distance;
    path.hit = true;
    path.hitDistance = distance;
    path.hitWS = hitWS;
    path.cone.width += path.cone.spread * distance;
    ++path.reused;
    LitSurface met = shownSurface(px, hitWS, normalWS, path.ray.directionWS, 0.0, 0.0);
    bool halfDepth = (frame.constants.flags & kInputHalfDepth) != 0u;
    met.positionWS += normalWS * depthUncertainty(hitWS, -shownVS.z, halfDepth);
    leaveSurface(met, 0u, from.px, sampleNumber(i), path);
    return path;
}

// ---------------------------------------------------------------- a pixel

/// True if the first hit of this pixel's only path is in the screen's answer.
bool startsOnScreen(bool mirror, RayRecord screen) {
    return mirror && isAfterScreen() && isCertain(screen) && metReflector(screen) &&
           frame.constants.traceSize == frame.constants.size;
}

void main() {
    uint index = listedRay();
    if (index >= rays.header.rayCount)
        return;
    PixelRays from = loadPixelRays(index);
    bool mirror = isOn(kRaysMirror) || from.perceptualRoughness < kMirrorRoughness;
    uint samples = mirror && settings.bounces == 1u ? 1u : settings.samples; // further samples would be equal
    RayRecord screen = screenRay(from.px);
    bool fromScreen = startsOnScreen(mirror, screen);
    vec4 sum = vec4(0.0); // weighted radiance, weight of known samples
    float weights = 0.0;
    if (isOn(kRaysAccumulate)) {
        sum = imageLoad(raysSum, from.px);
        weights = imageLoad(raysWeights, from.px).r;
    }
    RayRecord record = RayRecord(from.uv, 0.0, 0u, kOutcomeSky, false);
    float hits = 0.0;
    uint reused = 0u;
    for (uint i = 0u; i < samples; ++i) {
        Direction first = samplePixel(from, i);
        if (first.weight <= 0.0 && i + 1u == samples && weights == 0.0 && !isOn(kRaysAccumulate))
            first = Direction(reflect(-from.V, from.N), 1.0); // all went below: use the middle of the lobe
        if (first.weight <= 0.0)
            continue;
        weights += first.weight;
        float regularization = regularizationOf(settings.regularization, weights);
        Path path = fromScreen
                        ? pathFromScreen(from, screen, i, regularization)
                        : startPath(from.originWS, first.ws, from.cone, from.perceptualRoughness, regularization);
        followPath(fromScreen ? 1u : 0u, from.px, sampleNumber(i), path);
        sum += first.weight * path.weight * vec4(sanitize(path.radiance), 1.0);
        record.lookups += path.rays;
        reused += path.reused;
        if (path.hit) {
            record.hitDistance += path.hitDistance;
            hits += 1.0;
            if (record.outcome != kOutcomeHit)
                record.hitUV = projectedUV(path.hitWS);
            record.outcome = kOutcomeHit;
        }
    }
    record.hitDistance /= max(hits, 1.0);
    if (isOn(kRaysAccumulate)) {
        imageStore(raysSum, from.px, sum);
        imageStore(raysWeights, from.px, vec4(weights));
    }
    vec4 answer = sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a / weights) : vec4(0.0);
    imageStore(raysRadianceWeight, from.px, vec4(sanitize(answer.rgb), answer.a));
    uint route = min(reused, kRaysReusedMask) | (fromScreen ? kRaysStartOnScreen : 0u) |
                 (takesBack(screen) ? kRaysReplaceScreen : 0u);
    imageStore(raysRecord, from.px, uvec4(packRayRecord(record), route, 0u));
}
