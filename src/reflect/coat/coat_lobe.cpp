#include "reflect/coat/coat_lobe.hpp"

namespace glint::reflect {

// ---------------------------------------------------------------- creation

Result<std::unique_ptr<CoatLobe>> CoatLobe::create(StageContext& frame) {
    std::unique_ptr<CoatLobe> coat(new CoatLobe(frame));
    StageContext& stages = coat->stages_;
    stages.desc.views = stages.desc.inspection = stages.desc.statistics = false; // they show the surfaces' own
    GLINT_TRY(progress, gpu::Progress::create(frame.gpu, "glint/coatProgress", frame.desc.framesInFlight));
    stages.progress = std::move(progress);
    GLINT_TRY(block,
              gpu::Buffer::create(frame.gpu, {"glint/coatFrame", sizeof(FrameBlockValues),
                                              VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                              gpu::BufferHome::Device}));
    coat->block_ = std::move(block);
    coat->follow();
    GLINT_TRY(trace, ScreenTrace::create(stages));
    GLINT_TRY(resolve, ScreenResolve::create(stages));
    GLINT_TRY(hierarchy, Hierarchy::create(stages, coat->makeSources()));
    coat->trace_ = std::move(trace);
    coat->resolve_ = std::move(resolve);
    coat->hierarchy_ = std::move(hierarchy);
    return coat;
}

/// Takes over the plan, settings and extent of the surfaces' frame. Coats are classified by a pass of their own, and
/// their answers are combined apart.
void CoatLobe::follow() {
    stages_.desc.settings = frame_.desc.settings;
    stages_.extent = frame_.extent;
    stages_.plan = frame_.plan;
    stages_.plan.combines = true;
    stages_.plan.classifiesEarly = stages_.plan.storesListedOnly = stages_.plan.countsRays = false;
}

std::vector<Source> CoatLobe::makeSources() {
    std::vector<Source> sources(shared::kSourceCount);
    sources[shared::kSourceScreen] = {"screen", &FramePlan::screen, {}, [this] { return &resolve_->answer(); }};
    sources[shared::kSourceRays] = {
        "rays", &FramePlan::rays,
        [this](gpu::Frame& frame, const EarlierAnswers& before) {
            rays_->record(frame, {inputs(), prepared(), before, trace_->traced().rayRecord, given_->block.sameView()});
        },
        [this] { return &rays_->answer(); }};
    sources[shared::kSourcePlanar] = {"planar", &FramePlan::planar,
                                      [this](gpu::Frame& frame, const EarlierAnswers& before) {
                                          planar_->record(frame, {inputs(), prepared(), before});
                                      },
                                      [this] { return &planar_->answer(); }};
    sources[shared::kSourceProbes] = {"probes", &FramePlan::probes,
                                      [this](gpu::Frame& frame, const EarlierAnswers& before) {
                                          probes_->record(frame, {inputs(), prepared(), before});
                                      },
                                      [this] { return &probes_->answer(); }};
    sources[shared::kSourceSky] = {"sky", &FramePlan::sky, {}, [] { return nullptr; }};
    return sources;
}

Result<void> CoatLobe::makeRays(const CoatSources& sources, bool again) {
    const bool isNew = !rays_;
    if (isNew) {
        GLINT_TRY(made, RaysSource::create(stages_));
        rays_ = std::move(made);
    }
    const bool sceneChanged = sources.scene != sources_.scene || sources.surfaces != sources_.surfaces;
    if (sources.scene && (isNew || sceneChanged || !rays_->hasScene()))
        GLINT_CHECK(sources.surfaces ? rays_->setScene(*sources.scene, *sources.surfaces)
                                     : rays_->setScene(*sources.scene, sources.shade));
    return isNew || again ? rays_->make(stages_.settings()) : Result<void>();
}

Result<void> CoatLobe::make(const CoatSources& sources, bool again) {
    follow();
    const FramePlan& plan = stages_.plan;
    GLINT_CHECK(trace_->make());
    GLINT_CHECK(resolve_->make());
    GLINT_CHECK(hierarchy_->makeReflected(nullptr));
    if (stages_.settings().rays.enabled)
        GLINT_CHECK(makeRays(sources, again));
    if (sources.planar && !planar_) {
        GLINT_TRY(made, PlanarSource::create(stages_));
        planar_ = std::move(made);
    }
    if (sources.planar && planar_->planar() != sources.planar)
        GLINT_CHECK(planar_->setPlanar(*sources.planar));
    if (sources.probes && !probes_) {
        GLINT_TRY(made, ProbesSource::create(stages_));
        probes_ = std::move(made);
    }
    if (sources.probes && probes_->probes() != sources.probes)
        GLINT_CHECK(probes_->setProbes(*sources.probes));
    if (plan.denoise) {
        const bool isNew = !denoiser_;
        if (isNew) {
            GLINT_TRY(made, Denoiser::create(stages_));
            denoiser_ = std::move(made);
        }
        if (isNew || again)
            GLINT_CHECK(denoiser_->make(stages_.settings()));
    }
    using Join = Hierarchy::Join;
    hierarchy_->joinScreenAndRays(plan.denoise ? Join([this](gpu::Frame& frame) { return &denoise(frame); }) : Join());
    sources_ = sources;
    return {};
}

void CoatLobe::forgetFrames(HistoryReset reason) {
    if (denoiser_)
        denoiser_->forgetFrames(reason);
}

void CoatLobe::restartAccumulation() {
    if (!rays_)
        return;
    rays_->forgetFrames(HistoryReset::Asked);
    rays_->environmentChanged();
}

void CoatLobe::environmentChanged() {
    if (rays_)
        rays_->environmentChanged();
}

// ---------------------------------------------------------------- the frame, top to bottom

gpu::Image& CoatLobe::record(gpu::Frame& frame, const CoatInputs& inputs) {
    given_ = &inputs;
    follow();
    begin(frame, inputs);
    if (stages_.plan.tracesScreen)
        trace(frame, inputs);
    else
        resolve_->recordNothing(trace_->recordNothing(frame));
    const Reflected reflected = hierarchy_->record(frame, hierarchyInputs());
    end(frame);
    given_ = nullptr;
    return reflected.reflected;
}

/// Writes the frame's constants as the coats' passes read them.
void CoatLobe::begin(gpu::Frame& frame, const CoatInputs& inputs) {
    stages_.progress.begin(inputs.frameNumber);
    stages_.retired.begin(inputs.frameNumber, stages_.desc.framesInFlight);
    trace_->clear(frame);
    trace_->begin(stages_.plan.rays && !stages_.plan.screen);
    if (denoiser_)
        denoiser_->begin(frame);
    values_ = inputs.block.whole();
    values_.constants.flags |= shared::kLobeCoat;
    values_.settings.hierarchy = hierarchy_->constants();
    if (stages_.plan.rays)
        values_.settings.rays = rays_->constants(inputs.below.frame.host, hierarchy_->before(shared::kSourceRays));
    if (denoiser())
        values_.settings.denoise = denoiser_->constants(inputs.seconds, stages_.plan.rays && rays_->branches());
    frame.update(block_, &values_, sizeof(values_));
    if (inputs.colors.valid())
        inputs.colors.copyTag(frame, block_, offsetof(FrameBlockValues, constants.historyTag));
    if (denoiser())
        denoiser_->copyTag(frame, block_, offsetof(FrameBlockValues, settings.denoise.historyTag));
}

/// Depth pyramid, back faces and pictures for cones are the surfaces' own.
void CoatLobe::trace(gpu::Frame& frame, const CoatInputs& inputs) {
    trace_->classify(frame, this->inputs(), prepared());
    trace_->list(frame, glm::uvec2(0), false);
    const Traced traced = trace_->record(frame, traceInputs());
    inputs.afterMarch({traceInputs(), trace_->target(), traced.rayRecord, nullptr});
    resolve_->record(frame, {traceInputs(), traced});
}

void CoatLobe::end(gpu::Frame& frame) {
    if (denoiser_)
        denoiser_->end(frame);
    if (stages_.plan.rays)
        rays_->end(frame);
    stages_.progress.end(frame);
}

/// Joins and denoises the answers of screen and rays.
gpu::Image& CoatLobe::denoise(gpu::Frame& frame) {
    const FramePlan& plan = stages_.plan;
    const Traced traced = trace_->traced();
    RaysSource* const rays = plan.rays ? rays_.get() : nullptr;
    DenoiserInputs joined = {.frame = inputs(),
                             .prepared = prepared(),
                             .screenAnswer = plan.screen ? &traced.target : nullptr,
                             .screenRecord = traced.rayRecord,
                             .raysAnswer = rays ? &rays->answer() : nullptr,
                             .raysRecord = rays ? rays->rayRecord() : traced.rayRecord,
                             .raysFirst = hierarchy_->raysComeFirst()};
    if (rays && rays->storesApart())
        joined.mirrored.emplace(rays->mirrored());
    if (plan.followsPaths)
        joined.followPaths = [this, rays](gpu::Frame& f, const SentinelImages& images) {
            rays->recordSentinels(f, inputs(), prepared(), images);
        };
    return denoiser_->record(frame, joined);
}

// ---------------------------------------------------------------- inputs of the passes

FrameInputs CoatLobe::inputs() {
    const FrameInputs& below = given_->below.frame;
    return {block_,
            values_.constants,
            below.host,
            below.standIns,
            denoiser() ? denoiser_->rayRates() : below.standIns.black,
            denoiser() ? denoiser_->metaBefore() : below.standIns.black};
}

/// The coats' surfaces change places with those below.
Prepared CoatLobe::prepared() {
    const Prepared& below = given_->below.prepared;
    return {below.viewZ,     below.otherLobe,      below.material,         below.edge,
            below.backViewZ, below.backFacesKnown, below.backFacesInPlace, below.surface};
}

/// Rays meet the coats rather than what is below: normals of bumpy paint say less about where a surface is.
TraceInputs CoatLobe::traceInputs() {
    const TraceInputs& below = given_->below;
    const Met met = {below.met.viewZ, below.prepared.otherLobe, below.met.backViewZ};
    TraceInputs trace = {inputs(),      prepared(),   met,          trace_->rays(),
                         below.pyramid, std::nullopt, below.probes, below.conePicture};
    if (below.previous)
        trace.previous.emplace(*below.previous);
    return trace;
}

HierarchyInputs CoatLobe::hierarchyInputs() {
    return {inputs(), prepared(), trace_->traced().rayRecord, stages_.plan.rays ? &rays_->rayRecord() : nullptr};
}

} // namespace glint::reflect
