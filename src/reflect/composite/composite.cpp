#include "reflect/composite/composite.hpp"

namespace glint::reflect {

Result<Composite> Composite::create(StageContext& stages) {
    using gpu::Compile, gpu::Pipeline;
    Composite composite(stages);
    GLINT_TRY(pass, Pipeline::compute(stages.gpu, {"composite/composite", 0, {}}, Compile::Later));
    GLINT_TRY(combined, Pipeline::compute(stages.gpu, {"composite/combined", 0, {}}, Compile::Later));
    GLINT_TRY(coated, Pipeline::compute(stages.gpu, {"composite/coated", 0, {}}, Compile::Later));
    composite.pass_ = std::move(pass);
    composite.coatedPass_ = std::move(coated);
    composite.combinedPass_ = std::move(combined);
    return composite;
}

Result<void> Composite::make(bool combines) {
    return (combines ? combinedPass_ : stages_->plan.coat ? coatedPass_ : pass_).compile();
}

shared::CompositeConstants Composite::constants() const {
    const Settings& settings = stages_->settings();
    const uint32_t debug = settings.screen.clipToFrustum ? shared::kDebugClipped : shared::kDebugOutcome;
    return {static_cast<uint32_t>(settings.composite.model), settings.reflect.fresnel,
            settings.debug.outcome ? debug : 0, settings.reflect.strength, settings.reflect.falloffExponent};
}

void Composite::bind(gpu::Pass& pass, const HierarchyInputs& inputs, const CompositeImages& images) {
    Inputs& host = inputs.frame.host;
    pass.read("material", inputs.prepared.material, kTexels)
        .read("litRadiance", host.litRadiance, kTexels)
        .read("fallbackSpecular", host.fallbackSpecular ? host.fallbackSpecular : inputs.frame.standIns.black, kTexels)
        .read("rayRecord", images.rayRecord)
        .read("dfg", inputs.frame.standIns.dfg)
        .write("composite", images.composite);
}

void Composite::record(gpu::Frame& frame, const HierarchyInputs& inputs, const Reflected& reflected,
                       const CompositeImages& images) {
    gpu::Pass pass = frame.pass(images.coat ? coatedPass_ : pass_);
    bind(pass, inputs, images);
    if (images.coat)
        pass.read("coatSurface", inputs.prepared.otherLobe).read("coatReflected", *images.coat);
    pass.read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("edge", inputs.prepared.edge)
        .read("reflected", reflected.reflected)
        .dispatch(stages_->extent.x, stages_->extent.y);
}

void Composite::recordCombined(gpu::Frame& frame, const HierarchyInputs& inputs, const Hierarchy& sources,
                               gpu::Buffer& rayTiles, const CompositeImages& images) {
    gpu::Pass pass = frame.pass(combinedPass_);
    bind(pass, inputs, images);
    sources.bindAnswers(pass, inputs);
    pass.read("rayTiles", rayTiles).dispatch(stages_->extent.x, stages_->extent.y);
}

} // namespace glint::reflect
