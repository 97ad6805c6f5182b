// Radiance of the host's environment in a direction. The entry point declares the cube.
#ifndef GLINT_HIERARCHY_ENVIRONMENT_RADIANCE_GLSL
#define GLINT_HIERARCHY_ENVIRONMENT_RADIANCE_GLSL

#include "frame/frame_block.glsl"
#include "lib/sanitize.glsl"

vec3 environmentRadiance(samplerCube environment, vec3 directionWS, float perceptualRoughness) {
    vec3 direction = mat3(frame.constants.worldToEnvironment) * directionWS;
    float mip = perceptualRoughness * max(frame.constants.environmentMips - 1.0, 0.0);
    return sanitize(sanitize(textureLod(environment, direction, mip).rgb) * frame.constants.environmentStrength);
}

#endif
