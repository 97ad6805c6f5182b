// The source `rays`: the reflections of the listed pixels, traced through the host's triangles.
// docs/techniques/ray-reflections.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "rays/surface_table.glsl"

#include "rays/back_end.glsl"
#include "rays/rays_inputs.glsl"

#include "rays/path.glsl"

#include "denoise/history.glsl"
#include "lib/mirrored.glsl"
#include "lib/packed_motion.glsl"
#include "rays/hit_motion.glsl"

#include "rays/after_screen.glsl"

layout(local_size_x = 64) in; // kRaysPerGroup

layout(set = 0, binding = 7, rgba16f) uniform writeonly image2D raysRadianceWeight;
layout(set = 0, binding = 8, rgba32ui) uniform uimage2D raysRecord;
layout(set = 0, binding = 11, rgba32f) uniform image2D raysSum;  // all samples: weighted radiance, known weight
layout(set = 0, binding = 12, r32f) uniform image2D raysWeights; // all samples: weight (both: kRaysAccumulate)
layout(set = 0, binding = 27) uniform sampler2D metaBefore; // denoise/accumulate.comp's; one black texel without
// lib/mirrored.glsl, where the record says kRaysBranched or kRaysSkyApart; one texel each without either flag.
layout(set = 0, binding = 28, rgba32ui) uniform writeonly uimage2D mirroredSurface;
layout(set = 0, binding = 29, rgba32ui) uniform writeonly uimage2D mirroredLight;

/// True if the pixel's paths are stored in two parts: lib/mirrored.glsl.
bool splitsPaths(PixelRays from) {
    return isOn(kRaysBranches) && isMirror(from.perceptualRoughness);
}

/// A path whose first hit is the hit of the screen's ray.
Path pathFromScreen(PixelRays from, RayRecord screen, uint i, float regularization) {
    Path path = startPath(from.originWS, reflect(-from.V, from.N), from.cone, 0.0, regularization);
    path.splits = splitsPaths(from);
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

/// Frames in the mean that the denoiser will join this pixel's answer to: those of the mean that the previous frame left
/// here. In motion the mean comes from some pixels away, where it is as long unless there is an edge between them.
float framesBefore(PixelRays from) {
    if (!hasDenoiserHistory())
        return 0.0;
    float frames = texelFetch(metaBefore, ivec2(from.uv * frame.constants.prevSize), 0).x;
    if (frames <= 1.0 && isMirror(from.perceptualRoughness))
        return 0.0; // nothing is averaged
    return min(frames, frame.settings.denoise.historyFrames - 1.0);
}

/// True if the first hit of this pixel's only path is in the screen's answer.
bool startsOnScreen(bool mirror, RayRecord screen) {
    return mirror && isAfterScreen() && isCertain(screen) && metReflector(screen) &&
           frame.constants.traceSize == frame.constants.size;
}

/// Stores where a mirror's path branched, but for what was found from there on, which is returned. The branch's weight is
/// that of all samples, by which what they found is divided: the denoiser weighs directions itself.
vec3 storeBranch(PixelRays from, Branch branch, float distance, vec3 radiance) {
    const float kLeastShare = 1e-4; // below, the quotient is rounding
    mat3 toView = mat3(frame.constants.worldToView);
    float metresAtOne = pixelExtent(frame.constants, frame.constants.uvToView, 1.0).y;
    MirroredSurface met = MirroredSurface(distance, toView * branch.normalWS, branch.perceptualRoughness,
                                          branch.width / metresAtOne,
                                          branch.endDistance > 0.0 ? 1.0 / branch.endDistance : 0.0);
    vec3 exact = sanitize(branch.exact);
    uint direction = packSnorm2x16(encodeOctahedral(toView * branch.directionWS));
    imageStore(mirroredSurface, from.px, packMirroredSurface(met));
    imageStore(mirroredLight, from.px, packMirroredLight(MirroredLight(exact, branch.share, direction)));
    if (branch.weight <= 0.0)
        return vec3(0.0);
    return max(radiance - exact, vec3(0.0)) / max(branch.share * branch.weight, vec3(kLeastShare));
}

/// Without an environment, rays to lights may find light where no path found a surface. The answer then has a small
/// weight and much radiance, as far as halves can store it.
float leastKnownWeight(vec3 radiance, float weights) {
    const float kLeastShare = 1.0 / 1024.0;
    const float kMostRadiance = 32768.0;
    float brightest = maxComponent(radiance);
    return brightest > 0.0 ? min(max(weights * kLeastShare, brightest / kMostRadiance), weights) : 0.0;
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
    uint motion = kNoMotion; // of the first sample's hit, view space
    Branch branch = kNoBranch;
    float branchDistance = 0.0;
    vec3 exact = vec3(0.0); // sums over the samples, weighted, of both parts of lib/mirrored.glsl
    vec3 share = vec3(0.0);
    float branchWeights = 0.0;
    float roughness = sampledRoughness(from.perceptualRoughness);
    bool skyApart = samplesSky(roughness) && !fromScreen;
    bool lights = skyApart || (samplesLights(roughness) && !fromScreen);
    uint listed = skyApart ? imageLoad(raysRecord, from.px).z : 0u;
    bool lightsOnly = (listed & kRaysLightsOnly) != 0u;
    vec3 skyLight = vec3(0.0);
    LobeFrame lobe = makeLobeFrame(from.N, from.V, from.perceptualRoughness);
    float meanOver = 1.0 + framesBefore(from);
    for (uint i = 0u; i < samples; ++i) {
        Direction first = samplePixel(from, i);
        bool middle = first.weight <= 0.0 && i + 1u == samples && weights == 0.0 && !isOn(kRaysAccumulate);
        if (middle) { // all went below: use the middle of the lobe
            first = Direction(reflect(-from.V, from.N), 1.0);
            sum.rgb = vec3(0.0);
        }
        if (first.weight <= 0.0 && !lights)
            continue;
        weights += first.weight;
        float regularization = regularizationOf(settings.regularization, max(weights, 1.0) * meanOver);
        Path path;
        if (fromScreen)
            path = pathFromScreen(from, screen, i, regularization);
        else
            path = startPath(from.originWS, first.ws, from.cone,
                             drawnAngle(from.N, from.V, first.ws, from.perceptualRoughness), regularization);
        path.splits = splitsPaths(from);
        path.isAveraged = path.isAveraged || !mirror;
        path.ended = path.ended || first.weight <= 0.0 || lightsOnly;
        if (lights && !middle) {
            path.vertex = LobeVertex(true, lobe, from.N, kLeastLobeCosine, true, vec3(1.0));
            path.density = lobeDensity(lobe.wo, first.ws * lobe.axes, lobe.alpha);
        }
        followPath(fromScreen ? 1u : 0u, from.px, sampleNumber(i), path);
        if (isOn(kRaysSampleSky))
            skyLight += sanitize(path.lights);
        else
            sum.rgb += sanitize(path.lights);
        if (first.weight <= 0.0 || lightsOnly)
            continue;
        sum += first.weight * path.weight * vec4(sanitize(path.radiance), 1.0);
        if (path.splits) {
            exact += first.weight * path.weight * sanitize(path.branch.exists ? path.branch.exact : path.radiance);
            if (path.branch.exists) {
                share += first.weight * path.weight * path.branch.share;
                branchWeights += first.weight * path.weight * path.branch.weight;
            }
            if (path.branch.exists && (!branch.exists || branch.weight <= 0.0)) {
                branch = path.branch;
                branchDistance = path.hitDistance;
            }
        }
        record.lookups += path.rays;
        reused += path.reused;
        if (path.hit) {
            record.hitDistance += path.hitDistance;
            hits += 1.0;
            if (record.outcome != kOutcomeHit) {
                record.hitUV = projectedUV(path.hitWS);
                motion = packMotion(mat3(frame.constants.worldToView) * hitStepWS(path.first, path.hitWS));
            }
            record.outcome = kOutcomeHit;
        }
    }
    if (skyApart) {
        // Not over this frame's weights: they and this light do not depend on each other.
        float mean = meanLobeWeight(from.N, from.V, from.perceptualRoughness);
        vec3 apart = min(skyLight / (float(samples) * mean), vec3(kLargestStored));
        imageStore(mirroredLight, from.px, packMirroredLight(MirroredLight(apart, vec3(0.0), 0u)));
        if (lightsOnly) {
            record.outcome = kOutcomeNone;
            imageStore(raysRecord, from.px, uvec4(packRayRecord(record), kRaysSkyApart | (listed & kRaysReplaceScreen), 0u));
            return;
        }
    }
    record.hitDistance /= max(hits, 1.0);
    if (isOn(kRaysAccumulate)) {
        imageStore(raysSum, from.px, sum);
        imageStore(raysWeights, from.px, vec4(weights));
    }
    if (lights && !skyApart)
        sum.a = max(sum.a, leastKnownWeight(sum.rgb, weights));
    vec4 answer = sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a / weights) : vec4(0.0);
    if (branch.exists && sum.a > 0.0) {
        branch.exact = exact / sum.a;
        branch.share = share / sum.a;
        branch.weight = branchWeights / sum.a;
        answer.rgb = storeBranch(from, branch, branchDistance, answer.rgb) + skyLight / (sum.a * branch.meanWeight);
    }
    imageStore(raysRadianceWeight, from.px, vec4(sanitize(answer.rgb), answer.a));
    uint route = (branch.exists ? kRaysBranched : 0u) | (skyApart ? kRaysSkyApart : 0u) | min(reused, kRaysReusedMask) |
                 (fromScreen ? kRaysStartOnScreen : 0u) | (takesBack(screen) ? kRaysReplaceScreen : 0u);
    imageStore(raysRecord, from.px, uvec4(packRayRecord(record), route, motion));
}
