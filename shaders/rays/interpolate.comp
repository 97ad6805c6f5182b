// Answers the pixels that rays/list left to their neighbours: by the mean of the rays around them, where these start on the
// same surface and found nearly the same. The other pixels are marked for a second list. So where a reflection is plain one
// ray serves four pixels, and its outlines and details are as sharp as with a ray for each pixel.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "denoise/lobe_surface.glsl"
#include "frame/prepared.glsl"
#include "lib/math.glsl"
#include "lib/ray_record.glsl"
#include "shared/rays_constants.h"
#include "trace/ray_list.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 7, rgba16f) uniform image2D raysRadianceWeight;
layout(set = 0, binding = 8, rgba32ui) uniform uimage2D raysRecord;
RaysConstants settings = frame.settings.rays;

/// True if the pixel sent a ray of its own.
bool sentRay(RayRecord ray) {
    return ray.outcome == kOutcomeHit || ray.outcome == kOutcomeSky;
}

/// True if what rays found, between the smallest and the largest of each channel, may count as one answer. The fourth
/// channel is the weight.
bool areAlike(vec4 least, vec4 most) {
    float brightest = max(maxComponent(most.rgb), 1e-6);
    return maxComponent(most.rgb - least.rgb) <= settings.interpolate * brightest &&
           most.a - least.a <= settings.interpolate;
}

/// The mean of the two or four rays of pixels with even coordinates around `px`; false where they do not answer for it.
bool interpolated(ivec2 px, out vec4 answer, out float distance) {
    ivec2 odd = px & 1;
    LobeSurface here = lobeSurfaceAt(px);
    vec4 sum = vec4(0.0); // radiance times weight, weight
    vec4 least = vec4(1e30);
    vec4 most = vec4(-1e30);
    float count = 0.0;
    float hits = 0.0;
    answer = vec4(0.0);
    distance = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        if (any(greaterThan(corner, odd)))
            continue; // the pixel lies in line with the others
        ivec2 at = (px & ~1) + 2 * corner;
        if (!isInFrame(at))
            return false;
        RayRecord ray = unpackRayRecord(imageLoad(raysRecord, at).xy);
        if (!sentRay(ray) || !isSameSurface(here, lobeSurfaceAt(at)))
            return false;
        vec4 found = imageLoad(raysRadianceWeight, at);
        least = min(least, found);
        most = max(most, found);
        sum += vec4(found.rgb * found.a, found.a);
        count += 1.0;
        if (ray.outcome == kOutcomeHit) {
            distance += ray.hitDistance;
            hits += 1.0;
        }
    }
    if (!areAlike(least, most))
        return false;
    answer = vec4(sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0), sum.a / count);
    distance /= max(hits, 1.0);
    return true;
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    bool needsRay = false;
    if (isInFrame(px) && ((px.x | px.y) & 1) != 0) {
        uvec4 stored = imageLoad(raysRecord, px);
        RayRecord ray = unpackRayRecord(stored.xy);
        if (ray.outcome == kOutcomeFromNeighbours) {
            vec4 answer;
            needsRay = !interpolated(px, answer, ray.hitDistance);
            if (!needsRay) {
                imageStore(raysRadianceWeight, px, answer);
                imageStore(raysRecord, px, uvec4(packRayRecord(ray), stored.zw));
            }
        }
    }
    needRay(needsRay, false);
}
