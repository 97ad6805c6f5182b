// Why a ray ended, as a colour. Blue, red, yellow and green are Babylon.js' own (its `debug`); the reasons that it does
// not tell apart have colours of ours.
#ifndef GLINT_LIB_OUTCOME_COLOR_GLSL
#define GLINT_LIB_OUTCOME_COLOR_GLSL

#include "lib/ray_record.glsl"

vec3 outcomeColor(RayRecord ray, uint maxSteps) {
    switch (ray.outcome) {
    case kOutcomeHit: // brighter: more steps were needed
        return vec3(0.0, clamp(float(ray.lookups) / float(max(maxSteps, 1u)), 0.02, 1.0), 0.0);
    case kOutcomeSky:
        return vec3(0.25, 0.6, 0.9);
    case kOutcomeOffScreen:
        return vec3(1.0, 1.0, 0.0);
    case kOutcomeBehindCamera:
        return vec3(1.0, 0.5, 0.0);
    case kOutcomeMaxDistance:
        return vec3(0.0, 0.0, 1.0);
    case kOutcomeOutOfSteps:
        return vec3(1.0, 0.0, 0.0);
    case kOutcomeHidden:
        return vec3(0.5, 0.0, 0.5);
    case kOutcomeTooThick:
        return vec3(0.9, 0.3, 0.9);
    case kOutcomeBackFace:
        return vec3(0.45, 0.3, 0.15);
    case kOutcomeSide:
        return vec3(0.45, 0.75, 0.1);
    case kOutcomeInferred:
        return vec3(0.75, 1.0, 0.8);
    case kOutcomeBelowThreshold:
        return vec3(0.15);
    case kOutcomeTooRough:
        return vec3(0.3);
    case kOutcomeFacingCamera:
        return vec3(0.0, 0.5, 0.5);
    case kOutcomeFromNeighbours:
        return vec3(0.2, 0.3, 0.45);
    default:
        return vec3(0.0);
    }
}

#endif
