// Pixels of which a layer covers a part that misses their centre: they blend in that fraction of their neighbours' layer,
// over all that the centre shows of the layers so far. What covers the centre layer_main.glsl has blended already.
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
layout(set = 0, binding = 4) uniform sampler2D behind;           // the frame without this layer
layout(set = 0, binding = 5, rgba16f) uniform image2D composite; // the frame with it; pixels read here are not written

#include "refraction/layer_seen.glsl"

const float kSeen = 1.0 / 32.0; // less than one sample of sixteen

/// Of two surfaces, the one that is nearer by this fraction of its distance is another one.
const float kNearer = 0.005;

/// A pixel of the layer.
struct LayerPixel {
    float viewZ;    // of the layer at the centre; kBackgroundZ: it misses the centre
    float coverage; // of the whole layer
    float missing;  // of its surfaces that miss the centre
};

LayerPixel layerPixel(ivec2 px) {
    vec3 stored = clamp(sanitize(texelFetch(layerCoverage, px, 0).rgb), 0.0, 1.0);
    float z = seenLayerZ(px);
    return LayerPixel(z, stored.r, z < kBackgroundZ ? stored.g : max(stored.r, stored.g));
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
    LayerPixel here = layerPixel(px);
    if (here.missing < kSeen || here.missing > 1.0 - kSeen)
        return;
    vec4 sum = vec4(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            ivec2 other = px + ivec2(x, y);
            if (any(lessThan(other, ivec2(0))) || any(greaterThanEqual(other, size)))
                continue;
            LayerPixel beside = layerPixel(other);
            // Pixels that miss a part are written here, so they cannot be read.
            bool shows = beside.viewZ < here.viewZ * (1.0 - kNearer) && beside.missing < kSeen;
            if (shows && beside.coverage >= kSeen)
                sum += beside.coverage * (x * y == 0 ? 1.0 : 0.5) * vec4(layerAt(other, beside.coverage), 1.0);
        }
    if (sum.a <= 0.0)
        return;
    vec4 stored = imageLoad(composite, px);
    vec3 result = sanitize(mix(linear(stored.rgb), sum.rgb / sum.a, here.missing));
    if ((frame.constants.flags & kOutputGamma) != 0u)
        result = encodeSrgb(result);
    imageStore(composite, px, vec4(result, stored.a));
}
