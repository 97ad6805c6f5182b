// The `linear` marcher: one depth lookup every `step` pixels along the ray's line on screen, but for those in open space.
//
// Depths are compared at the sample itself, so a plane never intersects itself however grazing the ray. McGuire and
// Mara's half-pixel intervals do self-intersect, and need `selfCollisionSkip`. The settings follow Babylon.js'
// SSRRenderingPipeline: docs/techniques/linear.md lists the differences.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "trace/ray_inputs.glsl"

#include "trace/hit_test.glsl"
#include "trace/open_space.glsl"

/// Tests pixel by pixel between two coarse samples for the first hit. Moves `s` to the hit.
uint refineBySinglePixels(Ray r, Sample before, inout Sample s, float pixels, inout March march) {
    float pixelShare = 1.0 / pixels;
    float beforeShare = before.share;
    for (float share = beforeShare + pixelShare;; share += pixelShare) {
        bool isLast = share >= s.share;
        Sample fine = s;
        if (!isLast)
            fine = takeSample(r.screen, share, march.lookups);
        uint met = !isLast && fine.rayZ < fine.sceneZ ? kPasses : meetSurface(r, beforeShare, fine, march);
        if (isLast || isEnd(met)) {
            s = fine;
            return met;
        }
        beforeShare = share;
    }
}

March march(Ray r) {
    ScreenRay ray = r.screen;
    March result = startMarch(ray);
    bool clip = isOn(kTraceClipToFrustum);
    float pixels = screenPixels(ray);
    float endShare = clip ? ray.screenEnd : 1.0;
    float stepShare = float(settings.step) / pixels;
    // Neighbours start at different fractions of a coarse step, so that a miss shows as grain, not as bands.
    float startOffset = settings.step > 1u ? float((r.px.x + r.px.y) & 3) * 0.25 : 0.0;
    uint needed = uint(min(ceil(endShare / stepShare + startOffset), 8192.0));
    uint iterations = min(needed, settings.maxSteps);

    float startZ = rayViewZ(ray, 0.0);
    Sample before = Sample(0.0, ray.startPX, startZ, startZ);
    bool nearlyThickEnough = false;

    OpenSpace space = openSpace(ray);
    for (uint i = 1u; i <= iterations; ++i) {
        float next = (float(i) - startOffset) * stepShare;
        bool wasInFront = before.rayZ < before.sceneZ || i == 1u; // behind something, little is open
        bool mayPay = i + (1u << kFinestOpen) <= iterations;
        if (wasInFront && mayPay && next >= space.from && onScreen(ray.startPX + ray.deltaPX * next)) {
            float until = openUntil(ray, space, next, 0.5 * stepShare, result.lookups);
            // The last sample is taken: what it shows tells how the ray ended.
            uint last = min(uint(floorToInt(until / stepShare + startOffset)), iterations - 1u);
            if (until > next && last >= i) {
                float share = (float(last) - startOffset) * stepShare;
                before = Sample(share, ray.startPX + ray.deltaPX * share, rayViewZ(ray, share), kBackgroundZ);
                nearlyThickEnough = false;
                i = last + 1u;
            }
        }
        result.iterations = i;
        result.share = min((float(i) - startOffset) * stepShare, endShare);
        if (!onScreen(ray.startPX + ray.deltaPX * result.share)) {
            result.outcome = kOutcomeOffScreen;
            return result;
        }
        Sample s = takeSample(ray, result.share, result.lookups);
        bool inFront = s.rayZ < s.sceneZ;
        Sample hit = s;
        nearlyThickEnough = nearlyThickEnough && !inFront;
        bool tests = i > settings.selfCollisionSkip;
        if (inFront)
            tests = tests && settings.step == 1u && mayMeetBeforeLeaving(r, s.share + 0.5 * stepShare, hit);
        if (tests) {
            uint met = meetSurface(r, before.share, inFront, hit, result);
            if (settings.step > 1u && isOn(kTraceSmooth) && (isEnd(met) || met == kGrazes)) {
                hit = s;
                met = refineBySinglePixels(r, before, hit, pixels, result);
            }
            if (endsMarch(met, hit, result))
                return result;
            nearlyThickEnough = nearlyThickEnough || met == kNearlyMeets;
        }
        if (i > settings.selfCollisionSkip || inFront)
            before = s; // a surface crossed in skipped iterations is hit by the first that counts
    }

    bool endsBehind = before.rayZ >= before.sceneZ && before.share > 0.0;
    if (needed > iterations)
        result.outcome = kOutcomeOutOfSteps;
    else if (clip && ray.screenEnd < 1.0)
        result.outcome = kOutcomeOffScreen; // as the same ray without clipping, whatever it passed behind
    else
        result.outcome = endedOnScreen(ray, before.sceneZ, endsBehind, nearlyThickEnough);
    return result;
}

#include "trace/trace_main.glsl"
