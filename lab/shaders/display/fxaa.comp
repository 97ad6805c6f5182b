// This work is based on:
// Timothy Lottes. FXAA. NVIDIA white paper, 2009
// Smooths edges of the final image. Finds edges by the contrast of displayed luma (after tone map and sRGB curve),
// follows each edge to its ends, and moves every pixel's sample across the edge by the slope that the pixel's place
// along the edge implies.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/math.glsl"
#include "shared/display.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D aliased; // sRGB-encoded
layout(set = 0, binding = 1, rgba8) uniform writeonly image2D display;
layout(push_constant, scalar) uniform PushBlock {
    FxaaConstants constants;
};

// The white paper's constants for high quality.
const float kEdgeThreshold = 1.0 / 8.0;     // of the largest luma around: lower contrast is no edge
const float kEdgeThresholdMin = 1.0 / 24.0; // in dark regions, lower contrast is invisible
const float kSubpixelTrim = 1.0 / 4.0;      // features below this fraction of the contrast are kept
const float kSubpixelCap = 3.0 / 4.0;       // most of a thin feature that is smoothed away
// Length of each step of the search along the edge, pixels. Long edges are followed with less precision.
const int kSteps = 12;
const float kStrides[kSteps] = float[](1.0, 1.0, 1.0, 1.0, 1.0, 1.5, 2.0, 2.0, 2.0, 2.0, 4.0, 8.0);

float luma(vec3 color) {
    return dot(color, vec3(0.299, 0.587, 0.114)); // Rec. 601, for encoded colours
}

float lumaAt(ivec2 px) {
    return luma(texelFetch(aliased, clamp(px, ivec2(0), ivec2(constants.size) - 1), 0).rgb);
}

float lumaBetween(vec2 uv) {
    return luma(textureLod(aliased, uv, 0.0).rgb);
}

/// Luma around the pixel: [row][column], rows from the top.
struct Neighbourhood {
    float l[3][3];
};

Neighbourhood neighbourhood(ivec2 px) {
    Neighbourhood n;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x)
            n.l[y][x] = lumaAt(px + ivec2(x - 1, y - 1));
    return n;
}

/// Amount of a feature thinner than a pixel, [0, kSubpixelCap].
float subpixelShare(Neighbourhood n, float range) {
    float cross_ = n.l[0][1] + n.l[2][1] + n.l[1][0] + n.l[1][2];
    float corners = n.l[0][0] + n.l[0][2] + n.l[2][0] + n.l[2][2];
    float away = abs((2.0 * cross_ + corners) / 12.0 - n.l[1][1]) / range;
    float share = saturate((away - kSubpixelTrim) / (1.0 - kSubpixelTrim));
    return share * share * (3.0 - 2.0 * share) * kSubpixelCap;
}

bool isHorizontal(Neighbourhood n) {
    float acrossRows = abs(n.l[0][0] - 2.0 * n.l[1][0] + n.l[2][0]) + 2.0 * abs(n.l[0][1] - 2.0 * n.l[1][1] + n.l[2][1]) +
                       abs(n.l[0][2] - 2.0 * n.l[1][2] + n.l[2][2]);
    float acrossColumns = abs(n.l[0][0] - 2.0 * n.l[0][1] + n.l[0][2]) +
                          2.0 * abs(n.l[1][0] - 2.0 * n.l[1][1] + n.l[1][2]) +
                          abs(n.l[2][0] - 2.0 * n.l[2][1] + n.l[2][2]);
    return acrossRows >= acrossColumns;
}

/// Where an edge ends, in one direction.
struct EdgeEnd {
    float distance; // pixels
    float change;   // luma there minus the edge's own luma
};

EdgeEnd followEdge(vec2 uv, vec2 direction, float edgeLuma, float enough) {
    EdgeEnd end = EdgeEnd(0.0, 0.0);
    for (int i = 0; i < kSteps; ++i) {
        end.distance += kStrides[i];
        end.change = lumaBetween(uv + direction * end.distance) - edgeLuma;
        if (abs(end.change) >= enough)
            break;
    }
    return end;
}

/// Offset of the pixel's sample across its edge, pixels: half a pixel at the edge's end, none in its middle.
float edgeOffset(vec2 uv, Neighbourhood n, bool horizontal, float side, float sideLuma, float gradient) {
    vec2 texel = 1.0 / vec2(constants.size);
    vec2 along = horizontal ? vec2(texel.x, 0.0) : vec2(0.0, texel.y);
    vec2 across = horizontal ? vec2(0.0, texel.y) : vec2(texel.x, 0.0);
    float middle = n.l[1][1];
    float edgeLuma = 0.5 * (middle + sideLuma);
    vec2 onEdge = uv + across * (0.5 * side); // between the two rows, where the filter averages them
    EdgeEnd back = followEdge(onEdge, -along, edgeLuma, 0.25 * gradient);
    EdgeEnd forth = followEdge(onEdge, along, edgeLuma, 0.25 * gradient);
    bool backIsNearer = back.distance < forth.distance;
    float change = backIsNearer ? back.change : forth.change;
    if ((change < 0.0) == (middle < edgeLuma)) // the edge steps away from this pixel: the other row's pixel smooths it
        return 0.0;
    return 0.5 - min(back.distance, forth.distance) / (back.distance + forth.distance);
}

vec3 smoothed(ivec2 px, Neighbourhood n, float range) {
    bool horizontal = isHorizontal(n);
    float before = horizontal ? n.l[0][1] : n.l[1][0];
    float after = horizontal ? n.l[2][1] : n.l[1][2];
    float beforeGradient = abs(before - n.l[1][1]);
    float afterGradient = abs(after - n.l[1][1]);
    float side = beforeGradient >= afterGradient ? -1.0 : 1.0; // the edge runs on this side of the pixel
    vec2 uv = (vec2(px) + 0.5) / vec2(constants.size);
    float offset = edgeOffset(uv, n, horizontal, side, side < 0.0 ? before : after, max(beforeGradient, afterGradient));
    offset = max(offset, subpixelShare(n, range));
    vec2 shift = (horizontal ? vec2(0.0, 1.0) : vec2(1.0, 0.0)) * (side * offset);
    return textureLod(aliased, uv + shift / vec2(constants.size), 0.0).rgb;
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(constants.size))))
        return;
    vec3 color = texelFetch(aliased, px, 0).rgb;
    Neighbourhood n = neighbourhood(px);
    float lowest = min(n.l[1][1], min(min(n.l[0][1], n.l[2][1]), min(n.l[1][0], n.l[1][2])));
    float highest = max(n.l[1][1], max(max(n.l[0][1], n.l[2][1]), max(n.l[1][0], n.l[1][2])));
    float range = highest - lowest;
    if (range >= max(kEdgeThresholdMin, highest * kEdgeThreshold))
        color = smoothed(px, n, range);
    imageStore(display, px, vec4(color, 1.0));
}
