// All sources under the one rule (hierarchy/walk.glsl), in the user's order (settings order.*).
#ifndef GLINT_HIERARCHY_COMBINED_GLSL
#define GLINT_HIERARCHY_COMBINED_GLSL

#include "frame/prepared.glsl"
#include "generate/pixel_ray.glsl"
#include "hierarchy/answers.glsl"
#include "hierarchy/environment_radiance.glsl"
#include "hierarchy/source_log.glsl"
#include "lib/camera.glsl"
#include "lib/sanitize.glsl"
#include "lib/surface.glsl"

layout(set = 0, binding = 4) uniform samplerCube environment;
layout(set = 0, binding = 8) uniform sampler2D occlusion; // ambient, of the host

/// Fraction of the mirror lobe that ambient occlusion leaves open; 1 without occlusion. Lagarde, de Rousiers 2014,
/// "Moving Frostbite to Physically Based Rendering", section 4.10.2: a fit, exact at occlusion 1 (open) and at
/// occlusion 0 with grazing view.
float specularOcclusion(ivec2 px, float z) {
    HostChannel stored = frame.constants.occlusion;
    float open = stored.bias;
    if (stored.scale != 0.0)
        open += texelFetch(occlusion, px, 0)[stored.channel] * stored.scale;
    open = clamp(sanitize(open), 0.0, 1.0);
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    vec3 positionVS = viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z);
    float NoV = clamp(dot(here.normalVS, -viewDirection(frame.constants, positionVS)), 0.0, 1.0);
    float alpha = here.perceptualRoughness * here.perceptualRoughness;
    return clamp(pow(NoV + open, exp2(-16.0 * alpha - 1.0)) - 1.0 + open, 0.0, 1.0);
}

/// The sky answers every direction.
vec4 skyAnswer(ivec2 px, float z) {
    if ((frame.constants.flags & kInputEnvironment) == 0u)
        return vec4(0.0);
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    PixelRay ray = generateRay(uv, z, here);
    if (ray.roughnessLeft < kSmoothestLobe)
        return vec4(environmentRadiance(environment, directionWS(ray), ray.roughnessLeft), 1.0);
    mat3 toWorld = mat3(frame.constants.viewToWorld);
    vec3 toEyeWS = -(toWorld * viewDirection(frame.constants, ray.originVS));
    return vec4(environmentLobe(environment, toWorld * here.normalVS, toEyeWS, ray.roughnessLeft), 1.0);
}

/// The sum over all sources for the pixel, whose surface is at `z`; `traced`: the screen has an answer; `shares`: the
/// weight that each source got.
Walk combinedAnswers(ivec2 px, float z, bool traced, out float shares[kMaxSources]) {
    HierarchyConstants settings = frame.settings.hierarchy;
    Walk walk = beginWalk();
    shares = float[](0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    for (uint i = 0u; i < kMaxSources && z < kBackgroundZ && walk.taken < 1.0; ++i) {
        uint source = (settings.order >> (4u * i)) & 15u;
        if ((settings.sources & (1u << source)) == 0u || (source == kSourceScreen && !traced))
            continue;
        vec4 answer = source == kSourceSky ? skyAnswer(px, z) : loadAnswer(source, settings.sources, px);
        bool untested = source == kSourceSky || source == kSourceProbes; // no ray has tested what hides the direction
        if (untested && (frame.constants.flags & kInputOcclusion) != 0u)
            answer.rgb *= specularOcclusion(px, z);
        shares[source] = take(walk, answer);
        logSource(px, i, source, shares[source], answer.rgb);
    }
    return walk;
}

#endif
