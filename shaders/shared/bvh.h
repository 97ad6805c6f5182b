// Memory layout of Glint's own bounding volume hierarchy: eight children a node, boxes in bytes. Ylitie, Karras and
// Laine 2017, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG.
#ifndef GLINT_SHARED_BVH_H
#define GLINT_SHARED_BVH_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

/// A node's children are in eight slots. A slot's number tells in which corner of the node the child lies (bit 0: +x,
/// bit 1: +y, bit 2: +z), so a ray's octant gives the order of visits.
///   words[0]  xyz: the box's low corner (float bits); w: grid exponents of x, y, z with bias 127 (a byte each), then
///             a bit for each slot that holds a node
///   words[1]  x: first child node; y: first primitive; zw: a byte a slot: for primitives, 0 to 23 from the first one
///             in the low five bits and one to three set bits above, one a primitive; 0x20 for a node; 0 for none
///   words[2]  xy: low x, zw: low y      a byte a slot each, in cells of the grid
///   words[3]  xy: low z, zw: high x
///   words[4]  xy: high y, zw: high z
struct BvhNode {
    uint4 words[5];
};

/// A triangle in the order of the leaves. w of the first vertex, as float bits: the triangle's number in the mesh and,
/// in the top two bits, the normal's longest axis. w of the other vertices: the normal's other two components over the
/// longest one. The normal is computed in double precision, because a thin triangle's normal would not survive single
/// precision; NaN if the triangle has no normal.
struct BvhTriangle {
    float4 vertices[3];
};
GLINT_CONSTANT(uint, kBvhNormalAxisShift, 30u);

GLINT_CONSTANT(uint, kBvhInstanceOpaque, 0x100u); ///< beside the mask
GLINT_CONSTANT(uint, kBvhInstanceDoubleSided, 0x200u);

/// An instance in the order of the top level's leaves.
struct BvhInstance {
    float4 worldToLocal[3]; ///< rows of the linear part; w: the local origin in world space
    uint rootNode;
    uint number;       ///< in the host's list
    uint maskAndFlags; ///< low byte: the mask; kBvhInstance...
    uint unused;
};

/// Where the scene's arrays are: read by address, because a storage buffer may be as small as 128 MiB, the triangles of
/// 2.8 million. Low and high half of each.
struct BvhAddresses {
    uint2 nodes; ///< the top level's root first
    uint2 triangles;
    uint2 instances;
};

GLINT_CONSTANT(uint, kBvhPrimitivesPerSlot, 3u);
/// The builder keeps these limits (src/rays/binary_bvh.hpp), so the traversal's stack cannot overflow: each level
/// leaves at most one group of siblings on the stack, and entering an instance leaves the primitives beside it.
GLINT_CONSTANT(uint, kBvhTopLevels, 8u);
GLINT_CONSTANT(uint, kBvhMeshLevels, 16u);
GLINT_CONSTANT(uint, kBvhStackSize, 25u); // 8 + 1 + 16

GLINT_SHARED_END

#ifdef __cplusplus
static_assert(sizeof(glint::shared::BvhNode) == 80);
static_assert(sizeof(glint::shared::BvhTriangle) == 48);
static_assert(sizeof(glint::shared::BvhInstance) == 64);
static_assert(glint::shared::kBvhStackSize == glint::shared::kBvhTopLevels + 1 + glint::shared::kBvhMeshLevels);
#endif
#endif
