// Combines all sources under the one rule (hierarchy/walk.glsl), in the user's order (settings order.*).
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/prepared.glsl"
#include "generate/pixel_ray.glsl"
#include "hierarchy/answers.glsl"
#include "hierarchy/source_log.glsl"
#include "lib/camera.glsl"
#include "lib/source_weights.glsl"
#include "lib/surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 4) uniform samplerCube environment;
layout(set = 0, binding = 6, rgba16f) uniform writeonly image2D reflected; // sum of weight * radiance; total weight
layout(set = 0, binding = 7, rg32ui) uniform writeonly uimage2D weights;   // lib/source_weights.glsl
HierarchyConstants settings = frame.settings.hierarchy;

#include "hierarchy/environment_radiance.glsl"

/// The sky answers every direction.
vec4 skyAnswer(ivec2 px, float z) {
    if ((frame.constants.flags & kInputEnvironment) == 0u)
        return vec4(0.0);
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    PixelRay ray = generateRay(uv, z, here);
    return vec4(environmentRadiance(environment, directionWS(ray), ray.roughnessLeft), 1.0);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    float z = texelFetch(viewZ, px, 0).r;
    Walk walk = beginWalk();
    float shares[kMaxSources] = float[](0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    for (uint i = 0u; i < kMaxSources && z < kBackgroundZ && walk.taken < 1.0; ++i) {
        uint source = (settings.order >> (4u * i)) & 15u;
        if ((settings.sources & (1u << source)) == 0u)
            continue;
        vec4 answer = source == kSourceSky ? skyAnswer(px, z) : loadAnswer(source, settings.sources, px);
        shares[source] = take(walk, answer);
        logSource(px, i, source, shares[source], answer.rgb);
    }
    imageStore(reflected, px, vec4(walk.radiance, walk.taken));
    imageStore(weights, px, uvec4(packSourceWeights(shares), 0u, 0u));
}
