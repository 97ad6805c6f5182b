// The barrier tracker against a model of Vulkan's own rules (Vulkan 1.3, chapter 7, "Synchronization and Cache
// Control"): a barrier orders the stages of its first scope before those of its second, barriers chain where the scopes
// meet, a write is available once a barrier names its stage and access, and visible to what a later barrier names. The
// model knows nothing of the tracker's shortcuts: it keeps every operation and every barrier of a sequence.
#include "gpu/sync.hpp"

#include <gtest/gtest.h>

#include <bitset>
#include <random>
#include <sstream>

namespace glint::gpu {
namespace sync_model_test {

constexpr VkAccessFlags2 kWriteAccess = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT |
                                        VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT |
                                        VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR;

std::vector<uint64_t> bitsOf(uint64_t mask) {
    std::vector<uint64_t> bits;
    for (uint64_t rest = mask; rest != 0; rest &= rest - 1)
        bits.push_back(rest & ~(rest - 1));
    return bits;
}

class Model {
public:
    explicit Model(VkImageLayout layout) : layout_(layout) {}

    /// Is `use` right if `barrier` (or nothing) precedes it? The first rule that it breaks, or "".
    std::string judge(const Use& use, const std::optional<Barrier>& barrier) const {
        Model next = *this;
        return next.add(use, barrier);
    }

    std::string add(const Use& use, const std::optional<Barrier>& barrier) {
        std::string wrong;
        if (barrier)
            wrong = addBarrier(use, *barrier);
        if (wrong.empty() && layout_ != use.layout)
            wrong = "used in another layout than it is in";
        if (!wrong.empty())
            return wrong;

        std::vector<size_t> own;
        for (uint64_t stage : bitsOf(use.stages)) {
            if (!visible(stage, use.access))
                return "the last write is not visible";
            if (use.writes)
                for (size_t reader : readers_)
                    if (!happensBefore(reader, stage))
                        return "a reader may still be reading";
            own.push_back(operations_.size());
            operations_.push_back({stage, use.access});
        }
        if (use.writes) {
            writers_ = own;
            transition_.reset();
            readers_.clear();
        } else {
            readers_.insert(readers_.end(), own.begin(), own.end());
        }
        return "";
    }

private:
    static constexpr size_t kMost = 512;
    struct Operation {
        uint64_t stage;
        uint64_t access;
    };
    struct Node {
        Barrier barrier;
        size_t operationsBefore;
        std::bitset<kMost> operations; ///< that happen before it
        std::bitset<kMost> nodes;      ///< itself, and barriers that happen before it
    };

    std::string addBarrier(const Use& use, const Barrier& barrier) {
        Node node = {barrier, operations_.size(), {}, {}};
        for (size_t i = 0; i < operations_.size(); ++i)
            if (operations_[i].stage & barrier.srcStages)
                node.operations.set(i);
        for (size_t i = 0; i < nodes_.size(); ++i)
            if (nodes_[i].barrier.dstStages & barrier.srcStages) { // a chain
                node.operations |= nodes_[i].operations;
                node.nodes |= nodes_[i].nodes;
            }
        node.nodes.set(nodes_.size());
        nodes_.push_back(node);

        const bool moves = barrier.oldLayout != barrier.newLayout;
        if (!moves)
            return "";
        if (barrier.newLayout != use.layout)
            return "moved into a layout that nobody asked for";
        if (barrier.oldLayout != layout_ && !(barrier.oldLayout == VK_IMAGE_LAYOUT_UNDEFINED && use.discards))
            return "moved from a layout that it is not in";
        // The transition reads and writes the whole image: all before it must be over, and written data available.
        for (size_t reader : readers_)
            if (!node.operations[reader])
                return "the transition may overtake a reader";
        for (size_t writer : writers_)
            if (!node.operations[writer] || !availableAt(writer, nodes_.back()))
                return "the transition may overtake a write";
        if (transition_ && !node.nodes[*transition_])
            return "the transition may overtake another";
        writers_.clear();
        readers_.clear();
        transition_ = nodes_.size() - 1;
        layout_ = barrier.newLayout;
        return "";
    }

    bool happensBefore(size_t operation, uint64_t stage) const {
        for (const Node& node : nodes_)
            if ((node.barrier.dstStages & stage) && node.operations[operation])
                return true;
        return false;
    }

    bool availableAt(size_t writer, const Node& at) const {
        const Operation& operation = operations_[writer];
        const uint64_t written = operation.access & kWriteAccess;
        for (size_t i = 0; i < nodes_.size(); ++i) {
            const Node& node = nodes_[i];
            if (at.nodes[i] && writer < node.operationsBefore && (node.barrier.srcStages & operation.stage) &&
                (written & ~node.barrier.srcAccess) == 0)
                return true;
        }
        return false;
    }

    bool visible(uint64_t stage, uint64_t access) const {
        const auto reaches = [&](uint64_t bit, const auto& available) {
            for (const Node& node : nodes_)
                if ((node.barrier.dstStages & stage) && (node.barrier.dstAccess & bit) && available(node))
                    return true;
            return false;
        };
        for (uint64_t bit : bitsOf(access)) {
            for (size_t writer : writers_)
                if (!reaches(bit, [&](const Node& node) { return availableAt(writer, node); }))
                    return false;
            if (transition_ && !reaches(bit, [&](const Node& node) { return node.nodes[*transition_]; }))
                return false;
        }
        return true;
    }

    VkImageLayout layout_;
    std::vector<Operation> operations_;
    std::vector<Node> nodes_;
    std::vector<size_t> writers_;      ///< the operations of the last write
    std::vector<size_t> readers_;      ///< since
    std::optional<size_t> transition_; ///< the last write was this barrier's change of layout
};

std::string describe(const Use& use) {
    std::ostringstream text;
    text << (use.writes ? "write" : "read") << (use.discards ? " (discard)" : "") << std::hex << " stages "
         << use.stages << " access " << use.access << std::dec << " layout " << use.layout;
    return text.str();
}

/// Uses as passes make them: each kind with its own stages, access and layout.
std::vector<Use> imageUses() {
    constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    constexpr VkPipelineStageFlags2 kFragment = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
    constexpr VkPipelineStageFlags2 kVertex = VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT;
    constexpr VkPipelineStageFlags2 kCopy = VK_PIPELINE_STAGE_2_COPY_BIT;
    constexpr VkPipelineStageFlags2 kColor = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    constexpr VkAccessFlags2 kSampled = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
    constexpr VkAccessFlags2 kLoad = VK_ACCESS_2_SHADER_STORAGE_READ_BIT;
    constexpr VkAccessFlags2 kStore = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
    constexpr VkImageLayout kReadOnly = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    constexpr VkImageLayout kGeneral = VK_IMAGE_LAYOUT_GENERAL;
    return {
        {kCompute, kSampled, kReadOnly, false, false},
        {kFragment, kSampled, kReadOnly, false, false},
        {kVertex | kFragment, kSampled, kReadOnly, false, false},
        {kFragment, VK_ACCESS_2_INPUT_ATTACHMENT_READ_BIT, kReadOnly, false, false},
        {kCompute, kLoad, kGeneral, false, false},
        {kFragment, kLoad, kGeneral, false, false},
        {kCompute, kStore, kGeneral, true, false},
        {kCompute, kStore, kGeneral, true, true},
        {kCompute, kLoad | kStore, kGeneral, true, false},
        {kVertex | kFragment, kLoad | kStore, kGeneral, true, false},
        {kColor, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, true, true},
        {kColor, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT,
         VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, true, false},
        {kCopy, VK_ACCESS_2_TRANSFER_READ_BIT, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, false, false},
        {kCopy, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, true, false},
        {kCopy, VK_ACCESS_2_TRANSFER_READ_BIT, kGeneral, false, false},
    };
}

std::vector<Use> bufferUses() {
    std::vector<Use> uses = imageUses();
    for (Use& use : uses) {
        use.layout = VK_IMAGE_LAYOUT_UNDEFINED;
        use.discards = false;
    }
    return uses;
}

/// What happens to the buffers of a ray scene: filled, read by builds, built, fitted, referred to and traced.
std::vector<Use> rayUses() {
    constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    return {
        {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_UNDEFINED, true, false},
        kBuildInput,
        kBuildReference,
        kBuildTarget,
        traversal(kCompute),
        traversal(kCompute | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT),
        {kCompute, VK_ACCESS_2_SHADER_STORAGE_READ_BIT, VK_IMAGE_LAYOUT_UNDEFINED, false, false},
        {kCompute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_IMAGE_LAYOUT_UNDEFINED, true, false},
    };
}

/// Runs the sequence through tracker and model; both must agree at every step, in both directions.
void check(const std::vector<Use>& sequence) {
    ResourceState state;
    Model model(state.layout);
    std::string history;
    for (const Use& use : sequence) {
        history += describe(use) + "\n";
        const bool needed = !model.judge(use, std::nullopt).empty();
        const std::optional<Barrier> barrier = transition(state, use);
        ASSERT_EQ(model.judge(use, barrier), "") << "after\n" << history;
        // A discard that keeps its layout may be dressed as a transition from nothing: that costs nothing more.
        ASSERT_EQ(barrier.has_value(), needed) << "a barrier that nothing needs, after\n" << history;
        model.add(use, barrier);
        ASSERT_EQ(state.layout, use.layout);
    }
}

TEST(SyncModel, everyPairAndTripleOfImageUses) {
    const std::vector<Use> uses = imageUses();
    for (const Use& first : uses)
        for (const Use& second : uses)
            for (const Use& third : uses) {
                check({first, second, third});
                if (HasFatalFailure())
                    return;
            }
}

TEST(SyncModel, everyPairAndTripleOfBufferUses) {
    const std::vector<Use> uses = bufferUses();
    for (const Use& first : uses)
        for (const Use& second : uses)
            for (const Use& third : uses) {
                check({first, second, third});
                if (HasFatalFailure())
                    return;
            }
}

TEST(SyncModel, everyPairAndTripleOfRaySceneUses) {
    const std::vector<Use> uses = rayUses();
    for (const Use& first : uses)
        for (const Use& second : uses)
            for (const Use& third : uses) {
                check({first, second, third});
                if (HasFatalFailure())
                    return;
            }
}

TEST(SyncModel, longRandomSequences) {
    std::mt19937 random(20240607);
    for (const std::vector<Use>& uses : {imageUses(), bufferUses(), rayUses()})
        for (int round = 0; round < 300; ++round) {
            // Some rounds draw from a few uses only: long runs of readers between rare writes.
            const size_t kinds = round % 3 == 0 ? uses.size() : 2 + random() % 4;
            std::vector<Use> palette;
            for (size_t i = 0; i < kinds; ++i)
                palette.push_back(uses[random() % uses.size()]);
            std::vector<Use> sequence;
            for (int i = 0; i < 40; ++i)
                sequence.push_back(palette[random() % palette.size()]);
            check(sequence);
            if (HasFatalFailure())
                return;
        }
}

TEST(SyncModel, theModelItselfSeesMissingBarriers) {
    const std::vector<Use> uses = bufferUses();
    const Use& store = uses[6];
    const Use& load = uses[4];
    Model model(VK_IMAGE_LAYOUT_UNDEFINED);
    EXPECT_EQ(model.add(store, std::nullopt), "");
    EXPECT_NE(model.judge(load, std::nullopt), "");
    EXPECT_NE(model.judge(store, std::nullopt), "");
    const Barrier noAccess = {store.stages, 0, load.stages, load.access};
    EXPECT_NE(model.judge(load, noAccess), "") << "ordered, but never made available";
    const Barrier right = {store.stages, store.access, load.stages, load.access};
    EXPECT_EQ(model.judge(load, right), "");
}

} // namespace sync_model_test
} // namespace glint::gpu
