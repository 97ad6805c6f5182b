// A ray to be marched, how its march ended, and the seam between the marchers and what they march through. A file that
// includes a marcher declares `settings` before it, of type TraceConstants, and defines the loads below:
// trace/ray_inputs.glsl for the frame's rays, refraction/layer_march.glsl for those of a layer.
#ifndef GLINT_TRACE_RAY_GLSL
#define GLINT_TRACE_RAY_GLSL

#include "frame/frame_block.glsl"
#include "lib/screen_ray.glsl"
#include "shared/outcome.h"
#include "shared/trace_constants.h"

/// The surface that rays may hit in a pixel: metres, kBackgroundZ where there is none; and its normal, unit.
float loadSceneZ(ivec2 px);
vec3 loadSceneNormalVS(ivec2 px);
/// viewZ of that surface's back; kBackgroundZ where it is open. Asked with kTraceBackDepth alone.
float loadSceneBackZ(ivec2 px, float sceneZ);

bool isOn(uint flag) {
    return (settings.flags & flag) != 0u;
}

bool onScreen(vec2 px) {
    return all(greaterThanEqual(px, vec2(0.0))) && all(lessThan(px, frame.constants.size));
}

/// A ray to be marched.
struct Ray {
    ScreenRay screen;
    vec3 originVS;
    vec3 originNormalVS;
    vec3 directionVS; // unit
    ivec2 px;         // the pixel where it starts
};

/// How a march ended, and what it found on its way.
struct March {
    float share; // fraction of the ray's line on screen
    vec2 hitPX;  // of a hit
    uint iterations;
    uint lookups; // reads of any depth image
    uint outcome;
    bool passedBehind; // an occluder: what it would have hit there is not known
    float firstBehind; // where on its line the ray first did; 1: nowhere
    float evidence;    // of outcome inferred: what the surface beside the crossing tells about it, 0 to 1
    bool sunk;         // of a hit: the ray came from beside and is just behind the front
};

/// A march that has not left its start.
March startMarch(ScreenRay ray) {
    March march;
    march.share = 0.0;
    march.hitPX = ray.startPX;
    march.iterations = 0u;
    march.lookups = 0u;
    march.outcome = kOutcomeNone;
    march.passedBehind = false;
    march.firstBehind = 1.0;
    march.evidence = 1.0;
    march.sunk = false;
    return march;
}

void passBehind(inout March march, float share) {
    march.passedBehind = true;
    march.firstBehind = min(march.firstBehind, share);
}

#include "trace/ray_log.glsl"

#endif
