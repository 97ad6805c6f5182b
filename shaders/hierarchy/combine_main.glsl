// The one rule: sources are asked front to back, each gets only what those before it left, and the walk ends at 1.
// Replace, never add twice. The order is the user's (settings order.*).
#include "hierarchy/source_log.glsl"
#include "lib/camera.glsl"
#include "lib/source_weights.glsl"
#include "lib/surface.glsl"
#include "shared/rays_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
}
frame;
layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 2) uniform usampler2D surface;
layout(set = 0, binding = 3) uniform sampler2D radianceWeight;
layout(set = 0, binding = 4) uniform samplerCube environment;
layout(set = 0, binding = 5, rgba16f) uniform writeonly image2D reflected; // sum of weight * radiance; total weight
layout(set = 0, binding = 6, rg32ui) uniform writeonly uimage2D weights;   // lib/source_weights.glsl
layout(set = 0, binding = 7) uniform sampler2D raysAnswer;
layout(set = 0, binding = 8) uniform usampler2D raysRecord;
layout(set = 0, binding = 9) uniform sampler2D probesAnswer;
layout(set = 0, binding = 10) uniform sampler2D planarAnswer;
layout(push_constant, scalar) uniform PushBlock {
    HierarchyConstants settings;
};

#include "hierarchy/environment_radiance.glsl"

/// What is left of a weight of `wanted` after `taken`.
float takeRest(float wanted, float taken) {
    return clamp(min(wanted, 1.0 - taken), 0.0, 1.0);
}

/// The sky has an answer for everything.
vec4 skyAnswer(ivec2 px, float z) {
    if ((frame.constants.flags & kInputEnvironment) == 0u)
        return vec4(0.0);
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    vec3 toSurfaceVS = viewDirection(frame.constants, viewPosition(frame.constants, uv, z));
    vec3 directionWS = mat3(frame.constants.viewToWorld) * reflect(toSurfaceVS, here.normalVS);
    return vec4(environmentRadiance(environment, directionWS, here.perceptualRoughness), 1.0);
}

/// Of those pixels rays have found something better.
vec4 screenAnswer(ivec2 px) {
    bool replaced = (settings.sources & (1u << kSourceRays)) != 0u &&
                    (texelFetch(raysRecord, px, 0).z & kRaysReplaceScreen) != 0u;
    return replaced ? vec4(0.0) : texelFetch(radianceWeight, px, 0);
}

vec4 sourceAnswer(uint source, ivec2 px, float z) {
    switch (source) {
    case kSourceScreen:
        return screenAnswer(px);
    case kSourceRays:
        return texelFetch(raysAnswer, px, 0);
    case kSourcePlanar:
        return texelFetch(planarAnswer, px, 0);
    case kSourceProbes:
        return texelFetch(probesAnswer, px, 0);
    default:
        return skyAnswer(px, z);
    }
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    float z = texelFetch(viewZ, px, 0).r;
    vec3 sum = vec3(0.0);
    float total = 0.0;
    float shares[kSourceCount] = float[](0.0, 0.0, 0.0, 0.0, 0.0);
    for (uint i = 0u; i < kSourceCount && z < kBackgroundZ && total < 1.0; ++i) {
        uint source = (settings.order >> (4u * i)) & 15u;
        if ((settings.sources & (1u << source)) == 0u)
            continue;
        vec4 answer = sourceAnswer(source, px, z);
        float share = takeRest(answer.a, total);
        shares[source] = share;
        sum += share * answer.rgb;
        total += share;
        logSource(px, i, source, share, answer.rgb);
    }
    imageStore(reflected, px, vec4(sum, total));
    imageStore(weights, px, uvec4(packSourceWeights(shares), 0u, 0u));
}
