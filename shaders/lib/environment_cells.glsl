// The cells of the environment that paths sample directly (shared/light_tree.h), on the faces of a cube.
#ifndef GLINT_LIB_ENVIRONMENT_CELLS_GLSL
#define GLINT_LIB_ENVIRONMENT_CELLS_GLSL

#include "lib/environment.glsl"
#include "shared/light_tree.h"

struct CubePoint {
    uint face;
    vec2 p; // [-1, 1]^2, as cubeDirection takes it
};

/// The inverse of cubeDirection.
CubePoint cubePoint(vec3 direction) {
    vec3 size = abs(direction);
    if (size.x >= size.y && size.x >= size.z)
        return CubePoint(direction.x > 0.0 ? 0u : 1u,
                         vec2(direction.x > 0.0 ? -direction.z : direction.z, -direction.y) / size.x);
    if (size.y >= size.z)
        return CubePoint(direction.y > 0.0 ? 2u : 3u,
                         vec2(direction.x, direction.y > 0.0 ? direction.z : -direction.z) / size.y);
    return CubePoint(direction.z > 0.0 ? 4u : 5u,
                     vec2(direction.z > 0.0 ? direction.x : -direction.x, -direction.y) / size.z);
}

/// Interleaves the low eight bits of both numbers, x first.
uint mortonCode(uvec2 cell) {
    uvec2 bits = cell & 0xffu;
    bits = (bits | (bits << 4u)) & 0x0f0fu;
    bits = (bits | (bits << 2u)) & 0x3333u;
    bits = (bits | (bits << 1u)) & 0x5555u;
    return bits.x | (bits.y << 1u);
}

uvec2 mortonCell(uint code) {
    uvec2 bits = uvec2(code, code >> 1u) & 0x5555u;
    bits = (bits | (bits >> 1u)) & 0x3333u;
    bits = (bits | (bits >> 2u)) & 0x0f0fu;
    return (bits | (bits >> 4u)) & 0xffu;
}

uint environmentLeaf(CubePoint at) {
    vec2 cell = clamp((0.5 * at.p + 0.5) * float(kEnvironmentSide), 0.0, float(kEnvironmentSide - 1u));
    return (at.face << (2u * kEnvironmentSideBits)) | mortonCode(uvec2(cell));
}

/// A point of a leaf; `inCell` in [0, 1]^2.
CubePoint environmentPoint(uint leaf, vec2 inCell) {
    uvec2 cell = mortonCell(leaf & ((1u << (2u * kEnvironmentSideBits)) - 1u));
    return CubePoint(leaf >> (2u * kEnvironmentSideBits), (vec2(cell) + inCell) * (2.0 / float(kEnvironmentSide)) - 1.0);
}

/// Solid angle of a cell about this point, over which the ratio of solid angle to area hardly changes.
float cellSolidAngle(CubePoint at) {
    return square(2.0 / float(kEnvironmentSide)) * pow(1.0 + dot(at.p, at.p), -1.5);
}

#endif
