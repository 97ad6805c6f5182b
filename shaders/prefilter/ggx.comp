// One mip of the radiance cube: the environment as a GGX lobe of that mip's roughness sees it head-on. Karis 2013,
// "Real Shading in Unreal Engine 4" (N = V = R), by filtered importance sampling: Krivanek, Colbert 2008, "Real-time
// Shading with Filtered Importance Sampling". Each sample reads the source at the mip whose texels are as large as the
// sample's part of the lobe, so a small sun causes no fireflies.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/brdf.glsl"
#include "lib/environment.glsl"
#include "lib/sampling.glsl"
#include "shared/environment.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform samplerCube source;
layout(set = 0, binding = 1, rgba16f) uniform writeonly image2DArray filtered;
layout(push_constant, scalar) uniform PushBlock {
    PrefilterConstants constants;
};

void main() {
    uvec3 texel = gl_GlobalInvocationID;
    if (texel.x >= constants.faceSize || texel.y >= constants.faceSize)
        return;
    vec2 p = (vec2(texel.xy) + 0.5) / float(constants.faceSize) * 2.0 - 1.0;
    vec3 N = normalize(cubeDirection(texel.z, p));
    mat3 tangentToWorld = orthonormalBasis(N);
    float alpha = square(constants.perceptualRoughness);
    float texelSolidAngle = 4.0 * kPi / (6.0 * square(constants.sourceFaceSize));

    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (uint i = 0u; i < constants.sampleCount; ++i) {
        vec3 H = sampleGGX(hammersley(i, constants.sampleCount), alpha); // V = N = +Z
        float NoL = 2.0 * H.z * H.z - 1.0;
        if (NoL <= 0.0)
            continue;
        vec3 L = vec3(2.0 * H.z * H.xy, NoL);
        float pdf = D_GGX(H.z, alpha) * 0.25; // D NoH / (4 VoH), and VoH = NoH here
        float sampleSolidAngle = 1.0 / (float(constants.sampleCount) * pdf);
        float mip = max(0.5 * log2(sampleSolidAngle / texelSolidAngle) + 1.0, 0.0); // + 1: neighbours overlap
        sum += textureLod(source, tangentToWorld * L, mip) * NoL;
        weights += NoL;
    }
    imageStore(filtered, ivec3(texel), sum / weights);
}
