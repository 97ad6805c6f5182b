// The hierarchy that shaders traverse (shared/bvh.h): the binary one with up to eight children a node, boxes in bytes.
#pragma once

#include "rays/binary_bvh.hpp"
#include "shared/bvh.h"

namespace glint::rays {

/// Node and primitive numbers count from this tree's own; BvhScene moves them to where it puts the tree.
struct WideBvh {
    std::vector<shared::BvhNode> nodes; ///< root first; children come after their parent
    std::vector<Bounds> bounds;         ///< of each node, as stated by its children
    std::vector<uint32_t> order;        ///< primitives as the leaves have them
    uint32_t levels = 0;                ///< of nodes
};

/// Cost of testing a node's eight boxes and of a primitive: what collapsing weighs.
constexpr float kNodeCost = 1;
constexpr float kPrimitiveCost = 0.5f;

/// Builds over `boxes` (one a primitive, finite) with at most `maxLeaf` (1 to kBvhPrimitivesPerSlot) primitives a slot
/// and at most `maxLevels` levels of nodes; 8^maxLevels must be enough. Without boxes: one node without children.
WideBvh buildWideBvh(std::span<const Bounds> boxes, uint32_t maxLeaf, uint32_t maxLevels);

/// Fits all boxes of the tree to the moved primitives; `boxes` as in buildWideBvh. Cost: O(n).
void refit(WideBvh& bvh, std::span<const Bounds> boxes);

/// The surface area heuristic's cost, with the exact boxes of nodes: tells when a fitted tree should be built anew.
double sahCost(const WideBvh& bvh, std::span<const Bounds> boxes);

} // namespace glint::rays
