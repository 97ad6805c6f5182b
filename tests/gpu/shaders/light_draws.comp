// Draws from a tree of lights (lib/light_tree.glsl), and the density of directions to the environment's cells.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/environment_cells.glsl"
#include "lib/light_tree.glsl"

layout(local_size_x = 64) in;

layout(scalar, set = 0, binding = 24) readonly buffer LightTreeBlock {
    vec4 groups[];
}
lightTree;

struct Draw {
    uint leaf;
    float probability;    // as drawn
    float again;          // of the same leaf, looked up
    vec3 directionWS;     // not normalized, in the leaf's cell
    uint leafOfDirection; // as looked up
    float solidAngle;     // of the cell, about the direction
};

layout(scalar, set = 0, binding = 0) writeonly buffer DrawBlock {
    Draw list[];
}
draws;

layout(scalar, push_constant) uniform Push {
    uint firstGroup;
    uint depth;
    uint every; // 1: a draw for each thread; 0: the leaf of the thread's number
};

vec4 loadLightGroup(uint group) {
    return lightTree.groups[group];
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(draws.list.length()))
        return;
    DrawnLight drawn = DrawnLight(i, lightProbability(firstGroup, depth, i));
    if (every != 0u)
        drawn = drawLight(firstGroup, depth, LightNoise(uvec2(i & 0xffffu, i >> 16u), 5u, 9u));
    CubePoint at = environmentPoint(drawn.leaf, hashNoise(uvec2(i, 0u), 1u, 77u).xy);
    vec3 direction = cubeDirection(at.face, at.p);
    draws.list[i] = Draw(drawn.leaf, drawn.probability, lightProbability(firstGroup, depth, drawn.leaf), direction,
                         environmentLeaf(cubePoint(normalize(direction))), cellSolidAngle(at));
}
