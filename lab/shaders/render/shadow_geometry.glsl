// Geometry that shadow rays test in fragment stages: the holes of alpha-tested triangles. Include before
// rays/back_end.glsl.
#ifndef GLINT_RENDER_SHADOW_GEOMETRY_GLSL
#define GLINT_RENDER_SHADOW_GEOMETRY_GLSL

#define GLINT_RAY_ALPHA_TEST

#include "render/surface_bindings.glsl"

layout(scalar, set = 0, binding = 12) readonly buffer RayItemBlock {
    uint list[]; // indexed by the ray scene's instances: the draw's
}
rayItems;

bool rayMeetsSurface(uint instance, uint primitive, vec2 barycentrics) {
    Instance placed = instances.list[rayItems.list[instance]];
    Material material = materials.list[placed.material];
    if ((material.flags & kMaterialAlphaMask) == 0u)
        return true;
    vec3 weights = vec3(1.0 - barycentrics.x - barycentrics.y, barycentrics);
    SurfacePoint point = SurfacePoint(vec3(0.0), vec3(0.0), vec4(0.0), vec2(0.0), vec2(0.0), vec4(0.0), true);
    for (uint corner = 0u; corner < 3u; ++corner) {
        VertexAttributes vertex = loadAttributes(int(placed.vertexOffset + loadIndex(placed, primitive, corner)));
        point.uv0 += weights[corner] * vertex.uv0;
        point.uv1 += weights[corner] * vertex.uv1;
        point.color += weights[corner] * vertex.color;
    }
    sharpestTexels = true;
    float alpha = sampleBaseColor(material, point).a;
    sharpestTexels = false;
    return alpha >= material.alphaCutoff;
}

#endif
