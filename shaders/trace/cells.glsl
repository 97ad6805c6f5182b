// A ray's line among the cells of the depth pyramid (lib/pyramid.glsl).
#ifndef GLINT_TRACE_CELLS_GLSL
#define GLINT_TRACE_CELLS_GLSL

#include "lib/math.glsl"
#include "lib/nearness.glsl"
#include "lib/pyramid.glsl"
#include "trace/ray.glsl"

layout(set = 0, binding = 12) uniform usampler2D pyramid;

CellBounds loadCell(ivec2 cell, int level) {
    ivec2 at = pyramidOffset(ivec2(frame.constants.size), level) + cell;
    return unpackBounds(texelFetch(pyramid, at, 0), frame.constants.invSize.x);
}

/// The line on screen, in the form that crossings of cell borders need.
struct Line {
    vec2 startPX;
    vec2 deltaPX;
    vec2 invDelta;    // large for an axis along which the line does not move
    vec2 forward;     // 1 where the line moves toward larger coordinates, else 0
    float pixelShare; // a pixel along the line's longer axis, as a fraction of the line
};

Line makeLine(ScreenRay ray) {
    // By a choice, not by weights of 0 and 1: GPUs may compute mix(x, y, a) as x + a * (y - x), which loses y beside 1e30.
    bvec2 moves = notEqual(ray.deltaPX, vec2(0.0));
    vec2 invDelta = mix(vec2(1e30), 1.0 / mix(vec2(1.0), ray.deltaPX, moves), moves);
    return Line(ray.startPX, ray.deltaPX, invDelta, vec2(greaterThan(ray.deltaPX, vec2(0.0))), 1.0 / screenPixels(ray));
}

/// Fraction of the line at which it leaves the cell that spans [low, low + size) pixels, and the axis it crosses.
float leaveCell(Line line, vec2 low, float size, out bool overX) {
    vec2 at = (low + line.forward * size - line.startPX) * line.invDelta;
    at = mix(at, vec2(1e30), greaterThan(abs(line.invDelta), vec2(1e29)));
    overX = at.x < at.y;
    return min(at.x, at.y);
}

#endif
