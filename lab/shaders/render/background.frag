// The environment and its suns' discs, where no surface is drawn.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/environment.glsl"
#include "lib/math.glsl"
#include "render/background_ray.glsl"

layout(set = 0, binding = 1) uniform samplerCube environmentRadiance;

layout(location = 0) out vec4 outLitRadiance;

vec3 backgroundRadiance(vec3 directionWS) {
    if (view.constants.environmentVisible == 0u)
        return vec3(0.0);
    vec3 turned = rotateToEnvironment(directionWS, view.constants.environmentRotation);
    vec3 radiance = textureLod(environmentRadiance, turned, 0.0).rgb * view.constants.environmentStrength;
    for (uint i = 0u; i < kMaxSuns; ++i)
        if (dot(directionWS, view.constants.suns[i].directionWS) > view.constants.suns[i].cosRadius)
            radiance += view.constants.suns[i].radiance;
    return min(radiance, vec3(65000.0)); // the largest half is 65504
}

void main() {
    vec3 radiance = backgroundRadiance(viewRay());
    outLitRadiance = vec4(radiance, meanComponent(radiance)); // no highlight
}
