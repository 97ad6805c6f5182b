// Radiance of the host's environment in a direction. The entry point declares the cube.
#ifndef GLINT_HIERARCHY_ENVIRONMENT_RADIANCE_GLSL
#define GLINT_HIERARCHY_ENVIRONMENT_RADIANCE_GLSL

#include "frame/frame_block.glsl"
#include "lib/environment_lobe.glsl"
#include "lib/sanitize.glsl"

vec3 environmentRadiance(samplerCube environment, vec3 directionWS, float perceptualRoughness) {
    vec3 direction = mat3(frame.constants.worldToEnvironment) * directionWS;
    float mip = perceptualRoughness * max(frame.constants.environmentMips - 1.0, 0.0);
    return sanitize(sanitize(textureLod(environment, direction, mip).rgb) * frame.constants.environmentStrength);
}

/// What a surface of at least kSmoothestLobe reflects of it to the eye. `V`: unit, towards the eye.
vec3 environmentLobe(samplerCube environment, vec3 N, vec3 V, float perceptualRoughness) {
    EnvironmentLobe lobe = beginLobe(N, V, perceptualRoughness);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < kLobeLookups; ++i) {
        LobeLookup at = nextLookup(i, lobe);
        sum += at.weight * environmentRadiance(environment, at.direction, at.perceptualRoughness);
    }
    return max(sum, vec3(0.0));
}

#endif
