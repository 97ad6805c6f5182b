// Shows what the passes know as an image: one view, a row of shared/views.h, unscaled values in full precision.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "denoise/changed_light.glsl"
#include "denoise/history.glsl"
#include "denoise/sent_ray.glsl"
#include "generate/pixel_ray.glsl"
#include "frame/prepared.glsl"
#include "lib/camera.glsl"
#include "lib/math.glsl"
#include "lib/outcome_color.glsl"
#include "lib/resolved_material.glsl"
#include "lib/source_weights.glsl"
#include "lib/surface.glsl"
#include "lib/trace_pixel.glsl"
#include "shared/trace_constants.h"
#include "shared/views.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 3) uniform sampler2D radianceWeight;
layout(set = 0, binding = 4) uniform usampler2D rayRecord;
layout(set = 0, binding = 5) uniform sampler2D reflected;
layout(set = 0, binding = 6) uniform usampler2D weights;
layout(set = 0, binding = 7, rgba32f) uniform writeonly image2D view;
layout(set = 0, binding = 8) uniform sampler2D material;
layout(set = 0, binding = 9) uniform sampler2D probesAnswer;
layout(set = 0, binding = 10) uniform sampler2D planarAnswer;
layout(set = 0, binding = 11) uniform sampler2D refracted;         // one texel without layers
layout(set = 0, binding = 12) uniform sampler2D refractionWeights;
layout(set = 0, binding = 13) uniform usampler2D sentRay; // this and the following: if `denoised`
layout(set = 0, binding = 14) uniform sampler2D historyMeta;
layout(set = 0, binding = 15) uniform sampler2D historyMetaBefore;
layout(set = 0, binding = 16) uniform sampler2D changed; // of the previous frame's tiles: denoise/change.comp
layout(push_constant, scalar) uniform PushBlock {
    uint shownView; // row of GLINT_VIEWS
    uint denoised;
};

/// A colour a source, that of the heaviest; black where none answered.
vec3 sourceColor(uvec2 shares) {
    const vec3 kColors[kMaxSources] = vec3[](vec3(0.1, 0.8, 0.2), vec3(0.9, 0.5, 0.15), vec3(0.95, 0.85, 0.2),
                                              vec3(0.7, 0.4, 0.9), vec3(0.25, 0.6, 0.9),
                                             vec3(0.8));
    float heaviest = 0.0;
    vec3 color = vec3(0.0);
    for (uint source = 0u; source < kMaxSources; ++source)
        if (sourceWeight(shares, source) > heaviest) {
            heaviest = sourceWeight(shares, source);
            color = kColors[source];
        }
    return color;
}

/// Unity HDRP's colours; answers that are no hits are neither of the two.
vec3 successColor(uint outcome) {
    if (outcome == kOutcomeNone || outcome >= kOutcomeBelowThreshold)
        return vec3(0.0);
    if (outcome == kOutcomeHit)
        return vec3(0.55, 0.95, 0.55);
    return isAnswered(outcome) ? vec3(0.95, 0.85, 0.4) : vec3(0.6, 0.8, 1.0);
}

vec3 rayDirectionWS(ivec2 px, Surface here, float z) {
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    return directionWS(generateRay(uv, z, here));
}

/// viewZ of what the picture shows where the ray hit.
float hitDepth(RayRecord ray) {
    ivec2 px = min(ivec2(ray.hitUV * frame.constants.size), ivec2(frame.constants.size) - 1);
    float z = texelFetch(viewZ, px, 0).r;
    return z < kBackgroundZ ? z : 0.0;
}

/// Share of the previous frame's mean at this pixel that counts no more.
float historyGivenUp(ivec2 px) {
    if (!hasDenoiserHistory() || any(greaterThanEqual(px, ivec2(frame.constants.prevSize))))
        return 0.0;
    float frames = texelFetch(historyMetaBefore, px, 0).x;
    return frames > 0.0 ? 1.0 - framesKept(frames, lightChange(changed, vec2(px) + 0.5)) / frames : 0.0;
}

float raySent(ivec2 px) {
    const float kAwaits = 0.25;
    SentRay ray = unpackSentRay(texelFetch(sentRay, px, 0).xy);
    return ray.sent ? 1.0 : ray.awaits ? kAwaits : 0.0;
}

vec3 foundRadiance(ivec2 px) {
    vec4 answer = texelFetch(radianceWeight, px, 0);
    return answer.a > 0.0 ? answer.rgb : vec3(0.0);
}

/// Radiance of a source that takes part in the pixel.
vec3 answerOf(uint source, sampler2D answer, uvec2 shares, ivec2 px) {
    return sourceWeight(shares, source) > 0.0 ? texelFetch(answer, px, 0).rgb : vec3(0.0);
}

/// Black without layers.
vec3 texelOfLayer(sampler2D layer, ivec2 px) {
    return all(lessThan(px, textureSize(layer, 0))) ? texelFetch(layer, px, 0).rgb : vec3(0.0);
}

vec4 rgba(float value) {
    return vec4(vec3(value), 1.0);
}
vec4 rgba(vec2 value) {
    return vec4(value, 0.0, 1.0);
}
vec4 rgba(vec3 value) {
    return vec4(value, 1.0);
}
vec4 rgba(vec4 value) {
    return value;
}

/// The names below are those that rows of GLINT_VIEWS use.
vec4 viewValue(ivec2 px) {
    float z = texelFetch(viewZ, px, 0).r;
    bool background = z >= kBackgroundZ;
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    RayRecord ray = RayRecord(vec2(0.0), 0.0, 0u, kOutcomeNone, false);
    if (!background)
        ray = unpackRayRecord(texelFetch(rayRecord, fullToTracePixel(frame.constants, px), 0).xy);
    bool hit = isAnswered(ray.outcome);
    uvec2 shares = texelFetch(weights, px, 0).xy;

    uint row = 0u;
#define RETURN_IF_SHOWN(name, kind, channels, meaning, value) \
    if (shownView == row++)                                   \
        return rgba(value);
    GLINT_VIEWS(RETURN_IF_SHOWN)
    return vec4(0.0, 0.0, 0.0, 1.0);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(px, ivec2(frame.constants.size))))
        imageStore(view, px, viewValue(px));
}
