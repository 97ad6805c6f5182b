#include "reflect/resolve/lobe_mean.hpp"

#include "reflect/frame_plan.hpp"
#include "reflect/trace/cone_picture.hpp"
#include "shared/lobe_mean.h"

namespace glint::reflect {

bool LobeMean::wanted(const Settings& settings) {
    return ConePicture::wanted(settings) && settings.screen.targetFormat != TargetFormat::Rgba8;
}

Result<std::unique_ptr<LobeMean>> LobeMean::create(StageContext& stages) {
    std::unique_ptr<LobeMean> stage(new LobeMean(stages));
    using gpu::Pipeline;
    GLINT_TRY(take, Pipeline::compute(stages.gpu, {"resolve/lobe_take", 0, {}}));
    GLINT_TRY(shrink, Pipeline::compute(stages.gpu, {"resolve/lobe_shrink", sizeof(shared::LobeShrinkConstants), {}}));
    GLINT_TRY(mean, Pipeline::compute(stages.gpu, {"resolve/lobe", 0, {}}));
    stage->take_ = std::move(take);
    stage->shrink_ = std::move(shrink);
    stage->mean_ = std::move(mean);
    return stage;
}

Result<void> LobeMean::make(const Settings& settings) {
    // Whole tiles, so that each mip has exactly half of the texels of the one before, and a texel of the last to spare.
    const auto tiled = [&](uint32_t pixels) {
        const uint32_t most = tracedPixels(settings, pixels) + shared::kLobeTile;
        return (most + shared::kLobeTile - 1) / shared::kLobeTile * shared::kLobeTile;
    };
    const uint32_t w = tiled(stages_.width());
    const uint32_t h = tiled(stages_.height());
    const auto grow = [&](gpu::Image& image, const char* name) -> Result<void> {
        if (image && image.width() >= w && image.height() >= h)
            return {};
        GLINT_TRY(made, gpu::Image::create(stages_.gpu, {name, VK_FORMAT_R16G16B16A16_SFLOAT, w, h, shared::kLobeMips,
                                                         1, gpu::ImageShape::Flat,
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
    const uint32_t w = tracedPixels(stages_.settings(), stages_.extent.x);
    const uint32_t h = tracedPixels(stages_.settings(), stages_.extent.y);
    frame.pass(take_)
        .read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("rayRecord", stage.rayRecord)
        .read("traced", stage.target.radianceWeight)
        .read("rayList", inputs.rays.list)
        .write("lights", lights_)
        .write("places", places_)
        .dispatch(w + 1, h + 1); // filters reach one texel beyond
    const auto used = [&](uint32_t mip) {
        const uint32_t side = 1u << mip;
        return glm::uvec2((w + side - 1) / side, (h + side - 1) / side);
    };
    for (uint32_t mip = 1; mip < shared::kLobeMips; ++mip)
        frame.pass(shrink_)
            .readWrite("finerLights", lights_, mip - 1)
            .readWrite("finerPlaces", places_, mip - 1)
            .read("rayList", inputs.rays.list)
            .write("lights", lights_, mip)
            .write("places", places_, mip)
            .push(shared::LobeShrinkConstants{used(mip), used(mip - 1)})
            .dispatch(used(mip).x + 1, used(mip).y + 1);
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
        .dispatch(w, h);
}

} // namespace glint::reflect
