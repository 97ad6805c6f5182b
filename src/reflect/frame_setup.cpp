// FrameStages: its sources, its plan, the host's inputs, and creation.
#include "reflect/frame.hpp"

namespace glint::reflect {

/// More than any frame writes; gpu::Frame drops further entries.
constexpr size_t kMaxWritten = 256;

// ---------------------------------------------------------------- the table of sources

std::vector<Source> FrameStages::makeSources() {
    std::vector<Source> sources(shared::kSourceCount);
    sources[shared::kSourceScreen] = {"screen", &FramePlan::screen, {}, [this] { return &resolve_->answer(); }};
    sources[shared::kSourceRays] = {"rays", &FramePlan::rays,
                                    [this](gpu::Frame& frame, const EarlierAnswers& before) {
                                        raysSource()->record(frame,
                                                             {inputs(), prepared(), before, trace_->traced().rayRecord,
                                                              block_->sameView(), previousFrame()});
                                    },
                                    [this] { return &raysSource()->answer(); }};
    sources[shared::kSourcePlanar] = {"planar", &FramePlan::planar,
                                      [this](gpu::Frame& frame, const EarlierAnswers& before) {
                                          planarSource_->record(frame, {inputs(), prepared(), before});
                                      },
                                      [this] { return &planarSource_->answer(); }};
    sources[shared::kSourceProbes] = {"probes", &FramePlan::probes,
                                      [this](gpu::Frame& frame, const EarlierAnswers& before) {
                                          probesSource_->record(frame, {inputs(), prepared(), before});
                                      },
                                      [this] { return &probesSource_->answer(); }};
    sources[shared::kSourceSky] = {"sky", &FramePlan::sky, {}, [] { return nullptr; }};
    return sources;
}

// ---------------------------------------------------------------- the plan

/// What the plan depends on, as it is in force. All pixels are in use.
PlanInputs FrameStages::planInputs() const {
    const ReflectionsDesc& desc = stages_.desc;
    const GBuffer& gbuffer = host_.gbuffer;
    PlanInputs inputs = {.settings = desc.settings,
                         .width = desc.width,
                         .height = desc.height,
                         .views = desc.views,
                         .inspection = desc.inspection,
                         .statistics = desc.statistics,
                         .transparentLayers = desc.transparentLayers,
                         .inputCheck = desc.inputCheck,
                         .compositeOutput = static_cast<bool>(outputs_.stated().composite),
                         .reflectionOutput = static_cast<bool>(outputs_.stated().reflection),
                         .scene = scene_.scene != nullptr,
                         .shadesHits = scene_.scene && !scene_.surfaces,
                         .mirrors = planarSource_ && planarSource_->hasMirrors(),
                         .probes = hasProbes(),
                         .extentWidth = desc.width,
                         .extentHeight = desc.height};
    inputs.setImages(gbuffer, host_.environment);
    return inputs;
}

/// Plans the frame again, for the pixels in use.
void FrameStages::replan() {
    PlanInputs inputs = planInputs();
    inputs.extentWidth = stages_.extent.x;
    inputs.extentHeight = stages_.extent.y;
    adopt(inputs);
}

void FrameStages::adopt(const PlanInputs& inputs) {
    stages_.desc.settings = inputs.settings;
    stages_.plan = planFrame(inputs);
    optional_.plan(inputs);
}

/// Plans the frame for other settings or inputs, and creates what the plan needs for the first time. `withOptional`:
/// optional stages get the settings, which starts their histories again. On error the old plan stays in force.
Result<void> FrameStages::change(const PlanInputs& next, bool withOptional) {
    const PlanInputs old = planInputs();
    adopt(next);
    Result<void> made = makeFixed(next);
    if (made && withOptional)
        made = optional_.make(stages_, [this]<class Stage>(Stage& stage) {
            if constexpr (std::is_same_v<Stage, RaysSource>)
                return stage.hasScene() ? Result<void>() : giveScene(stage);
            return Result<void>();
        });
    if (made)
        made = makeCoat(withOptional);
    if (!made)
        adopt(old);
    return made;
}

/// The lobe of clear coats, once a host states one. Its passes are the surfaces' own, which are rehearsed. `again`: the
/// settings are others.
Result<void> FrameStages::makeCoat(bool again) {
    if (!stages_.plan.coat)
        return {};
    if (!coat_) {
        GLINT_TRY(made, CoatLobe::create(stages_));
        coat_ = std::move(made);
    }
    return coat_->make(
        {scene_.scene, scene_.surfaces, scene_.shade, planarSource_ ? planarSource_->planar() : nullptr, probes()},
        again);
}

/// What the plan keeps of the previous frame.
Result<void> FrameStages::makePrevious() {
    if (!stages_.plan.previousColors && !stages_.plan.previousEnds)
        return {};
    GLINT_CHECK(outputs_.makePrevious());
    return colors_.remember();
}

/// What the stages that every frame has need for the plan.
Result<void> FrameStages::makeFixed(const PlanInputs& inputs) {
    const FramePlan& plan = stages_.plan;
    GLINT_CHECK(trace_->make());
    GLINT_CHECK(makePrevious());
    if (inputs.settings.rays.enabled || plan.denoise)
        GLINT_CHECK(tables_->makeNoise(stages_.gpu));
    GLINT_CHECK(resolve_->make());
    if (DepthPyramid::wanted(inputs))
        GLINT_CHECK(pyramid_->make());
    GLINT_CHECK(prepare_->make());
    if (plan.combines)
        GLINT_CHECK(hierarchy_->makeReflected(outputs_.reflection()));
    return plan.composites ? composite_->make(!plan.combines) : Result<void>();
}

std::vector<FrameDecision> FrameStages::decisions() const {
    std::vector<FrameDecision> rows = decisionsOf(stages_.plan);
    optional_.describe(rows);
    return rows;
}

// ---------------------------------------------------------------- the host's inputs

Result<void> FrameStages::setSettings(const Settings& settings) {
    PlanInputs next = planInputs();
    next.settings = settings;
    GLINT_CHECK(change(next, true));
    using Join = Hierarchy::Join;
    hierarchy_->joinScreenAndRays(
        stages_.plan.denoise ? Join([this](gpu::Frame& frame) { return &denoise(frame, *optional_.find<Denoiser>()); })
                             : Join());
    recorded_ = false;
    written_.clear();
    gpu::Frame frame = gpu::Frame::rehearsal(stages_.gpu);
    optional_.forEach([&](auto& stage) { rehearse(frame, stage); });
    return frame.firstError();
}

Result<void> FrameStages::setInputs(const GBuffer& gbuffer, const EnvironmentMap& environment) {
    PlanInputs next = planInputs();
    next.setImages(gbuffer, environment);
    GLINT_CHECK(change(next, false));
    if (environment.cube.view != host_.environment.cube.view) {
        if (RaysSource* const rays = raysSource())
            rays->environmentChanged();
        if (coat_)
            coat_->environmentChanged();
    }
    if (InputChecker* const checker = inputChecker();
        checker && (!host_.isSet() || gbuffer.conventions != host_.conventions()))
        checker->restart();
    host_.set(gbuffer, environment);
    return {};
}

Result<void> FrameStages::setOutputs(const Outputs& outputs) {
    const Outputs old = outputs_.stated();
    GLINT_CHECK(outputs_.set(outputs));
    if (const Result<void> made = change(planInputs(), false); !made) {
        GLINT_CHECK(outputs_.set(old));
        replan();
        return made.error();
    }
    colors_.reset(HistoryReset::Settings);
    recorded_ = false;
    written_.clear();
    return {};
}

Result<void> FrameStages::takeSources(FrameStages& old) {
    frameNumber_ = old.frameNumber_;
    if (old.scene_.scene)
        GLINT_CHECK(setRays(old.scene_));
    if (old.planarSource_ && old.planarSource_->planar())
        GLINT_CHECK(setPlanar(*old.planarSource_->planar()));
    if (ProbesState* const probes = old.probes())
        GLINT_CHECK(setProbes(*probes));
    return {};
}

void FrameStages::restartAccumulation() {
    if (coat_)
        coat_->restartAccumulation();
    RaysSource* const rays = raysSource();
    if (!rays)
        return;
    rays->forgetFrames(HistoryReset::Asked);
    rays->environmentChanged();
}

Result<void> FrameStages::setRays(GivenScene given) {
    std::swap(scene_, given);
    RaysSource* const rays = raysSource();
    replan(); // paths may end in the previous picture, now that there are paths
    Result<void> set = makePrevious();
    if (set && rays)
        set = giveScene(*rays);
    if (!set) {
        std::swap(scene_, given);
        replan();
        return set.error();
    }
    GLINT_CHECK(makeCoat(false));
    return rays ? rehearseAlone(*rays) : Result<void>();
}

/// Creates the pipelines for the host's scene once there is one.
Result<void> FrameStages::giveScene(RaysSource& source) {
    if (!scene_.scene)
        return {};
    return scene_.surfaces ? source.setScene(*scene_.scene, *scene_.surfaces)
                           : source.setScene(*scene_.scene, scene_.shade);
}

Result<void> FrameStages::setPlanar(PlanarState& planar) {
    if (!planarSource_) {
        GLINT_TRY(source, PlanarSource::create(stages_));
        planarSource_ = std::move(source);
    }
    GLINT_CHECK(planarSource_->setPlanar(planar));
    replan();
    GLINT_CHECK(makeCoat(false));
    return rehearseAlone(*planarSource_);
}

Result<void> FrameStages::setProbes(ProbesState& probes) {
    if (!probesSource_) {
        GLINT_TRY(source, ProbesSource::create(stages_));
        probesSource_ = std::move(source);
    }
    GLINT_CHECK(probesSource_->setProbes(probes));
    replan();
    GLINT_CHECK(makeCoat(false));
    GLINT_CHECK(rehearseAlone(*probesSource_));
    Refraction* const refraction = optional_.find<Refraction>();
    if (!refraction)
        return {};
    GLINT_CHECK(refraction->setProbes(probes, stages_.retired));
    GLINT_CHECK(refraction->make(stages_.settings()));
    return rehearseAlone(*refraction);
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
    GLINT_CHECK(frame->rehearseFixed());
    GLINT_CHECK(frame->setSettings(desc.settings));
    return frame;
}

/// Creates the stages that every frame has; setSettings creates the others.
Result<void> FrameStages::createStages() {
    const auto keep = [](auto& member, auto made) -> Result<void> {
        if (!made)
            return made.error();
        member = *std::move(made);
        return {};
    };
    const ReflectionsDesc& desc = stages_.desc;
    const std::array<StageImage, 1> depths = {kViewZ.sized(stages_.width(), stages_.height())};
    GLINT_CHECK(keep(stages_.progress, gpu::Progress::create(stages_.gpu, "glint/progress", desc.framesInFlight)));
    GLINT_CHECK(outputs_.set({}));
    GLINT_CHECK(colors_.make(depths, false));
    GLINT_CHECK(keep(tables_, Tables::create(stages_.gpu)));
    GLINT_CHECK(keep(block_, FrameBlock::create(stages_)));
    GLINT_CHECK(keep(prepare_, Prepare::create(stages_)));
    GLINT_CHECK(keep(pyramid_, DepthPyramid::create(stages_)));
    GLINT_CHECK(keep(trace_, ScreenTrace::create(stages_)));
    GLINT_CHECK(keep(resolve_, ScreenResolve::create(stages_)));
    GLINT_CHECK(keep(hierarchy_, Hierarchy::create(stages_, makeSources())));
    GLINT_CHECK(keep(composite_, Composite::create(stages_)));
    written_.reserve(desc.views ? kMaxWritten : 0);
    return desc.timers ? keep(timers_, gpu::Timers::create(stages_.gpu)) : Result<void>();
}

} // namespace glint::reflect
