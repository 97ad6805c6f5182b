#include "reflect/probes/probes_source.hpp"

namespace glint::reflect {

Result<std::unique_ptr<ProbesSource>> ProbesSource::create(gpu::Context& context, uint32_t width, uint32_t height) {
    std::unique_ptr<ProbesSource> source(new ProbesSource(context));
    GLINT_TRY(answer, gpu::Image::create(context, {"glint/probesAnswer", VK_FORMAT_R16G16B16A16_SFLOAT, width, height,
                                                   1, 1, gpu::ImageShape::Flat,
                                                   VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT}));
    source->answer_ = std::move(answer);
    return source;
}

Result<void> ProbesSource::setProbes(ProbesState& probes) {
    GLINT_TRY(reflect, gpu::Pipeline::compute(
                           context_, {"probes/reflect", sizeof(shared::ProbesConstants), {}, probes.cubesLayout()}));
    reflect_ = std::move(reflect);
    probes_ = &probes;
    return {};
}

uint32_t probeFlags(const Settings& settings) {
    return static_cast<uint32_t>(settings.probes.steps) << shared::kProbesStepsShift |
           (settings.probes.parallax ? shared::kProbesParallax : 0) |
           (settings.probes.distanceRoughness ? shared::kProbesDistanceRoughness : 0);
}

void ProbesSource::record(gpu::Frame& frame, const Settings& settings, const ProbesInputs& inputs) {
    const shared::ProbesConstants constants = {probeFlags(settings), inputs.earlier.before};
    gpu::Pass pass = frame.pass(reflect_);
    pass.read("frame", inputs.frameConstants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .write("answers", answer_);
    inputs.earlier.bind(pass);
    probes_->bind(pass).push(constants).dispatch(answer_.width(), answer_.height());
}

} // namespace glint::reflect
