#include "reflect/probes/probes_source.hpp"

namespace glint::reflect {

Result<std::unique_ptr<ProbesSource>> ProbesSource::create(StageContext& stages) {
    std::unique_ptr<ProbesSource> source(new ProbesSource(stages));
    GLINT_CHECK(makeImage(stages.gpu, source->answer_,
                          {"glint/probesAnswer", VK_FORMAT_R16G16B16A16_SFLOAT, stages.width(), stages.height()}));
    return source;
}

Result<void> ProbesSource::setProbes(ProbesState& probes) {
    GLINT_TRY(reflect, gpu::Pipeline::compute(stages_.gpu, {"probes/reflect", 0, {}, probes.cubesLayout()}));
    stages_.retired.keep(std::move(reflect_));
    reflect_ = std::move(reflect);
    probes_ = &probes;
    return {};
}

uint32_t probeFlags(const Settings& settings) {
    return static_cast<uint32_t>(settings.probes.steps) << shared::kProbesStepsShift |
           (settings.probes.parallax ? shared::kProbesParallax : 0) |
           (settings.probes.distanceRoughness ? shared::kProbesDistanceRoughness : 0);
}

void ProbesSource::record(gpu::Frame& frame, const ProbesInputs& inputs) {
    gpu::Pass pass = frame.pass(reflect_);
    pass.read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .write("probesRadianceWeight", answer_);
    inputs.earlier.bind(pass);
    probes_->bind(pass).dispatch(stages_.extent.x, stages_.extent.y);
}

} // namespace glint::reflect
