// A scene on the GPU: vertices that shaders pull by index, and instances placed in the world.
#ifndef GLINT_SHARED_GPU_SCENE_H
#define GLINT_SHARED_GPU_SCENE_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

/// A vertex without its position, which has a buffer of its own: depth passes and ray tracing need only positions.
struct VertexAttributes {
    float3 normal;  ///< unit
    float4 tangent; ///< xyz unit, w = handedness; zero if there is none
    float2 uv0;
    float2 uv1;
    float4 color; ///< linear; white if there is none
};

GLINT_CONSTANT(uint, kInstanceMirrored, 1u);  ///< the transform has a negative determinant
GLINT_CONSTANT(uint, kInstanceNoNormals, 2u); ///< lines or points without normals: shown without lighting

/// An instance of a geometry, with a transform and a material.
struct Instance {
    float4x4 localToWorld;
    float4x4 prevLocalToWorld;
    uint material;
    uint flags;          ///< kInstance...
    uint firstIndex;     ///< of its triangles, in the index buffer
    uint vertexOffset;   ///< added to each index
    int prevVertexDelta; ///< offset from a vertex to its place in the previous frame; 0 unless it deforms
    float3 centerWS;     ///< of its bounding box
    uint bodyShape;      ///< kRefraction* (shared/refraction.h): the body's shape for transmitted light
};

/// Where the scene's arrays are: read by address, because a storage buffer may be as small as 128 MiB, the attributes
/// of 2.2 million vertices. Low and high half of each.
struct GeometryAddresses {
    uint2 positions;  ///< float3
    uint2 attributes; ///< VertexAttributes
    uint2 indices;    ///< uint
};

/// Push constants of each draw.
struct DrawConstants {
    uint instance;
};

GLINT_SHARED_END

#ifdef __cplusplus
static_assert(sizeof(glint::shared::VertexAttributes) == 60);
static_assert(sizeof(glint::shared::Instance) == 164);
#endif
#endif
