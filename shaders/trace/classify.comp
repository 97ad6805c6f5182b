// Finds the pixels that need a ray; list.comp lists them. Tracing costs nothing where nothing reflects. Where every
// pixel is traced and none asks its neighbours, prepare/classified does this beside its own work.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/prepared.glsl"
#include "lib/surface.glsl"
#include "lib/trace_pixel.glsl"
#include "trace/ray_list.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 12) uniform sampler2D rayRates;

#define GLINT_NEIGHBOURS_ANSWER
#include "trace/starts_ray.glsl"

void main() {
    ivec2 tracePX = ivec2(gl_GlobalInvocationID.xy);
    bool needsRay = false;
    bool fromRough = false;
    if (isTracePixel(frame.constants, tracePX)) {
        ivec2 px = tracePixelToFull(frame.constants, tracePX);
        Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
        needsRay = startsRay(tracePX, px, texelFetch(viewZ, px, 0).r, here, fromRough);
    }
    needRay(needsRay, fromRough);
}
