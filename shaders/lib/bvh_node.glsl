// Intersects a ray with one node of the wide hierarchy (shared/bvh.h): all eight boxes at once. Ylitie, Karras and
// Laine 2017, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG.
#ifndef GLINT_LIB_BVH_NODE_GLSL
#define GLINT_LIB_BVH_NODE_GLSL

#extension GL_EXT_control_flow_attributes : require

#include "shared/bvh.h"

/// A ray in the form that box tests need.
struct BoxRay {
    vec3 origin;
    vec3 inverseDirection;
    uint order; // slot ^ order: larger for corners that the ray reaches sooner
};

BoxRay makeBoxRay(vec3 origin, vec3 direction) {
    BoxRay ray;
    ray.origin = origin;
    // Replace zeros: the distance of a face that the ray runs along would be 0 * infinity. Rays are 2^-60 off at worst.
    vec3 size = abs(direction);
    float least = max(max(size.x, size.y), size.z) * exp2(-60.0);
    vec3 away = mix(vec3(1.0), vec3(-1.0), lessThan(direction, vec3(0.0)));
    ray.inverseDirection = away / max(size, vec3(least));
    ray.order = (direction.x < 0.0 ? 0u : 1u) | (direction.y < 0.0 ? 0u : 2u) | (direction.z < 0.0 ? 0u : 4u);
    return ray;
}

vec4 bytesOf(uint word) {
    return vec4(word & 0xffu, (word >> 8) & 0xffu, (word >> 16) & 0xffu, word >> 24);
}

/// The children that the ray intersects between tMin and tMax. Nodes are in bits 24 to 31, the first to visit in the
/// highest bit; primitives are in bits 0 to 23, counted from the node's first.
uint intersectChildren(BvhNode node, BoxRay ray, float tMin, float tMax) {
    vec3 low = uintBitsToFloat(node.words[0].xyz);
    uint exponents = node.words[0].w;
    vec3 cell = uintBitsToFloat((uvec3(exponents, exponents >> 8, exponents >> 16) & 0xffu) << 23);
    vec3 perCell = cell * ray.inverseDirection;
    vec3 start = (low - ray.origin) * ray.inverseDirection;
    // Conservative: each distance below is start + n * perCell with n <= 255, so its error is a few roundings (2^-24
    // each, a division 2.5) of the two. Ize 2013, "Robust BVH Ray Traversal", JCGT 2(2), bounds slabs the same way.
    vec3 slack = (abs(start) + 255.0 * abs(perCell)) * exp2(-20.0);
    vec3 startNear = start - slack;
    vec3 startFar = start + slack;

    uint hits = 0u;
    [[unroll]] for (int half4 = 0; half4 < 2; ++half4) {
        uint lowX = half4 == 0 ? node.words[2].x : node.words[2].y;
        uint lowY = half4 == 0 ? node.words[2].z : node.words[2].w;
        uint lowZ = half4 == 0 ? node.words[3].x : node.words[3].y;
        uint highX = half4 == 0 ? node.words[3].z : node.words[3].w;
        uint highY = half4 == 0 ? node.words[4].x : node.words[4].y;
        uint highZ = half4 == 0 ? node.words[4].z : node.words[4].w;
        vec4 nearX = bytesOf(ray.inverseDirection.x < 0.0 ? highX : lowX) * perCell.x + startNear.x;
        vec4 nearY = bytesOf(ray.inverseDirection.y < 0.0 ? highY : lowY) * perCell.y + startNear.y;
        vec4 nearZ = bytesOf(ray.inverseDirection.z < 0.0 ? highZ : lowZ) * perCell.z + startNear.z;
        vec4 farX = bytesOf(ray.inverseDirection.x < 0.0 ? lowX : highX) * perCell.x + startFar.x;
        vec4 farY = bytesOf(ray.inverseDirection.y < 0.0 ? lowY : highY) * perCell.y + startFar.y;
        vec4 farZ = bytesOf(ray.inverseDirection.z < 0.0 ? lowZ : highZ) * perCell.z + startFar.z;
        vec4 enter = max(max(nearX, nearY), max(nearZ, vec4(tMin)));
        vec4 leave = min(min(farX, farY), min(farZ, vec4(tMax)));

        uint meta = half4 == 0 ? node.words[1].z : node.words[1].w;
        [[unroll]] for (int i = 0; i < 4; ++i) {
            uint child = (meta >> (8 * i)) & 0xffu;
            uint slot = uint(4 * half4 + i);
            bool isNode = (exponents >> (24u + slot) & 1u) != 0u;
            uint bits = isNode ? 1u << (24u + (slot ^ ray.order)) : (child >> 5) << (child & 31u);
            hits |= enter[i] <= leave[i] ? bits : 0u;
        }
    }
    return hits;
}

#endif
