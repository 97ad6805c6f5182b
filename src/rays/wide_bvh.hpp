// The hierarchy that shaders traverse (shared/bvh.h): the binary one collapsed to up to eight children per node, with
// boxes quantized to bytes.
#pragma once

#include "rays/binary_bvh.hpp"
#include "shared/bvh.h"

namespace glint::rays {

/// Node and primitive numbers are relative to this tree; BvhScene offsets them when it places the tree in its buffers.
struct WideBvh {
    std::vector<shared::BvhNode> nodes; ///< root first; children after their parent
    std::vector<Bounds> bounds;         ///< of each node, as its quantized children state them
    std::vector<uint32_t> order;        ///< primitives in leaf order
    uint32_t levels = 0;                ///< number of levels of nodes
};

/// Costs of testing a node's eight boxes and of testing a primitive, which collapsing minimizes.
constexpr float kNodeCost = 1;
constexpr float kPrimitiveCost = 0.5f;

/// Builds over `boxes` (one per primitive, finite) with at most `maxLeaf` (1 to kBvhPrimitivesPerSlot) primitives per
/// slot and at most `maxLevels` levels of nodes; 8^maxLevels must be at least the number of primitives. Without boxes
/// the tree is one node without children.
WideBvh buildWideBvh(std::span<const Bounds> boxes, uint32_t maxLeaf, uint32_t maxLevels);

/// Refits all boxes of the tree to the moved primitives; `boxes` as in buildWideBvh. Cost: O(n).
void refit(WideBvh& bvh, std::span<const Bounds> boxes);

/// Where the nodes and the primitives of a tree hang. Valid until the tree is built again.
struct BvhLinks {
    std::vector<uint32_t> parents; ///< by node; 0 for the root
    std::vector<uint32_t> leaves;  ///< by primitive: the node whose slot holds it
    std::vector<uint32_t> places;  ///< by primitive: its place in WideBvh::order
};
BvhLinks linksOf(const WideBvh& bvh);

/// Refits the boxes above these primitives alone: if all others keep theirs, the same result as refit of the whole
/// tree. Returns the nodes that were refitted.
std::vector<uint32_t> refit(WideBvh& bvh, const BvhLinks& links, std::span<const Bounds> boxes,
                            std::span<const uint32_t> primitives);

/// Returns the surface area heuristic's cost with the exact boxes of nodes. A refitted tree whose cost has grown should
/// be rebuilt.
double sahCost(const WideBvh& bvh, std::span<const Bounds> boxes);

} // namespace glint::rays
