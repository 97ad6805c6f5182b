// What the paths of a pixel found, summed: their light, their hits, and both parts of lib/mirrored.glsl.
#ifndef GLINT_RAYS_PIXEL_SUMS_GLSL
#define GLINT_RAYS_PIXEL_SUMS_GLSL

#include "lib/packed_motion.glsl"
#include "rays/hit_motion.glsl"
#include "rays/path.glsl"
#include "rays/reflect_images.glsl"

/// The two parts of a mirror's paths, weighted.
struct BranchSums {
    Branch first; // of the first path that branched
    float distance; // metres, of that path's first ray
    vec3 exact;
    vec3 share;
    float weights;
};

struct PixelSums {
    vec4 light;    // weighted radiance, weight of the known samples
    float weights; // of all samples
    vec3 skyLight; // that rays to lights found, where it is kept apart
    RayRecord record;
    float hits;
    uint reused; // hits lit from the frame's colour
    uint motion; // of the first sample's hit, view space
    BranchSums branch;
};

/// Nothing yet, or with kRaysAccumulate what earlier frames found.
PixelSums startSums(PixelRays from) {
    PixelSums sums;
    sums.light = vec4(0.0);
    sums.weights = 0.0;
    if (isOn(kRaysAccumulate)) {
        sums.light = imageLoad(raysSum, from.px);
        sums.weights = imageLoad(raysWeights, from.px).r;
    }
    sums.skyLight = vec3(0.0);
    sums.record = RayRecord(from.uv, 0.0, 0u, kOutcomeSky, false);
    sums.hits = 0.0;
    sums.reused = 0u;
    sums.motion = kNoMotion;
    sums.branch = BranchSums(kNoBranch, 0.0, vec3(0.0), vec3(0.0), 0.0);
    return sums;
}

void addBranch(Path path, float weight, inout BranchSums sums) {
    sums.exact += weight * sanitize(path.branch.exists ? path.branch.exact : path.radiance);
    if (path.branch.exists) {
        sums.share += weight * path.branch.share;
        sums.weights += weight * path.branch.weight;
    }
    if (path.branch.exists && (!sums.first.exists || sums.first.weight <= 0.0)) {
        sums.first = path.branch;
        sums.distance = path.hitDistance;
    }
}

void addHit(Path path, inout PixelSums sums) {
    sums.record.hitDistance += path.hitDistance;
    sums.hits += 1.0;
    if (sums.record.outcome != kOutcomeHit) {
        sums.record.hitUV = projectedUV(path.hitWS);
        sums.motion = packMotion(mat3(frame.constants.worldToView) * hitStepWS(path.first, path.hitWS));
    }
    sums.record.outcome = kOutcomeHit;
}

/// `weight`: of the path's first direction.
void addPath(Path path, float weight, inout PixelSums sums) {
    sums.light += weight * path.weight * vec4(sanitize(path.radiance), 1.0);
    if (path.splits)
        addBranch(path, weight * path.weight, sums.branch);
    sums.record.lookups += path.rays;
    sums.reused += path.reused;
    if (path.hit)
        addHit(path, sums);
}

#endif
