// Finds the pixels that the source `rays` must answer, for trace/list to list: pixels that reflect and have remaining
// weight after the sources before. The other pixels get an empty answer here. With rays.interpolate one pixel of 2 x 2 is
// listed; rays/interpolate sees to those left.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/prepared.glsl"
#include "hierarchy/answers.glsl"
#include "lib/ray_record.glsl"
#include "lib/surface.glsl"
#include "shared/rays_constants.h"
#include "trace/ray_list.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 9, rgba16f) uniform writeonly image2D raysRadianceWeight;
layout(set = 0, binding = 8, rgba32ui) uniform writeonly uimage2D raysRecord;
layout(set = 0, binding = 24) uniform sampler2D rayRates;
RaysConstants settings = frame.settings.rays;

#include "denoise/lobe_turn.glsl"
#include "denoise/ray_rate.glsl"
#include "rays/after_screen.glsl"

/// Returns kOutcomeNone where a ray is needed.
uint whyNoRay(ivec2 px, Surface here) {
    if (here.reflectivity <= settings.threshold)
        return kOutcomeBelowThreshold;
    if (here.perceptualRoughness > settings.maxRoughness)
        return kOutcomeTooRough;
    bool sends = sendsRay(px, here.perceptualRoughness) && hasLobesTurn(px, (vec2(px) + 0.5) * frame.constants.invSize);
    return sends ? kOutcomeNone : kOutcomeFromNeighbours;
}

/// True if the pixel's surface sends a ray to the environment, whatever its own ray meets.
bool samplesSky(Surface here) {
    return (settings.flags & kRaysSampleSky) != 0u && here.perceptualRoughness >= kSmoothestSampled;
}

/// True for pixels that rays/interpolate answers, or lists.
bool isLeftToNeighbours(ivec2 px) {
    return settings.interpolate > 0.0 && ((px.x | px.y) & 1) != 0;
}

/// Bit s of `sources`: source s.
bool takeAll(uint sources, ivec2 px) {
    return takenBefore(sources, px) >= kAll; // what remains is less than a ray could add
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    bool needsRay = false;
    uint route = 0u;
    if (all(lessThan(px, ivec2(frame.constants.size)))) {
        RayRecord record = RayRecord((vec2(px) + 0.5) * frame.constants.invSize, 0.0, 0u, kOutcomeNone, false);
        if (texelFetch(viewZ, px, 0).r < kBackgroundZ) {
            Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
            record.outcome = whyNoRay(px, here);
            bool reflects = record.outcome == kOutcomeNone;
            needsRay = reflects && !takeAll(settings.before, px);
            // True if rays may replace the screen's answer where the sources before took all weight and no ray is
            // needed. Behind the sky, rays may not.
            bool heard = (settings.before & (1u << kSourceSky)) == 0u;
            if (reflects && !needsRay && heard && takesBack(screenRay(px))) {
                needsRay = !takeAll(settings.before & ~(1u << kSourceScreen), px);
                route = kRaysReplaceScreen;
            }
            if (reflects && !needsRay && samplesSky(here)) {
                needsRay = true;
                route |= kRaysLightsOnly;
            }
            if (needsRay && isLeftToNeighbours(px)) {
                needsRay = false;
                record.outcome = kOutcomeFromNeighbours;
                route = takesBack(screenRay(px)) ? kRaysReplaceScreen : 0u;
            }
        }
        imageStore(raysRadianceWeight, px, vec4(0.0)); // hosts that shade hits need not answer each pixel
        if (!needsRay || (settings.flags & kRaysSampleSky) != 0u) // rays/reflect reads it with that flag
            imageStore(raysRecord, px, uvec4(packRayRecord(record), route, 0u));
    }
    needRay(needsRay, false);
}
