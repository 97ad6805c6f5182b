// What the triangles that rays hit look like (glint/surface_table.hpp), as shaders read it.
#ifndef GLINT_SHARED_SURFACE_TABLE_H
#define GLINT_SHARED_SURFACE_TABLE_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

/// Floats in a buffer of the host's.
struct StreamRecord {
    uint2 address; ///< low and high half; 0: absent
    uint stride;   ///< floats from vertex to vertex
};

struct SurfaceMeshRecord {
    StreamRecord positions;
    StreamRecord normals;
    StreamRecord tangents;
    StreamRecord uv0;
    StreamRecord uv1;
    StreamRecord colors;
    uint2 indices; ///< address of three a triangle
};

struct SurfaceInstanceRecord {
    float4 localToWorld[3]; ///< rows
    uint mesh;
    uint material;
};

GLINT_SHARED_END

#ifdef __cplusplus
static_assert(sizeof(glint::shared::SurfaceMeshRecord) == 80);
static_assert(sizeof(glint::shared::SurfaceInstanceRecord) == 56);
#endif
#endif
