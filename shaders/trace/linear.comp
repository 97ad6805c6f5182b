// The `linear` marcher: one depth lookup every `step` pixels along the ray's line on screen.
//
// A hit is a crossing: the ray was in front of what the picture shows (or in its slab) and is behind it now, by no more
// than the slab's thickness. Depths are compared at the sample itself, so a plane never hits itself however grazing
// the ray; McGuire and Mara's half-pixel intervals do (and need `selfCollisionSkip`).
// Babylon.js' SSRRenderingPipeline is the model for the settings: docs/techniques/linear.md says what differs.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/fades.glsl"
#include "lib/noise.glsl"
#include "lib/screen_ray.glsl"
#include "lib/surface.glsl"
#include "lib/trace_pixel.glsl"
#include "shared/trace_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
} frame;
layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 2) uniform usampler2D surface;
layout(push_constant, scalar) uniform PushBlock {
    TraceConstants settings;
};

#include "trace/hit_color.glsl"
#include "trace/traced.glsl"

bool isOn(uint flag) {
    return (settings.flags & flag) != 0u;
}

/// dot(normal at the hit, -ray) below which a surface was met from behind. A little below 0, as shading normals lean;
/// `fade.backface` fades what lies between.
const float kBackFaceLimit = -0.17;
/// dot(normal at the hit, normal at the start) above which both may be one surface, which its own ray never meets from
/// the front; 25 degrees.
const float kOwnSurface = 0.9;

// ---------------------------------------------------------------- the march

struct March {
    float share;    // of the ray's line on screen, where it ended
    vec2 hitPX;
    uint iterations;
    uint lookups;
    uint outcome;
};

/// One depth sample of the ray.
struct Sample {
    float share;
    vec2 px;
    float rayZ;
    float sceneZ;
};

Sample takeSample(ScreenRay ray, float share) {
    Sample s;
    s.share = share;
    s.px = ray.startPX + ray.deltaPX * share;
    s.rayZ = rayViewZ(ray, share);
    s.sceneZ = texelFetch(viewZ, ivec2(s.px), 0).r;
    return s;
}

float slabThickness(float sceneZ) {
    return settings.thickness + settings.thicknessRelative * sceneZ;
}

/// Behind the surface at `s`, and not so far that the ray, coming from `before`, passed behind its slab.
bool crosses(Sample before, Sample s) {
    return s.rayZ >= s.sceneZ && min(before.rayZ, s.rayZ) <= s.sceneZ + slabThickness(s.sceneZ);
}

bool onScreen(vec2 px) {
    return all(greaterThanEqual(px, vec2(0.0))) && all(lessThan(px, frame.constants.size));
}

/// Where between two samples the ray met the surface: both gaps are linear there if they see the same surface. Across a
/// depth edge the later sample alone knows the surface.
Sample refineCrossing(ScreenRay ray, Sample before, Sample s, float pixels) {
    float gapBefore = before.sceneZ - before.rayZ;
    float gapBehind = s.rayZ - s.sceneZ;
    bool sameSurface = gapBefore > 0.0 && abs(before.sceneZ - s.sceneZ) <= slabThickness(s.sceneZ);
    if (sameSurface)
        s.share = mix(before.share, s.share, gapBefore / max(gapBefore + gapBehind, 1e-20));
    else if (before.share == 0.0 && s.share * pixels < 1.5)
        s.share *= 0.51; // in a crease, within the very first pixel: its middle, which is still in the hit's own texel
    s.px = ray.startPX + ray.deltaPX * s.share;
    return s;
}

/// Between two coarse samples, pixel by pixel: the first crossing, or the coarse sample itself.
Sample refineBySinglePixels(ScreenRay ray, inout Sample before, Sample s, float pixels, inout uint lookups) {
    float pixelShare = 1.0 / pixels;
    for (float share = before.share + pixelShare; share < s.share; share += pixelShare) {
        Sample fine = takeSample(ray, share);
        ++lookups;
        if (crosses(before, fine))
            return fine;
        before = fine;
    }
    return s;
}

March march(ScreenRay ray, vec3 originNormalVS, vec3 directionVS, float startOffset) {
    March result = March(0.0, ray.startPX, 0u, 0u, kOutcomeNone);
    bool clip = isOn(kTraceClipToFrustum);
    float pixels = max(max(abs(ray.deltaPX.x), abs(ray.deltaPX.y)), 1e-6);
    float endShare = clip ? ray.screenEnd : 1.0;
    float stepShare = float(settings.step) / pixels;
    uint needed = uint(min(ceil(endShare / stepShare + startOffset), 8192.0));
    uint iterations = min(needed, settings.maxSteps);

    Sample before = Sample(0.0, ray.startPX, rayViewZ(ray, 0.0), rayViewZ(ray, 0.0));
    bool wasInFront = false; // has the ray left its own surface?
    bool metBackFace = false;
    bool nearlyThickEnough = false;

    for (uint i = 1u; i <= iterations; ++i) {
        result.iterations = i;
        result.share = min((float(i) - startOffset) * stepShare, endShare);
        if (!onScreen(ray.startPX + ray.deltaPX * result.share)) {
            result.outcome = kOutcomeOffScreen;
            return result;
        }
        Sample s = takeSample(ray, result.share);
        ++result.lookups;

        if (s.rayZ < s.sceneZ) {
            wasInFront = true;
            metBackFace = false;
            nearlyThickEnough = false;
        } else if (crosses(before, s)) {
            if (i > settings.selfCollisionSkip) {
                Sample hit = s;
                if (settings.step > 1u && isOn(kTraceSmooth))
                    hit = refineBySinglePixels(ray, before, s, pixels, result.lookups);
                // An opaque surface is met from its front. From behind, the ray either grazes the surface that it
                // starts from, where shading normals disagree with depth, or meets a side that nobody sees.
                vec3 hitNormalVS = unpackSurface(texelFetch(surface, ivec2(hit.px), 0).xy).normalVS;
                float limit = dot(hitNormalVS, originNormalVS) > kOwnSurface ? 0.0 : kBackFaceLimit;
                if (dot(hitNormalVS, -directionVS) > limit) {
                    hit = refineCrossing(ray, before, hit, pixels);
                    result.share = hit.share;
                    result.hitPX = hit.px;
                    result.outcome = kOutcomeHit;
                    return result;
                }
                metBackFace = wasInFront;
            }
        } else {
            float slab = slabThickness(s.sceneZ);
            nearlyThickEnough = nearlyThickEnough || min(before.rayZ, s.rayZ) <= s.sceneZ + 2.0 * slab;
        }
        before = s;
    }

    bool endsBehind = before.rayZ >= before.sceneZ && before.share > 0.0;
    if (needed > iterations)
        result.outcome = kOutcomeOutOfSteps;
    else if (clip && ray.screenEnd < 1.0)
        result.outcome = kOutcomeOffScreen; // as the same ray would without clipping, whatever it passed behind
    else if (metBackFace)
        result.outcome = kOutcomeBackFace;
    else if (endsBehind)
        result.outcome = nearlyThickEnough ? kOutcomeTooThick : kOutcomeHidden;
    else if (ray.clippedNear)
        result.outcome = kOutcomeBehindCamera;
    else
        result.outcome = before.sceneZ >= kBackgroundZ ? kOutcomeSky : kOutcomeMaxDistance;
    return result;
}

// ---------------------------------------------------------------- what a hit is worth

float hitWeight(March end, vec2 hitUV, float hitDistance, vec3 directionVS, float perceptualRoughness, float VoR) {
    float weight = fadeRoughness(perceptualRoughness, settings.roughnessFadeStart, settings.maxRoughness);
    if (isOn(kFadeBorderSmooth))
        weight *= fadeBorderSmooth(hitUV);
    if (isOn(kFadeBorderLinear))
        weight *= fadeBorderLinear(hitUV, settings.borderWidth);
    if (isOn(kFadeDistance))
        weight *= fadeDistance(hitDistance, settings.maxDistance);
    if (isOn(kFadeIterations))
        weight *= fadeIterations(float(end.iterations), float(settings.maxSteps));
    if (isOn(kFadeFacingCamera))
        weight *= fadeFacingCamera(VoR);
    if (isOn(kFadeBackface)) {
        vec3 hitNormalVS = unpackSurface(texelFetch(surface, ivec2(end.hitPX), 0).xy).normalVS;
        weight *= fadeBackface(dot(hitNormalVS, -directionVS));
    }
    return weight;
}

void main() {
    ivec2 tracePX = ivec2(gl_GlobalInvocationID.xy);
    if (!isTracePixel(frame.constants, tracePX))
        return;
    ivec2 px = tracePixelToFull(frame.constants, tracePX);
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;

    float originZ = texelFetch(viewZ, px, 0).r;
    if (originZ >= kBackgroundZ) {
        storeTraced(tracePX, vec3(0.0), 0.0, RayRecord(uv, 0.0, 0u, kOutcomeNone));
        return;
    }
    Surface origin = unpackSurface(texelFetch(surface, px, 0).xy);
    if (origin.reflectivity <= settings.threshold) {
        storeTraced(tracePX, vec3(0.0), 0.0, RayRecord(uv, 0.0, 0u, kOutcomeBelowThreshold));
        return;
    }
    if (fadeRoughness(origin.perceptualRoughness, settings.roughnessFadeStart, settings.maxRoughness) <= 0.0) {
        storeTraced(tracePX, vec3(0.0), 0.0, RayRecord(uv, 0.0, 0u, kOutcomeTooRough));
        return;
    }

    vec3 originVS = viewPosition(frame.constants, uv, originZ);
    vec3 toSurfaceVS = viewDirection(frame.constants, originVS);
    vec3 directionVS = reflect(toSurfaceVS, origin.normalVS);
    if (settings.roughnessFactor > 0.0) {
        vec3 noise = hashNoise(uvec2(px), frame.constants.frameIndex, frame.constants.seed) - 0.5;
        vec3 jittered = normalize(directionVS + noise * origin.perceptualRoughness * settings.roughnessFactor);
        directionVS = dot(jittered, origin.normalVS) > 0.0 ? jittered : directionVS;
    }
    float VoR = dot(-toSurfaceVS, directionVS);
    if (isOn(kFadeFacingCamera) && fadeFacingCamera(VoR) <= 0.0) {
        storeTraced(tracePX, vec3(0.0), 0.0, RayRecord(uv, 0.0, 0u, kOutcomeFacingCamera));
        return;
    }

    ScreenRay ray = makeScreenRay(frame.constants, originVS, directionVS, settings.maxDistance);
    // Neighbours start at different fractions of a coarse step, so that a miss shows as grain and not as bands.
    float startOffset = settings.step > 1u ? float((tracePX.x + tracePX.y) & 3) * 0.25 : 0.0;
    March end = march(ray, origin.normalVS, directionVS, startOffset);

    vec2 endPX = end.outcome == kOutcomeHit ? end.hitPX : ray.startPX + ray.deltaPX * end.share;
    RayRecord record;
    record.hitUV = clamp(endPX * frame.constants.invSize, vec2(0.0), vec2(1.0));
    record.hitDistance = rayDistance(ray, end.share);
    record.lookups = end.lookups;
    record.outcome = end.outcome;

    vec3 radiance = vec3(0.0);
    float weight = 0.0;
    if (end.outcome == kOutcomeHit) {
        radiance = hitRadiance(ivec2(end.hitPX));
        weight = hitWeight(end, record.hitUV, record.hitDistance, directionVS, origin.perceptualRoughness, VoR);
    }
    storeTraced(tracePX, radiance, weight, record);
}
