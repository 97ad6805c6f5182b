// Decides for each tile of pixels how many of its rough pixels send a ray in the next frame (reuse.rate adaptive): all
// while histories are short or much noise is left, half while there is noise, a quarter where wide lobes have settled.
// docs/techniques/rough.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/prepared.glsl"
#include "generate/lobe.glsl"
#include "lib/surface.glsl"
#include "shared/denoise_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 3) uniform sampler2D meta; // frames; luminance: mean, mean square; nearness
layout(set = 0, binding = 4, r8) uniform writeonly image2D rates;
DenoiseConstants settings = frame.settings.denoise;

void main() {
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tile * int(kRateTile), ivec2(frame.constants.size))))
        return;
    // 4 x 4 samples, out to one pixel of each neighbour tile, since the image may move before the next frame.
    const int kAcross = 4;
    const int kStep = 3;
    const float kYoungFrames = 4.0;
    const float kWideLobePixels = 8.0;
    const float kMuchNoise = 2.0; // of the target
    float rough = 0.0;
    float young = 0.0;
    float noise = 0.0; // standard deviations of the mean, as fractions of it
    float narrowest = 1e4;
    for (int i = 0; i < kAcross * kAcross; ++i) {
        ivec2 offset = ivec2(i % kAcross, i / kAcross) * kStep - 1;
        ivec2 px = clamp(tile * int(kRateTile) + offset, ivec2(0), ivec2(frame.constants.size) - 1);
        vec4 moments = texelFetch(meta, px, 0);
        if (moments.x == 0.0 && moments.w == 0.0)
            continue; // does not reflect
        float perceptualRoughness = unpackSurface(texelFetch(surface, px, 0).xy).perceptualRoughness;
        float z = texelFetch(viewZ, px, 0).r;
        if (isMirror(perceptualRoughness))
            continue;
        rough += 1.0;
        young += moments.x < kYoungFrames ? 1.0 : 0.0;
        float variance = max(moments.z - square(moments.y), 0.0) / max(moments.x, 1.0);
        noise += sqrt(variance) / (moments.y + 0.01);
        narrowest = min(narrowest, lobePixels(perceptualRoughness, z, moments.w));
    }
    float share = 0.5;
    if (young > 0.125 * rough || noise > kMuchNoise * settings.noiseTarget * rough)
        share = 1.0;
    else if (noise <= settings.noiseTarget * rough && narrowest > kWideLobePixels)
        share = 0.25;
    imageStore(rates, tile, vec4(share));
}
