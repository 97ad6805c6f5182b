// Steadies the brightness of what is shown: the filter's answer, averaged over frames as far as the pixels around allow.
// Colours and weights stay those of this frame. docs/techniques/rough.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "denoise/cubic.glsl"
#include "denoise/lobe_surface.glsl"
#include "denoise/taken_from.glsl"
#include "lib/color.glsl"
#include "lib/half.glsl"
#include "lib/noise.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 3) uniform sampler2D filtered; // radiance, weight
layout(set = 0, binding = 4) uniform sampler2D meta;     // frames; luminance: mean, mean square; nearness
layout(set = 0, binding = 5) uniform sampler2D takenFrom;
layout(set = 0, binding = 6) uniform sampler2D stableBefore;
layout(set = 0, binding = 7, rg16f) uniform writeonly image2D stable; // luminance of weight * radiance; frames
layout(set = 0, binding = 8, rgba16f) uniform writeonly image2D answer; // radiance, weight
DenoiseConstants settings = frame.settings.denoise;

const int kReach = 2; // pixels around
const int kSide = 8 + 2 * kReach;
const float kNoRay = -1.0;

/// Luminance of weight * radiance; kNoRay where no ray was sent, and outside of the picture.
shared float around[kSide][kSide];

float shownBrightness(vec4 shown) {
    return luminance(shown.rgb) * shown.a;
}

void load() {
    ivec2 corner = ivec2(gl_WorkGroupID.xy) * 8 - kReach;
    for (uint i = gl_LocalInvocationIndex; i < uint(kSide * kSide); i += 64u) {
        ivec2 at = ivec2(i % uint(kSide), i / uint(kSide));
        ivec2 px = corner + at;
        bool sent = isInFrame(px) && texelFetch(meta, px, 0).x > 0.0;
        around[at.y][at.x] = sent ? shownBrightness(texelFetch(filtered, px, 0)) : kNoRay;
    }
    barrier();
}

/// Mean and standard deviation of the pixels around.
vec2 spreadAround() {
    ivec2 first = ivec2(gl_LocalInvocationID.xy);
    vec3 sums = vec3(0.0);
    for (int y = 0; y <= 2 * kReach; ++y)
        for (int x = 0; x <= 2 * kReach; ++x) {
            float there = around[first.y + y][first.x + x];
            if (there >= 0.0)
                sums += vec3(there, there * there, 1.0);
        }
    vec2 means = sums.xy / sums.z; // the pixel itself is one of them
    return vec2(means.x, sqrt(max(means.y - square(means.x), 0.0)));
}

/// Brightness that was shown at `at` of the previous frame, and the fewest frames that any of the four nearest texels
/// holds.
vec2 stableAt(vec2 at) {
    vec2 corner = floor(at - 0.5);
    vec2 share = at - 0.5 - corner;
    vec4 wx = cubicWeights(share.x);
    vec4 wy = cubicWeights(share.y);
    float sum = 0.0;
    float frames = 1e4;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            ivec2 texel = clamp(floorToInt(corner) + ivec2(x, y) - 1, ivec2(0), ivec2(frame.constants.prevSize) - 1);
            vec2 there = texelFetch(stableBefore, texel, 0).rg;
            sum += wx[x] * wy[y] * there.x;
            bool near = x > 0 && x < 3 && y > 0 && y < 3;
            frames = near ? min(frames, there.y) : frames;
        }
    return vec2(sum, frames);
}

void main() {
    load();
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (!isInFrame(px))
        return;
    vec4 shown = texelFetch(filtered, px, 0);
    float now = around[gl_LocalInvocationID.y + kReach][gl_LocalInvocationID.x + kReach];
    if (now < 0.0) {
        imageStore(stable, px, vec4(0.0));
        imageStore(answer, px, shown);
        return;
    }
    float steadied = now;
    float frames = 0.0;
    vec2 from = texelFetch(takenFrom, px, 0).rg;
    if (hasPlace(from)) {
        vec2 before = stableAt(vec2(px) + 0.5 + from);
        // A mean that has just begun, or that changed light has shortened, is no reason to keep what was shown before.
        float most = settings.stableFrames * saturate(texelFetch(meta, px, 0).x / settings.historyFrames);
        frames = min(before.y, most);
        vec2 spread = spreadAround();
        // The pixel itself widens it: a line as thin as a pixel lies outside of what its surroundings have.
        float allowed = clamp(before.x, min(spread.x - spread.y, now), max(spread.x + spread.y, now));
        steadied = mix(allowed, now, 1.0 / (1.0 + frames));
    }
    float noise = hashNoise(uvec2(px), frame.constants.frameIndex, frame.constants.seed).x;
    imageStore(stable, px, roundToHalf(vec4(steadied, frames + 1.0, 0.0, 0.0), noise));
    if (now > 0.0 && steadied != now) // mirrors keep their bits: a GPU's quotient of equal numbers may be a little below 1
        shown.rgb *= steadied / now;
    imageStore(answer, px, shown);
}
