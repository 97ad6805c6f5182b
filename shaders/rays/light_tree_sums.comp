// Adds up a tree of lights from its leaves to its root, in one workgroup.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/environment_cells.glsl"
#include "lib/light_tree_layout.glsl"

layout(local_size_x = 256) in; // kLightTreeThreads

layout(scalar, set = 0, binding = 24) coherent buffer LightTreeBlock {
    vec4 groups[];
}
lightTree;
layout(scalar, push_constant) uniform Push {
    LightTreeConstants tree;
};

shared float partSums[kLightTreeThreads];

/// Least fraction of an environment's light above its mean that is worth a ray. It is also far above what rounding
/// leaves of uniform light.
const float kLeastAboveMean = 1e-3;

/// The sum of one number of each thread.
float sumOfThreads(float value) {
    partSums[gl_LocalInvocationIndex] = value;
    for (uint count = kLightTreeThreads / 2u; count > 0u; count /= 2u) {
        barrier();
        if (gl_LocalInvocationIndex < count)
            partSums[gl_LocalInvocationIndex] += partSums[gl_LocalInvocationIndex + count];
    }
    barrier();
    float sum = partSums[0];
    barrier();
    return sum;
}

float sumOfGroups(uint first, uint count) {
    float sum = 0.0;
    for (uint g = gl_LocalInvocationIndex; g < count; g += kLightTreeThreads)
        sum += dot(lightTree.groups[first + g], vec4(1.0));
    return sumOfThreads(sum);
}

/// Leaves each cell its light above the environment's mean, because lobes sample dim and even light well themselves.
/// Karlik et al. 2019, "MIS Compensation: Optimizing Sampling Techniques in Multiple Importance Sampling", TOG 38(6).
void keepAboveMean(uint first, uint count) {
    float total = sumOfGroups(first, count);
    float mean = total / (4.0 * kPi);
    for (uint g = gl_LocalInvocationIndex; g < count; g += kLightTreeThreads)
        for (uint i = 0u; i < 4u; ++i) {
            float atMean = mean * cellSolidAngle(environmentPoint(4u * g + i, vec2(0.5)));
            lightTree.groups[first + g][i] = max(lightTree.groups[first + g][i] - atMean, 0.0);
        }
    memoryBarrierBuffer();
    barrier();
    if (sumOfGroups(first, count) > kLeastAboveMean * total)
        return;
    for (uint g = gl_LocalInvocationIndex; g < count; g += kLightTreeThreads)
        lightTree.groups[first + g] = vec4(0.0);
    memoryBarrierBuffer();
    barrier();
}

void main() {
    uint groups = (tree.leaves + 3u) / 4u;
    if (tree.isEnvironment != 0u)
        keepAboveMean(tree.firstGroup + lightGroupsAbove(tree.depth), groups);
    for (uint d = tree.depth; d > 0u; --d) {
        uint children = tree.firstGroup + lightGroupsAbove(d);
        uint count = groups;
        groups = (groups + 3u) / 4u;
        for (uint g = gl_LocalInvocationIndex; g < groups; g += kLightTreeThreads) {
            vec4 sums = vec4(0.0);
            for (uint i = 0u; i < 4u; ++i)
                if (4u * g + i < count)
                    sums[i] = dot(lightTree.groups[children + 4u * g + i], vec4(1.0));
            lightTree.groups[tree.firstGroup + lightGroupsAbove(d - 1u) + g] = sums;
        }
        memoryBarrierBuffer();
        barrier();
    }
}
