// CompileBatch: what is asked for while it lives is compiled by its end, once, and by the outermost batch alone.
#include "gpu/support/gpu_test.hpp"

namespace glint::test {
namespace compile_batch_test {

/// Uses a device of its own: no other test has compiled these pipelines.
class CompileBatchTest : public testing::Test {
protected:
    void SetUp() override {
        context_ = must(gpu::Context::create({}));
        context_->addShaders(gpu::shaders::reflect());
    }
    gpu::Pipeline ask(std::string_view shader) { return must(gpu::Pipeline::compute(*context_, {shader, 0, {}})); }

    std::unique_ptr<gpu::Context> context_;
};

TEST_F(CompileBatchTest, WithoutOneAPipelineIsCompiledAtOnce) {
    EXPECT_NE(ask("trace/classify").handle(), VK_NULL_HANDLE);
}

TEST_F(CompileBatchTest, CompilesAllAtItsEnd) {
    gpu::CompileBatch batch(*context_);
    const std::array<gpu::Pipeline, 4> all = {ask("trace/classify"), ask("denoise/reuse"), ask("denoise/filter"),
                                              ask("trace/classify")};
    for (const gpu::Pipeline& pipeline : all)
        EXPECT_EQ(pipeline.handle(), VK_NULL_HANDLE) << pipeline.name();
    must(batch.finish());
    for (const gpu::Pipeline& pipeline : all)
        EXPECT_NE(pipeline.handle(), VK_NULL_HANDLE) << pipeline.name();
    EXPECT_EQ(all[0].handle(), all[3].handle());
}

TEST_F(CompileBatchTest, TheOutermostCompiles) {
    gpu::CompileBatch outer(*context_);
    gpu::Pipeline pipeline;
    {
        gpu::CompileBatch inner(*context_);
        pipeline = ask("denoise/filter");
        must(inner.finish());
    }
    EXPECT_EQ(pipeline.handle(), VK_NULL_HANDLE);
    must(outer.finish());
    EXPECT_NE(pipeline.handle(), VK_NULL_HANDLE);
}

TEST_F(CompileBatchTest, WhatAFailedCallLeftIsCompiledWhenAskedAgain) {
    {
        const gpu::CompileBatch batch(*context_);
        EXPECT_EQ(ask("denoise/filter").handle(), VK_NULL_HANDLE);
    }
    EXPECT_NE(ask("denoise/filter").handle(), VK_NULL_HANDLE);
}

} // namespace compile_batch_test
} // namespace glint::test
