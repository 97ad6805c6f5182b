// Everything a lit surface's fragment stage reads, and how the lighting functions reach it.
#ifndef GLINT_RENDER_SURFACE_BINDINGS_GLSL
#define GLINT_RENDER_SURFACE_BINDINGS_GLSL

#include "lib/environment.glsl"
#include "lib/lighting.glsl"
#include "lib/shadow.glsl"
#include "render/draw_constants.glsl"
#include "render/material_binding.glsl"
#include "render/scene_bindings.glsl"
#include "shared/render_view.h"

layout(scalar, set = 0, binding = 4) uniform ViewBlock {
    RenderView constants;
} view;
layout(scalar, set = 0, binding = 5) readonly buffer LightBlock {
    Light list[];
} lights;
layout(set = 0, binding = 6) uniform samplerCube environmentRadiance;
layout(set = 0, binding = 7) uniform samplerCube environmentDiffuse;
layout(set = 0, binding = 8) uniform sampler2D dfg;
layout(set = 0, binding = 9) uniform sampler2DShadow shadowAtlas;
layout(set = 1, binding = 0) uniform sampler2D textures[];

#define VARYING in
#include "render/surface_varyings.glsl"

vec4 sampleTexture(uint index, vec2 uv) {
    return texture(textures[index], uv); // one draw has one material, so the index is uniform
}

uint loadLightCount() {
    return view.constants.lightCount;
}

Light loadLight(uint index) {
    return lights.list[index];
}

float loadLightVisibility(Light light, vec3 position, vec3 geometricNormal, vec3 L) {
    if (light.castsShadow == 0u)
        return 1.0;
    vec2 texel = 1.0 / vec2(textureSize(shadowAtlas, 0));
    ShadowLookup at = shadowLookup(light, position, geometricNormal, L, texel);
    return at.covered ? filterShadow(shadowAtlas, at, texel) : 1.0;
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
    return textureLod(dfg, dfgUV(vec2(NoV, perceptualRoughness), textureSize(dfg, 0).x), 0.0).rg;
}

/// Unit, towards the eye.
vec3 viewVector() {
    return view.constants.orthographic != 0u ? -view.constants.cameraForwardWS
                                             : normalize(view.constants.cameraPositionWS - positionWS);
}

SurfacePoint interpolatedPoint() {
    return SurfacePoint(positionWS, normalWS, tangentWS, uv01.xy, uv01.zw, color, gl_FrontFacing);
}

/// The draw's material; lines and points without normals cannot be lit and show their colour.
Material drawnMaterial() {
    Instance instance = instances.list[draw.constants.instance];
    Material material = materials.list[instance.material];
    if ((instance.flags & kInstanceNoNormals) != 0u)
        material.flags |= kMaterialUnlit;
    return material;
}

#endif
