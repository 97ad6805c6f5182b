#include "reflect/frame.hpp"

#include "reflect/input_checks.hpp"

#include <algorithm>
#include <utility>

namespace glint::reflect {
namespace {

/// Since the previous frame.
double secondsOf(const View& view) {
    return view.seconds > 0 ? view.seconds : 1.0 / 60.0;
}

} // namespace

// ---------------------------------------------------------------- the frame, top to bottom

void FrameStages::recordFrame(gpu::Frame& frame, const View& view) {
    const FramePlan& plan = stages_.plan;
    clear(frame);
    previousHasLayers_ = std::exchange(hasLayers_, false);
    if (view.cut)
        forgetFrames(HistoryReset::View);
    if (colors_.begin(frame, plan.previousColors || plan.previousEnds))
        outputs_.remember(frame);
    if (Denoiser* const denoiser = optional_.find<Denoiser>())
        denoiser->begin(frame);
    prepare(frame, view);
    if (plan.tracesScreen)
        traceScreen(frame);
    else
        resolve_->recordNothing(trace_->recordNothing(frame));
    if (plan.layers && !plan.tracesScreen)
        pyramid_->record(frame, inputs(), prepared(), nullptr);
    if (plan.reflects)
        hierarchy_->recordSources(frame, hierarchyInputs());
    recordComposite(frame, recordCoat(frame, view));
    optional_.record(frame, Moment::AfterAll, stageInputs());
    if (plan.countsRays)
        countRays(frame, *optional_.find<RayCounts>());
    if (plan.layers)
        optional_.find<Refraction>()->begin(frame, composite());
    colors_.end(frame, stages_.settings().debug.outcome ? HistoryReset::NotLight : HistoryReset::None);
    if (Denoiser* const denoiser = optional_.find<Denoiser>())
        denoiser->end(frame);
    if (plan.rays)
        raysSource()->end(frame);
}

/// The screen's rays, from the list of pixels that need one to an answer for every pixel.
void FrameStages::traceScreen(gpu::Frame& frame) {
    const FramePlan& plan = stages_.plan;
    if (!plan.classifiesEarly)
        trace_->classify(frame, inputs(), prepared());
    trace_->list(frame, prepare_->backFaceGroups(), plan.coat);
    prepare_->recordBackFaces(frame, inputs(), colors_.now(kViewZ), trace_->rays());
    if (plan.pyramid)
        pyramid_->record(frame, inputs(), prepared(), plan.layers ? nullptr : &trace_->rays());
    optional_.record(frame, Moment::BeforeMarch, stageInputs());
    const Traced traced = trace_->record(frame, traceInputs());
    optional_.record(frame, Moment::AfterMarch, stageInputs());
    resolve_->record(frame, {traceInputs(), traced});
}

/// Combines the sources, and replaces the host's reflections by them.
void FrameStages::recordComposite(gpu::Frame& frame, gpu::Image* coat) {
    if (!stages_.plan.combines) {
        composite_->recordCombined(frame, hierarchyInputs(), *hierarchy_, trace_->rayTiles(),
                                   {rayRecord(), composite()});
        return;
    }
    const Reflected reflected = hierarchy_->combine(frame, hierarchyInputs());
    if (stages_.plan.composites)
        composite_->record(frame, hierarchyInputs(), reflected, {rayRecord(), composite(), coat});
}

/// What clear coats reflect, by the same passes; null where the host states none.
gpu::Image* FrameStages::recordCoat(gpu::Frame& frame, const View& view) {
    if (!coat_)
        return nullptr;
    if (!stages_.plan.coat) {
        coat_->forgetFrames(HistoryReset::NotLight);
        coat_->restartAccumulation();
        return nullptr;
    }
    gpu::Image* reflected = nullptr;
    const CoatInputs inputs = {traceInputs(),
                               *block_,
                               colors_,
                               frameNumber_,
                               secondsOf(view),
                               [this, &frame](const StageInputs& stage) { optional_.record(frame, Moment::AfterMarch, stage); }};
    frame.scope("coat",
                [&] { frame.untimed([&] { frame.unnoted([&] { reflected = &coat_->record(frame, inputs); }); }); });
    return reflected;
}

void FrameStages::prepare(gpu::Frame& frame, const View& view) {
    block_->begin(view, host_);
    if (!block_->sameProjection() && colors_.valid())
        colors_.drop(HistoryReset::View);
    const FramePlan& plan = stages_.plan;
    trace_->begin(plan.rays && !plan.screen); // the record of `rays` has the frame's size
    const Traced traced = trace_->traced();
    block_->record(frame, host_, resolveSettings(view), {traced.width, traced.height}, colors_);
    if (plan.denoise)
        optional_.find<Denoiser>()->copyTag(frame, block_->buffer(),
                                            offsetof(FrameBlockValues, settings.denoise.historyTag));
    if (!plan.classifiesEarly) {
        prepare_->record(frame, inputs(), colors_.now(kViewZ));
        return;
    }
    trace_->beginClasses(frame);
    prepare_->recordClassified(frame, inputs(), colors_.now(kViewZ),
                               [this](gpu::Pass& pass) { trace_->bindClasses(pass); });
}

/// The settings in force, with the inputs of this frame: a host may add lights or probes at any time.
shared::SettingsConstants FrameStages::resolveSettings(const View& view) {
    const Settings& settings = stages_.settings();
    const FramePlan& plan = stages_.plan;
    const uint32_t levels = pyramid_->pyramid().levels;
    shared::SettingsConstants resolved = {};
    resolved.trace = traceConstants(settings, plan.backFaces);
    resolved.trace.flags |= plan.backFacesInPlace ? shared::kTraceBackInPlace : 0;
    resolved.trace.flags |= plan.keepsRecord ? shared::kTraceRecords : 0;
    resolved.trace.flags |= plan.storesListedOnly ? shared::kTraceListedOnly : 0;
    resolved.trace.flags |= plan.probes ? shared::kTraceNextOther : plan.sky ? shared::kTraceNextSky : 0;
    resolved.trace.minLevel = std::min(resolved.trace.minLevel, levels);
    resolved.trace.maxLevel = std::min(resolved.trace.maxLevel, levels);
    resolved.layerTrace = layerTraceConstants(settings, levels);
    resolved.refraction =
        refractionConstants(settings, probes() != nullptr, static_cast<bool>(host_.images.environment));
    if (plan.rays)
        resolved.rays = raysSource()->constants(host_.images, hierarchy_->before(shared::kSourceRays));
    resolved.planar = PlanarSource::constants(settings, hierarchy_->before(shared::kSourcePlanar));
    resolved.probes = {probeFlags(settings), hierarchy_->before(shared::kSourceProbes)};
    resolved.hierarchy = hierarchy_->constants();
    resolved.blur = blurConstants(settings);
    if (plan.denoise)
        resolved.denoise =
            optional_.find<Denoiser>()->constants(secondsOf(view), plan.rays && raysSource()->branches());
    resolved.composite = composite_->constants();
    return resolved;
}

/// Initializes images that may be read before they are written.
void FrameStages::clear(gpu::Frame& frame) {
    prepare_->clear(frame);
    pyramid_->clear(frame);
    trace_->clear(frame);
    optional_.clear(frame);
    tables_->record(frame, stages_.progress);
}

/// Initializes images that the last frame did not need, so that views can show them.
void FrameStages::bringUpToDate(gpu::Frame& frame) {
    if (ranPasses_ || !upToDate_.isNeeded(stages_.progress))
        return;
    clear(frame);
    prepare(frame, lastView_);
    resolve_->recordNothing(trace_->recordNothing(frame));
    hierarchy_->record(frame, hierarchyInputs());
    if (!frame.rehearsing())
        upToDate_.recorded(stages_.progress);
}

void FrameStages::countRays(gpu::Frame& frame, RayCounts& rayCounts) {
    const Traced traced = trace_->traced();
    rayCounts.record(frame, inputs(), rayRecord(), traced.width, traced.height, [&](gpu::Buffer& counts) {
        if (stages_.plan.rays)
            raysSource()->count(frame, inputs(), counts);
    });
}

void FrameStages::recordLayer(gpu::Frame& frame, LayerImages& layer) {
    optional_.find<Refraction>()->record(frame, layer, {inputs(), prepared(), pyramid_->pyramid(), probes()},
                                         composite());
}

// ---------------------------------------------------------------- recordings

HostImage FrameStages::record(VkCommandBuffer commands, const View& view) {
    host_.lend();
    outputs_.lend();
    frameNumber_ = view.frameNumber > 0 ? view.frameNumber : frameNumber_ + 1;
    stages_.progress.begin(frameNumber_);
    stages_.retired.begin(frameNumber_, stages_.desc.framesInFlight);
    lastView_ = view;
    stages_.extent = {view.width > 0 ? view.width : stages_.width(), view.height > 0 ? view.height : stages_.height()};
    replan(); // the host adds mirrors and probes at any time, and may use another extent
    recorded_ = true;
    ranPasses_ = stages_.plan.records;
    upToDate_.ask();
    written_.clear();
    InputChecker* const checker = inputChecker();
    if (checker)
        checker->begin(view, frameNumber_);
    if (!ranPasses_) {
        forgetFrames(HistoryReset::NotLight);
        return host_.gbuffer.litRadiance;
    }
    gpu::Frame frame(stages_.gpu, commands, timers_.get(), stages_.desc.views ? &written_ : nullptr);
    recordFrame(frame, view);
    if (checker && checker->isDue())
        checker->record(frame, inputs(), host_.gbuffer);
    outputs_.handOut(frame);
    host_.giveBack(frame);
    stages_.progress.end(frame);
    return outputs_.result();
}

void FrameStages::forget() {
    written_.clear();
    recorded_ = ranPasses_ = false;
    upToDate_.ask();
    if (InputChecker* const checker = inputChecker())
        checker->forget();
    forgetFrames(HistoryReset::NotLight);
}

void FrameStages::forgetFrames(HistoryReset reason) {
    colors_.reset(reason);
    if (Denoiser* const denoiser = optional_.find<Denoiser>())
        denoiser->forgetFrames(reason);
    if (coat_)
        coat_->forgetFrames(reason);
}

HostImage FrameStages::recordLayer(VkCommandBuffer commands, const TransparentLayer& layer, VkImageLayout layout) {
    host_.lendEnvironment();
    for (const LayerImage& image : kLayerImages)
        lend(layer_.*image.borrowed, layer.*image.host, image.name);
    gpu::Frame frame = gpu::Frame::more(stages_.gpu, commands, timers_.get());
    outputs_.lend();
    frame.find(composite(), layout); // the host may have drawn over it
    recordLayer(frame, layer_);
    hasLayers_ = true;
    outputs_.handOut(frame);
    for (const LayerImage& image : kLayerImages)
        giveBack(frame, layer_.*image.borrowed, layer.*image.host);
    giveBack(frame, host_.images.environment, host_.environment.cube);
    return outputs_.result();
}

gpu::Image& FrameStages::recordView(VkCommandBuffer commands, uint32_t view) {
    host_.lend();
    outputs_.lend();
    stages_.progress.begin(frameNumber_);
    gpu::Frame frame(stages_.gpu, commands);
    bringUpToDate(frame);
    const bool layers = recorded_ && stages_.plan.layers;
    Denoiser* const denoiser = ranPasses_ ? optional_.findWanted<Denoiser>() : nullptr;
    gpu::Image& image = optional_.find<Views>()->record(frame,
                                                        {hierarchyInputs(), *hierarchy_, resolve_->answer(),
                                                         rayRecord(), layers ? optional_.find<Refraction>() : nullptr,
                                                         denoiser ? denoiser->history() : std::nullopt},
                                                        view);
    frame.hand(image, kHandedOut);
    outputs_.giveBack(frame);
    host_.giveBack(frame);
    stages_.progress.end(frame);
    return image;
}

gpu::Image& FrameStages::recordWritten(VkCommandBuffer commands, size_t image) {
    outputs_.lend();
    stages_.progress.begin(frameNumber_);
    gpu::Frame frame(stages_.gpu, commands);
    gpu::Image& shown = optional_.find<Views>()->show(frame, *written_[image].image);
    frame.hand(shown, kHandedOut);
    outputs_.giveBack(frame);
    stages_.progress.end(frame);
    return shown;
}

void FrameStages::recordInspection(VkCommandBuffer commands, uint32_t x, uint32_t y) {
    host_.lend();
    outputs_.lend();
    stages_.progress.begin(frameNumber_);
    gpu::Frame frame(stages_.gpu, commands);
    bringUpToDate(frame);
    optional_.find<Inspector>()->record(frame, inspectorInputs(), x, y);
    if (ranPasses_)
        outputs_.handOut(frame);
    host_.giveBack(frame);
    stages_.progress.end(frame);
}

void FrameStages::recordInputCheck(VkCommandBuffer commands, const std::optional<KnownPlane>& plane) {
    host_.lend();
    stages_.progress.begin(frameNumber_);
    gpu::Frame frame(stages_.gpu, commands);
    tables_->record(frame, stages_.progress);
    inputChecker()->record(frame, inputs(), host_.gbuffer, plane);
    host_.giveBack(frame);
    stages_.progress.end(frame);
}

// ---------------------------------------------------------------- outputs that other stages read

/// Joins and denoises the answers of screen and rays.
gpu::Image& FrameStages::denoise(gpu::Frame& frame, Denoiser& denoiser) {
    const FramePlan& plan = stages_.plan;
    const Traced traced = trace_->traced();
    RaysSource* const rays = plan.rays ? raysSource() : nullptr;
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
    return denoiser.record(frame, joined);
}

gpu::Image& FrameStages::rayRecord() {
    return stages_.plan.rays && !stages_.plan.screen ? raysSource()->rayRecord() : trace_->traced().rayRecord;
}

TraceInputs FrameStages::traceInputs() {
    ConePicture* const cones = optional_.findWanted<ConePicture>();
    TraceInputs trace = {inputs(),
                         prepared(),
                         met(),
                         trace_->rays(),
                         pyramid_->pyramid(),
                         {},
                         probes(),
                         cones ? &cones->image() : nullptr};
    if (const std::optional<PreviousFrame> previous = previousFrame())
        trace.previous.emplace(*previous);
    return trace;
}

std::optional<PreviousFrame> FrameStages::previousFrame() {
    if (!colors_.valid())
        return {};
    return PreviousFrame{previousHasLayers_ ? optional_.find<Refraction>()->withoutLayers() : outputs_.previous(),
                         outputs_.previous(), colors_.before(kViewZ)};
}

StageInputs FrameStages::stageInputs() {
    return {traceInputs(), trace_->target(), rayRecord(), stages_.plan.composites ? &composite() : nullptr};
}

HierarchyInputs FrameStages::hierarchyInputs() {
    return {inputs(), prepared(), trace_->traced().rayRecord, stages_.plan.rays ? &raysSource()->rayRecord() : nullptr};
}

InspectorInputs FrameStages::inspectorInputs() {
    return {traceInputs(),     trace_->target(),
            hierarchyInputs(), *hierarchy_,
            rayRecord(),       ranPasses_ && stages_.plan.composites ? composite() : host_.images.litRadiance};
}

// ---------------------------------------------------------------- results

std::vector<gpu::PassTime> FrameStages::passTimes() const {
    return ranPasses_ && timers_ ? timers_->latest() : std::vector<gpu::PassTime>();
}

Statistics FrameStages::statistics() const {
    return stages_.plan.countsRays ? optional_.find<RayCounts>()->read() : Statistics();
}

} // namespace glint::reflect
