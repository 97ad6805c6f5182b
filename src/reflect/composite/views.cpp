#include "reflect/composite/views.hpp"

#include "reflect/trace/technique.hpp"

namespace glint::reflect {
namespace {

/// The push constants of composite/view.comp.
struct Shown {
    uint32_t view;
    uint32_t denoised;
};

} // namespace

Result<std::unique_ptr<Views>> Views::create(StageContext& stages) {
    std::unique_ptr<Views> views(new Views(stages));
    GLINT_TRY(pass, gpu::Pipeline::compute(stages.gpu, {"composite/view", sizeof(Shown), {}}));
    views->pass_ = std::move(pass);
    GLINT_TRY(show, gpu::Pipeline::compute(stages.gpu, {"composite/show", 0, {}}));
    GLINT_TRY(showIntegers, gpu::Pipeline::compute(stages.gpu, {"composite/show_integers", 0, {}}));
    views->show_ = std::move(show);
    views->showIntegers_ = std::move(showIntegers);
    GLINT_CHECK(makeImage(stages.gpu, views->image_,
                          {"glint/view", VK_FORMAT_R32G32B32A32_SFLOAT, stages.width(), stages.height(),
                           kCleared | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
    return views;
}

gpu::Image& Views::show(gpu::Frame& frame, gpu::Image& written) {
    const VkFormat format = written.desc().format;
    const bool integers =
        format == VK_FORMAT_R32_UINT || format == VK_FORMAT_R32G32_UINT || format == VK_FORMAT_R32G32B32A32_UINT;
    frame.pass(integers ? showIntegers_ : show_)
        .read("shown", written, kTexels)
        .write("view", image_)
        .dispatch(stages_.width(), stages_.height());
    return image_;
}

void Views::rehearse(gpu::Frame& frame, const ViewInputs& inputs) {
    record(frame, inputs, 0);
    show(frame, inputs.rayRecord);
    show(frame, inputs.screenAnswer);
}

gpu::Image& Views::record(gpu::Frame& frame, const ViewInputs& inputs, uint32_t view) {
    const Prepared& prepared = inputs.hierarchy.prepared;
    gpu::Image& black = inputs.hierarchy.frame.standIns.black;
    const DenoiserHistory history = inputs.history.value_or(DenoiserHistory{inputs.rayRecord, black, black, black});
    const Reflected reflected = inputs.sources.reflected();
    frame.pass(pass_)
        .read("frame", inputs.hierarchy.frame.constants)
        .read("viewZ", prepared.viewZ)
        .read("surface", prepared.surface)
        .read("material", prepared.material, kTexels)
        .read("radianceWeight", inputs.screenAnswer)
        .read("rayRecord", inputs.rayRecord)
        .read("reflected", reflected.reflected)
        .read("weights", reflected.weights)
        .read("planarAnswer", inputs.sources.answerOf(shared::kSourcePlanar, inputs.hierarchy))
        .read("probesAnswer", inputs.sources.answerOf(shared::kSourceProbes, inputs.hierarchy))
        .read("refracted", inputs.refraction ? inputs.refraction->refracted() : black)
        .read("refractionWeights", inputs.refraction ? inputs.refraction->weights() : black)
        .read("sentRay", history.sentRay)
        .read("historyMeta", history.meta)
        .read("historyMetaBefore", history.metaBefore, kTexels)
        .read("changed", history.changed)
        .write("view", image_)
        .push(Shown{view, inputs.history ? 1u : 0u})
        .dispatch(stages_.extent.x, stages_.extent.y);
    return image_;
}

} // namespace glint::reflect
