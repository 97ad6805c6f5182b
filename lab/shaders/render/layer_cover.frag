// Counts the samples that show a layer, and among them those that show surfaces in front of the layer's own one: they
// miss the pixel's centre, otherwise they would be the layer there.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "render/transparent_present.glsl"

layout(set = 0, binding = 10) uniform sampler2D nearerLayer; // reversed depth of the layer before
layout(set = 0, binding = 11) uniform sampler2D thisLayer;

/// True if there is a layer before.
layout(constant_id = 1) const bool kBehindAnother = false;

/// Added up: a sample is counted once, because the image holds no value above 1.
layout(location = 0) out vec4 outCovered;

/// How far the depth of one surface may differ at the pixel's centre, where another of its triangles may be: by its own
/// slope over two pixels, and in creases by half a percent of its distance.
float depthSlack(float depth) {
    return 2.0 * fwidth(depth) + 0.005 * depth;
}

void main() {
    float depth = gl_FragCoord.z;
    float slack = depthSlack(depth);
    if (!isTransparentPresent())
        discard;
    ivec2 px = ivec2(gl_FragCoord.xy);
    float layer = texelFetch(thisLayer, px, 0).r;
    if (kBehindAnother) {
        float nearer = texelFetch(nearerLayer, px, 0).r;
        bool behind = depth < (layer > 0.0 ? max(nearer - slack, 0.5 * (nearer + layer)) : nearer - slack);
        if (!behind)
            discard;
    }
    if (depth < layer - slack)
        discard;
    outCovered = vec4(1.0, depth > layer + slack || layer == 0.0 ? 1.0 : 0.0, 0.0, 0.0);
}
