// The picture that cones of rough surfaces read (trace/cone.glsl): the radiance that hits take, averaged over 2, 4, ...
// 64 pixels a side. Each group reduces one tile to all of the levels.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/prepared.glsl"
#include "lib/history.glsl"
#include "lib/input_color.glsl"
#include "lib/surface.glsl"
#include "shared/trace_constants.h"

layout(local_size_x = 16, local_size_y = 16) in;

layout(set = 0, binding = 3) uniform sampler2D litRadiance;
layout(set = 0, binding = 6) uniform sampler2D prevColor;
layout(set = 0, binding = 7) uniform sampler2D prevViewZ;
layout(set = 0, binding = 20, rgba16f) uniform writeonly image2D level1; // level n averages 2^n pixels a side
layout(set = 0, binding = 21, rgba16f) uniform writeonly image2D level2;
layout(set = 0, binding = 22, rgba16f) uniform writeonly image2D level3;
layout(set = 0, binding = 23, rgba16f) uniform writeonly image2D level4;
layout(set = 0, binding = 24, rgba16f) uniform writeonly image2D level5;
layout(set = 0, binding = 25, rgba16f) uniform writeonly image2D level6;

#include "trace/shown_radiance.glsl"

const int kThreads = int(kPictureTile) / 4; // a side; each reduces 4 x 4 pixels
shared vec4 means[kThreads * kThreads];

/// Radiance and 1 / viewZ, 0 for the background. Beside the picture: what its border shows.
vec4 shownAt(ivec2 px) {
    if (hasHistory(frame.constants)) {
        px = min(px, ivec2(frame.constants.prevSize) - 1);
        return vec4(linearColor(texelFetch(prevColor, px, 0).rgb, (frame.constants.flags & kHistoryGamma) != 0u),
                    1.0 / texelFetch(prevViewZ, px, 0).r);
    }
    px = min(px, ivec2(frame.constants.size) - 1);
    bool apart = (frame.constants.flags & kInputHighlights) != 0u; // else the roughness says nothing
    float roughness = apart ? unpackSurface(texelFetch(surface, px, 0).xy).perceptualRoughness : 1.0;
    return vec4(shownRadiance(px, roughness), 1.0 / texelFetch(viewZ, px, 0).r);
}

void store(int level, ivec2 at, vec4 mean) {
    switch (level) {
    case 1: imageStore(level1, at, mean); break;
    case 2: imageStore(level2, at, mean); break;
    case 3: imageStore(level3, at, mean); break;
    case 4: imageStore(level4, at, mean); break;
    case 5: imageStore(level5, at, mean); break;
    case 6: imageStore(level6, at, mean); break;
    }
}

/// Level 2's texel of this thread.
vec4 reducePixels(ivec2 at) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 texel = 2 * at + ivec2(i & 1, i >> 1);
        vec4 four = vec4(0.0);
        for (int k = 0; k < 4; ++k)
            four += shownAt(2 * texel + ivec2(k & 1, k >> 1));
        store(1, texel, 0.25 * four);
        sum += 0.25 * four;
    }
    return 0.25 * sum;
}

void main() {
    ivec2 thread = ivec2(gl_LocalInvocationID.xy);
    ivec2 tile = ivec2(gl_WorkGroupID.xy);
    vec4 mean = reducePixels(tile * kThreads + thread);
    store(2, tile * kThreads + thread, mean);
    means[thread.y * kThreads + thread.x] = mean;
    barrier();
    int across = kThreads;
    for (int level = 3; level <= int(kPictureLevels); ++level) {
        int above = across / 2;
        bool works = all(lessThan(thread, ivec2(above)));
        if (works) {
            ivec2 low = 2 * thread;
            mean = 0.25 * (means[low.y * across + low.x] + means[low.y * across + low.x + 1] +
                           means[(low.y + 1) * across + low.x] + means[(low.y + 1) * across + low.x + 1]);
            store(level, tile * above + thread, mean);
        }
        barrier();
        if (works)
            means[thread.y * above + thread.x] = mean;
        barrier();
        across = above;
    }
}
