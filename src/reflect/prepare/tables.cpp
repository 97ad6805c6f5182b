#include "reflect/prepare/tables.hpp"

#include "shared/probes.h"

namespace glint::reflect {

constexpr uint32_t kDfgSize = 64;

Result<Tables> Tables::create(gpu::Context& context) {
    Tables tables;
    GLINT_TRY(makeDfg, gpu::Pipeline::compute(context, {"prepare/dfg", 0, {}}));
    tables.makeDfg_ = std::move(makeDfg);
    GLINT_CHECK(makeImage(context, tables.dfg_, {"glint/dfg", VK_FORMAT_R16G16_SFLOAT, kDfgSize, kDfgSize}));
    GLINT_CHECK(makeImage(context, tables.black_, {"glint/black", VK_FORMAT_R16G16B16A16_SFLOAT, 1, 1, kCleared}));
    GLINT_TRY(cube, gpu::Image::create(context, {"glint/blackCube", VK_FORMAT_R16G16B16A16_SFLOAT, 1, 1, 1, 6,
                                                 gpu::ImageShape::Cube, VK_IMAGE_USAGE_SAMPLED_BIT | kCleared}));
    tables.blackCube_ = std::move(cube);
    GLINT_TRY(lists,
              gpu::Buffer::create(context, {"glint/noProbes", sizeof(shared::ProbeRecord),
                                            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                            gpu::BufferHome::Device}));
    tables.noProbes_ = std::move(lists);
    return tables;
}

void Tables::record(gpu::Frame& frame) {
    frame.pass(makeDfg_).write("dfg", dfg_).dispatch(kDfgSize, kDfgSize);
    frame.clear(black_, {});
    frame.clear(blackCube_, {});
    frame.fill(noProbes_, 0);
}

} // namespace glint::reflect
