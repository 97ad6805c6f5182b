// A binary bounding volume hierarchy by the surface area heuristic, of bounded height: what the wide one is made of.
#pragma once

#include "rays/bounds.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace glint::rays {

struct BinaryNode {
    Bounds bounds;
    uint32_t left = 0;   ///< children at left and left + 1; 0: a leaf (the root is nobody's child)
    uint32_t first = 0;  ///< the subtree's primitives in BinaryBvh::order
    uint32_t count = 0;  ///< a leaf has one; 0 only for an empty tree's root
    uint32_t height = 0; ///< of the subtree; a leaf has 0
    bool isLeaf() const { return left == 0; }
};

struct BinaryBvh {
    std::vector<BinaryNode> nodes; ///< root first; children come after their parent
    std::vector<uint32_t> order;   ///< every primitive once
};

/// Builds top-down to single primitives: splits go where the expected cost, area times primitives summed over both
/// sides, is least among up to 16 bins on each axis. Where the allowed height is nearly used up it halves by number,
/// which always fits. Wald 2007, "On Fast Construction of SAH-based Bounding Volume Hierarchies", IEEE Symposium on
/// Interactive Ray Tracing.
///
/// `boxes`      one a primitive, finite
/// `maxHeight`  of the tree; 2^maxHeight must be enough for all primitives
/// Cost: O(n log n), large subtrees on threads of their own.
BinaryBvh buildBinaryBvh(std::span<const Bounds> boxes, uint32_t maxHeight);

/// The heuristic's cost of a tree: expected tests of boxes and primitives of a long random ray that meets the root's
/// box.
double sahCost(const BinaryBvh& bvh);

} // namespace glint::rays
