// What a scene is on the GPU: vertices that shaders pull by index, and the things placed in the world.
#ifndef GLINT_SHARED_GPU_SCENE_H
#define GLINT_SHARED_GPU_SCENE_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

/// What a vertex carries besides its position, which has a buffer of its own: depth passes and ray tracing need no
/// more.
struct VertexAttributes {
    float3 normal;  ///< unit
    float4 tangent; ///< xyz unit, w = handedness; zero if there is none
    float2 uv0;
    float2 uv1;
    float4 color; ///< linear; white if there is none
};

GLINT_CONSTANT(uint, kInstanceMirrored, 1u);  ///< the transform has a negative determinant
GLINT_CONSTANT(uint, kInstanceNoNormals, 2u); ///< lines or points without normals: shown without lighting

/// A piece of geometry, somewhere, with a material.
struct Instance {
    float4x4 localToWorld;
    float4x4 prevLocalToWorld;
    uint material;
    uint flags;          ///< kInstance...
    uint firstIndex;     ///< of its triangles, in the index buffer
    uint vertexOffset;   ///< added to each index
    int prevVertexDelta; ///< from a vertex to where it stood in the previous frame; 0 unless it deforms
    float3 centerWS;     ///< of its bounding box
    uint bodyShape;      ///< kRefraction* (shared/refraction.h): what light that comes through it meets
};

/// Pushed for each draw.
struct DrawConstants {
    uint instance;
};

GLINT_SHARED_END

#ifdef __cplusplus
static_assert(sizeof(glint::shared::VertexAttributes) == 60);
static_assert(sizeof(glint::shared::Instance) == 164);
#endif
#endif
