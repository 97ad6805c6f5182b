#include "gpu/support/gpu_test.hpp"

#include "gpu/support/test_shaders.hpp"

namespace glint::test {

gpu::Context& GpuTest::gpu() {
    static const std::unique_ptr<gpu::Context> context = [] {
        auto created = must(gpu::Context::create({.device = {}, .validation = true}));
        created->addShaders(gpu::shaders::reflect());
        created->addShaders(gpu::shaders::test());
        return created;
    }();
    return *context;
}

Context& GpuTest::library() {
    static Context context = [] {
        const gpu::AdoptedDevice handles = gpu().handles();
        return must(Context::adopt({handles.instance, handles.physicalDevice, handles.device, handles.queueFamily,
                                    handles.getInstanceProcAddr, handles.rayQuery}));
    }();
    return context;
}

void GpuTest::SetUp() {
    messagesBefore_ = gpu().validationMessages().size();
}

void GpuTest::TearDown() {
    const std::vector<std::string>& messages = gpu().validationMessages();
    for (size_t i = messagesBefore_; i < messages.size(); ++i)
        ADD_FAILURE() << "validation: " << messages[i];
}

} // namespace glint::test
