// The source `rays`: what the listed pixels reflect, by rays through the host's triangles. A ray that meets a surface
// brings its light, and goes on from there while rays.bounces lasts; the last surface reflects the environment, as the
// host's own pictures of it do. docs/techniques/ray-reflections.md.
#include "rays/hit_lighting.glsl"
#include "rays/pixel_rays.glsl"
#include "rays/shown_surface.glsl"

#include "rays/after_screen.glsl"

layout(local_size_x = 64) in; // kRaysPerGroup

layout(set = 0, binding = 7, rgba16f) uniform writeonly image2D raysRadianceWeight;
layout(set = 0, binding = 8, rgba32ui) uniform writeonly uimage2D raysRecord;
layout(set = 0, binding = 11, rgba32f) uniform image2D raysSum;  // kRaysAccumulate: over all samples so far, weighted
layout(set = 0, binding = 12, r32f) uniform image2D raysWeights; // radiance and weight of what is known; weight

/// Less is no longer followed: half of what an 8-bit picture can show.
const float kLeastThroughput = 1.0 / 512.0;

// ---------------------------------------------------------------- a path

struct Path {
    vec3 radiance;
    float weight;      // 0: nothing is known of where it leads
    float hitDistance; // metres, of its first ray
    vec3 hitWS;
    bool hit;    // its first ray met a surface
    uint rays;   // that it took, those for shadows apart
    uint reused; // hits whose light was in the picture

    // where it goes on
    bool ended;
    vec3 throughput;
    Ray ray;
    Cone cone;
};

Path startPath(vec3 originWS, vec3 directionWS, Cone cone) {
    return Path(vec3(0.0), 1.0, 0.0, originWS, false, 0u, 0u, false, vec3(1.0), viewRay(originWS, directionWS), cone);
}

LitSurface litSurface(HitSurface met, vec3 V) {
    MaterialSample m = sampleMaterial(met.material, met.point);
    litFaceNormalWS = met.faceNormalWS;
    Lighting lighting = lightSurface(m, met.point, V);
    LitSurface lit;
    lit.positionWS = met.point.positionWS;
    lit.faceNormalWS = met.faceNormalWS;
    lit.normalWS = m.normalWS;
    lit.perceptualRoughness = m.perceptualRoughness;
    lit.own = lighting.diffuse + lighting.directSpecular + lighting.coatSpecular + lighting.emission;
    float coat = m.clearcoat > 0.0 ? coatReflectance(m, V) : 0.0;
    lit.response =
        specularResponse(m.f0, m.f90, loadDfg(clampedNoV(m.normalWS, V), m.perceptualRoughness)) * (1.0 - coat);
    lit.environmentSpecular = lighting.environmentSpecular;
    return lit;
}

/// By the picture where it shows the hit, else by the host's table.
LitSurface surfaceAt(Hit hit, inout Path path) {
    HitSurface met =
        hitSurface(hit.instance, hit.primitive, hit.barycentrics, hit.frontFace, path.ray.directionWS, path.cone.width);
    if (isOn(kRaysReuseLight)) {
        ivec2 px = pixelThatShows(met.point.positionWS, met.faceNormalWS, path.ray.directionWS, path.cone.width);
        if (px.x >= 0) {
            ++path.reused;
            return shownSurface(px, met.point.positionWS, met.faceNormalWS, path.ray.directionWS);
        }
    }
    return litSurface(met, -path.ray.directionWS);
}

/// Takes the light of what bounce number `bounce` has met, and goes on from there while there are bounces left.
void leaveSurface(LitSurface met, uint bounce, ivec2 px, uint sampleIndex, inout Path path) {
    bool last = bounce + 1u == settings.bounces || met.perceptualRoughness > settings.maxRoughness ||
                maxComponent(path.throughput * met.response) < kLeastThroughput;
    Direction next = Direction(vec3(0.0), 0.0);
    if (!last)
        next = sampleReflection(met.normalWS, -path.ray.directionWS, met.perceptualRoughness,
                                laterBounceNoise(px, sampleIndex, bounce, frame.constants.seed));
    path.ended = next.weight <= 0.0;
    path.radiance += path.throughput * (met.own + (path.ended ? met.environmentSpecular : vec3(0.0)));
    path.throughput *= met.response;
    float offset = settings.tMin > 0.0 ? 0.0 : hitUncertainty(met.positionWS);
    path.ray = viewRay(met.positionWS + met.faceNormalWS * offset, aboveSurface(next.ws, met.faceNormalWS));
}

void leaveScene(uint bounce, inout Path path) {
    path.ended = true;
    if (isOn(kRaysEnvironment))
        path.radiance += path.throughput * loadEnvironmentRadiance(path.ray.directionWS, 0.0);
    else if (bounce == 0u)
        path.weight = 0.0;
}

/// `bounce`: surfaces that the path has met already.
void followPath(uint bounce, ivec2 px, uint sampleIndex, inout Path path) {
    for (; bounce < settings.bounces && !path.ended; ++bounce) {
        Hit hit = traceRay(path.ray);
        ++path.rays;
        if (!isHit(hit)) {
            leaveScene(bounce, path);
            return;
        }
        path.cone.width += path.cone.spread * hit.distance;
        LitSurface met = surfaceAt(hit, path);
        if (bounce == 0u) {
            path.hit = true;
            path.hitDistance = hit.distance;
            path.hitWS = met.positionWS;
        }
        leaveSurface(met, bounce, px, sampleIndex, path);
    }
}

/// The first hit is the one that the screen's ray has found.
Path pathFromScreen(PixelRays from, RayRecord screen, uint i) {
    Path path = startPath(from.originWS, reflect(-from.V, from.N), from.cone);
    ivec2 px = hitPixel(screen);
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    vec3 shownVS = viewPosition(frame.constants, uv, texelFetch(viewZ, px, 0).r);
    vec3 shownWS = (frame.constants.viewToWorld * vec4(shownVS, 1.0)).xyz;
    vec3 normalWS = mat3(frame.constants.viewToWorld) * unpackSurface(texelFetch(surface, px, 0).xy).normalVS;
    // The record's distance has eleven bits; the pixel's plane says it better, unless the ray runs along it.
    float distance = dot(shownWS - from.originWS, normalWS) / min(dot(path.ray.directionWS, normalWS), -1e-3);
    if (abs(distance - screen.hitDistance) > 0.05 * screen.hitDistance)
        distance = screen.hitDistance;
    vec3 hitWS = from.originWS + path.ray.directionWS * distance;
    path.hit = true;
    path.hitDistance = distance;
    path.hitWS = hitWS;
    path.cone.width += path.cone.spread * distance;
    ++path.reused;
    LitSurface met = shownSurface(px, hitWS, normalWS, path.ray.directionWS);
    bool halfDepth = (frame.constants.flags & kInputHalfDepth) != 0u;
    met.positionWS += normalWS * depthUncertainty(hitWS, -shownVS.z, halfDepth);
    leaveSurface(met, 0u, from.px, sampleNumber(i), path);
    return path;
}

// ---------------------------------------------------------------- a pixel

/// Does the first hit of this pixel's only path stand in the screen's answer?
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
    uint samples = mirror && settings.bounces == 1u ? 1u : settings.samples; // all the same
    RayRecord screen = screenRay(from.px);
    bool fromScreen = startsOnScreen(mirror, screen);
    vec4 sum = vec4(0.0); // weighted radiance, weight of what is known
    float weights = 0.0;
    RayRecord record = RayRecord(from.uv, 0.0, 0u, kOutcomeSky, false);
    float hits = 0.0;
    uint reused = 0u;
    for (uint i = 0u; i < samples; ++i) {
        Direction first = samplePixel(from, i);
        if (first.weight <= 0.0 && i + 1u == samples && weights == 0.0 && !isOn(kRaysAccumulate))
            first = Direction(reflect(-from.V, from.N), 1.0); // all went below: the middle of the lobe stands for it
        if (first.weight <= 0.0)
            continue;
        weights += first.weight;
        Path path = fromScreen ? pathFromScreen(from, screen, i) : startPath(from.originWS, first.ws, from.cone);
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
        sum += imageLoad(raysSum, from.px);
        weights += imageLoad(raysWeights, from.px).r;
        imageStore(raysSum, from.px, sum);
        imageStore(raysWeights, from.px, vec4(weights));
    }
    vec4 answer = sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a / weights) : vec4(0.0);
    imageStore(raysRadianceWeight, from.px, vec4(sanitize(answer.rgb), answer.a));
    uint route = min(reused, kRaysReusedMask) | (fromScreen ? kRaysStartOnScreen : 0u) |
                 (takesBack(screen) ? kRaysReplaceScreen : 0u);
    imageStore(raysRecord, from.px, uvec4(packRayRecord(record), route, 0u));
}
