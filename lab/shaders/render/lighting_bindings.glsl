// Further inputs of a lit surface's fragment stage, and the functions that give the lighting code access to them.
#ifndef GLINT_RENDER_LIGHTING_BINDINGS_GLSL
#define GLINT_RENDER_LIGHTING_BINDINGS_GLSL

#include "lib/environment.glsl"
#include "lib/lighting.glsl"
#include "render/surface_bindings.glsl"

layout(scalar, set = 0, binding = 5) readonly buffer LightBlock {
    Light list[];
}
lights;
layout(set = 0, binding = 6) uniform samplerCube environmentRadiance;
layout(set = 0, binding = 7) uniform samplerCube environmentDiffuse;
layout(set = 0, binding = 8) uniform sampler2D dfg;

#ifdef GLINT_SHADOW_RAYS
#include "render/shadow_rays.glsl"
#else
#include "render/shadow_maps.glsl"
#endif

uint loadLightCount() {
    return view.constants.lightCount;
}

Light loadLight(uint index) {
    return lights.list[index];
}

uint loadLightsTogether() {
    return 1u;
}

float loadLightNoise(uint first) {
    return 0.0;
}

vec3 loadEnvironmentRadiance(vec3 direction, float perceptualRoughness) {
    float mip = environmentMip(perceptualRoughness, textureQueryLevels(environmentRadiance));
    vec3 turned = rotateToEnvironment(direction, view.constants.environmentRotation);
    return textureLod(environmentRadiance, turned, mip).rgb * view.constants.environmentStrength;
}

vec3 loadEnvironmentDiffuse(vec3 normal) {
    vec3 turned = rotateToEnvironment(normal, view.constants.environmentRotation);
    return textureLod(environmentDiffuse, turned, 0.0).rgb * view.constants.environmentStrength;
}

vec2 loadDfg(float NoV, float perceptualRoughness) {
    return dfgAt(dfg, NoV, perceptualRoughness);
}

/// Lighting as this view shows it: images that are sampled from elsewhere have no highlights. `V`: unit, towards the
/// eye.
Lighting shownLighting(MaterialSample surface, SurfacePoint point, vec3 V) {
    Lighting lighting = lightSurface(surface, point, V);
    if (view.constants.highlights == 0u)
        lighting.directSpecular = vec3(0.0);
    return lighting;
}

#endif
