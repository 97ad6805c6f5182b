// The next mip of a mirror's image. Beyond the border nothing is known, and nothing counts.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "lib/lobe_mips.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0, rgba16f) uniform image2D finer; // only read
layout(set = 0, binding = 1, rgba16f) uniform writeonly image2D coarser;

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(coarser);
    if (any(greaterThanEqual(px, size)))
        return;
    ivec2 finerSize = imageSize(finer);
    vec2 center = (vec2(px) + 0.5) * vec2(finerSize) / vec2(size);
    ivec2 first = ivec2(floor(center - 0.5 * float(kLobeMipSide) + 0.5));
    vec4 sum = vec4(0.0);
    float total = 0.0;
    for (int y = 0; y < kLobeMipSide; ++y)
        for (int x = 0; x < kLobeMipSide; ++x) {
            ivec2 texel = first + ivec2(x, y);
            if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, finerSize)))
                continue;
            vec2 along = vec2(texel) + 0.5 - center;
            float share = lobeMipWeight(along.x) * lobeMipWeight(along.y);
            sum += share * imageLoad(finer, texel);
            total += share;
        }
    imageStore(coarser, px, sum / total);
}
