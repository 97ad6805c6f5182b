// Each rough pixel also uses the rays of its neighbours, weighed by its own lobe: the ratio estimator of Stachowiak 2015,
// "Stochastic Screen-Space Reflections", with weights bounded by pairwise mixtures of densities (balance heuristic, Veach
// 1995). Uniform light stays exactly uniform. A pixel that sent no ray (reuse.rate) uses its neighbours' rays alone.
// docs/techniques/rough.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "denoise/lobe_surface.glsl"
#include "denoise/sent_ray.glsl"
#include "lib/color.glsl"
#include "lib/environment.glsl"
#include "lib/noise.glsl"
#include "lib/packed_motion.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 3) uniform sampler2D noisy;     // weight * radiance, weight
layout(set = 0, binding = 4) uniform usampler2D sentRay; // denoise/sent_ray.glsl
layout(set = 0, binding = 7) uniform sampler2D rayRates;
layout(set = 0, binding = 10) uniform usampler2D mirroredSurface; // lib/mirrored.glsl, if settings.mirrored
layout(set = 0, binding = 11) uniform sampler2D dfg;              // dfgAt
layout(set = 0, binding = 5, rgba16f) uniform writeonly image2D reused;
/// 1 / metres to the rays' ends, weighed by light; how much of a frame the answer counts for: 1 on average with an own ray,
/// more where facets hinder little of it; less where few of the neighbours' rays lie in the pixel's lobe; 0: none was
/// found; -1: the pixel does not reflect, and nothing else is written there.
layout(set = 0, binding = 6, rg16f) uniform writeonly image2D reusedMeta;
layout(set = 0, binding = 8) uniform usampler2D hitMotion; // denoise/gather.comp
/// How what the rays met has moved: mean displacement, view space; root mean square of its length; both weighed by the
/// light that it sends. If settings.hitMotion.
layout(set = 0, binding = 9, rgba16f) uniform writeonly image2D reusedMotion;
DenoiseConstants settings = frame.settings.denoise;

#include "denoise/averaged_surface.glsl"
#include "denoise/ray_rate.glsl"

/// A pixel's lobe and the ray that it sent.
struct Lobe {
    LobeSurface at;
    vec3 toEyeVS; // above the surface
    float NoV;
    float alpha;
    float scale; // of the density: what depends on the direction to the eye
    SentRay ray;
    float distance; // metres to where the ray ended
};

Lobe lobeOf(LobeSurface at, SentRay ray) {
    Lobe lobe;
    lobe.at = at;
    float NoV = dot(at.normalVS, at.toEyeVS);
    lobe.toEyeVS = normalize(at.toEyeVS + at.normalVS * max(1e-3 - NoV, 0.0)); // a bent normal may face away
    lobe.NoV = dot(at.normalVS, lobe.toEyeVS);
    lobe.alpha = square(at.perceptualRoughness);
    lobe.scale = reflectedGGXScale(lobe.NoV, lobe.alpha);
    lobe.ray = ray;
    lobe.distance = endDistance(ray.nearness);
    return lobe;
}

/// lobeDensity (generate/lobe.glsl) in view space: GGX depends on angles to the normal alone.
float densityOf(Lobe lobe, vec3 wiVS) {
    if (dot(lobe.at.normalVS, wiVS) <= 0.0)
        return 0.0;
    vec3 h = normalize(lobe.toEyeVS + wiVS);
    float NoH = dot(lobe.at.normalVS, h);
    vec3 across = h - lobe.at.normalVS * NoH;
    float a2 = square(lobe.alpha);
    return lobe.scale * a2 / (kPi * square(dot(across, across) + a2 * square(NoH)));
}

float shadowing(Lobe lobe, vec3 wiVS) {
    return reflectedGGXWeight(lobe.NoV, max(dot(lobe.at.normalVS, wiVS), 1e-6), lobe.alpha);
}

/// Mean of `shadowing` over the lobe.
float meanPassing(Lobe lobe) {
    vec2 parts = dfgAt(dfg, lobe.NoV, lobe.at.perceptualRoughness);
    return max(parts.x + parts.y, 1e-3);
}

/// Where `from`'s ray ended, as seen from `to`: its direction, and by how much solid angles shrink on the way.
vec3 carried(Lobe from, LobeSurface to, out float jacobian) {
    vec3 way = from.at.positionVS + from.ray.directionVS * from.distance - to.positionVS;
    float distance2 = max(dot(way, way), 1e-12);
    jacobian = clamp(square(from.distance) / distance2, 0.25, 4.0);
    return way * inversesqrt(distance2);
}

/// What a ray found.
struct Found {
    vec4 answer;
    float nearness;
    vec3 stepVS; // where its end was - where it is
};

/// What further rays behind mirrors met counts as resting: their pixel's motion is that of what the mirror shows.
Found foundAt(ivec2 px, LobeSurface at, SentRay sent) {
    bool knowsMotion = settings.hitMotion != 0u && !at.isMirrored;
    vec3 step = knowsMotion ? unpackMotion(texelFetch(hitMotion, px, 0).r) : vec3(0.0);
    return Found(texelFetch(noisy, px, 0), sent.nearness, step);
}

struct Sums {
    vec4 answer;
    float near;      // by weight
    float lightNear; // by light
    vec4 motion; // steps, squares of their lengths
    float light;
    float weight;
    float share; // the weights without what facets hinder
};

const Sums kNoSums = Sums(vec4(0.0), 0.0, 0.0, vec4(0.0), 0.0, 0.0, 0.0);

/// `passing`: fraction of the light from there that leaves the facets.
void add(inout Sums sums, Found found, float share, float passing) {
    float weight = share * passing;
    sums.answer += weight * found.answer;
    sums.near += weight * found.nearness;
    float light = weight * luminance(found.answer.rgb);
    sums.motion += light * vec4(found.stepVS, dot(found.stepVS, found.stepVS));
    sums.light += light;
    sums.lightNear += light * found.nearness;
    sums.weight += weight;
    sums.share += share;
}

/// Of a frame: what a pixel learns from each ray that is not in its lobe.
const float kLeastLearnt = 0.01;

/// The mean of the nearest senders' answers on this surface, whatever their lobes.
void addNearest(ivec2 px, LobeSurface here, inout Sums sums) {
    for (int i = 0; i < 9; ++i) {
        ivec2 tap = senderAt(px + 2 * ivec2(i % 3 - 1, i / 3 - 1), here.perceptualRoughness);
        if (!isInFrame(tap))
            continue;
        SentRay theirRay = unpackSentRay(texelFetch(sentRay, tap, 0).xy);
        if (!theirRay.sent)
            continue;
        LobeSurface there = averagedSurfaceAt(tap);
        if (isSameSurface(here, there))
            add(sums, foundAt(tap, there, theirRay), 1.0, 1.0);
    }
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (!isInFrame(px))
        return;
    SentRay ray = unpackSentRay(texelFetch(sentRay, px, 0).xy);
    if (!ray.sent && !ray.awaits) {
        imageStore(reusedMeta, px, vec4(0.0, -1.0, 0.0, 0.0));
        return;
    }
    LobeSurface here = averagedSurfaceAt(px);
    Found found = ray.sent ? foundAt(px, here, ray) : Found(vec4(0.0), 0.0, vec3(0.0));
    vec4 answer = found.answer;
    float near = found.nearness;
    vec4 motion = vec4(found.stepVS, dot(found.stepVS, found.stepVS));
    float ratedRoughness = here.isMirrored ? 0.0 : here.perceptualRoughness; // mirrors send rays in every frame
    float learnt = ray.sent ? 1.0 : 0.0;
    if (!isMirror(here.perceptualRoughness)) {
        Lobe own = lobeOf(here, ray);
        // Without an own ray nothing bounds f / p: a part of the own density, so that no neighbour counts more than four
        // times.
        float ownPart = ray.sent ? 1.0 : 0.25;
        ivec2 sender = senderAt(px, ratedRoughness);
        if (ray.awaits && isInFrame(sender))
            near = unpackSentRay(texelFetch(sentRay, sender, 0).xy).nearness; // for the radius
        float ownDensity = densityOf(own, ray.directionVS);
        float ownPassing = shadowing(own, ray.directionVS);
        float ownShare = 0.0; // of the pixel's own ray: a part from each pair
        Sums sums = kNoSums;
        float pairs = 0.0; // of the own ray and a neighbour's
        float radius = clamp(0.5 * lobePixels(here.perceptualRoughness, here.viewZ, near), 1.0, settings.reuseRadius);
        mat2 disc = lobeDisc(here, radius);
        Spiral spiral =
            beginSpiral(max(settings.reuseSamples, 1u), hashNoise(uvec2(px), frame.constants.frameIndex, frame.constants.seed).x);
        for (uint i = 0u; i < settings.reuseSamples; ++i) {
            ivec2 tap = floorToInt(vec2(px) + 0.5 + disc * nextPoint(spiral, i));
            tap = senderAt(tap, ratedRoughness);
            if (tap == px || !isInFrame(tap))
                continue;
            SentRay theirRay = unpackSentRay(texelFetch(sentRay, tap, 0).xy);
            LobeSurface there = averagedSurfaceAt(tap);
            if (!theirRay.sent || !isSameSurface(here, there) || isMirror(there.perceptualRoughness))
                continue;
            Lobe other = lobeOf(there, theirRay);
            pairs += 1.0;
            float shrink;
            vec3 wi = carried(other, here, shrink);
            float theirs = densityOf(other, theirRay.directionVS) / shrink;
            float density = densityOf(own, wi);
            float share = density / max(theirs + ownPart * density, 1e-20);
            add(sums, foundAt(tap, there, theirRay), theirs > 0.0 ? share : 0.0, shadowing(own, wi));
            if (ray.sent && ownDensity > 0.0) {
                vec3 across = carried(own, there, shrink);
                ownShare += ownDensity / (densityOf(other, across) * shrink + ownDensity);
            }
        }
        if (ray.sent) {
            bool isAlone = pairs == 0.0;
            add(sums, found, isAlone ? float(ownDensity > 0.0) : ownShare, ownPassing);
            learnt = sums.weight / max(pairs, 1.0);
        } else if (sums.weight > 0.0) {
            learnt = min(1.0, 1.0 / sums.share) * sums.weight;
        } else {
            addNearest(px, here, sums);
            learnt = kLeastLearnt * sums.weight;
        }
        // A pair's shares add up to 1 on average, and the facets let meanPassing of that through: `learnt` is 1 on average.
        // Weighed by it, the mean over frames is a ratio of sums. In a mean of ratios, light that facets hinder counts too much.
        learnt = ray.sent || sums.weight > 0.0 ? max(learnt / meanPassing(own), kLeastLearnt) : 0.0;
        if (sums.weight > 0.0) {
            answer = sums.answer / sums.weight;
            near = sums.light > 0.0 ? sums.lightNear / sums.light : sums.near / sums.weight;
            motion = sums.motion / max(sums.light, 1e-20);
        }
    }
    imageStore(reused, px, answer);
    imageStore(reusedMeta, px, vec4(near, learnt, 0.0, 0.0));
    if (settings.hitMotion != 0u)
        imageStore(reusedMotion, px, vec4(motion.xyz, sqrt(motion.w)));
}
