// The source `probes`: for each pixel that the sources before left something of, the probes whose volumes hold it,
// smallest first, each getting at most what is left. A grid says which those are. docs/techniques/probes.md.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "hierarchy/taken_before.glsl"
#include "lib/camera.glsl"
#include "lib/probe.glsl"
#include "lib/sanitize.glsl"
#include "lib/surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
} frame;
layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 2) uniform usampler2D surface;
layout(scalar, set = 0, binding = 7) readonly buffer ProbesBlock {
    ProbeRecord list[];
} probes;
layout(scalar, set = 0, binding = 8) readonly buffer CellsBlock {
    uint first[];
} probeCells;
layout(scalar, set = 0, binding = 9) readonly buffer ListsBlock {
    uint probe[];
} probeLists;
layout(set = 0, binding = 10, rgba16f) uniform writeonly image2D probesAnswer; // mean radiance, weight
layout(set = 1, binding = 0) uniform samplerCube cubes[];
layout(push_constant, scalar) uniform PushBlock {
    ProbesConstants constants;
};

vec3 probeRadiance(ProbeRecord probe, vec3 positionWS, vec3 directionWS, float perceptualRoughness) {
    ProbeLookup lookup = probeLookup(probe, positionWS, directionWS, perceptualRoughness, constants.flags);
    float mip = lookup.perceptualRoughness * probe.lastMip;
    vec3 radiance = textureLod(cubes[nonuniformEXT(probe.cube)], lookup.directionWS, mip).rgb;
    return sanitize(sanitize(radiance) * probe.strength);
}

/// Of the cell that holds this position; empty outside of the grid.
uvec2 probesAround(vec3 positionWS) {
    vec3 at = (positionWS - constants.gridOriginWS) * constants.cellsPerMetre;
    if (any(lessThan(at, vec3(0.0))) || any(greaterThanEqual(at, vec3(constants.gridSize))))
        return uvec2(0u);
    uvec3 cell = min(uvec3(at), constants.gridSize - 1u);
    uint index = (cell.z * constants.gridSize.y + cell.y) * constants.gridSize.x + cell.x;
    return uvec2(probeCells.first[index], probeCells.first[index + 1u]);
}

vec4 answer(ivec2 px, float z) {
    float left = 1.0 - takenBefore(constants.before, px);
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    if (left <= 0.0 || here.reflectivity <= 0.0)
        return vec4(0.0);
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    vec3 positionVS = viewPosition(frame.constants, uv, z);
    vec3 positionWS = (frame.constants.viewToWorld * vec4(positionVS, 1.0)).xyz;
    vec3 normalWS = mat3(frame.constants.viewToWorld) * here.normalVS;
    vec3 directionWS =
        mat3(frame.constants.viewToWorld) * reflect(viewDirection(frame.constants, positionVS), here.normalVS);
    uvec2 range = probesAround(positionWS);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (uint i = range.x; i < range.y && total < left; ++i) {
        ProbeRecord probe = probes.list[probeLists.probe[i]];
        float weight = min(probeWeight(probe, positionWS, normalWS, directionWS), left - total);
        if (weight <= 0.0)
            continue;
        sum += weight * probeRadiance(probe, positionWS, directionWS, here.perceptualRoughness);
        total += weight;
    }
    return total > 0.0 ? vec4(sanitize(sum / total), total) : vec4(0.0);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    float z = texelFetch(viewZ, px, 0).r;
    imageStore(probesAnswer, px, z < kBackgroundZ ? answer(px, z) : vec4(0.0));
}
