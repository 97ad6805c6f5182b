// Visibility of each light from the shadow maps: lights.shadows maps.
#ifndef GLINT_RENDER_SHADOW_MAPS_GLSL
#define GLINT_RENDER_SHADOW_MAPS_GLSL

#include "lib/shadow.glsl"

layout(set = 0, binding = 9) uniform sampler2DShadow shadowAtlas;

void beginLighting() {}

float loadLightVisibility(Light light, vec3 position, vec3 geometricNormal, vec3 L) {
    vec2 texel = 1.0 / vec2(textureSize(shadowAtlas, 0));
    ShadowLookup at = shadowLookup(light, position, geometricNormal, L, texel);
    return at.covered ? filterShadow(shadowAtlas, at, texel) : 1.0;
}

#endif
