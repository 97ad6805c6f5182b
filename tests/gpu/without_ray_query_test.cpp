// A device without ray queries: rays still work, and no object that needs the extension is created.
#include "gpu/support/ray_test.hpp"
#include "gpu/support/test_shaders.hpp"

namespace glint::test {
namespace without_ray_query_test {

class WithoutRayQuery : public testing::Test {
protected:
    void SetUp() override {
        context_ = must(gpu::Context::create({.device = {}, .validation = true, .rayQuery = false}));
        context_->addShaders(gpu::shaders::test());
    }
    void TearDown() override {
        for (const std::string& message : context_->validationMessages())
            ADD_FAILURE() << "validation: " << message;
    }
    std::unique_ptr<gpu::Context> context_;
};

TEST_F(WithoutRayQuery, autoTakesTheHierarchyAndItWorks) {
    const std::unique_ptr<rays::Scene> scene = oneTriangle().build(*context_, RayBackend::Auto);
    EXPECT_EQ(scene->backend(), RayBackend::Bvh);
    EXPECT_TRUE(traceRays(*context_, *scene, {TestRay{}})[0].met());
}

TEST_F(WithoutRayQuery, aHostThatOnlySaysItEnabledThemIsToldSo) {
    gpu::AdoptedDevice handles = context_->handles();
    handles.rayQuery = true;
    const auto adopted = gpu::Context::adopt(handles);
    ASSERT_FALSE(adopted);
    EXPECT_NE(adopted.error().message.find("ray queries are not enabled"), std::string::npos)
        << adopted.error().message;
}

TEST_F(WithoutRayQuery, queriesAreRefused) {
    const auto scene = rays::Scene::create(*context_, {.backend = RayBackend::Query});
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, ErrorCode::Unsupported);
    const auto pipeline = gpu::Pipeline::compute(*context_, {"ray_query", 0, {}});
    ASSERT_FALSE(pipeline);
    EXPECT_EQ(pipeline.error().code, ErrorCode::Unsupported);
    EXPECT_NE(pipeline.error().message.find("ray_query traces by ray queries"), std::string::npos)
        << pipeline.error().message;
}

TEST_F(WithoutRayQuery, aHostsAccelerationStructureIsRefused) {
    HostAccelerationStructure host;
    host.topLevel = reinterpret_cast<VkAccelerationStructureKHR>(uintptr_t{1}); // no call may see it
    const auto scene = rays::Scene::adopt(*context_, host);
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, ErrorCode::Unsupported);
    EXPECT_NE(scene.error().message.find("ray queries are not enabled"), std::string::npos) << scene.error().message;
}

} // namespace without_ray_query_test
} // namespace glint::test
