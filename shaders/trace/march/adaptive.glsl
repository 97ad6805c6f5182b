// The `adaptive` marcher: equal steps on screen, with more steps for rays that are long on screen, then a binary search
// in the step that intersects. The settings follow compute_ssr: docs/techniques/adaptive.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "trace/ray_inputs.glsl"

#include "trace/hit_test.glsl"

/// Narrows the step between `front`, where the ray is in front of the depth buffer, and `behind`. Moves both.
void refine(ScreenRay ray, inout float front, inout Sample behind, inout uint lookups) {
    for (uint i = 0u; i < settings.refinements; ++i) {
        Sample middle = takeSample(ray, 0.5 * (front + behind.share), lookups);
        if (middle.rayZ >= middle.sceneZ)
            behind = middle;
        else
            front = middle.share;
    }
}

/// Moves `s`, the end of a step, to where the ray goes behind the depth of a pixel's centre, and `from`, the step's
/// beginning, to just before it: the ray may intersect the plane through that centre anywhere in the pixel.
void narrow(Ray r, inout float from, inout Sample s, inout uint lookups) {
    float front = from;
    refine(r.screen, front, s, lookups);
    float halfPixel = 0.5 / screenPixels(r.screen);
    s.share = min(s.share + halfPixel, 1.0);
    s.rayZ = rayViewZ(r.screen, s.share);
    from = max(front - halfPixel, from);
}

/// Fraction of the line at which the ray leaves its own pixel. In there it goes behind the depth of the pixel's centre,
/// which is that of its start: a search would end at that instead of at what stands beside.
float endOfOwnPixel(Ray r) {
    vec2 low = vec2(r.px);
    ScreenRay ray = r.screen;
    return clamp(min(shareInside(ray.startPX.x, ray.deltaPX.x, low.x, low.x + 1.0),
                     shareInside(ray.startPX.y, ray.deltaPX.y, low.y, low.y + 1.0)),
                 0.0, 1.0);
}

March march(Ray r) {
    ScreenRay ray = r.screen;
    March result = startMarch(ray);
    bool clip = isOn(kTraceClipToFrustum);
    float end = clip ? ray.screenEnd : 1.0;
    float pixels = screenPixels(ray) * end;
    uint most = min(2u * settings.baseSteps, settings.maxSteps);
    uint steps = uint(clamp(ceil(pixels / settings.pixelSpacing), float(settings.baseSteps), float(most)));

    float startZ = rayViewZ(ray, 0.0);
    Sample before = Sample(min(endOfOwnPixel(r), end / float(steps)), ray.startPX, startZ, startZ);
    bool isInFront = true;
    bool nearlyThickEnough = false;
    for (uint i = 1u; i <= steps; ++i) {
        result.iterations = i;
        result.share = end * (float(i) / float(steps)); // the last step is the end itself, without rounding
        if (!onScreen(ray.startPX + ray.deltaPX * result.share)) {
            result.outcome = kOutcomeOffScreen;
            return result;
        }
        Sample s = takeSample(ray, result.share, result.lookups);
        if (s.rayZ < s.sceneZ) {
            isInFront = true;
            nearlyThickEnough = false;
        } else if (i > settings.selfCollisionSkip) {
            Sample hit;
            uint met = kInFront;
            // Where the search ends, then, if the ray is in front of the surface there, at the step's own end.
            for (uint attempt = isInFront ? 0u : 1u; attempt < 2u && met == kInFront; ++attempt) {
                hit = s;
                float from = before.share;
                if (attempt == 0u)
                    narrow(r, from, hit, result.lookups);
                met = meetSurface(r, from, hit, result);
                // The ray intersects the plane far from the pixel that shows it: as far as the depth buffer tells, not
                // its surface.
                vec2 apart = abs(ray.startPX + ray.deltaPX * hit.share - hit.px);
                if (attempt == 1u && met == kMeets && max(apart.x, apart.y) > 1.0)
                    met = kPasses;
            }
            if (endsMarch(met, hit, result))
                return result;
            nearlyThickEnough = nearlyThickEnough || met == kNearlyMeets;
            isInFront = false;
        }
        if (i > settings.selfCollisionSkip || s.rayZ < s.sceneZ)
            before = s; // a surface crossed in skipped steps is hit by the first step that counts
    }

    if (clip && ray.screenEnd < 1.0)
        result.outcome = kOutcomeOffScreen;
    else
        result.outcome = endedOnScreen(ray, before.sceneZ, !isInFront, nearlyThickEnough);
    return result;
}

#include "trace/trace_main.glsl"
