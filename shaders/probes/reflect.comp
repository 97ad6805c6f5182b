// The source `probes`: for each pixel with remaining weight after the sources before, the probes whose volumes hold it,
// smallest first; each probe gets at most the remaining weight. A grid lists the probes. docs/techniques/probes.md.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/prepared.glsl"
#include "generate/pixel_ray.glsl"
#include "hierarchy/answers.glsl"
#include "lib/camera.glsl"
#include "lib/surface.glsl"
#include "probes/probe_cubes.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 10, rgba16f) uniform writeonly image2D probesRadianceWeight; // mean radiance, weight
ProbesConstants settings = frame.settings.probes;

vec4 answer(ivec2 px, float z) {
    float left = 1.0 - takenBefore(settings.before, px);
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    if (left <= 0.0 || here.reflectivity <= 0.0)
        return vec4(0.0);
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    PixelRay ray = generateRay(uv, z, here);
    vec3 positionWS = (frame.constants.viewToWorld * vec4(ray.originVS, 1.0)).xyz;
    vec3 normalWS = mat3(frame.constants.viewToWorld) * here.normalVS;
    return probesAnswer(positionWS, normalWS, directionWS(ray), ray.roughnessLeft, left, settings.flags);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    float z = texelFetch(viewZ, px, 0).r;
    imageStore(probesRadianceWeight, px, z < kBackgroundZ ? answer(px, z) : vec4(0.0));
}
