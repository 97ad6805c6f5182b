#include "reflect/trace/cone_picture.hpp"

#include "reflect/denoise/denoises.hpp"

#include <array>

namespace glint::reflect {

bool ConePicture::wanted(const Settings& settings) {
    return settings.rough.cones && settings.screen.enabled && !denoises(settings) && settings.blur.strength <= 0 &&
           settings.rough.factor <= 0;
}

Result<std::unique_ptr<ConePicture>> ConePicture::create(StageContext& stages) {
    std::unique_ptr<ConePicture> picture(new ConePicture(stages));
    GLINT_TRY(pass, gpu::Pipeline::compute(stages.gpu, {"trace/picture", 0, {}}, gpu::Compile::Later));
    picture->pass_ = std::move(pass);
    return picture;
}

Result<void> ConePicture::make(const Settings&) {
    GLINT_CHECK(pass_.compile());
    if (image_)
        return {};
    // Whole tiles, so that each level has exactly half of the texels of the one before.
    const auto half = [](uint32_t pixels) {
        return (pixels + shared::kPictureTile - 1) / shared::kPictureTile * (shared::kPictureTile / 2);
    };
    GLINT_TRY(image,
              gpu::Image::create(stages_.gpu, {"glint/picture", VK_FORMAT_R16G16B16A16_SFLOAT, half(stages_.width()),
                                               half(stages_.height()), shared::kPictureLevels, 1, gpu::ImageShape::Flat,
                                               VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | kCleared}));
    image_ = std::move(image);
    return {};
}

void ConePicture::clear(gpu::Frame& frame) {
    if (frame.rehearsing() || !image_ || !blank_.isNeeded(stages_.progress))
        return;
    frame.clear(image_, {});
    blank_.recorded(stages_.progress);
}

void ConePicture::record(gpu::Frame& frame, const StageInputs& stage) {
    const TraceInputs& inputs = stage.trace;
    static_assert(shared::kPictureTile == shared::kPyramidTile, "dispatched over the pyramid's tiles");
    static constexpr std::array kLevels = {"level1", "level2", "level3", "level4", "level5", "level6"};
    static_assert(kLevels.size() == shared::kPictureLevels);
    gpu::Pass pass = frame.pass(pass_);
    pass.read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("litRadiance", inputs.frame.host.litRadiance, kTexels)
        .read("prevColor", inputs.previous ? inputs.previous->color : inputs.frame.standIns.black, kTexels)
        .read("prevViewZ", inputs.previous ? inputs.previous->viewZ : inputs.frame.standIns.black, kTexels);
    for (uint32_t level = 0; level < shared::kPictureLevels; ++level)
        pass.write(kLevels[level], image_, level);
    pass.dispatchIndirect(inputs.rays.list, offsetof(shared::RayListHeader, pictureGroups));
}

} // namespace glint::reflect
