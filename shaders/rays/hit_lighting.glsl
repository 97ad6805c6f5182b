// Lights a ray's hit with the same functions that light rasterized surfaces (lib/lighting.glsl), with rays for shadows.
// Include after the ray seam, rays_inputs.glsl and surface_table.glsl.
#ifndef GLINT_RAYS_HIT_LIGHTING_GLSL
#define GLINT_RAYS_HIT_LIGHTING_GLSL

#include "lib/environment.glsl"
#include "lib/lighting.glsl"
#include "lib/noise.glsl"
#include "lib/ray_start.glsl"
#include "lib/sanitize.glsl"

layout(scalar, set = 0, binding = 22) readonly buffer SurfaceLightsBlock {
    Light item[];
}
surfaceLights;
layout(set = 0, binding = 3) uniform samplerCube environment; // prefiltered: glint::EnvironmentMap
layout(set = 0, binding = 4) uniform samplerCube environmentDiffuse;
layout(set = 0, binding = 5) uniform sampler2D dfg;

/// Face normal of the lit surface: shadow rays start off the triangle, not off its bent normal.
vec3 litFaceNormalWS;

/// How the lit surface's lights share shadow rays, and what their random numbers depend on.
struct LightDraw {
    uint together;
    ivec2 px;
    uint index; // of the surface on its path, and of the path
};
LightDraw lightDraw = LightDraw(1u, ivec2(0), 0u);

uint loadLightsTogether() {
    return lightDraw.together;
}

float loadLightNoise(uint first) {
    const uint kShadowSeed = 0x2c1b3c6du; // apart from those of the path's other draws
    return hashNoise(uvec2(lightDraw.px), lightDraw.index, (frame.constants.seed ^ kShadowSeed) + first).x;
}

vec3 toEnvironment(vec3 directionWS) {
    return mat3(frame.constants.worldToEnvironment) * directionWS;
}

uint loadLightCount() {
    return settings.lightCount;
}

Light loadLight(uint index) {
    return surfaceLights.item[index];
}

float loadLightVisibility(Light light, vec3 positionWS, vec3 geometricNormalWS, vec3 L) {
    float offset = hitUncertainty(positionWS);
    float reach = settings.tMax;
    if (light.type != kLightDirectional)
        reach = max(distance(light.positionWS, positionWS) - offset, 0.0);
    Ray ray = makeRay(positionWS + litFaceNormalWS * offset, L, 0.0, reach);
    ray.mask = settings.cullMask;
    ray.flags = shadowRayFlags();
    return isOccluded(ray) ? 0.0 : 1.0;
}

vec3 loadEnvironmentRadiance(vec3 directionWS, float perceptualRoughness) {
    if ((frame.constants.flags & kInputEnvironment) == 0u)
        return vec3(0.0);
    float mip = perceptualRoughness * max(frame.constants.environmentMips - 1.0, 0.0);
    return sanitize(textureLod(environment, toEnvironment(directionWS), mip).rgb) * frame.constants.environmentStrength;
}

vec3 loadEnvironmentDiffuse(vec3 normalWS) {
    if (!isOn(kRaysEnvironmentDiffuse)) // the lobe of roughness 1 is about as wide as the diffuse lobe
        return loadEnvironmentRadiance(normalWS, 1.0);
    return sanitize(textureLod(environmentDiffuse, toEnvironment(normalWS), 0.0).rgb) *
           frame.constants.environmentStrength;
}

vec2 loadDfg(float NoV, float perceptualRoughness) {
    return dfgAt(dfg, NoV, perceptualRoughness);
}

#endif
