// Joins what screen and rays answered for the pixel's one sampled ray, by the one rule, into one noisy signal, and
// stores that ray for the neighbours. Where none was sent, no more than that is written.
// docs/techniques/rough.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "denoise/sent_ray.glsl"
#include "frame/prepared.glsl"
#include "generate/sampled_ray.glsl"
#include "hierarchy/walk.glsl"
#include "lib/mirrored.glsl"
#include "lib/packed_motion.glsl"
#include "lib/ray_record.glsl"
#include "lib/sanitize.glsl"
#include "lib/surface.glsl"
#include "shared/rays_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 3) uniform sampler2D screenAnswer; // radiance, weight
layout(set = 0, binding = 4) uniform usampler2D screenRecord;
layout(set = 0, binding = 5) uniform sampler2D raysAnswer;
layout(set = 0, binding = 6) uniform usampler2D raysRecord;
layout(set = 0, binding = 7, rgba16f) uniform writeonly image2D noisy;  // weight * radiance, weight
layout(set = 0, binding = 8, rg32ui) uniform writeonly uimage2D sentRay;
layout(set = 0, binding = 10) uniform sampler2D motion; // lib/previous_place.glsl
/// Where the ray's end was, as a displacement from where it is: lib/packed_motion.glsl, view space. Behind a mirror: where
/// what it shows was. If settings.hitMotion.
layout(set = 0, binding = 11, r32ui) uniform writeonly uimage2D hitMotion;
// lib/mirrored.glsl, of this frame's mirrors, if settings.mirrored.
layout(set = 0, binding = 12, rgba32ui) uniform uimage2D mirroredSurface;
layout(set = 0, binding = 13, rgba32ui) uniform uimage2D mirroredLight;
layout(push_constant, scalar) uniform PushBlock {
    uint sources; // kJoin*
};

DenoiseConstants settings = frame.settings.denoise;

#include "lib/previous_place.glsl"

/// True if a ray was traced.
bool wasTraced(RayRecord record) {
    return record.outcome != kOutcomeNone && record.outcome < kOutcomeBelowThreshold;
}

struct Answer {
    vec4 radianceWeight;
    float nearness;
};

Answer answerOf(vec4 radianceWeight, RayRecord record) {
    bool ends = isAnswered(record.outcome) && record.hitDistance > 0.0;
    return Answer(vec4(sanitize(radianceWeight.rgb), radianceWeight.a), ends ? 1.0 / record.hitDistance : 0.0);
}

/// The displacement of what the screen's ray hit.
vec3 screenHitMotion(ivec2 px, RayRecord ray) {
    if (!isAnswered(ray.outcome) || (frame.constants.flags & kInputMotion) == 0u)
        return vec3(0.0);
    ivec2 hitPX = min(ivec2(ray.hitUV * frame.constants.size), ivec2(frame.constants.size) - 1);
    float z = texelFetch(viewZ, hitPX, 0).r;
    return z < kBackgroundZ ? displacementVS(hitPX, z) : vec3(0.0);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    bool hasRays = (sources & kJoinRays) != 0u;
    bool hasScreen = (sources & kJoinScreen) != 0u;
    const RayRecord kNotTraced = RayRecord(vec2(0.0), 0.0, 0u, kOutcomeNone, false);
    uvec4 routed = hasRays ? texelFetch(raysRecord, px, 0) : uvec4(0u);
    RayRecord raysRay = hasRays ? unpackRayRecord(routed.xy) : kNotTraced;
    RayRecord screenRay = hasScreen ? unpackRayRecord(texelFetch(screenRecord, px, 0).xy) : kNotTraced;
    float z = texelFetch(viewZ, px, 0).r;
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    bool branched = settings.mirrored != 0u && (routed.z & kRaysBranched) != 0u;
    if (settings.mirrored != 0u && !branched && isMirror(here.perceptualRoughness))
        imageStore(mirroredSurface, px, uvec4(0u));
    SentRay ray = SentRay(vec3(0.0), 0.0, z < kBackgroundZ && (wasTraced(screenRay) || wasTraced(raysRay)), false);
    if (!ray.sent) {
        ray.awaits = screenRay.outcome == kOutcomeFromNeighbours || raysRay.outcome == kOutcomeFromNeighbours;
        imageStore(sentRay, px, uvec4(packSentRay(ray), 0u, 0u));
        return;
    }
    const Answer kNone = Answer(vec4(0.0), 0.0);
    Answer screen = hasScreen ? answerOf(texelFetch(screenAnswer, px, 0), screenRay) : kNone;
    Answer rays = hasRays ? answerOf(texelFetch(raysAnswer, px, 0), raysRay) : kNone;
    if ((routed.z & kRaysReplaceScreen) != 0u)
        screen.radianceWeight = vec4(0.0);
    bool raysFirst = (sources & kJoinRaysFirst) != 0u;
    MirroredLight mirrored = MirroredLight(vec3(0.0), vec3(0.0), 0u);
    vec4 sampled = rays.radianceWeight; // behind a mirror: what goes to the neighbours and into the mean
    if (branched) {
        mirrored = unpackMirroredLight(imageLoad(mirroredLight, px));
        rays.radianceWeight.rgb = mirrored.exact;
    }
    Walk walk = beginWalk();
    vec2 taken; // from the first, from the second
    for (int i = 0; i < 2; ++i) {
        Answer answer = (i == 0) == raysFirst ? rays : screen;
        taken[i] = take(walk, answer.radianceWeight);
        ray.nearness += taken[i] * answer.nearness;
    }
    ray.nearness /= max(walk.taken, 1e-6);
    vec3 positionVS = viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z);
    Direction drawn = sampledDirection(px, positionVS, here);
    // Below the surface the lobe's density is 0: neighbours take nothing from there.
    ray.directionVS = drawn.weight > 0.0 ? mat3(frame.constants.worldToView) * drawn.ws : -here.normalVS;
    vec4 found = vec4(walk.radiance, walk.taken);
    if ((routed.z & kRaysSkyApart) != 0u)
        found.rgb += unpackMirroredLight(imageLoad(mirroredLight, px)).exact;
    if (branched) {
        ray.directionVS = decodeOctahedral(unpackSnorm2x16(mirrored.last));
        ray.nearness = unpackMirroredSurface(imageLoad(mirroredSurface, px)).nearness;
        float share = raysFirst ? taken.x : taken.y;
        imageStore(mirroredLight, px,
                   packMirroredLight(MirroredLight(walk.radiance, share * mirrored.share, floatBitsToUint(walk.taken))));
        found = vec4(sampled.rgb, 1.0);
    }
    imageStore(noisy, px, found);
    imageStore(sentRay, px, uvec4(packSentRay(ray), 0u, 0u));
    if (settings.hitMotion != 0u) {
        bool fromRays = (taken.x >= taken.y) == raysFirst;
        if (branched)
            fromRays = (routed.z & kRaysStartOnScreen) == 0u; // else the screen knows how its hit moved
        imageStore(hitMotion, px, uvec4(fromRays ? routed.w : packMotion(screenHitMotion(px, screenRay)), 0u, 0u, 0u));
    }
}
