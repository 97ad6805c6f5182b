// When a ray meets what the picture shows. A pixel knows its surface's depth and normal, so it is held for a small flat
// piece: the ray meets its front if it goes from before the piece's plane to behind it, whatever the piece's thickness.
// A ray that comes upon it from elsewhere, behind its plane already, meets it if it is no deeper than the slab.
#ifndef GLINT_TRACE_HIT_TEST_GLSL
#define GLINT_TRACE_HIT_TEST_GLSL

#include "trace/ray_inputs.glsl"

/// dot(normal at the hit, -ray) below which a surface was met from behind. A little below 0, as shading normals lean;
/// `fade.backface` fades what lies between.
const float kBackFaceLimit = -0.17;
/// dot(normal at the hit, normal at the start) above which both may be one surface, which its own ray never meets from
/// the front; 25 degrees.
const float kOwnSurface = 0.9;

/// One depth sample of the ray.
struct Sample {
    float share;
    vec2 px;
    float rayZ;
    float sceneZ;
};

Sample takeSample(ScreenRay ray, float share, inout uint lookups) {
    Sample s;
    s.share = share;
    s.px = ray.startPX + ray.deltaPX * share;
    s.rayZ = rayViewZ(ray, share);
    s.sceneZ = texelFetch(viewZ, ivec2(s.px), 0).r;
    ++lookups;
    return s;
}

/// viewZ to which the surface that the picture shows at `px` reaches back.
float slabEnd(vec2 px, float sceneZ, inout uint lookups) {
    float reach = sceneZ;
    if (isOn(kTraceBackDepth)) {
        ivec2 size = textureSize(backViewZ, 0);
        ivec2 backPX = min(ivec2(px * frame.constants.invSize * vec2(size)), size - 1);
        float backZ = texelFetch(backViewZ, backPX, 0).r;
        ++lookups;
        // A back face in front of the front: something open, of which nothing is known behind.
        if (backZ < kBackgroundZ && backZ >= sceneZ * 0.999)
            reach = max(backZ, sceneZ);
    }
    return reach + settings.thickness + settings.thicknessRelative * sceneZ;
}

/// Was the surface met from its front? From behind, the ray either grazes the surface that it starts from, where
/// shading normals disagree with depth, or meets a side that nobody sees.
bool facesRay(vec3 hitNormalVS, Ray ray) {
    float limit = dot(hitNormalVS, ray.originNormalVS) > kOwnSurface ? 0.0 : kBackFaceLimit;
    return dot(hitNormalVS, -ray.directionVS) > limit;
}

vec3 normalAt(vec2 px) {
    return unpackSurface(texelFetch(surface, ivec2(px), 0).xy).normalVS;
}

const uint kPasses = 0u;       // in front of the surface, or far behind it
const uint kMeets = 1u;        // its front, or its slab from a side that may be seen
const uint kMeetsBehind = 2u;  // its back
const uint kNearlyMeets = 3u;  // a slab twice as thick would have been met

/// Does the ray, coming from `beforeShare`, meet the surface at the sample `s`? `s` moves to where it does.
uint meetSurface(Ray r, float beforeShare, inout Sample s, inout uint lookups) {
    if (s.rayZ < s.sceneZ)
        return kPasses;
    vec3 normalVS = normalAt(s.px);
    vec2 pixel = floor(s.px);
    vec3 surfaceVS = viewPosition(frame.constants, (pixel + 0.5) * frame.constants.invSize, s.sceneZ);
    vec2 beforePX = r.screen.startPX + r.screen.deltaPX * beforeShare;
    float beforeZ = rayViewZ(r.screen, beforeShare);
    vec3 beforeVS = viewPosition(frame.constants, beforePX * frame.constants.invSize, beforeZ);
    vec3 hereVS = viewPosition(frame.constants, s.px * frame.constants.invSize, s.rayZ);
    float heightBefore = dot(normalVS, beforeVS - surfaceVS);
    float heightHere = dot(normalVS, hereVS - surfaceVS);
    if (heightHere > 0.0 && heightBefore > 0.0)
        return kPasses; // behind the pixel's centre, but not behind its plane
    bool faces = facesRay(normalVS, r);
    if (faces && heightBefore >= 0.0) {
        s.share = mix(beforeShare, s.share, clamp(heightBefore / max(heightBefore - heightHere, 1e-30), 0.0, 1.0));
        // The colour is that of the pixel that was met, even where the plane is crossed just outside of it.
        s.px = clamp(r.screen.startPX + r.screen.deltaPX * s.share, pixel, pixel + 0.999);
        return kMeets;
    }
    float slabZ = slabEnd(s.px, s.sceneZ, lookups);
    float nearest = min(s.rayZ, beforeZ);
    if (nearest <= slabZ)
        return faces ? kMeets : kMeetsBehind;
    return nearest <= 2.0 * slabZ - s.sceneZ ? kNearlyMeets : kPasses;
}

#endif
