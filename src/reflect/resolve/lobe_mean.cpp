#include "reflect/resolve/lobe_mean.hpp"

#include "reflect/frame_plan.hpp"
#include "reflect/trace/cone_picture.hpp"
#include "shared/lobe_mean.h"

#include <algorithm>
#include <bit>

namespace glint::reflect {

bool LobeMean::wanted(const Settings& settings) {
    return ConePicture::wanted(settings) && settings.screen.targetFormat != TargetFormat::Rgba8;
}

Result<std::unique_ptr<LobeMean>> LobeMean::create(StageContext& stages) {
    std::unique_ptr<LobeMean> stage(new LobeMean(stages));
    using gpu::Pipeline;
    GLINT_TRY(take, Pipeline::compute(stages.gpu, {"resolve/lobe_take", 0, {}}));
    GLINT_TRY(shrink, Pipeline::compute(stages.gpu, {"resolve/lobe_shrink", 0, {}}));
    GLINT_TRY(mean, Pipeline::compute(stages.gpu, {"resolve/lobe", 0, {}}));
    stage->take_ = std::move(take);
    stage->shrink_ = std::move(shrink);
    stage->mean_ = std::move(mean);
    return stage;
}

Result<void> LobeMean::make(const Settings& settings) {
    const uint32_t w = tracedPixels(settings, stages_.width());
    const uint32_t h = tracedPixels(settings, stages_.height());
    const auto grow = [&](gpu::Image& image, const char* name) -> Result<void> {
        if (image && image.width() >= w && image.height() >= h)
            return {};
        const auto most = static_cast<uint32_t>(std::bit_width(std::max(w, h)));
        GLINT_TRY(made, gpu::Image::create(stages_.gpu, {name, VK_FORMAT_R16G16B16A16_SFLOAT, w, h,
                                                         std::min(most, shared::kLobeMips), 1, gpu::ImageShape::Flat,
                                                         VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT}));
        stages_.retired.keep(std::move(image));
        image = std::move(made);
        return {};
    };
    GLINT_CHECK(grow(lights_, "glint/lobeLights"));
    return grow(places_, "glint/lobePlaces");
}

void LobeMean::record(gpu::Frame& frame, const StageInputs& stage) {
    const TraceInputs& inputs = stage.trace;
    frame.pass(take_)
        .read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("rayRecord", stage.rayRecord)
        .read("traced", stage.target.radianceWeight)
        .read("rayList", inputs.rays.list)
        .write("lights", lights_)
        .write("places", places_)
        .dispatch(lights_.width(), lights_.height());
    for (uint32_t mip = 1; mip < lights_.desc().mips; ++mip)
        frame.pass(shrink_)
            .readWrite("finerLights", lights_, mip - 1)
            .readWrite("finerPlaces", places_, mip - 1)
            .read("rayList", inputs.rays.list)
            .write("lights", lights_, mip)
            .write("places", places_, mip)
            .dispatch(std::max(lights_.width() >> mip, 1u), std::max(lights_.height() >> mip, 1u));
    gpu::Pass pass = frame.pass(mean_);
    readHitColor(pass, inputs);
    pass.read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("rayRecord", stage.rayRecord)
        .read("rayList", inputs.rays.list)
        .read("lights", lights_)
        .read("places", places_)
        .readWrite("radianceWeight", stage.target.radianceWeight)
        .dispatch(tracedPixels(stages_.settings(), stages_.extent.x),
                  tracedPixels(stages_.settings(), stages_.extent.y));
}

} // namespace glint::reflect
