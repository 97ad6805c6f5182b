// FrameStages: its rehearsals. Each runs every pass that settings may need without a command buffer, so that a wrong
// name, kind or size of a binding is an error of creation.
#include "reflect/frame.hpp"

namespace glint::reflect {

void FrameStages::rehearse(gpu::Frame& frame, RaysSource& rays) {
    if (!rays.hasScene())
        return;
    rays.record(frame, {inputs(), prepared(), hierarchy_->noAnswersBefore(hierarchyInputs()),
                        trace_->traced().rayRecord, false, std::nullopt});
    if (Denoiser* const denoiser = optional_.findWanted<Denoiser>())
        rehearse(frame, *denoiser);
    rays.end(frame);
}

void FrameStages::rehearse(gpu::Frame& frame, PlanarSource& planar) {
    planar.record(frame, {inputs(), prepared(), hierarchy_->noAnswersBefore(hierarchyInputs())});
}

void FrameStages::rehearse(gpu::Frame& frame, ProbesSource& probes) {
    probes.record(frame, {inputs(), prepared(), hierarchy_->noAnswersBefore(hierarchyInputs())});
}

void FrameStages::rehearse(gpu::Frame& frame, Denoiser& denoiser) {
    denoise(frame, denoiser);
}

void FrameStages::rehearse(gpu::Frame& frame, Refraction& refraction) {
    refraction.begin(frame, composite());
    LayerImages layer;
    recordLayer(frame, layer);
}

void FrameStages::rehearse(gpu::Frame& frame, RayCounts& counts) {
    countRays(frame, counts);
}

void FrameStages::rehearse(gpu::Frame& frame, Views& views) {
    views.rehearse(frame, {hierarchyInputs(), *hierarchy_, resolve_->answer(), rayRecord(), nullptr, {}});
}

void FrameStages::rehearse(gpu::Frame& frame, Inspector& inspector) {
    inspector.rehearse(frame, inspectorInputs());
}

void FrameStages::rehearse(gpu::Frame& frame, InputChecker& checker) {
    checker.rehearse(frame, inputs());
}

/// Every pass of the stages that all frames have.
Result<void> FrameStages::rehearseFixed() {
    gpu::Frame frame = gpu::Frame::rehearsal(stages_.gpu);
    clear(frame);
    prepare(frame, {});
    prepare_->rehearse(frame, inputs(), colors_.now(kViewZ));
    pyramid_->record(frame, inputs(), prepared(), nullptr);
    prepare_->recordClassified(frame, inputs(), colors_.now(kViewZ),
                               [this](gpu::Pass& pass) { trace_->bindClasses(pass); });
    trace_->rehearse(frame, traceInputs(), prepare_->backFaceGroups());
    resolve_->rehearse(frame, {traceInputs(), trace_->traced()});
    const Reflected reflected = hierarchy_->combine(frame, hierarchyInputs());
    composite_->record(frame, hierarchyInputs(), reflected, {rayRecord(), composite()});
    composite_->record(frame, hierarchyInputs(), reflected, {rayRecord(), composite(), &reflected.reflected});
    composite_->recordCombined(frame, hierarchyInputs(), *hierarchy_, trace_->rayTiles(), {rayRecord(), composite()});
    return frame.firstError();
}

} // namespace glint::reflect
