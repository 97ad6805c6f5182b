// The hierarchy's builder: every primitive reachable once, every stated box around what is below it, a bounded depth,
// a cost not worse than halving by number.
#include "rays/wide_bvh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <random>

namespace glint::rays {
namespace wide_bvh_test {

/// A slot as shared/bvh.h describes it, decoded in double precision: independent of the builder's own code.
struct Slot {
    bool used = false;
    bool node = false;
    uint32_t child = 0; ///< node
    uint32_t first = 0; ///< primitives: place in the order
    uint32_t count = 0;
    glm::dvec3 low = {};
    glm::dvec3 high = {};
};

uint32_t byteAt(const shared::BvhNode& node, uint32_t byte) {
    return node.words[byte / 16][static_cast<int>(byte % 16 / 4)] >> (8 * (byte % 4)) & 0xff;
}

Slot decode(const shared::BvhNode& node, uint32_t slot) {
    Slot out;
    const uint32_t meta = byteAt(node, 24 + slot);
    const uint32_t nodes = node.words[0].w >> 24;
    out.used = meta != 0;
    out.node = (nodes >> slot & 1) != 0;
    EXPECT_TRUE(!out.node || meta == 0x20) << "the node bit and the slot's byte disagree";
    out.child = node.words[1].x + static_cast<uint32_t>(std::popcount(nodes & ((1u << slot) - 1)));
    out.first = node.words[1].y + (meta & 31);
    out.count = static_cast<uint32_t>(std::popcount(meta >> 5));
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = static_cast<double>(std::bit_cast<float>(node.words[0][axis]));
        const double cell = std::ldexp(1.0, static_cast<int>(byteAt(node, 12 + axis)) - 127);
        const auto n = [&](uint32_t half) { return byteAt(node, 32 + 24 * half + 8 * axis + slot); };
        out.low[axis] = origin + cell * n(0);
        out.high[axis] = origin + cell * n(1);
    }
    return out;
}

std::vector<Bounds> randomBoxes(uint32_t seed, size_t count, float spread = 10, float size = 0.2f) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(-1, 1);
    std::vector<Bounds> boxes(count);
    for (Bounds& box : boxes) {
        const glm::vec3 center = glm::vec3(unit(random), unit(random), unit(random)) * spread;
        for (int i = 0; i < 3; ++i)
            box.add(center + glm::vec3(unit(random), unit(random), unit(random)) * size);
    }
    return boxes;
}

void expectContains(const Slot& slot, const Bounds& box) {
    for (int axis = 0; axis < 3; ++axis) {
        ASSERT_LE(slot.low[axis], static_cast<double>(box.low[axis]));
        ASSERT_GE(slot.high[axis], static_cast<double>(box.high[axis]));
    }
}

/// Walks the tree; adds what it meets to `seen` and returns the box of it all.
Bounds walk(const WideBvh& bvh, const std::vector<Bounds>& boxes, uint32_t node, uint32_t level, uint32_t maxLevels,
            std::vector<uint32_t>& seen) {
    EXPECT_LE(level, maxLevels);
    Bounds whole;
    for (uint32_t i = 0; i < 8; ++i) {
        const Slot slot = decode(bvh.nodes[node], i);
        if (!slot.used)
            continue;
        Bounds below;
        if (slot.node) {
            EXPECT_GT(slot.child, node) << "refit goes from the last node to the first";
            below = walk(bvh, boxes, slot.child, level + 1, maxLevels, seen);
        } else {
            for (uint32_t p = 0; p < slot.count; ++p) {
                const uint32_t primitive = bvh.order[slot.first + p];
                seen.push_back(primitive);
                below.add(boxes[primitive]);
            }
        }
        expectContains(slot, below);
        whole.add(below);
    }
    EXPECT_EQ(bvh.bounds[node].low, whole.low);
    EXPECT_EQ(bvh.bounds[node].high, whole.high);
    return whole;
}

void expectSound(const WideBvh& bvh, const std::vector<Bounds>& boxes, uint32_t maxLevels) {
    std::vector<uint32_t> seen;
    walk(bvh, boxes, 0, 1, maxLevels, seen);
    std::sort(seen.begin(), seen.end());
    std::vector<uint32_t> all(boxes.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(seen, all) << "every primitive exactly once";
}

TEST(WideBvh, everyPrimitiveIsReachableOnceAndInsideOfEveryBoxAbove) {
    for (const size_t count : {1, 2, 3, 4, 7, 8, 9, 24, 25, 100, 1000, 20000}) {
        const std::vector<Bounds> boxes = randomBoxes(3, count);
        for (const uint32_t leaf : {1u, 3u}) {
            SCOPED_TRACE(testing::Message() << count << " boxes, " << leaf << " a leaf");
            expectSound(buildWideBvh(boxes, leaf, shared::kBvhMeshLevels), boxes, shared::kBvhMeshLevels);
        }
    }
}

TEST(WideBvh, withoutPrimitivesIsOneNodeWithoutChildren) {
    const WideBvh bvh = buildWideBvh({}, 3, shared::kBvhMeshLevels);
    ASSERT_EQ(bvh.nodes.size(), 1u);
    for (uint32_t slot = 0; slot < 8; ++slot)
        EXPECT_FALSE(decode(bvh.nodes[0], slot).used);
    EXPECT_TRUE(bvh.bounds[0].empty());
}

TEST(WideBvh, depthIsBoundedWhateverTheInput) {
    // Each box half as large and half as far as the one before: the heuristic alone would cut off one at a time.
    std::vector<Bounds> boxes;
    for (int i = 0; i < 3000; ++i) {
        const float x = std::ldexp(1.0f, -i % 120);
        boxes.push_back({glm::vec3(x, 0, 0), glm::vec3(x * 1.5f, x, x)});
    }
    for (const uint32_t levels : {4u, 5u, 8u, 16u}) {
        SCOPED_TRACE(levels);
        expectSound(buildWideBvh(boxes, 3, levels), boxes, levels);
    }
    // As many as fit: 8^4 slots of one.
    const std::vector<Bounds> full = randomBoxes(5, 4096);
    expectSound(buildWideBvh(full, 1, 4), full, 4);
}

TEST(WideBvh, equalAndDegenerateAndHugeBoxesAreFine) {
    std::vector<Bounds> equal(5000, Bounds{glm::vec3(1), glm::vec3(2)});
    expectSound(buildWideBvh(equal, 3, 16), equal, 16);
    std::vector<Bounds> points(5000, Bounds{glm::vec3(-3), glm::vec3(-3)});
    expectSound(buildWideBvh(points, 3, 16), points, 16);
    std::vector<Bounds> extreme = randomBoxes(7, 500, 9e17f, 1e17f);
    extreme.push_back({glm::vec3(1e-30f), glm::vec3(2e-30f)});
    expectSound(buildWideBvh(extreme, 3, 16), extreme, 16);
    const std::vector<Bounds> far = [] {
        std::vector<Bounds> boxes = randomBoxes(8, 500, 1e-3f, 1e-4f);
        for (Bounds& box : boxes) {
            box.low += 1e5f;
            box.high += 1e5f;
        }
        return boxes;
    }();
    expectSound(buildWideBvh(far, 3, 16), far, 16);
}

TEST(WideBvh, refitMovesEveryBox) {
    std::vector<Bounds> boxes = randomBoxes(11, 3000);
    WideBvh bvh = buildWideBvh(boxes, 3, 16);
    const double before = sahCost(bvh, boxes);
    refit(bvh, boxes);
    expectSound(bvh, boxes, 16);
    EXPECT_NEAR(sahCost(bvh, boxes), before, 1e-6 * before) << "nothing has moved";
    const std::vector<Bounds> moved = randomBoxes(12, 3000, 100, 1);
    refit(bvh, moved);
    expectSound(bvh, moved, 16);
    EXPECT_GT(sahCost(bvh, moved), 3 * before) << "a tree of other places is a bad one, and says so";
}

/// Halving by number along the longest axis.
double medianSplitCost(std::vector<Bounds> boxes, size_t first, size_t count, const Bounds& root) {
    Bounds bounds;
    for (size_t i = first; i < first + count; ++i)
        bounds.add(boxes[i]);
    const double share = static_cast<double>(bounds.halfArea()) / static_cast<double>(root.halfArea());
    if (count == 1)
        return share;
    const glm::vec3 size = bounds.high - bounds.low;
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    std::vector<Bounds> part(boxes.begin() + first, boxes.begin() + first + count);
    std::sort(part.begin(), part.end(),
              [axis](const Bounds& a, const Bounds& b) { return a.center()[axis] < b.center()[axis]; });
    return share + medianSplitCost(part, 0, count / 2, root) +
           medianSplitCost(part, count / 2, count - count / 2, root);
}

TEST(BinaryBvh, costsLessThanHalvingByNumber) {
    // Evenly spread, and as scenes are: small things crowded in a few places among large ones.
    std::vector<Bounds> crowded = randomBoxes(21, 200, 10, 5);
    for (uint32_t i = 0; i < 8; ++i)
        for (Bounds box : randomBoxes(30 + i, 400, 0.3f, 0.05f)) {
            const glm::vec3 place(std::cos(float(i)) * 8, std::sin(float(i)) * 8, float(i));
            box.low += place;
            box.high += place;
            crowded.push_back(box);
        }
    for (const auto& [boxes, factor] : {std::pair{randomBoxes(20, 4000), 1.0}, std::pair{crowded, 0.8}}) {
        const BinaryBvh bvh = buildBinaryBvh(boxes, 48);
        const double median = medianSplitCost(boxes, 0, boxes.size(), bvh.nodes.front().bounds);
        EXPECT_LT(sahCost(bvh), factor * median);
    }
}

/// Refitting the boxes above some primitives gives the bits of refitting all, and touches few nodes.
TEST(WideBvh, aPartIsRefittedAsTheWhole) {
    std::vector<Bounds> boxes = randomBoxes(5, 20000);
    WideBvh part = buildWideBvh(boxes, 1, shared::kBvhTopLevels);
    WideBvh whole = part;
    const BvhLinks links = linksOf(part);
    for (uint32_t place = 0; place < part.order.size(); ++place)
        ASSERT_EQ(links.places[part.order[place]], place);
    std::mt19937 random(9);
    for (const size_t count : {1, 7, 200, 20000}) {
        std::vector<uint32_t> moved;
        for (size_t i = 0; i < count; ++i) {
            const uint32_t primitive = static_cast<uint32_t>(random() % boxes.size());
            const Bounds before = boxes[primitive];
            boxes[primitive] = {};
            boxes[primitive].add(before.low + glm::vec3(0.5f, 0, -0.25f));
            boxes[primitive].add(before.high + glm::vec3(0.5f, 0.1f, -0.25f));
            moved.push_back(primitive);
        }
        const std::vector<uint32_t> nodes = refit(part, links, boxes, moved);
        EXPECT_LE(nodes.size(), count * shared::kBvhTopLevels);
        refit(whole, boxes);
        EXPECT_EQ(part.bounds.front().low, whole.bounds.front().low);
        for (size_t i = 0; i < whole.nodes.size(); ++i)
            for (int word = 0; word < 5; ++word)
                ASSERT_EQ(part.nodes[i].words[word], whole.nodes[i].words[word]) << count << " moved, node " << i;
        expectSound(part, boxes, shared::kBvhTopLevels);
    }
    EXPECT_TRUE(refit(part, links, boxes, std::span<const uint32_t>()).empty());
}

} // namespace wide_bvh_test
} // namespace glint::rays
