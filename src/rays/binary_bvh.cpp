#include "rays/binary_bvh.hpp"

#include "base/assert.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <future>

namespace glint::rays {
namespace {

constexpr uint32_t kMostBins = 16;

constexpr uint32_t kWorthAThread = 20000; ///< primitives: about ten milliseconds of work
constexpr uint32_t kThreadedDepth = 5;    ///< at most 2^5 threads at once

struct Reference {
    Bounds bounds;
    uint32_t primitive = 0;
};

struct Split {
    float cost = std::numeric_limits<float>::infinity(); ///< area times primitives, summed over both sides
    int axis = -1;
    uint32_t bin = 0; ///< the first bin on the right side
};

/// Bins of centroids along an axis.
struct BinScale {
    float low = 0;
    float perUnit = 0;

    uint32_t bins = 0;

    BinScale(const Bounds& centroids, int axis, uint32_t count)
        : low(centroids.low[axis]), bins(std::min(kMostBins, 2 * count)) {
        perUnit = static_cast<float>(bins) / (centroids.high[axis] - centroids.low[axis]);
    }
    /// False for extents of 0, and for extents so small that the scale overflows.
    bool usable() const { return perUnit > 0 && std::isfinite(perUnit); }
    uint32_t binOf(const Reference& reference, int axis) const {
        const float place = (reference.bounds.center()[axis] - low) * perUnit;
        return std::min(static_cast<uint32_t>(std::max(place, 0.0f)), bins - 1);
    }
};

class Builder {
public:
    explicit Builder(std::span<const Bounds> boxes) {
        references_.reserve(boxes.size());
        for (uint32_t i = 0; i < boxes.size(); ++i)
            references_.push_back({boxes[i], i});
    }

    BinaryBvh build(uint32_t maxHeight) {
        const auto count = static_cast<uint32_t>(references_.size());
        bvh_.nodes.resize(count > 0 ? 2 * size_t{count} - 1 : 1); // down to single primitives
        fill({0, 1, 0, count, maxHeight}, 0);
        bvh_.order.reserve(count);
        for (const Reference& reference : references_)
            bvh_.order.push_back(reference.primitive);
        return std::move(bvh_);
    }

private:
    struct Subtree {
        uint32_t root;
        uint32_t nodes; ///< first of the 2 * count - 2 other nodes
        uint32_t first;
        uint32_t count;
        uint32_t maxHeight; ///< maximum depth of splits
    };

    std::span<Reference> part(uint32_t first, uint32_t count) { return std::span(references_).subspan(first, count); }

    /// Subtrees have separate nodes and references, so large ones are built in parallel; the result does not depend on
    /// it.
    void fill(const Subtree& tree, uint32_t depth) {
        Bounds bounds;
        Bounds centroids;
        for (const Reference& reference : part(tree.first, tree.count)) {
            bounds.add(reference.bounds);
            centroids.add(reference.bounds.center());
        }
        BinaryNode& node = bvh_.nodes[tree.root];
        node = {bounds, 0, tree.first, tree.count, 0};
        if (tree.count <= 1)
            return;
        const uint32_t onLeft = sortIntoSides(tree.first, tree.count, centroids, tree.maxHeight);
        node.left = tree.nodes;
        const Subtree left = {node.left, node.left + 2, tree.first, onLeft, tree.maxHeight - 1};
        const Subtree right = {node.left + 1, node.left + 2 * onLeft, tree.first + onLeft, tree.count - onLeft,
                               tree.maxHeight - 1};
        if (tree.count >= kWorthAThread && depth < kThreadedDepth) {
            // Deferred if the system cannot start a thread.
            auto other = std::async(std::launch::async | std::launch::deferred, [&] { fill(left, depth + 1); });
            fill(right, depth + 1);
            other.get();
        } else {
            fill(left, depth + 1);
            fill(right, depth + 1);
        }
        node.height = 1 + std::max(bvh_.nodes[left.root].height, bvh_.nodes[right.root].height);
    }

    /// Returns the number of primitives on the left.
    uint32_t sortIntoSides(uint32_t first, uint32_t count, const Bounds& centroids, uint32_t maxHeight) {
        // Halving by count needs this many levels. If no more are left, halving is the only choice.
        if (count == 2 || static_cast<uint32_t>(std::bit_width(count - 1)) >= maxHeight)
            return halve(first, count, centroids);
        const Split split = bestSplit(first, count, centroids);
        if (split.axis < 0)
            return halve(first, count, centroids);
        const BinScale scale(centroids, split.axis, count);
        const std::span<Reference> all = part(first, count);
        const auto middle = std::partition(all.begin(), all.end(), [&](const Reference& reference) {
            return scale.binOf(reference, split.axis) < split.bin;
        });
        return static_cast<uint32_t>(middle - all.begin());
    }

    Split bestSplit(uint32_t first, uint32_t count, const Bounds& centroids) {
        struct Bin {
            Bounds bounds;
            uint32_t count = 0;
        };
        std::array<std::array<Bin, kMostBins>, 3> bins;
        const std::array<BinScale, 3> scales = {BinScale(centroids, 0, count), BinScale(centroids, 1, count),
                                                BinScale(centroids, 2, count)};
        for (const Reference& reference : part(first, count))
            for (int axis = 0; axis < 3; ++axis)
                if (scales[axis].usable()) {
                    Bin& bin = bins[axis][scales[axis].binOf(reference, axis)];
                    bin.bounds.add(reference.bounds);
                    ++bin.count;
                }
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!scales[axis].usable())
                continue;
            std::array<float, kMostBins> rightCost = {}; // of bins i to the last
            Bounds side;
            uint32_t number = 0;
            for (uint32_t i = scales[axis].bins - 1; i > 0; --i) {
                side.add(bins[axis][i].bounds);
                number += bins[axis][i].count;
                rightCost[i] = side.halfArea() * static_cast<float>(number);
            }
            side = {};
            number = 0;
            for (uint32_t i = 1; i < scales[axis].bins; ++i) {
                side.add(bins[axis][i - 1].bounds);
                number += bins[axis][i - 1].count;
                const float cost = side.halfArea() * static_cast<float>(number) + rightCost[i];
                if (number > 0 && number < count && cost < best.cost)
                    best = {cost, axis, i};
            }
        }
        return best;
    }

    /// Splits at the median along the longest axis.
    uint32_t halve(uint32_t first, uint32_t count, const Bounds& centroids) {
        const glm::vec3 size = centroids.high - centroids.low;
        const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const std::span<Reference> all = part(first, count);
        const uint32_t middle = (count + 1) / 2;
        std::nth_element(all.begin(), all.begin() + middle, all.end(), [axis](const Reference& a, const Reference& b) {
            return a.bounds.center()[axis] < b.bounds.center()[axis];
        });
        return middle;
    }

    std::vector<Reference> references_;
    BinaryBvh bvh_;
};

} // namespace

BinaryBvh buildBinaryBvh(std::span<const Bounds> boxes, uint32_t maxHeight) {
    GLINT_ASSERT(boxes.size() <= uint64_t{1} << maxHeight, "{} primitives in {} levels", boxes.size(), maxHeight);
    return Builder(boxes).build(maxHeight);
}

double sahCost(const BinaryBvh& bvh) {
    double cost = 0;
    for (const BinaryNode& node : bvh.nodes)
        cost += static_cast<double>(node.bounds.halfArea());
    const double whole = static_cast<double>(bvh.nodes.front().bounds.halfArea());
    return whole > 0 ? cost / whole : 0;
}

} // namespace glint::rays
