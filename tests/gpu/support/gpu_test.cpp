#include "gpu/support/gpu_test.hpp"

#include "gpu/support/test_shaders.hpp"

#include <cstdlib>
#include <stdexcept>

namespace glint::test {

gpu::Context& GpuTest::gpu() {
    static const std::unique_ptr<gpu::Context> context = [] {
        // The test `compute_only` runs some of these on a device with only the library's required features.
        const bool computeOnly = std::getenv("GLINT_TEST_COMPUTE_ONLY") != nullptr;
        gpu::ContextDesc desc = {.device = {}, .validation = true};
        if (computeOnly)
            desc.demands = gpu::Demands::Sources;
        auto created = must(gpu::Context::create(desc));
        if (computeOnly && created->queueFlags() & VK_QUEUE_GRAPHICS_BIT)
            throw std::runtime_error("compute_only: the queue draws; is the layer in tests/fakes enabled?");
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
