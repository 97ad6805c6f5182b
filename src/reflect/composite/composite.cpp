#include "reflect/composite/composite.hpp"

#include "reflect/trace/technique.hpp"

namespace glint::reflect {

Result<Composite> Composite::create(StageContext& stages) {
    Composite composite(stages);
    GLINT_TRY(pass,
              gpu::Pipeline::compute(stages.gpu, {"composite/composite", sizeof(shared::CompositeConstants), {}}));
    composite.pass_ = std::move(pass);
    return composite;
}

void Composite::record(gpu::Frame& frame, const FrameInputs& inputs, const Prepared& prepared,
                       const Reflected& reflected, gpu::Image& rayRecord, gpu::Image& composite) {
    const Settings& settings = stages_->settings();
    const uint32_t debug = settings.screen.clipToFrustum ? shared::kDebugClipped : shared::kDebugOutcome;
    const shared::CompositeConstants constants = {static_cast<uint32_t>(settings.composite.model),
                                                  settings.reflect.fresnel,
                                                  settings.debug.outcome ? debug : 0,
                                                  settings.reflect.strength,
                                                  settings.reflect.falloffExponent,
                                                  traceConstants(settings, prepared.backFacesKnown).maxSteps};
    Inputs& host = inputs.host;
    frame.pass(pass_)
        .read("frame", inputs.constants)
        .read("viewZ", prepared.viewZ)
        .read("surface", prepared.surface)
        .read("material", prepared.material, kTexels)
        .read("edge", prepared.edge)
        .read("litRadiance", host.litRadiance, kTexels)
        .read("fallbackSpecular", host.fallbackSpecular ? host.fallbackSpecular : inputs.standIns.black, kTexels)
        .read("reflected", reflected.reflected)
        .read("rayRecord", rayRecord)
        .read("dfg", inputs.standIns.dfg)
        .write("composite", composite)
        .push(constants)
        .dispatch(stages_->width(), stages_->height());
}

} // namespace glint::reflect
