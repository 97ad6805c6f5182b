// What means over rough surfaces' lobes are made of (resolve/lobe.comp): the traced answers, and where they come from.
// Texels without a ray are 0 throughout, so that sums leave them out.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/prepared.glsl"
#include "lib/nearness.glsl"
#include "shared/trace_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 3) uniform usampler2D rayRecord;
layout(set = 0, binding = 4) uniform sampler2D traced;                  // radiance, not multiplied by weight
layout(set = 0, binding = 5, rgba16f) uniform writeonly image2D lights; // radiance * weight, weight
/// 1; nearness of the surface (lib/nearness.glsl); 1 / metres of the way from the eye to what is reflected, times its
/// weight; that weight: brightness, times the part of the way that comes after the surface. So what is near, whose lobe
/// is narrow, says little of other pixels.
layout(set = 0, binding = 6, rgba16f) uniform writeonly image2D places;
layout(scalar, set = 0, binding = 11) readonly buffer RaysBlock {
    RayListHeader header;
}
rayList;

#include "resolve/neighbourhood.glsl"

void main() {
    ivec2 tracePX = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tracePX, imageSize(lights))) || rayList.header.pictureGroups[0] == 0u)
        return;
    vec4 light = vec4(0.0);
    vec4 place = vec4(0.0);
    RayRecord ray = RayRecord(vec2(0.0), 0.0, 0u, kOutcomeNone, false);
    if (isTracePixel(frame.constants, tracePX))
        ray = rayOf(tracePX);
    if (wasTraced(ray)) {
        const float kLargest = 6e4; // below the largest half
        light = texelFetch(traced, tracePX, 0);
        light.rgb *= light.a;
        ivec2 px = tracePixelToFull(frame.constants, tracePX);
        float z = texelFetch(viewZ, px, 0).r;
        float before = length(viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z));
        float part = ray.hitDistance / max(before + ray.hitDistance, 1e-6);
        float weight = isAnswered(ray.outcome) ? min(meanComponent(light.rgb), kLargest) * part : 0.0;
        place = vec4(1.0, nearnessOf(frame.constants, z), weight / max(before + ray.hitDistance, 1e-3), weight);
        place = min(place, vec4(kLargest));
    }
    imageStore(lights, tracePX, light);
    imageStore(places, tracePX, place);
}
