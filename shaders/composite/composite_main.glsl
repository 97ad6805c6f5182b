// Composites the reflections into the host's frame. What a reflection replaces is subtracted, so no light counts twice.
//   physical  out = lit - w * given * fallbackSpecular + R; R: the reflected radiance under the material's specular
//             response, of which the user's settings give the fraction `given`
//   lerp      out = lit * (1 - m) + reflection * m, Babylon.js' model; remaining weight keeps the pixel's own colour
// docs/techniques/composite.md.
//
// GLINT_COMBINES: the pass combines the sources itself, and no image holds the reflections alone. For hosts with one
// sample a pixel: a pixel that shows several surfaces needs the reflections of its neighbours.
//
// GLINT_COAT: the host states a clear coat, a second lobe over the surface's with reflections of its own.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/prepared.glsl"
#ifdef GLINT_COMBINES
#include "hierarchy/combined.glsl"
#include "trace/listed.glsl"
#endif
#include "lib/brdf.glsl"
#include "lib/camera.glsl"
#include "lib/coat.glsl"
#include "lib/edge.glsl"
#include "lib/environment.glsl"
#include "lib/input_color.glsl"
#include "lib/math.glsl"
#include "lib/outcome_color.glsl"
#include "lib/resolved_material.glsl"
#include "lib/surface.glsl"
#include "lib/trace_pixel.glsl"
#include "lib/user_response.glsl"
#include "shared/trace_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

#ifndef GLINT_COMBINES
layout(set = 0, binding = 6) uniform sampler2D reflected;
layout(set = 0, binding = 10) uniform usampler2D edge;
#endif
layout(set = 0, binding = 7) uniform usampler2D rayRecord;
layout(set = 0, binding = 9, rgba16f) uniform writeonly image2D composite;
layout(set = 0, binding = 11) uniform sampler2D material;
layout(set = 0, binding = 12) uniform sampler2D litRadiance;
layout(set = 0, binding = 13) uniform sampler2D fallbackSpecular;
layout(set = 0, binding = 14) uniform sampler2D dfg;
#ifdef GLINT_COAT
layout(set = 0, binding = 16) uniform usampler2D coatSurface; // lib/coat.glsl
layout(set = 0, binding = 17) uniform sampler2D coatReflected;
#endif
CompositeConstants settings = frame.settings.composite;

/// Fraction of reflected light that this surface sends to the eye.
vec3 physicalResponse(vec3 f0, float f90, float perceptualRoughness, float NoV) {
    return settings.fresnel != 0u ? specularResponse(f0, f90, dfgAt(dfg, NoV, perceptualRoughness)) : f0;
}

/// One of the surfaces that a pixel shows. With one sample a pixel there is one surface, with coverage 1.
struct Share {
    float coverage; // [0, 1]
    vec3 f0;
    float f90;
    float perceptualRoughness;
    float NoV;
    vec4 reflection; // weighted radiance, total weight
    vec3 lit;        // of this surface, as far as known
    ivec2 at;        // the pixel whose reflection that is
};

float viewCosine(ivec2 px, float z, vec3 normalVS) {
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    vec3 toSurfaceVS = viewDirection(frame.constants, viewPosition(frame.constants, uv, z));
    return clamp(dot(normalVS, -toSurfaceVS), 0.0, 1.0);
}

/// F0 and coverage.
vec4 loadMaterial(ivec2 px) {
    return resolvedMaterial(frame.constants, texelFetch(material, px, 0));
}

float loadF90(ivec2 px) {
    return resolvedF90(frame.constants, texelFetch(material, px, 0));
}

vec3 loadLit(ivec2 px) {
    return linearColor(texelFetch(litRadiance, px, 0).rgb, (frame.constants.flags & kInputGamma) != 0u);
}

#ifdef GLINT_COMBINES

Share frontShare(ivec2 px, float z, Surface here, vec3 lit) {
    vec3 f0 = here.reflectivity > 0.0 ? loadMaterial(px).rgb : vec3(0.0);
    vec4 reflection = vec4(0.0);
    if (maxComponent(f0) > 0.0) {
        float shares[kMaxSources];
        Walk walk = combinedAnswers(px, z, hasTracedAnswer(), shares);
        reflection = vec4(walk.radiance, walk.taken);
    }
    return Share(1.0, f0, loadF90(px), here.perceptualRoughness, viewCosine(px, z, here.normalVS), reflection, lit, px);
}

/// Does any surface of the pixel reflect? The background does not.
bool mayReflect(ivec2 px, Surface here) {
    return here.reflectivity > 0.0;
}

Share secondShare(ivec2 px, float frontCoverage) {
    return Share(0.0, vec3(0.0), 1.0, 1.0, 1.0, vec4(0.0), vec3(0.0), px);
}

#else

#include "composite/edge_shares.glsl"

bool mayReflect(ivec2 px, Surface here) {
    return texelFetch(viewZ, px, 0).r < kBackgroundZ; // a surface behind an edge may
}

#endif

Response response(Share share) {
    if (maxComponent(share.f0) <= 0.0)
        return Response(vec3(0.0), vec3(0.0));
    return userResponse(settings, physicalResponse(share.f0, share.f90, share.perceptualRoughness, share.NoV));
}

/// `fallback` is the mean over all surfaces of the pixel, and so includes coverage already. Where the sources answered
/// the surfaces with different weights, each surface gets the part of `fallback` that its response claims.
vec3 physical(vec3 lit, vec3 fallback, Share front, Share second) {
    Response frontResponse = response(front);
    Response secondResponse = response(second);
    vec3 weight = front.reflection.a * frontResponse.taken;
    if (second.coverage > 0.0) {
        vec3 frontPart = front.coverage * frontResponse.value;
        vec3 secondPart = second.coverage * secondResponse.value;
        weight = (frontPart * weight + secondPart * (second.reflection.a * secondResponse.taken)) /
                 max(frontPart + secondPart, vec3(1e-6));
    }
    return lit - weight * fallback + front.coverage * (front.reflection.rgb * frontResponse.value) +
           second.coverage * (second.reflection.rgb * secondResponse.value);
}

vec3 lerpedSurface(Share share) {
    if (maxComponent(share.f0) <= 0.0)
        return share.lit;
    return lerpedReflection(settings, share.lit, share.reflection, share.f0, share.f90, share.NoV);
}

vec3 lerped(vec3 lit, Share front, Share second) {
    if (front.coverage >= 1.0)
        return lerpedSurface(front);
    return lit + front.coverage * (lerpedSurface(front) - front.lit) +
           second.coverage * (lerpedSurface(second) - second.lit);
}

/// True if a source has answered what the surface reflects.
bool isReflecting(Share share) {
    return maxComponent(share.f0) * share.reflection.a > 0.0;
}

vec3 loadFallback(ivec2 px) {
    if ((frame.constants.flags & kInputFallback) == 0u)
        return vec3(0.0);
    return linearColor(texelFetch(fallbackSpecular, px, 0).rgb, (frame.constants.flags & kInputGamma) != 0u);
}

#ifdef GLINT_COAT

#include "composite/coat_shares.glsl"

/// The pixel with its reflections. False if no source has answered for it.
bool reflecting(ivec2 px, vec3 lit, Share front, Share second, out vec3 result) {
    return coated(px, lit, loadFallback(px), front, second, result);
}

#else

/// The pixel with its reflections. False if no source has answered for it.
bool reflecting(ivec2 px, vec3 lit, Share front, Share second, out vec3 result) {
    result = lit;
    if (!isReflecting(front) && !isReflecting(second))
        return false;
    result = settings.model == 0u ? physical(lit, loadFallback(px), front, second) : lerped(lit, front, second);
    return true;
}

#endif

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    bool fromGamma = (frame.constants.flags & kInputGamma) != 0u;
    bool toGamma = (frame.constants.flags & kOutputGamma) != 0u;
    vec4 stored = texelFetch(litRadiance, px, 0);
    vec3 lit = linearColor(stored.rgb, fromGamma);
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    vec3 result = lit;
    bool untouched = true; // where the pixel does not reflect, keep the host's own bits
    if (mayReflect(px, here)) {
        float z = texelFetch(viewZ, px, 0).r;
        Share front = frontShare(px, z, here, lit);
        Share second = secondShare(px, front.coverage);
        if (reflecting(px, lit, front, second, result)) {
            result = sanitize(result); // the sum of two large halves may be infinite
            untouched = false;
        }
    }
    if (settings.debugOutcome != 0u && texelFetch(viewZ, px, 0).r < kBackgroundZ) {
        ivec2 tracePX = fullToTracePixel(frame.constants, px);
        RayRecord ray = unpackRayRecord(texelFetch(rayRecord, tracePX, 0).xy);
        if (ray.outcome != kOutcomeNone) {
            // As in Babylon.js, a ray that was clipped at the frustum ends there.
            if (ray.outcome == kOutcomeOffScreen && settings.debugOutcome == kDebugClipped)
                ray.outcome = kOutcomeMaxDistance;
            result = outcomeColor(ray, frame.settings.trace.maxSteps);
            untouched = false;
        }
    }
    if (untouched && fromGamma == toGamma)
        result = stored.rgb;
    else if (toGamma)
        result = encodeSrgb(result);
    imageStore(composite, px, vec4(result, stored.a));
}
