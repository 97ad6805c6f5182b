// The next mip of the images of resolve/lobe_take.comp, each of half the size. What lies beyond the traced pixels counts as
// texels without a ray, and the texels there, which filters reach, are 0: images of any size give the same means.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/lobe_mips.glsl"
#include "shared/lobe_mean.h"
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
layout(push_constant, scalar) uniform PushBlock {
    LobeShrinkConstants mip;
};

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, imageSize(lights))) || rayList.header.pictureGroups[0] == 0u)
        return;
    vec2 center = 2.0 * (vec2(px) + 0.5);
    ivec2 first = 2 * px + 1 - kLobeMipSide / 2;
    vec4 light = vec4(0.0);
    vec4 place = vec4(0.0);
    bool isUsed = all(lessThan(px, ivec2(mip.used)));
    for (int y = 0; y < kLobeMipSide && isUsed; ++y)
        for (int x = 0; x < kLobeMipSide; ++x) {
            ivec2 texel = first + ivec2(x, y);
            if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(mip.finerUsed))))
                continue;
            vec2 along = vec2(texel) + 0.5 - center;
            float share = lobeMipWeight(along.x) * lobeMipWeight(along.y);
            light += share * imageLoad(finerLights, texel);
            place += share * imageLoad(finerPlaces, texel);
        }
    imageStore(lights, px, light);
    imageStore(places, px, place);
}
