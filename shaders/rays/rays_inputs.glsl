// What every pass of the source `rays` reads of the frame, and its settings.
#ifndef GLINT_RAYS_RAYS_INPUTS_GLSL
#define GLINT_RAYS_RAYS_INPUTS_GLSL

#include "frame/prepared.glsl"
#include "lib/camera.glsl"
#include "lib/surface.glsl"
#include "shared/rays_constants.h"
#include "shared/trace_constants.h"

layout(scalar, set = 0, binding = 10) readonly buffer RaysBlock {
    RayListHeader header;
    uint pixels[];
}
rays;
RaysConstants settings = frame.settings.rays;

bool isOn(uint flag) {
    return (settings.flags & flag) != 0u;
}

bool rayAsksHoles() {
    return isOn(kRaysAlphaTest);
}

/// kRayAllOpaque where no triangle needs a test: none has holes, and none is transparent.
uint opaqueFlags() {
    return isOn(kRaysAlphaTest) || isOn(kRaysTransparentScene) ? 0u : kRayAllOpaque;
}

/// kRay... flags: culling as in the raster pass, holes as rays.alphaTest sets.
uint viewRayFlags() {
    return kRayCullBackFaces | opaqueFlags();
}

/// Flags of shadow rays: any occluder blocks the light, hit from either side.
uint shadowRayFlags() {
    return opaqueFlags();
}

#endif
