// Finds where the object that a pixel shows ends behind, in metres along the view axis.
// The host's image has a size of its own and holds the nearest back face at one point of each texel. The surface at
// that point need not be the pixel's: beside a silhouette it is the background, whose back face would make the object
// endless. So a texel counts for a pixel only if the pixel's surface lies between the front and the back that are known
// at the texel's point. Otherwise the nearest back of the texels around it counts; where none counts, the back is
// unknown.
//
// Not run for the picture's surfaces where the host's image has one texel a pixel, at its centre: the passes that ask
// read that image itself then (kTraceBackInPlace).
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl"
#include "lib/back_face.glsl"
#include "lib/edge.glsl"
#include "lib/packed_coverage.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D backDepth; // of any size
layout(set = 0, binding = 2, r32f) uniform writeonly image2D backViewZ;
layout(set = 0, binding = 3) uniform sampler2D viewZ;
layout(set = 0, binding = 4) uniform sampler2D resolvedMaterial;
layout(set = 0, binding = 5) uniform usampler2D edge;

/// A step of depth from one pixel to the next that counts as an edge, as a fraction of the depth.
const float kStep = 0.05;

/// True if every surface that pixel `px` shows belongs to one object. The pixel's surface is at `frontZ`. With several
/// samples a pixel, the pixel's centre, where the back face was drawn, may show another surface than the selected one.
bool showsOneObject(ivec2 px, float frontZ) {
    if ((frame.constants.flags & kInputResolved) == 0u)
        return true; // one sample a pixel
    float coverage = unpackCoverage(frame.constants, texelFetch(resolvedMaterial, px, 0).a).x;
    if (coverage >= 1.0)
        return true;
    Edge second = unpackEdge(texelFetch(edge, px, 0));
    return coverage + second.coverage > 0.999 && abs(second.viewZ - frontZ) <= kStep * frontZ;
}

/// The part of the host's image that this frame uses: the same fraction as of the frame's images, rounded up.
ivec2 backExtent() {
    ivec2 whole = textureSize(viewZ, 0);
    return (textureSize(backDepth, 0) * ivec2(frame.constants.size) + whole - 1) / whole;
}

/// As the host's image has it: kBackgroundZ if the surface at `z` is open.
float backOfTexel(ivec2 texel, float z) {
    return backViewZOf(frame.constants, texelFetch(backDepth, texel, 0).r, z);
}

const float kSilent = -1.0;

/// viewZ of the back of a surface at `z`, as the host's image has it at `texel`: kBackgroundZ if that surface is open,
/// kSilent if the texel shows another surface.
float backAt(ivec2 texel, float z) {
    // The pixels that touch the point where the back face was drawn: one, or up to four where the point lies on their
    // borders.
    const float kTouches = 0.49;
    vec2 pointPX = (vec2(texel) + 0.5) / vec2(backExtent()) * frame.constants.size;
    ivec2 last = ivec2(frame.constants.size) - 1;
    ivec2 low = clamp(ivec2(floor(pointPX - kTouches)), ivec2(0), last);
    ivec2 high = clamp(ivec2(floor(pointPX + kTouches)), ivec2(0), last);
    float nearest = kBackgroundZ;
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) {
            float frontZ = texelFetch(viewZ, ivec2(x, y), 0).r;
            if (frontZ > z * (1.0 + kStep) || !showsOneObject(ivec2(x, y), frontZ))
                return kSilent;
            nearest = min(nearest, frontZ);
        }
    float back = backOfTexel(texel, z);
    if (back < kBackgroundZ)
        return back;
    return nearest >= z * (1.0 - kStep) ? kBackgroundZ : kSilent;
}

float backOfPixel(ivec2 px, float z) {
    ivec2 size = backExtent();
    bool oneSample = (frame.constants.flags & kInputSamples) == 0u;
    if (oneSample && size == ivec2(frame.constants.size))
        return backOfTexel(px, z); // the texel's point is the pixel's centre
    ivec2 own = min(ivec2((vec2(px) + 0.5) * frame.constants.invSize * vec2(size)), size - 1);
    float back = backAt(own, z);
    if (back != kSilent)
        return back;
    back = kBackgroundZ;
    for (int i = 0; i < 9; ++i) {
        ivec2 texel = own + ivec2(i % 3, i / 3) - 1;
        bool inside = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, size));
        float other = inside ? backAt(texel, z) : kSilent;
        if (other != kSilent)
            back = min(back, other);
    }
    return back;
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    float z = texelFetch(viewZ, px, 0).r;
    float back = z < kBackgroundZ ? backOfPixel(px, z) : kBackgroundZ;
    imageStore(backViewZ, px, vec4(storedViewZ(frame.constants, back)));
}
