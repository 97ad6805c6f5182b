// The appearance of the triangles that rays hit (glint/surface_table.hpp), for shaders.
#ifndef GLINT_SHARED_SURFACE_TABLE_H
#define GLINT_SHARED_SURFACE_TABLE_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

/// Floats in one of the host's buffers.
struct StreamRecord {
    uint2 address; ///< low and high half; 0: absent
    uint stride;   ///< floats from one vertex to the next
};

struct SurfaceMeshRecord {
    StreamRecord positions;
    StreamRecord normals;
    StreamRecord tangents;
    StreamRecord uv0;
    StreamRecord uv1;
    StreamRecord colors;
    uint2 indices; ///< address of the indices, three for each triangle
    StreamRecord previousPositions;
};

struct SurfaceInstanceRecord {
    float4 localToWorld[3]; ///< rows
    uint mesh;
    uint material;
};

GLINT_SHARED_END

#ifdef __cplusplus
static_assert(sizeof(glint::shared::SurfaceMeshRecord) == 92);
static_assert(sizeof(glint::shared::SurfaceInstanceRecord) == 56);
#endif
#endif
