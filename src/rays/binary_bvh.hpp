// A binary bounding volume hierarchy by the surface area heuristic, of bounded height. The wide hierarchy is built from
// it.
#pragma once

#include "rays/bounds.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace glint::rays {

struct BinaryNode {
    Bounds bounds;
    uint32_t left = 0;   ///< children at left and left + 1; 0: a leaf, as the root is never a child
    uint32_t first = 0;  ///< first primitive of the subtree in BinaryBvh::order
    uint32_t count = 0;  ///< primitives of the subtree; 1 for a leaf, 0 only for the root of an empty tree
    uint32_t height = 0; ///< of the subtree; a leaf has 0
    bool isLeaf() const { return left == 0; }
};

struct BinaryBvh {
    std::vector<BinaryNode> nodes; ///< root first; children after their parent
    std::vector<uint32_t> order;   ///< every primitive, once
};

/// Builds top-down to single primitives. A split minimizes the expected cost, area times primitives summed over both
/// sides, over up to 16 bins per axis. Where the allowed height is nearly used up, a node is halved by primitive count,
/// which always fits. Wald 2007, "On Fast Construction of SAH-based Bounding Volume Hierarchies", IEEE Symposium on
/// Interactive Ray Tracing.
///
/// `boxes`      one per primitive, finite
/// `maxHeight`  of the tree; 2^maxHeight must be at least the number of primitives
/// Cost: O(n log n); large subtrees are built on their own threads.
BinaryBvh buildBinaryBvh(std::span<const Bounds> boxes, uint32_t maxHeight);

/// Returns the heuristic's cost of a tree: the expected tests of boxes and primitives for a long random ray that
/// intersects the root's box.
double sahCost(const BinaryBvh& bvh);

} // namespace glint::rays
