// What every pass of the source `rays` reads of the frame, and its settings.
#ifndef GLINT_RAYS_RAYS_INPUTS_GLSL
#define GLINT_RAYS_RAYS_INPUTS_GLSL

#include "lib/camera.glsl"
#include "lib/surface.glsl"
#include "shared/rays_constants.h"
#include "shared/trace_constants.h"

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
}
frame;
layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 2) uniform usampler2D surface;
layout(scalar, set = 0, binding = 10) readonly buffer RaysBlock {
    RayListHeader header;
    uint pixels[];
}
rays;
layout(push_constant, scalar) uniform PushBlock {
    RaysConstants settings;
};

bool isOn(uint flag) {
    return (settings.flags & flag) != 0u;
}

/// kRay...: as the raster pass culls, and as rays.alphaTest says.
uint viewRayFlags() {
    return kRayCullBackFaces | (isOn(kRaysAlphaTest) ? 0u : kRayAllOpaque);
}

/// Whatever stands in a light's way does, seen from either side.
uint shadowRayFlags() {
    return isOn(kRaysAlphaTest) ? 0u : kRayAllOpaque;
}

#endif
