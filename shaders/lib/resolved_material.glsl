// F0, F90 and coverage of a pixel: from the image that prepare resolved, or from the host's own image where nothing
// needed resolving.
#ifndef GLINT_LIB_RESOLVED_MATERIAL_GLSL
#define GLINT_LIB_RESOLVED_MATERIAL_GLSL

#include "lib/packed_coverage.glsl"
#include "lib/sanitize.glsl"
#include "shared/frame_constants.h"

/// `texel` of the pass's material image: F0 in rgb, coverage of the pixel by the selected surface in a.
vec4 resolvedMaterial(FrameConstants frame, vec4 texel) {
    bool resolved = (frame.flags & kInputResolved) != 0u;
    return resolved ? vec4(texel.rgb, unpackCoverage(frame, texel.a).x)
                    : vec4(clamp(sanitize(texel.rgb), 0.0, 1.0), 1.0);
}

/// F90 of the same texel.
float resolvedF90(FrameConstants frame, vec4 texel) {
    return (frame.flags & kInputF90) != 0u ? unpackCoverage(frame, texel.a).y : 1.0;
}

#endif
