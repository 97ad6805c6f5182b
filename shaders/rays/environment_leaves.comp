// Writes the light of each cell of the environment: the leaves of the tree that paths draw directions from, before
// rays/light_tree_sums adds them up.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/color.glsl"
#include "lib/environment_cells.glsl"
#include "lib/light_tree_layout.glsl"
#include "lib/sanitize.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 3) uniform samplerCube environment;
layout(scalar, set = 0, binding = 24) writeonly buffer LightTreeBlock {
    float weights[];
}
lightTree;

/// Fetches along a cell's edge lie a texel apart. The outermost lie on the edge, so that a cell has some weight wherever
/// filtering spreads a bright texel to. Larger faces than this many cells' would take too long; what is missed only adds
/// noise.
const uint kMostSteps = 8u;

void main() {
    uint leaf = gl_GlobalInvocationID.x;
    if (leaf >= kEnvironmentLeaves)
        return;
    uint face = uint(textureSize(environment, 0).x);
    uint steps = clamp((face + kEnvironmentSide - 1u) / kEnvironmentSide, 1u, kMostSteps);
    float sum = 0.0;
    for (uint y = 0u; y <= steps; ++y)
        for (uint x = 0u; x <= steps; ++x) {
            CubePoint at = environmentPoint(leaf, vec2(x, y) / float(steps));
            sum += luminance(sanitize(textureLod(environment, cubeDirection(at.face, at.p), 0.0).rgb));
        }
    float mean = sum / float((steps + 1u) * (steps + 1u));
    lightTree.weights[4u * lightGroupsAbove(kEnvironmentDepth) + leaf] =
        mean * cellSolidAngle(environmentPoint(leaf, vec2(0.5)));
}
