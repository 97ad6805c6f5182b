// F0 and coverage of a pixel, from whichever image says them: the one that prepare resolved, or the host's own where
// there was nothing to resolve.
#ifndef GLINT_LIB_RESOLVED_MATERIAL_GLSL
#define GLINT_LIB_RESOLVED_MATERIAL_GLSL

#include "lib/sanitize.glsl"
#include "shared/frame_constants.h"

/// `texel` of the image that the pass was given: F0 in rgb, the picked surface's share of the pixel in a.
vec4 resolvedMaterial(FrameConstants frame, vec4 texel) {
    bool resolved = (frame.flags & kInputResolved) != 0u;
    return resolved ? texel : vec4(clamp(sanitize(texel.rgb), 0.0, 1.0), 1.0);
}

#endif
