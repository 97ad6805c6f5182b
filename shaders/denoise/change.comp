// Finds, for each tile of pixels of the previous frame, how much of its history is the light of the past: by what the
// sentinels saw change around it, and by where the mean over few frames has gone from the one over many.
// docs/techniques/rough.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl"
#include "lib/math.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D change; // of a tile: denoise/sentinels.comp
layout(set = 0, binding = 2) uniform sampler2D metaBefore; // frames; luminance: mean, mean square; nearness
layout(set = 0, binding = 3) uniform sampler2D fastBefore; // luminance: mean over few frames
/// Share of the light that changed, [0, 1]; how surely the long mean lags behind the short one, [0, 1]; the short mean as
/// a multiple of the long one.
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D changed;

/// Share of the light that sentinels saw change around the tile.
float changeAround(ivec2 tile) {
    const int kReach = 3;
    // Those that the frame wrote; without sentinels a black texel.
    ivec2 size = min(textureSize(change, 0),
                     (ivec2(frame.constants.size) + int(kSentinelTile) - 1) / int(kSentinelTile));
    vec3 sum = vec3(0.0);
    for (int y = -kReach; y <= kReach; ++y) {
        for (int x = -kReach; x <= kReach; ++x) {
            ivec2 at = tile + ivec2(x, y);
            if (all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, size)))
                sum += exp(-0.25 * float(x * x + y * y)) * texelFetch(change, at, 0).rgb;
        }
    }
    if (sum.x <= 0.0)
        return 0.0;
    // Light that changes goes one way. A picture with noise, or whose details lie between other pixels now, goes both.
    float oneWay = smoothstep(0.5, 0.8, abs(sum.z) / sum.x);
    return min(sum.x / sum.y, 1.0) * oneWay;
}

/// Compares both means over a region. Noise cancels there and so does the picture, which is in both; a change of light
/// does not.
vec2 lagAround(ivec2 tile) {
    const int kReach = 2;
    const int kStep = 4;                // pixels: neighbours nearer than that share rays
    const float kIndependent = 14.0 / 25.0; // of the taps
    float sum = 0.0;
    float squares = 0.0;
    float slow = 0.0;
    float count = 0.0;
    for (int y = -kReach; y <= kReach; ++y) {
        for (int x = -kReach; x <= kReach; ++x) {
            ivec2 px = tile * int(kSentinelTile) + int(kSentinelTile) / 2 + ivec2(x, y) * kStep;
            if (any(lessThan(px, ivec2(0))) || any(greaterThanEqual(px, ivec2(frame.constants.prevSize))))
                continue;
            vec4 moments = texelFetch(metaBefore, px, 0);
            if (moments.x < frame.settings.denoise.fastFrames + 2.0)
                continue; // both means are nearly the same
            float apart = texelFetch(fastBefore, px, 0).r - moments.y;
            sum += apart;
            squares += square(apart);
            slow += moments.y;
            count += 1.0;
        }
    }
    if (count < 9.0 || slow <= 0.0)
        return vec2(0.0, 1.0);
    float mean = sum / count;
    float variance = max(squares / count - square(mean), 0.0);
    float deviation = sqrt(variance / (count * kIndependent)) + 1e-3 * slow / count;
    const float kSure = 4.0;
    return vec2(saturate((abs(mean) / deviation - kSure) / 2.0), clamp(1.0 + sum / slow, 0.0, 16.0));
}

void main() {
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tile * int(kSentinelTile), ivec2(frame.constants.prevSize))))
        return;
    vec2 lag = frame.settings.denoise.comparesMeans != 0u ? lagAround(tile) : vec2(0.0, 1.0);
    imageStore(changed, tile, vec4(changeAround(tile), lag, 0.0));
}
