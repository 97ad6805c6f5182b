// Combines all sources, for passes and hosts that read the reflections alone. Where none does, composite/combined
// combines them itself.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "hierarchy/combined.glsl"
#include "lib/source_weights.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 6, rgba16f) uniform writeonly image2D reflected; // sum of weight * radiance; total weight
layout(set = 0, binding = 7, rg32ui) uniform writeonly uimage2D weights;   // lib/source_weights.glsl; if keepsWeights

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    float shares[kMaxSources];
    Walk walk = combinedAnswers(px, texelFetch(viewZ, px, 0).r, true, shares);
    imageStore(reflected, px, vec4(walk.radiance, walk.taken));
    if (frame.settings.hierarchy.keepsWeights != 0u)
        imageStore(weights, px, uvec4(packSourceWeights(shares), 0u, 0u));
}
