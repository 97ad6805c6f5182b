// Writes the power of each emissive triangle: the leaves of the tree that paths draw triangles from, before
// rays/light_tree_sums adds them up.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "rays/emitters.glsl"

#include "lib/color.glsl"
#include "lib/light_tree_layout.glsl"

layout(local_size_x = 64) in;

layout(scalar, set = 0, binding = 24) writeonly buffer LightTreeBlock {
    float weights[];
}
lightTree;

bool rayAsksHoles() {
    return false;
}

/// About the mean over the triangle: a fetch at its centre, filtered over its size.
vec3 meanEmission(SurfaceInstanceRecord placed, SurfaceMeshRecord mesh, uvec3 triangle) {
    const vec3 kCentre = vec3(1.0 / 3.0);
    const vec2 kAlongU = vec2(0.5, 0.0); // half a side: a parallelogram of a triangle's area, nearly
    const vec2 kAlongV = vec2(0.0, 0.5);
    uvFootprint[0] = UvFootprint(change2(mesh.uv0, triangle, kAlongU), change2(mesh.uv0, triangle, kAlongV));
    uvFootprint[1] = UvFootprint(change2(mesh.uv1, triangle, kAlongU), change2(mesh.uv1, triangle, kAlongV));
    SurfacePoint point =
        SurfacePoint(vec3(0.0), vec3(0.0, 1.0, 0.0), vec4(0.0), vec2(0.0), vec2(0.0), vec4(1.0), true);
    point.uv0 = interpolate2(mesh.uv0, triangle, kCentre, vec2(0.0));
    point.uv1 = interpolate2(mesh.uv1, triangle, kCentre, vec2(0.0));
    point.color = interpolate4(mesh.colors, triangle, kCentre, vec4(1.0));
    return sampleMaterial(surfaceMaterials.item[placed.material], point).emission;
}

/// Luminance times area; 0 for what is not a finite number.
float power(uint leaf) {
    EmitterTriangle emitter = emitterTriangle(leaf);
    SurfaceInstanceRecord placed = surfaceInstances.item[emitter.instance];
    SurfaceMeshRecord mesh = surfaceMeshes.item[placed.mesh];
    uvec3 triangle = loadTriangle(mesh, emitter.primitive);
    TriangleWS sides = triangleWS(placed, mesh, triangle);
    float area = 0.5 * length(cross(sides.u, sides.v));
    float result = luminance(meanEmission(placed, mesh, triangle)) * area;
    const float kMost = 1e24; // sums of as many leaves as there may be stay finite
    return result > 0.0 ? min(result, kMost) : 0.0;
}

void main() {
    uint leaf = gl_GlobalInvocationID.x;
    uint leaves = emitters.header.leaves;
    if (leaf >= ((leaves + 3u) & ~3u))
        return;
    lightTree.weights[4u * (kEnvironmentGroups + lightGroupsAbove(emitters.header.depth)) + leaf] =
        leaf < leaves ? power(leaf) : 0.0; // the last group is filled with zeros
}
