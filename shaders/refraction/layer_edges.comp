// Pixels that are partly covered, and whose centre neither this layer nor one behind it covers: they blend in that
// fraction of their neighbours' layer. Where the layer covers the centre, layer_main.glsl has blended it already; where
// a pixel is fully covered, other layers cover it.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl"
#include "lib/host_surface.glsl"
#include "lib/input_color.glsl"
#include "lib/math.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 2) uniform sampler2D layerDepth;
layout(set = 0, binding = 3) uniform sampler2D layerCoverage;
layout(set = 0, binding = 6) uniform sampler2D layersZ;          // of the layers behind this one
layout(set = 0, binding = 4) uniform sampler2D behind;           // the frame without this layer
layout(set = 0, binding = 5, rgba16f) uniform image2D composite; // the frame with it; pixels read here are not written

#include "refraction/layer_seen.glsl"

const float kSeen = 1.0 / 32.0; // less than one sample of sixteen

float coverageAt(ivec2 px) {
    return saturate(sanitize(texelFetch(layerCoverage, px, 0).r));
}

/// True if the layer covers the pixel's centre.
bool isShown(ivec2 px) {
    return seenLayerZ(px) < kBackgroundZ;
}

vec3 linear(vec3 stored) {
    return linearColor(stored, (frame.constants.flags & kOutputGamma) != 0u);
}

/// The layer alone, with its transmitted light, at a pixel whose centre it covers: undoes the blend.
vec3 layerAt(ivec2 px, float coverage) {
    vec3 mixed = linear(imageLoad(composite, px).rgb);
    return max((mixed - (1.0 - coverage) * linear(texelFetch(behind, px, 0).rgb)) / coverage, vec3(0.0));
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = ivec2(frame.constants.size);
    if (any(greaterThanEqual(px, size)))
        return;
    float coverage = coverageAt(px);
    bool inPart = coverage >= kSeen && coverage <= 1.0 - kSeen;
    if (!inPart || isShown(px) || texelFetch(layersZ, px, 0).r < kBackgroundZ)
        return;
    vec4 sum = vec4(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            ivec2 other = px + ivec2(x, y);
            if (any(lessThan(other, ivec2(0))) || any(greaterThanEqual(other, size)) || !isShown(other))
                continue;
            float share = coverageAt(other);
            if (share >= kSeen)
                sum += share * (x * y == 0 ? 1.0 : 0.5) * vec4(layerAt(other, share), 1.0);
        }
    if (sum.a <= 0.0)
        return;
    vec4 stored = texelFetch(behind, px, 0);
    vec3 result = sanitize(mix(linear(stored.rgb), sum.rgb / sum.a, coverage));
    if ((frame.constants.flags & kOutputGamma) != 0u)
        result = encodeSrgb(result);
    imageStore(composite, px, vec4(result, stored.a));
}
