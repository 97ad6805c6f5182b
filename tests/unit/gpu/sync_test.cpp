// The barrier tracker by cases: what each pair of uses needs, and what the state says afterwards.
// sync_model_test.cpp holds long sequences against a model of Vulkan's ordering and visibility.
#include "gpu/sync.hpp"

#include <gtest/gtest.h>

namespace glint::gpu {
namespace sync_test {

constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags2 kFragment = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
constexpr VkPipelineStageFlags2 kTransfer = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
constexpr VkAccessFlags2 kSampled = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
constexpr VkAccessFlags2 kUniform = VK_ACCESS_2_UNIFORM_READ_BIT;
constexpr VkAccessFlags2 kStore = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
constexpr VkImageLayout kReadOnly = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
constexpr VkImageLayout kGeneral = VK_IMAGE_LAYOUT_GENERAL;
constexpr VkImageLayout kNone = VK_IMAGE_LAYOUT_UNDEFINED;

Use read(VkPipelineStageFlags2 stages, VkAccessFlags2 access, VkImageLayout layout = kNone) {
    return {stages, access, layout, false, false};
}
Use write(VkPipelineStageFlags2 stages, VkAccessFlags2 access, VkImageLayout layout = kNone, bool discards = false) {
    return {stages, access, layout, true, discards};
}

TEST(Sync, firstUseOfABufferNeedsNothing) {
    ResourceState state;
    EXPECT_FALSE(transition(state, read(kCompute, kUniform)));
    EXPECT_FALSE(transition(state, read(kFragment, kSampled)));
    ResourceState other;
    EXPECT_FALSE(transition(other, write(kCompute, kStore)));
}

TEST(Sync, firstUseOfAnImageMovesItIntoItsLayout) {
    ResourceState state;
    const auto barrier = transition(state, write(kCompute, kStore, kGeneral));
    ASSERT_TRUE(barrier);
    EXPECT_EQ(*barrier, (Barrier{0, 0, kCompute, kStore, kNone, kGeneral}));
}

TEST(Sync, readAfterWriteWaitsForTheWriteAndMakesItVisible) {
    ResourceState state;
    transition(state, write(kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT));
    const auto barrier = transition(state, read(kCompute, kUniform));
    ASSERT_TRUE(barrier);
    EXPECT_EQ(*barrier, (Barrier{kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT, kCompute, kUniform, kNone, kNone}));
}

TEST(Sync, readAfterReadNeedsNothingOnceVisible) {
    ResourceState state;
    transition(state, write(kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT));
    EXPECT_TRUE(transition(state, read(kCompute, kUniform)));
    EXPECT_FALSE(transition(state, read(kCompute, kUniform)));
    EXPECT_FALSE(transition(state, read(kCompute, kUniform)));
}

TEST(Sync, anotherReadersStageIsMadeVisibleFromTheWriteNotFromTheReader) {
    ResourceState state;
    transition(state, write(kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT));
    transition(state, read(kCompute, kUniform));
    const auto barrier = transition(state, read(kFragment, kUniform));
    ASSERT_TRUE(barrier);
    EXPECT_EQ(barrier->srcStages, kTransfer);
    EXPECT_EQ(barrier->srcAccess, VK_ACCESS_2_TRANSFER_WRITE_BIT);
    EXPECT_EQ(barrier->dstStages & kFragment, kFragment);
    EXPECT_EQ(barrier->dstAccess, kUniform);
}

// Stages and access are kept as two sets. (compute, uniform) and (fragment, sampled) having been made visible does not
// make (compute, sampled) visible, so the second barrier must cover the product before the tracker may believe it.
TEST(Sync, visibilityIsOfTheProductOfStagesAndAccess) {
    ResourceState state;
    transition(state, write(kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT));
    transition(state, read(kCompute, kUniform));
    const auto second = transition(state, read(kFragment, kSampled));
    ASSERT_TRUE(second);
    const auto third = transition(state, read(kCompute, kSampled));
    const bool secondCovers = (second->dstStages & kCompute) && (second->dstAccess & kSampled);
    const bool thirdCovers = third && (third->dstStages & kCompute) && (third->dstAccess & kSampled);
    EXPECT_TRUE(secondCovers || thirdCovers);
}

TEST(Sync, writeAfterReadWaitsForEveryReader) {
    ResourceState state;
    transition(state, read(kCompute, kUniform));
    transition(state, read(kFragment, kSampled));
    const auto barrier = transition(state, write(kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT));
    ASSERT_TRUE(barrier);
    EXPECT_EQ(barrier->srcStages, kCompute | kFragment);
    EXPECT_EQ(barrier->srcAccess, 0u) << "readers have nothing to make available";
    EXPECT_EQ(barrier->dstStages, kTransfer);
}

TEST(Sync, writeAfterWriteIsOrderedAndMadeAvailable) {
    ResourceState state;
    transition(state, write(kCompute, kStore));
    const auto barrier = transition(state, write(kCompute, kStore));
    ASSERT_TRUE(barrier) << "dispatch to dispatch on one storage buffer";
    EXPECT_EQ(*barrier, (Barrier{kCompute, kStore, kCompute, kStore, kNone, kNone}));
}

TEST(Sync, aWriteForgetsTheReadersBeforeIt) {
    ResourceState state;
    transition(state, write(kCompute, kStore));
    transition(state, read(kFragment, kSampled));
    transition(state, write(kCompute, kStore));
    const auto barrier = transition(state, read(kFragment, kSampled));
    ASSERT_TRUE(barrier) << "what was visible before the second write no longer is";
    EXPECT_EQ(barrier->srcStages, kCompute);
    EXPECT_EQ(barrier->srcAccess, kStore);
}

TEST(Sync, anotherLayoutIsAWriteForReadersToo) {
    ResourceState state;
    transition(state, write(kCompute, kStore, kGeneral));
    const auto toSampled = transition(state, read(kCompute, kSampled, kReadOnly));
    ASSERT_TRUE(toSampled);
    EXPECT_EQ(*toSampled, (Barrier{kCompute, kStore, kCompute, kSampled, kGeneral, kReadOnly}));
    EXPECT_FALSE(transition(state, read(kCompute, kSampled, kReadOnly)));

    const auto otherStage = transition(state, read(kFragment, kSampled, kReadOnly));
    ASSERT_TRUE(otherStage) << "the transition was ordered before compute alone";
    EXPECT_EQ(otherStage->srcStages, kCompute) << "chained behind the transition";
    EXPECT_EQ(otherStage->oldLayout, otherStage->newLayout) << "no second transition";
    EXPECT_EQ(otherStage->dstStages & kFragment, kFragment);
}

TEST(Sync, aLayoutChangeWaitsForReadersOfTheOldLayout) {
    ResourceState state;
    state.layout = kReadOnly;
    transition(state, read(kCompute, kSampled, kReadOnly));
    transition(state, read(kFragment, kSampled, kReadOnly));
    const auto barrier =
        transition(state, read(kTransfer, VK_ACCESS_2_TRANSFER_READ_BIT, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL));
    ASSERT_TRUE(barrier);
    EXPECT_EQ(barrier->srcStages, kCompute | kFragment);
    EXPECT_EQ(barrier->oldLayout, kReadOnly);
}

TEST(Sync, aDiscardThrowsTheContentAwayButNotTheOrder) {
    ResourceState state;
    state.layout = kReadOnly;
    transition(state, read(kFragment, kSampled, kReadOnly));
    const auto barrier = transition(state, write(kCompute, kStore, kGeneral, true));
    ASSERT_TRUE(barrier);
    EXPECT_EQ(barrier->oldLayout, kNone);
    EXPECT_EQ(barrier->newLayout, kGeneral);
    EXPECT_EQ(barrier->srcStages, kFragment);
    EXPECT_EQ(state.layout, kGeneral);
}

TEST(Sync, withoutDiscardTheContentIsKept) {
    ResourceState state;
    transition(state, write(kCompute, kStore, kGeneral));
    const auto barrier =
        transition(state, write(kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL));
    ASSERT_TRUE(barrier);
    EXPECT_EQ(barrier->oldLayout, kGeneral);
}

TEST(Sync, aHostsStateIsWaitedForAsItSaysIt) {
    ResourceState state;
    state.writeStages = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    state.writeAccess = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    state.layout = kReadOnly;
    const auto barrier = transition(state, read(kCompute, kSampled, kReadOnly));
    ASSERT_TRUE(barrier);
    EXPECT_EQ(*barrier, (Barrier{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                 VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, kCompute, kSampled, kReadOnly, kReadOnly}));
}

// A frame of rays: bottom level built, read by the top level's build and by the shader, fitted while the shader may
// still be reading.
TEST(Sync, aBottomLevelIsVisibleToTheTopLevelsBuildAndToTheShader) {
    constexpr VkPipelineStageFlags2 kBuild = VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR;
    constexpr VkAccessFlags2 kRead = VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR;
    constexpr VkAccessFlags2 kReadWrite = kRead | VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR;
    ResourceState state;
    EXPECT_FALSE(transition(state, kBuildTarget));
    EXPECT_EQ(transition(state, kBuildReference), (Barrier{kBuild, kReadWrite, kBuild, kRead, kNone, kNone}));
    EXPECT_EQ(transition(state, traversal(kCompute)),
              (Barrier{kBuild, kReadWrite, kBuild | kCompute, kRead, kNone, kNone}));
    EXPECT_FALSE(transition(state, traversal(kCompute)));
    EXPECT_EQ(transition(state, kBuildTarget),
              (Barrier{kBuild | kCompute, kReadWrite, kBuild, kReadWrite, kNone, kNone}))
        << "the fitting waits for the shader";
}

TEST(Sync, buildsThatShareScratchMemoryAreOrdered) {
    constexpr VkPipelineStageFlags2 kBuild = VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR;
    ResourceState scratch;
    EXPECT_FALSE(transition(scratch, kBuildTarget));
    EXPECT_EQ(transition(scratch, kBuildTarget),
              (Barrier{kBuild, kBuildTarget.access, kBuild, kBuildTarget.access, kNone, kNone}));
}

TEST(Sync, verticesAreVisibleToTheBuildAsShaderReads) {
    ResourceState positions;
    transition(positions, write(kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT));
    EXPECT_EQ(transition(positions, kBuildInput), (Barrier{kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                                           VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
                                                           VK_ACCESS_2_SHADER_READ_BIT, kNone, kNone}));
}

} // namespace sync_test
} // namespace glint::gpu
