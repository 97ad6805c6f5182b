// The `adaptive` marcher: equal steps along the ray in 3D, more of them for rays that are long on screen, then a binary
// search in the step that met something. compute_ssr is the model for the settings: docs/techniques/adaptive.md.
#include "trace/hit_test.glsl"

/// Narrows the step from `front`, where the ray is in front of the picture, to `behind`; both move.
void refine(ScreenRay ray, inout float front, inout Sample behind, inout uint lookups) {
    for (uint i = 0u; i < settings.refinements; ++i) {
        Sample middle = takeSample(ray, 0.5 * (front + behind.share), lookups);
        if (middle.rayZ >= middle.sceneZ)
            behind = middle;
        else
            front = middle.share;
    }
}

March march(Ray r) {
    ScreenRay ray = r.screen;
    March result = March(0.0, ray.startPX, 0u, 0u, kOutcomeNone);
    bool clip = isOn(kTraceClipToFrustum);
    float usable = clip ? rayDistance(ray, ray.screenEnd) : ray.lengthVS;
    float pixels = screenPixels(ray) * (clip ? ray.screenEnd : 1.0);
    uint most = min(2u * settings.baseSteps, settings.maxSteps);
    uint steps = uint(clamp(ceil(pixels / settings.pixelSpacing), float(settings.baseSteps), float(most)));

    float startZ = rayViewZ(ray, 0.0);
    Sample before = Sample(0.0, ray.startPX, startZ, startZ);
    bool isInFront = true;
    bool nearlyThickEnough = false;
    for (uint i = 1u; i <= steps; ++i) {
        result.iterations = i;
        // The last one lands on the end itself, which rounding could put off screen.
        result.share = i < steps ? shareAtDistance(ray, usable * float(i) / float(steps)) : (clip ? ray.screenEnd : 1.0);
        if (!onScreen(ray.startPX + ray.deltaPX * result.share)) {
            result.outcome = kOutcomeOffScreen;
            return result;
        }
        Sample s = takeSample(ray, result.share, result.lookups);
        if (s.rayZ < s.sceneZ) {
            isInFront = true;
            nearlyThickEnough = false;
        } else if (i > settings.selfCollisionSkip) {
            Sample hit = s;
            float from = before.share;
            if (isInFront)
                refine(ray, from, hit, result.lookups);
            uint met = meetSurface(r, from, hit, result.lookups);
            if (endsMarch(met, hit, result))
                return result;
            nearlyThickEnough = nearlyThickEnough || met == kNearlyMeets;
            isInFront = false;
        }
        before = s;
    }

    if (clip && ray.screenEnd < 1.0)
        result.outcome = kOutcomeOffScreen;
    else if (!isInFront)
        result.outcome = nearlyThickEnough ? kOutcomeTooThick : kOutcomeHidden;
    else if (ray.clippedNear)
        result.outcome = kOutcomeBehindCamera;
    else
        result.outcome = before.sceneZ >= kBackgroundZ ? kOutcomeSky : kOutcomeMaxDistance;
    return result;
}
