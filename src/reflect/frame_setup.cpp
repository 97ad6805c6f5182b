// FrameStages: its sources, the host's inputs, and creation.
#include "reflect/frame.hpp"

namespace glint::reflect {

/// More than any frame writes; gpu::Frame drops further entries.
constexpr size_t kMaxWritten = 256;

// ---------------------------------------------------------------- the table of sources

std::vector<Source> FrameStages::makeSources() {
    std::vector<Source> sources(shared::kSourceCount);
    sources[shared::kSourceScreen] = {
        "screen", [this] { return stages_.settings().screen.enabled; }, {}, [this] { return &resolve_->answer(); }};
    sources[shared::kSourceRays] = {
        "rays", [this] { return usesRays(); },
        [this](gpu::Frame& frame, const EarlierAnswers& before) {
            raysSource_->record(frame, {inputs(), prepared(), before, trace_->traced().rayRecord, block_->sameView()});
        },
        [this] { return &raysSource_->answer(); }};
    sources[shared::kSourcePlanar] = {
        "planar", [this] { return stages_.settings().planar.enabled && planarSource_ && planarSource_->hasMirrors(); },
        [this](gpu::Frame& frame, const EarlierAnswers& before) {
            planarSource_->record(frame, {inputs(), prepared(), before});
        },
        [this] { return &planarSource_->answer(); }};
    sources[shared::kSourceProbes] = {"probes", [this] { return stages_.settings().probes.enabled && hasProbes(); },
                                      [this](gpu::Frame& frame, const EarlierAnswers& before) {
                                          probesSource_->record(frame, {inputs(), prepared(), before});
                                      },
                                      [this] { return &probesSource_->answer(); }};
    sources[shared::kSourceSky] = {"sky",
                                   [this] { return stages_.settings().sky.enabled && host_.images.environment; },
                                   {},
                                   [] { return nullptr; }};
    return sources;
}

// ---------------------------------------------------------------- the host's inputs

Result<void> FrameStages::setSettings(const Settings& settings) {
    GLINT_CHECK(trace_->make(settings));
    if (settings.screen.colorSource == ColorSource::Previous)
        GLINT_CHECK(rememberColors());
    if (settings.rays.enabled || reflect::denoises(settings))
        GLINT_CHECK(tables_->makeNoise(stages_.gpu));
    if (settings.rays.enabled && !raysSource_) {
        GLINT_TRY(source, RaysSource::create(stages_));
        GLINT_CHECK(source->setSettings(settings));
        raysSource_ = std::move(source);
        GLINT_CHECK(giveScene());
    } else if (raysSource_) {
        GLINT_CHECK(raysSource_->setSettings(settings));
        GLINT_CHECK(rehearseRays());
    }
    GLINT_CHECK(resolve_->make(settings));
    if (refraction_ && settings.refraction.enabled)
        GLINT_CHECK(refraction_->make());
    const bool marches = settings.screen.enabled || stages_.desc.inspection; // inspections record its pass
    const bool marchesPyramid = marches && techniqueFor(settings.screen.march).usesPyramid;
    if (marchesPyramid || (refraction_ && settings.refraction.enabled))
        GLINT_CHECK(pyramid_->make());
    GLINT_CHECK(setDenoise(settings));
    GLINT_CHECK(makeClasses(settings, host_.gbuffer));
    stages_.desc.settings = settings;
    GLINT_CHECK(setCones(settings));
    GLINT_CHECK(setTransparents(settings));
    recorded_ = false;
    written_.clear();
    return prepare_->setInputs(host_.gbuffer);
}

/// Compiles the passes that prepare pixels and find those that need a ray.
Result<void> FrameStages::makeClasses(const Settings& settings, const GBuffer& gbuffer) {
    const bool early = classifiesEarly(settings, gbuffer);
    if (settings.screen.enabled && !early)
        GLINT_CHECK(trace_->makeClassify());
    return gbuffer.depth.samples > 1 ? Result<void>() : prepare_->makeSurface(early);
}

Result<void> FrameStages::rememberColors() {
    GLINT_CHECK(outputs_.makePrevious());
    return colors_.remember();
}

/// Creates the copies of the picture once settings need them.
Result<void> FrameStages::setCones(const Settings& settings) {
    if (!ConePicture::isWanted(settings))
        return {};
    if (!conePicture_) {
        GLINT_TRY(picture, ConePicture::create(stages_));
        conePicture_ = std::move(picture);
    }
    GLINT_CHECK(conePicture_->make());
    gpu::Frame frame = gpu::Frame::rehearsal(stages_.gpu);
    conePicture_->record(frame, traceInputs());
    return frame.firstError();
}

/// Creates the march among transparent surfaces once settings need it.
Result<void> FrameStages::setTransparents(const Settings& settings) {
    if (!TransparentTrace::isWanted(settings))
        return {};
    if (!transparentTrace_) {
        GLINT_TRY(trace, TransparentTrace::create(stages_));
        transparentTrace_ = std::move(trace);
    }
    GLINT_CHECK(transparentTrace_->make(settings));
    gpu::Frame frame = gpu::Frame::rehearsal(stages_.gpu);
    transparentTrace_->record(frame, traceInputs(), trace_->target());
    return frame.firstError();
}

/// Creates the denoiser once settings need it, and starts its history anew.
Result<void> FrameStages::setDenoise(const Settings& settings) {
    if (denoiser_)
        denoiser_->forgetFrames(HistoryReset::Settings);
    if (!reflect::denoises(settings)) {
        hierarchy_->joinScreenAndRays({});
        return {};
    }
    hierarchy_->joinScreenAndRays([this](gpu::Frame& frame) { return &denoise(frame); });
    if (!denoiser_) {
        GLINT_TRY(denoise, Denoiser::create(stages_));
        denoiser_ = std::move(denoise);
    }
    GLINT_CHECK(denoiser_->make(settings));
    gpu::Frame frame = gpu::Frame::rehearsal(stages_.gpu);
    denoise(frame);
    return frame.firstError();
}

Result<void> FrameStages::setInputs(const GBuffer& gbuffer, const EnvironmentMap& environment) {
    if (raysSource_ && environment.cube.view != host_.environment.cube.view)
        raysSource_->environmentChanged();
    if (checker_ && (!host_.isSet() || gbuffer.conventions != host_.conventions()))
        checker_->restart();
    GLINT_CHECK(makeClasses(stages_.settings(), gbuffer));
    host_.set(gbuffer, environment);
    GLINT_CHECK(makeResults());
    return prepare_->setInputs(gbuffer);
}

/// Creates what combines and composites the sources' answers.
Result<void> FrameStages::makeResults() {
    if (readsReflected())
        GLINT_CHECK(hierarchy_->makeReflected(outputs_.reflection()));
    return hasComposite() ? composite_->make(!readsReflected()) : Result<void>();
}

Result<void> FrameStages::setOutputs(const Outputs& outputs) {
    const Outputs old = outputs_.stated();
    GLINT_CHECK(outputs_.set(outputs));
    if (const Result<void> made = makeResults(); !made) {
        GLINT_CHECK(outputs_.set(old));
        return made.error();
    }
    colors_.reset(HistoryReset::Settings);
    recorded_ = false;
    written_.clear();
    return {};
}

Result<void> FrameStages::takeSources(FrameStages& old) {
    frameNumber_ = old.frameNumber_;
    if (old.rayScene_ && old.raySurfaces_)
        GLINT_CHECK(setRays(*old.rayScene_, *old.raySurfaces_));
    else if (old.rayScene_)
        GLINT_CHECK(setRays(*old.rayScene_, old.shadeHits_));
    if (old.planarSource_ && old.planarSource_->planar())
        GLINT_CHECK(setPlanar(*old.planarSource_->planar()));
    if (ProbesState* const probes = old.probes())
        GLINT_CHECK(setProbes(*probes));
    return {};
}

void FrameStages::restartAccumulation() {
    if (!raysSource_)
        return;
    raysSource_->forgetFrames(HistoryReset::Asked);
    raysSource_->environmentChanged();
}

Result<void> FrameStages::setRays(rays::Scene& scene, SurfaceTableState& surfaces) {
    rayScene_ = &scene;
    raySurfaces_ = &surfaces;
    shadeHits_ = {};
    return giveScene();
}

Result<void> FrameStages::setRays(rays::Scene& scene, ShadeHits shade) {
    rayScene_ = &scene;
    raySurfaces_ = nullptr;
    shadeHits_ = std::move(shade);
    return giveScene();
}

/// Creates and rehearses the pipeline for the host's scene once source and scene exist.
Result<void> FrameStages::giveScene() {
    if (!raysSource_ || !rayScene_)
        return {};
    if (raySurfaces_)
        GLINT_CHECK(raysSource_->setScene(*rayScene_, *raySurfaces_));
    else
        GLINT_CHECK(raysSource_->setScene(*rayScene_, shadeHits_));
    return rehearseRays();
}

Result<void> FrameStages::rehearseRays() {
    if (!raysSource_->hasScene())
        return {};
    gpu::Frame frame = gpu::Frame::rehearsal(stages_.gpu);
    raysSource_->record(frame, {inputs(), prepared(), hierarchy_->noAnswersBefore(hierarchyInputs()),
                                trace_->traced().rayRecord, false});
    if (denoiser_)
        denoise(frame);
    raysSource_->end(frame);
    return frame.firstError();
}

Result<void> FrameStages::setPlanar(PlanarState& planar) {
    if (!planarSource_) {
        GLINT_TRY(source, PlanarSource::create(stages_));
        planarSource_ = std::move(source);
    }
    GLINT_CHECK(planarSource_->setPlanar(planar));
    gpu::Frame frame = gpu::Frame::rehearsal(stages_.gpu);
    planarSource_->record(frame, {inputs(), prepared(), hierarchy_->noAnswersBefore(hierarchyInputs())});
    return frame.firstError();
}

Result<void> FrameStages::setProbes(ProbesState& probes) {
    if (!probesSource_) {
        GLINT_TRY(source, ProbesSource::create(stages_));
        probesSource_ = std::move(source);
    }
    GLINT_CHECK(probesSource_->setProbes(probes));
    gpu::Frame frame = gpu::Frame::rehearsal(stages_.gpu);
    probesSource_->record(frame, {inputs(), prepared(), hierarchy_->noAnswersBefore(hierarchyInputs())});
    if (refraction_) {
        GLINT_CHECK(refraction_->setProbes(probes, stages_.retired));
        if (stages_.settings().refraction.enabled)
            GLINT_CHECK(refraction_->make());
        LayerImages layer;
        recordLayer(frame, layer);
    }
    return frame.firstError();
}

// ---------------------------------------------------------------- creation

Result<void> FrameStages::askForLongest(gpu::Context& context, const Settings& settings) {
    const Technique& march = techniqueFor(settings.screen.march);
    if (settings.screen.enabled)
        GLINT_CHECK(gpu::Pipeline::compute(context, {march.shader, 0, {}}));
    if (settings.screen.enabled && march.usesPyramid)
        GLINT_CHECK(gpu::Pipeline::compute(context, DepthPyramid::program()));
    if (reflect::denoises(settings))
        for (const char* shader : {"denoise/accumulate", "denoise/reuse", "denoise/filter"})
            GLINT_CHECK(gpu::Pipeline::compute(context, {shader, 0, {}}));
    return {};
}

Result<std::unique_ptr<FrameStages>> FrameStages::create(gpu::Context& context, const ReflectionsDesc& desc) {
    std::unique_ptr<FrameStages> frame(new FrameStages(context, desc));
    GLINT_CHECK(frame->createStages());
    GLINT_CHECK(frame->setSettings(desc.settings));
    GLINT_CHECK(frame->rehearse());
    return frame;
}

Result<void> FrameStages::createStages() {
    const ReflectionsDesc& desc = stages_.desc;
    const auto keep = [](auto& member, auto made) -> Result<void> {
        if (!made)
            return made.error();
        member = *std::move(made);
        return {};
    };
    GLINT_CHECK(keep(stages_.progress, gpu::Progress::create(stages_.gpu, "glint/progress", desc.framesInFlight)));
    GLINT_CHECK(outputs_.set({}));
    GLINT_CHECK(createDepths());
    GLINT_CHECK(keep(tables_, Tables::create(stages_.gpu)));
    GLINT_CHECK(keep(block_, FrameBlock::create(stages_)));
    GLINT_CHECK(keep(prepare_, Prepare::create(stages_)));
    GLINT_CHECK(keep(pyramid_, DepthPyramid::create(stages_)));
    GLINT_CHECK(keep(trace_, ScreenTrace::create(stages_)));
    GLINT_CHECK(keep(resolve_, ScreenResolve::create(stages_)));
    GLINT_CHECK(keep(hierarchy_, Hierarchy::create(stages_, makeSources())));
    GLINT_CHECK(keep(composite_, Composite::create(stages_)));
    GLINT_CHECK(makeResults());
    if (desc.transparentLayers)
        GLINT_CHECK(keep(refraction_, Refraction::create(stages_.gpu, desc.width, desc.height, desc.views)));
    if (desc.statistics)
        GLINT_CHECK(keep(counts_, RayCounts::create(stages_)));
    if (desc.views)
        GLINT_CHECK(keep(views_, Views::create(stages_)));
    written_.reserve(desc.views ? kMaxWritten : 0);
    if (desc.inspection)
        GLINT_CHECK(keep(inspector_, Inspector::create(stages_)));
    if (desc.inputCheck)
        GLINT_CHECK(keep(checker_, InputChecker::create(stages_)));
    if (desc.timers)
        GLINT_CHECK(keep(timers_, gpu::Timers::create(stages_.gpu)));
    return {};
}

Result<void> FrameStages::createDepths() {
    const std::array<StageImage, 1> images = {kViewZ.sized(stages_.width(), stages_.height())};
    return colors_.make(images, false);
}

/// Runs every pass without a command buffer: creation fails if a binding's name, kind or size is wrong.
Result<void> FrameStages::rehearse() {
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
    composite_->recordCombined(frame, hierarchyInputs(), *hierarchy_, trace_->rayTiles(), {rayRecord(), composite()});
    if (counts_)
        countRays(frame);
    if (refraction_) {
        refraction_->begin(frame, composite());
        LayerImages layer;
        recordLayer(frame, layer);
    }
    if (views_)
        views_->rehearse(frame, {hierarchyInputs(), *hierarchy_, resolve_->answer(), rayRecord(), nullptr, {}});
    if (inspector_)
        inspector_->rehearse(frame, inspectorInputs());
    if (checker_)
        checker_->rehearse(frame, inputs());
    return frame.firstError();
}

} // namespace glint::reflect
