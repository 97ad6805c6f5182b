// From the sums over a pixel's paths to what is stored of them.
#ifndef GLINT_RAYS_PIXEL_ANSWER_GLSL
#define GLINT_RAYS_PIXEL_ANSWER_GLSL

#include "lib/half.glsl"
#include "lib/mirrored.glsl"
#include "rays/pixel_plan.glsl"
#include "rays/pixel_sums.glsl"

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

/// Stores the light of rays to lights by itself. Not over this frame's weights: they and this light do not depend on each
/// other.
void storeSky(PixelRays from, PixelPlan plan, vec3 skyLight) {
    float mean = meanLobeWeight(from.N, from.V, from.perceptualRoughness);
    vec3 apart = min(skyLight / (float(plan.samples) * mean), vec3(kLargestStored));
    imageStore(mirroredLight, from.px, packMirroredLight(MirroredLight(apart, vec3(0.0), 0u)));
}

/// For a pixel whose answer is the lights' alone: it has no path.
void storeNoPath(PixelRays from, PixelPlan plan, RayRecord record) {
    record.outcome = kOutcomeNone;
    uint route = kRaysSkyApart | (plan.replacesScreen ? kRaysReplaceScreen : 0u);
    imageStore(raysRecord, from.px, uvec4(packRayRecord(record), route, 0u));
}

/// Radiance and weight of the pixel's answer. Stores the branch, if its paths have one.
vec4 meanOfPaths(PixelRays from, PixelPlan plan, PixelSums sums) {
    vec4 sum = sums.light;
    if (plan.lights && !plan.skyApart)
        sum.a = max(sum.a, leastKnownWeight(sum.rgb, sums.weights));
    vec4 answer = sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a / sums.weights) : vec4(0.0);
    if (sums.branch.first.exists && sum.a > 0.0) {
        Branch branch = sums.branch.first;
        branch.exact = sums.branch.exact / sum.a;
        branch.share = sums.branch.share / sum.a;
        branch.weight = sums.branch.weights / sum.a;
        answer.rgb = storeBranch(from, branch, sums.branch.distance, answer.rgb) +
                     sums.skyLight / (sum.a * branch.meanWeight);
    }
    return answer;
}

void storeAnswer(PixelRays from, PixelPlan plan, PixelSums sums) {
    if (isOn(kRaysAccumulate)) {
        imageStore(raysSum, from.px, sums.light);
        imageStore(raysWeights, from.px, vec4(sums.weights));
    }
    vec4 answer = meanOfPaths(from, plan, sums);
    imageStore(raysRadianceWeight, from.px, vec4(sanitize(answer.rgb), answer.a));
    uint route = (sums.branch.first.exists ? kRaysBranched : 0u) | (plan.skyApart ? kRaysSkyApart : 0u) |
                 min(sums.reused, kRaysReusedMask) | (plan.fromScreen ? kRaysStartOnScreen : 0u) |
                 (takesBack(plan.screen) ? kRaysReplaceScreen : 0u);
    sums.record.hitDistance /= max(sums.hits, 1.0);
    imageStore(raysRecord, from.px, uvec4(packRayRecord(sums.record), route, sums.motion));
}

#endif
