// Acceleration structures as passes use them: barriers and names.
#include "gpu/support/ray_test.hpp"

#include <array>

namespace glint::test {
namespace acceleration_structure_test {

class AccelerationStructureTest : public GpuTest {};

/// The packaged validation layer does not detect these hazards, so the test checks the tracker's barriers.
TEST_F(AccelerationStructureTest, aPassReadsTheTopLevelAndEveryBottomLevelBelowIt) {
    if (!gpu().rayQuery())
        GTEST_SKIP() << "no ray queries on " << gpu().info().name;
    const std::vector<glm::vec3> vertices = {{-1, -1, -2}, {3, -1, -2}, {-1, 3, -2}};
    const std::vector<uint32_t> triangle = {0, 1, 2};
    gpu::Buffer positions = must(gpu::uploadBuffer(gpu(), "test/positions", vertices, gpu::kBuildInputUsage));
    gpu::Buffer indices = must(gpu::uploadBuffer(gpu(), "test/indices", triangle, gpu::kBuildInputUsage));
    const gpu::TriangleRange range = {&positions, 0, 3, &indices, 0, 1};
    gpu::AccelerationStructure bottom = must(gpu::AccelerationStructure::bottom(gpu(), "test/bottom", range, true));
    VkAccelerationStructureInstanceKHR record = {};
    for (int i = 0; i < 3; ++i)
        record.transform.matrix[i][i] = 1;
    record.mask = 0xff;
    record.accelerationStructureReference = bottom.address();
    gpu::Buffer instances =
        must(gpu::uploadBuffer(gpu(), "test/instances", std::vector{record}, gpu::kBuildInputUsage));
    gpu::AccelerationStructure top = must(gpu::AccelerationStructure::top(gpu(), "test/top", instances, 1, {&bottom}));
    gpu::Buffer scratch =
        must(gpu::Buffer::create(gpu(), {"test/scratch", std::max(bottom.scratchSize(), top.scratchSize()),
                                         VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT,
                                         gpu::BufferHome::Device}));
    gpu::Buffer rays =
        must(gpu::uploadBuffer(gpu(), "test/rays", std::vector<TestRay>(1), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
    gpu::Buffer hits = must(gpu::Buffer::create(
        gpu(), {"test/hits", sizeof(TestHit), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::BufferHome::Device}));
    const gpu::Pipeline pipeline = must(gpu::Pipeline::compute(gpu(), {"ray_query", 0, {}}));

    constexpr VkPipelineStageFlags2 kBuild = VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR;
    constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    run([&](VkCommandBuffer commands) {
        gpu::Frame frame(gpu(), commands);
        frame.build(std::array{&bottom}, scratch);
        EXPECT_EQ(positions.state().readStages, kBuild);
        EXPECT_EQ(indices.state().readStages, kBuild);
        EXPECT_EQ(bottom.storage().state().writeStages, kBuild);
        EXPECT_EQ(scratch.state().writeStages, kBuild);
        frame.build(std::array{&top}, scratch);
        EXPECT_EQ(bottom.storage().state().readStages, kBuild);
        EXPECT_EQ(instances.state().readStages, kBuild);
        frame.pass(pipeline).read("scene", top).read("rays", rays).write("hits", hits).dispatch(1);
        for (gpu::AccelerationStructure* structure : {&top, &bottom}) {
            EXPECT_TRUE(structure->storage().state().readStages & kCompute);
            EXPECT_TRUE(structure->storage().state().readAccess & VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR);
        }
        frame.refit(std::array{&bottom}, scratch);
        EXPECT_EQ(bottom.storage().state().readStages, 0u) << "a write again, behind the shader's reads";
    });
    gpu::Frame rehearsal = gpu::Frame::rehearsal(gpu());
    rehearsal.pass(pipeline).read("scene", rays).read("rays", rays).write("hits", hits).dispatch(1);
    ASSERT_FALSE(rehearsal.firstError());
    EXPECT_EQ(rehearsal.firstError().error().message,
              "ray_query: 'scene' is declared for read as an acceleration structure, but bound for read as a buffer");
}

} // namespace acceleration_structure_test
} // namespace glint::test
