// The next mip of the images of resolve/lobe_take.comp. What lies beyond the border counts as texels without a ray.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/lobe_mips.glsl"
#include "shared/trace_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0, rgba16f) uniform image2D finerLights; // only read, like finerPlaces
layout(set = 0, binding = 1, rgba16f) uniform image2D finerPlaces;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D lights;
layout(set = 0, binding = 3, rgba16f) uniform writeonly image2D places;
layout(scalar, set = 0, binding = 11) readonly buffer RaysBlock {
    RayListHeader header;
}
rayList;

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(lights);
    if (any(greaterThanEqual(px, size)) || rayList.header.pictureGroups[0] == 0u)
        return;
    ivec2 finerSize = imageSize(finerLights);
    vec2 center = (vec2(px) + 0.5) * vec2(finerSize) / vec2(size); // sizes need not be even
    ivec2 first = ivec2(floor(center - 0.5 * float(kLobeMipSide) + 0.5));
    vec4 light = vec4(0.0);
    vec4 place = vec4(0.0);
    float total = 0.0;
    for (int y = 0; y < kLobeMipSide; ++y)
        for (int x = 0; x < kLobeMipSide; ++x) {
            ivec2 texel = first + ivec2(x, y);
            vec2 along = vec2(texel) + 0.5 - center;
            float share = lobeMipWeight(along.x) * lobeMipWeight(along.y);
            total += share;
            if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, finerSize)))
                continue;
            light += share * imageLoad(finerLights, texel);
            place += share * imageLoad(finerPlaces, texel);
        }
    imageStore(lights, px, light / total);
    imageStore(places, px, place / total);
}
