// Hosts with several samples a pixel: the light of an edge's pixel is the mean of its surfaces, but a ray meets one of
// them, whose depth and normal the pixel has. The pixels beside it tell that surface's own light. Include after
// `metViewZ` and `metSurface`.
#ifndef GLINT_TRACE_ONE_SURFACE_GLSL
#define GLINT_TRACE_ONE_SURFACE_GLSL

#include "lib/camera.glsl"
#include "lib/math.glsl"
#include "lib/packed_coverage.glsl"
#include "lib/surface.glsl"

layout(set = 0, binding = 45) uniform sampler2D hitMaterial; // F0; coverage of the pixel by its surface

bool showsOneSurface(ivec2 px) {
    bool mayShowMore = (frame.constants.flags & kInputSamples) != 0u && !kAmongTransparents;
    return !mayShowMore || unpackCoverage(frame.constants, texelFetch(hitMaterial, px, 0).a).x >= 1.0;
}

struct ShownPoint {
    float viewZ;
    vec3 positionVS;
    vec3 normalVS;
};

ShownPoint shownPoint(ivec2 px) {
    float z = texelFetch(metViewZ, px, 0).r;
    return ShownPoint(z, viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z),
                      unpackSurface(texelFetch(metSurface, px, 0).xy).normalVS);
}

/// How far `b` lies off the surface of `a`, in metres, if that is a plane or a ball: there the line between two points is
/// at right angles to the sum of their normals. 1e30 if they cannot be one surface.
float offSurface(ShownPoint a, ShownPoint b) {
    const float kOff = 0.02; // sine of the angle between that line and the surface
    const float kTurn = 0.5; // cosine of the angle between the normals
    vec3 apart = b.positionVS - a.positionVS;
    vec3 normalVS = normalizeOr(a.normalVS + b.normalVS, a.normalVS);
    // A pixel's depth may be that of any of its samples: half a pixel beside the centre.
    float slack = dot(abs(normalVS.xy), pixelExtent(frame.constants, frame.constants.uvToView, a.viewZ));
    float off = abs(dot(normalVS, apart));
    bool one = b.viewZ < kBackgroundZ && dot(a.normalVS, b.normalVS) > kTurn && off <= slack + kOff * length(apart);
    return one ? off : 1e30;
}

/// The middle of a pixel beside the one at `px` that shows the same surface alone; `px` if there is none.
vec2 placeOfSurfaceAlone(vec2 px) {
    ivec2 at = floorToInt(px);
    ShownPoint here = shownPoint(at);
    float least = 1e29;
    for (int i = 0; i < 9; ++i) {
        ivec2 beside = clamp(at + ivec2(i % 3, i / 3) - 1, ivec2(0), ivec2(frame.constants.size) - 1);
        float off = offSurface(here, shownPoint(beside));
        if (off < least && showsOneSurface(beside)) {
            least = off;
            px = vec2(beside) + 0.5;
        }
    }
    return px;
}

#endif
