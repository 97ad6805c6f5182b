// Maps between traced pixels and the frame's pixels. With screen.resolutionScale below 1 fewer rays than pixels are
// traced. Each ray starts from one pixel of the full-resolution G-buffer; every pass that reads the ray's result uses
// these functions to find that pixel. Pure functions of FrameConstants.
#ifndef GLINT_LIB_TRACE_PIXEL_GLSL
#define GLINT_LIB_TRACE_PIXEL_GLSL

#include "lib/math.glsl"
#include "shared/frame_constants.h"

bool isTracePixel(FrameConstants frame, ivec2 tracePX) {
    return all(greaterThanEqual(tracePX, ivec2(0))) && all(lessThan(tracePX, ivec2(frame.traceSize)));
}

/// The frame's pixel from which the ray of a traced pixel starts: the pixel under the traced pixel's centre.
ivec2 tracePixelToFull(FrameConstants frame, ivec2 tracePX) {
    return min(floorToInt((vec2(tracePX) + 0.5) * frame.traceScale), ivec2(frame.size) - 1);
}

/// The traced pixel that covers a pixel of the frame.
ivec2 fullToTracePixel(FrameConstants frame, ivec2 px) {
    return min(floorToInt((vec2(px) + 0.5) / frame.traceScale), ivec2(frame.traceSize) - 1);
}

#endif
