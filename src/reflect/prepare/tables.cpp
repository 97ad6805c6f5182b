#include "reflect/prepare/tables.hpp"

#include "reflect/prepare/blue_noise.hpp"
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

Result<void> Tables::makeNoise(gpu::Context& context) {
    if (blueNoise_)
        return {};
    GLINT_TRY(noise,
              gpu::Buffer::create(context, {"glint/blueNoise", blueNoiseMask().size() * sizeof(uint32_t),
                                            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                            gpu::BufferHome::Device}));
    blueNoise_ = std::move(noise);
    return {};
}

void Tables::record(gpu::Frame& frame, gpu::Progress& progress) {
    if (frame.rehearsing() || filled_.isNeeded(progress)) {
        frame.pass(makeDfg_).write("dfg", dfg_).dispatch(kDfgSize, kDfgSize);
        frame.clear(black_, {});
        frame.clear(blackCube_, {});
        frame.fill(noProbes_, 0);
        if (!frame.rehearsing())
            filled_.recorded(progress);
    }
    if (blueNoise_ && !frame.rehearsing() && noiseFilled_.isNeeded(progress)) {
        frame.update(blueNoise_, blueNoiseMask().data(), blueNoise_.size());
        noiseFilled_.recorded(progress);
    }
}

} // namespace glint::reflect
