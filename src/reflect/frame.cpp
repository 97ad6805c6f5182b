#include "reflect/frame.hpp"

#include "reflect/input_checks.hpp"

#include <algorithm>
#include <utility>

namespace glint::reflect {

// ---------------------------------------------------------------- the frame, top to bottom

void FrameStages::recordFrame(gpu::Frame& frame, const View& view) {
    const Settings& settings = stages_.settings();
    clear(frame);
    previousHasLayers_ = std::exchange(hasLayers_, false);
    if (view.cut)
        forgetFrames(HistoryReset::View);
    if (colors_.begin(frame, wantsHistory()))
        outputs_.remember(frame);
    if (denoiser_)
        denoiser_->begin(frame, followsSentinels());
    prepare(frame, view);
    const bool reflects = hierarchy_->anySource() || settings.debug.outcome;
    if (reflects && settings.screen.enabled) {
        if (!classifiesEarly())
            trace_->classify(frame, inputs(), prepared());
        trace_->list(frame, prepare_->backFaceGroups());
        prepare_->recordBackFaces(frame, inputs(), colors_.now(kViewZ), trace_->rays());
        if (techniqueFor(settings.screen.march).usesPyramid || expectsLayers())
            pyramid_->record(frame, inputs(), prepared(), expectsLayers() ? nullptr : &trace_->rays());
        if (blursHits())
            conePicture_->record(frame, traceInputs());
        const Traced traced = trace_->record(frame, traceInputs());
        if (meetsTransparents())
            transparentTrace_->record(frame, traceInputs(), trace_->target());
        resolve_->record(frame, {traceInputs(), traced});
    } else {
        resolve_->recordNothing(trace_->recordNothing(frame));
        if (expectsLayers())
            pyramid_->record(frame, inputs(), prepared(), nullptr);
    }
    if (reflects)
        hierarchy_->recordSources(frame, hierarchyInputs());
    recordComposite(frame);
    if (counts_ && tracesRays())
        countRays(frame);
    if (expectsLayers())
        refraction_->begin(frame, composite());
    colors_.end(frame, settings.debug.outcome ? HistoryReset::NotLight : HistoryReset::None);
    if (denoiser_)
        denoiser_->end(frame);
    if (usesRays())
        raysSource_->end(frame);
}

/// Combines the sources, and replaces the host's reflections by them.
void FrameStages::recordComposite(gpu::Frame& frame) {
    if (!readsReflected()) {
        composite_->recordCombined(frame, hierarchyInputs(), *hierarchy_, trace_->rayTiles(),
                                   {rayRecord(), composite()});
        return;
    }
    const Reflected reflected = hierarchy_->combine(frame, hierarchyInputs());
    if (hasComposite())
        composite_->record(frame, hierarchyInputs(), reflected, {rayRecord(), composite()});
}

void FrameStages::prepare(gpu::Frame& frame, const View& view) {
    block_->begin(view, host_);
    if (!block_->sameProjection() && colors_.valid())
        colors_.drop(HistoryReset::View);
    trace_->begin(usesRays() && !stages_.settings().screen.enabled); // the record of `rays` has the frame's size
    const Traced traced = trace_->traced();
    block_->record(frame, host_, resolveSettings(view), {traced.width, traced.height}, colors_);
    if (denoises())
        denoiser_->copyTag(frame, block_->buffer(), offsetof(FrameBlockValues, settings.denoise.historyTag));
    if (!classifiesEarly()) {
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
    const uint32_t levels = pyramid_->pyramid().levels;
    shared::SettingsConstants resolved = {};
    resolved.trace = traceConstants(settings, prepare_->backFacesKnown());
    resolved.trace.flags |= prepare_->backFacesInPlace() ? shared::kTraceBackInPlace : 0;
    resolved.trace.flags |= trace_->keepsRecord(settings) ? shared::kTraceRecords : 0;
    resolved.trace.flags |= storesListedOnly() ? shared::kTraceListedOnly : 0;
    resolved.trace.minLevel = std::min(resolved.trace.minLevel, levels);
    resolved.trace.maxLevel = std::min(resolved.trace.maxLevel, levels);
    resolved.layerTrace = layerTraceConstants(settings, levels);
    resolved.refraction =
        refractionConstants(settings, probes() != nullptr, static_cast<bool>(host_.images.environment));
    if (usesRays())
        resolved.rays = raysSource_->constants(host_.images, hierarchy_->before(shared::kSourceRays));
    resolved.planar = PlanarSource::constants(settings, hierarchy_->before(shared::kSourcePlanar));
    resolved.probes = {probeFlags(settings), hierarchy_->before(shared::kSourceProbes)};
    resolved.hierarchy = hierarchy_->constants();
    resolved.blur = blurConstants(settings);
    if (denoises())
        resolved.denoise = denoiser_->constants(view.seconds > 0 ? view.seconds : 1.0 / 60.0, averagesMirrored());
    resolved.composite = composite_->constants();
    return resolved;
}

/// Initializes images that may be read before they are written.
void FrameStages::clear(gpu::Frame& frame) {
    prepare_->clear(frame);
    pyramid_->clear(frame);
    trace_->clear(frame);
    if (conePicture_)
        conePicture_->clear(frame);
    if (transparentTrace_)
        transparentTrace_->clear(frame);
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

void FrameStages::countRays(gpu::Frame& frame) {
    const Traced traced = trace_->traced();
    counts_->record(frame, inputs(), rayRecord(), traced.width, traced.height, [&](gpu::Buffer& counts) {
        if (usesRays())
            raysSource_->count(frame, inputs(), counts);
    });
}

void FrameStages::recordLayer(gpu::Frame& frame, LayerImages& layer) {
    refraction_->record(frame, layer, {inputs(), prepared(), pyramid_->pyramid(), probes()}, composite());
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
    recorded_ = true;
    ranPasses_ = hierarchy_->anySource() || stages_.settings().debug.outcome || expectsLayers() || outputs_.areHosts();
    upToDate_.ask();
    written_.clear();
    if (checker_)
        checker_->begin(view, frameNumber_);
    if (!ranPasses_) {
        forgetFrames(HistoryReset::NotLight);
        return host_.gbuffer.litRadiance;
    }
    gpu::Frame frame(stages_.gpu, commands, timers_.get(), views_ ? &written_ : nullptr);
    recordFrame(frame, view);
    if (checker_ && checker_->isDue())
        checker_->record(frame, inputs(), host_.gbuffer);
    outputs_.handOut(frame);
    host_.giveBack(frame);
    stages_.progress.end(frame);
    return outputs_.result();
}

void FrameStages::forget() {
    written_.clear();
    recorded_ = ranPasses_ = false;
    upToDate_.ask();
    if (checker_)
        checker_->forget();
    forgetFrames(HistoryReset::NotLight);
}

void FrameStages::forgetFrames(HistoryReset reason) {
    colors_.reset(reason);
    if (denoiser_)
        denoiser_->forgetFrames(reason);
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
    const bool layers = recorded_ && expectsLayers();
    const bool denoised = ranPasses_ && denoises();
    gpu::Image& image =
        views_->record(frame,
                       {hierarchyInputs(), *hierarchy_, resolve_->answer(), rayRecord(),
                        layers ? refraction_.get() : nullptr, denoised ? denoiser_->history() : std::nullopt},
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
    gpu::Image& shown = views_->show(frame, *written_[image].image);
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
    inspector_->record(frame, inspectorInputs(), x, y);
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
    checker_->record(frame, inputs(), host_.gbuffer, plane);
    host_.giveBack(frame);
    stages_.progress.end(frame);
}

// ---------------------------------------------------------------- outputs that other stages read

bool FrameStages::wantsHistory() const {
    const ScreenSettings& screen = stages_.settings().screen;
    return screen.enabled && screen.colorSource == ColorSource::Previous;
}

/// Without a previous frame no colour of a transparent surface is known.
bool FrameStages::meetsTransparents() const {
    return TransparentTrace::isWanted(stages_.settings()) && host_.images.transparentDepth && colors_.valid();
}

bool FrameStages::averagesMirrored() const {
    return usesRays() && raysSource_->branches();
}

/// Joins and denoises the answers of screen and rays.
gpu::Image& FrameStages::denoise(gpu::Frame& frame) {
    const Traced traced = trace_->traced();
    const bool screen = stages_.settings().screen.enabled;
    DenoiserInputs joined = {inputs(),
                             prepared(),
                             screen ? &traced.target : nullptr,
                             traced.rayRecord,
                             usesRays() ? &raysSource_->answer() : nullptr,
                             usesRays() ? raysSource_->rayRecord() : traced.rayRecord,
                             hierarchy_->raysComeFirst(),
                             {},
                             {}};
    if (usesRays() && raysSource_->storesApart())
        joined.mirrored.emplace(raysSource_->mirrored());
    if (followsSentinels())
        joined.followPaths = [this](gpu::Frame& f, const SentinelImages& images) {
            raysSource_->recordSentinels(f, inputs(), prepared(), images);
        };
    return denoiser_->record(frame, joined);
}

gpu::Image& FrameStages::rayRecord() {
    return usesRays() && !stages_.settings().screen.enabled ? raysSource_->rayRecord() : trace_->traced().rayRecord;
}

TraceInputs FrameStages::traceInputs() {
    TraceInputs trace = {inputs(),
                         prepared(),
                         met(),
                         trace_->rays(),
                         pyramid_->pyramid(),
                         {},
                         probes(),
                         blursHits() ? &conePicture_->image() : nullptr};
    if (colors_.valid())
        trace.previous.emplace(PreviousFrame{previousHasLayers_ ? refraction_->withoutLayers() : outputs_.previous(),
                                             outputs_.previous(), colors_.before(kViewZ)});
    return trace;
}

HierarchyInputs FrameStages::hierarchyInputs() {
    return {inputs(), prepared(), trace_->traced().rayRecord, usesRays() ? &raysSource_->rayRecord() : nullptr};
}

InspectorInputs FrameStages::inspectorInputs() {
    return {traceInputs(), trace_->target(), hierarchyInputs(),
            *hierarchy_,   rayRecord(),      ranPasses_ && hasComposite() ? composite() : host_.images.litRadiance};
}

// ---------------------------------------------------------------- results

std::vector<gpu::PassTime> FrameStages::passTimes() const {
    return ranPasses_ && timers_ ? timers_->latest() : std::vector<gpu::PassTime>();
}

Statistics FrameStages::statistics() const {
    return counts_ && tracesRays() ? counts_->read() : Statistics();
}

} // namespace glint::reflect
