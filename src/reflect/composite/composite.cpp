#include "reflect/composite/composite.hpp"

namespace glint::reflect {

Result<Composite> Composite::create(StageContext& stages) {
    Composite composite(stages);
    GLINT_TRY(pass, gpu::Pipeline::compute(stages.gpu, {"composite/composite", 0, {}}));
    composite.pass_ = std::move(pass);
    return composite;
}

shared::CompositeConstants Composite::constants() const {
    const Settings& settings = stages_->settings();
    const uint32_t debug = settings.screen.clipToFrustum ? shared::kDebugClipped : shared::kDebugOutcome;
    return {static_cast<uint32_t>(settings.composite.model), settings.reflect.fresnel,
            settings.debug.outcome ? debug : 0, settings.reflect.strength, settings.reflect.falloffExponent};
}

void Composite::record(gpu::Frame& frame, const FrameInputs& inputs, const Prepared& prepared,
                       const Reflected& reflected, gpu::Image& rayRecord, gpu::Image& composite) {
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
        .dispatch(stages_->extent.x, stages_->extent.y);
}

} // namespace glint::reflect
