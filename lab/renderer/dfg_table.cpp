#include "lab/renderer/dfg_table.hpp"

#include "gpu/pass.hpp"

namespace glint::render {

Result<gpu::Image> makeDfgTable(gpu::Context& context) {
    constexpr uint32_t kSize = 128;
    GLINT_TRY(integrate, gpu::Pipeline::compute(context, {"environment/dfg", 0, {}}));
    GLINT_TRY(table, gpu::Image::create(
                         context,
                         {"environment/dfg", VK_FORMAT_R16G16_SFLOAT, kSize, kSize, 1, 1, gpu::ImageShape::Flat,
                          VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
    GLINT_CHECK(context.submitAndWait([&](VkCommandBuffer commands) {
        gpu::Frame frame(context, commands);
        frame.pass(integrate).write("dfg", table).dispatch(kSize, kSize);
    }));
    return table;
}

} // namespace glint::render
