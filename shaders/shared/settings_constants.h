// The settings in force, resolved for shaders. They follow FrameConstants in the frame block (frame/frame_block.glsl),
// so a setting costs no push constant, whichever passes read it. Push constants are left for what differs between the
// passes of a frame.
#ifndef GLINT_SHARED_SETTINGS_CONSTANTS_H
#define GLINT_SHARED_SETTINGS_CONSTANTS_H

#include "shared/denoise_constants.h"
#include "shared/hierarchy.h"
#include "shared/planar.h"
#include "shared/probes.h"
#include "shared/rays_constants.h"
#include "shared/refraction.h"
#include "shared/resolve_constants.h"
#include "shared/trace_constants.h"

GLINT_SHARED_BEGIN

struct SettingsConstants {
    TraceConstants trace;      // rays of the source `screen`
    TraceConstants layerTrace; // rays of transparent layers
    RefractionConstants refraction;
    RaysConstants rays;
    PlanarConstants planar;
    ProbesConstants probes;
    HierarchyConstants hierarchy;
    BlurConstants blur;
    DenoiseConstants denoise;
    CompositeConstants composite;
};

GLINT_SHARED_END

#endif
