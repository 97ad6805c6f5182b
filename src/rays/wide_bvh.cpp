#include "rays/wide_bvh.hpp"

#include "base/assert.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>

namespace glint::rays {
namespace {

constexpr uint32_t kSlots = 8;
constexpr uint32_t kMetaNode = 0x20;

using SlotBounds = std::array<Bounds, kSlots>;

uint32_t byteOf(const glm::uvec4& words, uint32_t word, uint32_t slot) {
    return words[static_cast<int>(word + slot / 4)] >> (8 * (slot % 4)) & 0xff;
}

uint32_t metaOf(const shared::BvhNode& node, uint32_t slot) {
    return byteOf(node.words[1], 2, slot);
}

bool isNode(const shared::BvhNode& node, uint32_t slot) {
    return (node.words[0].w >> (24 + slot) & 1) != 0;
}

uint32_t childNode(const shared::BvhNode& node, uint32_t slot) {
    return node.words[1].x + static_cast<uint32_t>(std::popcount(node.words[0].w >> 24 & ((1u << slot) - 1)));
}

void setByte(glm::uvec4& words, uint32_t word, uint32_t slot, uint32_t value) {
    words[static_cast<int>(word + slot / 4)] |= value << (8 * (slot % 4));
}

/// The grid of one axis: the exponent of the finest power of two of which 255 cells cover `size` from `low`, and the
/// cells of all slots. Cells are rounded outward, so that decoded boxes contain the given ones. In double precision,
/// where low + cell * n is exact enough for comparison.
class AxisGrid {
public:
    AxisGrid(double low, double high) : low_(low) {
        exponent_ = std::max(static_cast<int>(std::ceil(std::log2(std::max((high - low) / 255, 1e-37)))), -126);
        cell_ = std::ldexp(1.0, exponent_);
        if (std::ceil((high - low) / cell_) > 255)
            cell_ = std::ldexp(1.0, ++exponent_);
    }
    uint32_t biasedExponent() const { return static_cast<uint32_t>(exponent_ + 127); }
    uint32_t floorCell(double x) const {
        double n = std::floor((x - low_) / cell_);
        while (n > 0 && low_ + n * cell_ > x)
            --n;
        return static_cast<uint32_t>(std::clamp(n, 0.0, 255.0));
    }
    uint32_t ceilCell(double x) const {
        double n = std::ceil((x - low_) / cell_);
        while (n < 255 && low_ + n * cell_ < x)
            ++n;
        return static_cast<uint32_t>(std::clamp(n, 0.0, 255.0));
    }

private:
    double low_;
    double cell_ = 1;
    int exponent_ = 0;
};

/// Writes the node's grid and its children's boxes; other members do not change.
void quantize(shared::BvhNode& node, const SlotBounds& slots, const Bounds& whole) {
    const glm::vec3 low = whole.empty() ? glm::vec3(0) : whole.low;
    const glm::vec3 high = whole.empty() ? glm::vec3(0) : whole.high;
    for (int i = 2; i < 5; ++i)
        node.words[i] = glm::uvec4(0);
    node.words[0].w &= 0xff000000u;
    for (int axis = 0; axis < 3; ++axis) {
        const AxisGrid grid(static_cast<double>(low[axis]), static_cast<double>(high[axis]));
        node.words[0][axis] = std::bit_cast<uint32_t>(low[axis]);
        node.words[0].w |= grid.biasedExponent() << (8 * axis);
        for (uint32_t slot = 0; slot < kSlots; ++slot) {
            const bool used = metaOf(node, slot) != 0 && !slots[slot].empty();
            // An unused slot has an inverted box: a ray hardly ever intersects it, and it contains nothing.
            const uint32_t first = used ? grid.floorCell(static_cast<double>(slots[slot].low[axis])) : 255;
            const uint32_t last = used ? grid.ceilCell(static_cast<double>(slots[slot].high[axis])) : 0;
            constexpr std::array<std::array<uint32_t, 2>, 3> kLow = {{{2, 0}, {2, 2}, {3, 0}}};
            constexpr std::array<std::array<uint32_t, 2>, 3> kHigh = {{{3, 2}, {4, 0}, {4, 2}}};
            setByte(node.words[kLow[axis][0]], kLow[axis][1], slot, first);
            setByte(node.words[kHigh[axis][0]], kHigh[axis][1], slot, last);
        }
    }
}

/// Assigns each child to a slot by the corner that the child lies in, the most decided child first. Ylitie, Karras and
/// Laine 2017, section 3.2, solve the same assignment by auction.
std::array<int, kSlots> assignSlots(std::span<const Bounds> children, const glm::vec3& center) {
    std::array<int, kSlots> childAt;
    childAt.fill(-1);
    std::array<bool, kSlots> placed = {};
    for (size_t round = 0; round < children.size(); ++round) {
        float best = -std::numeric_limits<float>::infinity();
        size_t bestChild = 0;
        uint32_t bestSlot = 0;
        for (size_t child = 0; child < children.size(); ++child) {
            if (placed[child])
                continue;
            const glm::vec3 offset = children[child].center() - center;
            for (uint32_t slot = 0; slot < kSlots; ++slot) {
                const glm::vec3 corner(slot & 1 ? 1 : -1, slot & 2 ? 1 : -1, slot & 4 ? 1 : -1);
                if (const float gain = glm::dot(offset, corner); childAt[slot] < 0 && gain > best) {
                    best = gain;
                    bestChild = child;
                    bestSlot = slot;
                }
            }
        }
        childAt[bestSlot] = static_cast<int>(bestChild);
        placed[bestChild] = true;
    }
    return childAt;
}

/// Least cost of turning a binary subtree into at most i wide ones, for i up to 7, by dynamic programming from the
/// leaves up. Ylitie, Karras and Laine 2017, section 3.1.
class CollapseCosts {
public:
    CollapseCosts(const BinaryBvh& binary, uint32_t maxLeaf) : binary_(binary), maxLeaf_(maxLeaf) {
        costs_.resize(binary.nodes.size());
        for (size_t n = binary.nodes.size(); n-- > 0;) { // children are stored after their parents
            const BinaryNode& node = binary.nodes[n];
            std::array<float, kSlots - 1>& costs = costs_[n];
            const float asLeaf = node.count <= maxLeaf ? leafCost(node) : std::numeric_limits<float>::infinity();
            if (node.isLeaf()) {
                costs.fill(asLeaf);
                continue;
            }
            costs[0] = std::min(asLeaf, nodeCost(node));
            for (uint32_t i = 2; i < kSlots; ++i)
                costs[i - 1] = std::min(costs[i - 2], bestShare(node, i).cost);
        }
    }

    bool isCheapestAsLeaf(const BinaryNode& node) const {
        return node.count <= maxLeaf_ && (node.isLeaf() || leafCost(node) <= nodeCost(node));
    }

    /// Appends the binary nodes that become the children of `root`.
    void appendChildren(const BinaryNode& root, std::vector<uint32_t>& children) const {
        appendShares(root, kSlots, children);
    }

private:
    struct Share {
        float cost = std::numeric_limits<float>::infinity();
        uint32_t left = 1; ///< slots for the left child
    };

    float leafCost(const BinaryNode& node) const {
        return node.bounds.halfArea() * static_cast<float>(node.count) * kPrimitiveCost;
    }
    float nodeCost(const BinaryNode& node) const {
        return bestShare(node, kSlots).cost + node.bounds.halfArea() * kNodeCost;
    }
    /// Returns the cheapest division of `slots` between the two children.
    Share bestShare(const BinaryNode& node, uint32_t slots) const {
        Share best;
        for (uint32_t left = 1; left < slots; ++left) {
            const float cost = costs_[node.left][left - 1] + costs_[node.left + 1][slots - left - 1];
            if (cost < best.cost)
                best = {cost, left};
        }
        return best;
    }
    void appendShares(const BinaryNode& node, uint32_t slots, std::vector<uint32_t>& children) const {
        const Share share = bestShare(node, slots);
        append(node.left, share.left, children);
        append(node.left + 1, slots - share.left, children);
    }
    void append(uint32_t index, uint32_t slots, std::vector<uint32_t>& children) const {
        const std::array<float, kSlots - 1>& costs = costs_[index];
        while (slots > 1 && !(costs[slots - 1] < costs[slots - 2]))
            --slots; // more would not help
        if (slots == 1)
            children.push_back(index);
        else
            appendShares(binary_.nodes[index], slots, children);
    }

    const BinaryBvh& binary_;
    uint32_t maxLeaf_;
    std::vector<std::array<float, kSlots - 1>> costs_;
};

class Collapse {
public:
    Collapse(const BinaryBvh& binary, uint32_t maxLeaf, WideBvh& wide)
        : binary_(binary), costs_(binary, maxLeaf), maxLeaf_(maxLeaf), wide_(wide) {}

    void run(uint32_t maxLevels) {
        wide_.nodes.resize(1);
        wide_.bounds.resize(1);
        wide_.order.reserve(binary_.order.size());
        fill(0, 0, maxLevels, 1);
    }

private:
    /// A wide level holds three binary levels: a subtree of at most this height fits into the remaining levels,
    /// whichever nodes are opened.
    static uint32_t heightFor(uint32_t levels) { return 3 * levels; }

    std::vector<uint32_t> chooseChildren(uint32_t index, uint32_t levels) const {
        const BinaryNode& root = binary_.nodes[index];
        if (root.isLeaf())
            return {index};
        std::vector<uint32_t> children;
        if (root.height <= heightFor(levels - 1))
            costs_.appendChildren(root, children);
        else
            openTheHighest(index, heightFor(levels - 1), children);
        return children;
    }

    /// Used where levels are scarce: opens every subtree higher than `most`. With a root of height at most most + 3,
    /// all of them lie in its first three levels, so eight children are enough.
    void openTheHighest(uint32_t index, uint32_t most, std::vector<uint32_t>& children) const {
        const BinaryNode& node = binary_.nodes[index];
        if (node.height <= most || node.count <= maxLeaf_) {
            children.push_back(index);
            return;
        }
        openTheHighest(node.left, most, children);
        openTheHighest(node.left + 1, most, children);
    }

    void fill(uint32_t wideNode, uint32_t binaryNode, uint32_t levels, uint32_t level) {
        GLINT_ASSERT(levels > 0, "the wide hierarchy grew deeper than its stack");
        wide_.levels = std::max(wide_.levels, level);
        const BinaryNode& root = binary_.nodes[binaryNode];
        if (root.count == 0) {
            wide_.nodes[wideNode] = {};
            quantize(wide_.nodes[wideNode], {}, {});
            return;
        }
        const std::vector<uint32_t> children = chooseChildren(binaryNode, levels);
        std::vector<Bounds> boxes;
        for (const uint32_t child : children)
            boxes.push_back(binary_.nodes[child].bounds);
        const std::array<int, kSlots> childAt = assignSlots(boxes, root.bounds.center());

        shared::BvhNode node = {};
        SlotBounds slots;
        std::vector<uint32_t> inner;
        node.words[1].x = static_cast<uint32_t>(wide_.nodes.size());
        node.words[1].y = static_cast<uint32_t>(wide_.order.size());
        for (uint32_t slot = 0; slot < kSlots; ++slot) {
            if (childAt[slot] < 0)
                continue;
            const uint32_t index = children[childAt[slot]];
            const BinaryNode& child = binary_.nodes[index];
            slots[slot] = child.bounds;
            if (child.count <= maxLeaf_ && (levels == 1 || costs_.isCheapestAsLeaf(child))) {
                const uint32_t offset = static_cast<uint32_t>(wide_.order.size()) - node.words[1].y;
                setByte(node.words[1], 2, slot, ((1u << child.count) - 1) << 5 | offset);
                const auto first = binary_.order.begin() + child.first;
                wide_.order.insert(wide_.order.end(), first, first + child.count);
            } else {
                setByte(node.words[1], 2, slot, kMetaNode);
                node.words[0].w |= 1u << (24 + slot);
                inner.push_back(index);
            }
        }
        quantize(node, slots, root.bounds);
        wide_.nodes[wideNode] = node;
        wide_.bounds[wideNode] = root.bounds;
        wide_.nodes.resize(wide_.nodes.size() + inner.size());
        wide_.bounds.resize(wide_.nodes.size());
        for (uint32_t i = 0; i < inner.size(); ++i)
            fill(node.words[1].x + i, inner[i], levels - 1, level + 1);
    }

    const BinaryBvh& binary_;
    CollapseCosts costs_;
    uint32_t maxLeaf_;
    WideBvh& wide_;
};

/// Calls `visit(slot, box)` with the exact box of each used slot.
template <class Visit>
void visitSlots(const WideBvh& bvh, size_t index, std::span<const Bounds> boxes, Visit visit) {
    const shared::BvhNode& node = bvh.nodes[index];
    for (uint32_t slot = 0; slot < kSlots; ++slot) {
        const uint32_t meta = metaOf(node, slot);
        if (meta == 0)
            continue;
        Bounds box;
        uint32_t primitives = 0;
        if (isNode(node, slot)) {
            box = bvh.bounds[childNode(node, slot)];
        } else {
            for (uint32_t bits = meta >> 5; bits != 0; bits &= bits - 1)
                box.add(boxes[bvh.order[node.words[1].y + (meta & 31) + primitives++]]);
        }
        visit(slot, box, primitives);
    }
}

void refitNode(WideBvh& bvh, size_t index, std::span<const Bounds> boxes) {
    SlotBounds slots;
    Bounds whole;
    visitSlots(bvh, index, boxes, [&](uint32_t slot, const Bounds& box, uint32_t) {
        slots[slot] = box;
        whole.add(box);
    });
    bvh.bounds[index] = whole;
    quantize(bvh.nodes[index], slots, whole);
}

} // namespace

WideBvh buildWideBvh(std::span<const Bounds> boxes, uint32_t maxLeaf, uint32_t maxLevels) {
    GLINT_ASSERT(maxLeaf >= 1 && maxLeaf <= shared::kBvhPrimitivesPerSlot, "{} primitives a slot", maxLeaf);
    WideBvh wide;
    const BinaryBvh binary = buildBinaryBvh(boxes, 3 * maxLevels);
    Collapse(binary, maxLeaf, wide).run(maxLevels);
    return wide;
}

void refit(WideBvh& bvh, std::span<const Bounds> boxes) {
    for (size_t i = bvh.nodes.size(); i-- > 0;) // children are stored after their parents
        refitNode(bvh, i, boxes);
}

BvhLinks linksOf(const WideBvh& bvh) {
    BvhLinks links;
    links.parents.resize(bvh.nodes.size());
    links.leaves.resize(bvh.order.size());
    links.places.resize(bvh.order.size());
    for (uint32_t i = 0; i < bvh.nodes.size(); ++i) {
        const shared::BvhNode& node = bvh.nodes[i];
        for (uint32_t slot = 0; slot < kSlots; ++slot) {
            const uint32_t meta = metaOf(node, slot);
            if (isNode(node, slot))
                links.parents[childNode(node, slot)] = i;
            else if (meta != 0)
                for (int k = 0; k < std::popcount(meta >> 5); ++k) {
                    const uint32_t place = node.words[1].y + (meta & 31) + static_cast<uint32_t>(k);
                    links.leaves[bvh.order[place]] = i;
                    links.places[bvh.order[place]] = place;
                }
        }
    }
    return links;
}

std::vector<uint32_t> refit(WideBvh& bvh, const BvhLinks& links, std::span<const Bounds> boxes,
                            std::span<const uint32_t> primitives) {
    std::vector<bool> found(bvh.nodes.size());
    std::vector<uint32_t> nodes;
    const auto add = [&](uint32_t node) {
        const bool isNew = !found[node];
        if (isNew)
            nodes.push_back(node);
        found[node] = true;
        return isNew;
    };
    for (const uint32_t primitive : primitives)
        for (uint32_t node = links.leaves[primitive]; add(node) && node != 0;)
            node = links.parents[node];
    std::ranges::sort(nodes, std::greater()); // children are stored after their parents
    for (const uint32_t node : nodes)
        refitNode(bvh, node, boxes);
    return nodes;
}

double sahCost(const WideBvh& bvh, std::span<const Bounds> boxes) {
    double cost = 0;
    for (size_t i = 0; i < bvh.nodes.size(); ++i) {
        cost += static_cast<double>(kNodeCost) * static_cast<double>(bvh.bounds[i].halfArea());
        visitSlots(bvh, i, boxes, [&](uint32_t, const Bounds& box, uint32_t primitives) {
            cost += static_cast<double>(kPrimitiveCost) * static_cast<double>(box.halfArea()) * primitives;
        });
    }
    const double whole = static_cast<double>(bvh.bounds.front().halfArea());
    return whole > 0 ? cost / whole : 0;
}

} // namespace glint::rays
