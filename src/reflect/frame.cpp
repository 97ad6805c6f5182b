#include "reflect/frame.hpp"

#include "reflect/conventions.hpp"
#include "shared/outcome.h"
#include "shared/ray_log.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <bit>
#include <cstring>

namespace glint::reflect {
namespace {

constexpr uint32_t kDfgSize = 64;

/// A host's images are read texel by texel, and many of their formats (depth, 16-bit normals) need not be filterable.
constexpr gpu::SamplerKind kTexels = gpu::SamplerKind::NearestClamp;

bool wantsHistory(const Settings& settings) {
    return settings.screen.enabled && settings.screen.colorSource == ColorSource::Previous;
}

} // namespace

// ---------------------------------------------------------------- the frame, top to bottom

void FrameState::record(gpu::Frame& frame, const View& view) {
    makeTables(frame);
    turnHistory();
    prepare(frame, view);
    const bool reflects = anySource() || desc.settings.debug.outcome;
    if (reflects && desc.settings.screen.enabled) {
        classify(frame);
        prepareBackFaces(frame);
        if (techniqueFor(desc.settings.screen.march).usesPyramid || expectsLayers())
            makePyramid(frame);
        trace(frame);
        denoise(frame);
    } else {
        forgetTrace(frame);
        if (expectsLayers())
            makePyramid(frame);
    }
    if (reflects)
        askLaterSources(frame);
    combine(frame);
    compose(frame);
    if (desc.statistics && tracesRays())
        countOutcomes(frame);
    if (expectsLayers())
        refraction->begin(frame, composite);
}

void FrameState::recordLayer(gpu::Frame& frame, LayerImages& layer) {
    gpu::Image* environment = inputs.environment ? &inputs.environment : nullptr;
    ProbesState* probes = probesSource ? probesSource->probes() : nullptr;
    refraction->record(frame, desc.settings, layer,
                       {frameConstants, prepared, pyramid, probes, environment, dfg, black, blackCube}, composite);
}

bool FrameState::anySource() const {
    const bool sky = desc.settings.sky.enabled && inputs.environment;
    return desc.settings.reflect.strength > 0 &&
           (desc.settings.screen.enabled || sky || usesRays() || usesPlanar() || usesProbes());
}

bool FrameState::usesRays() const {
    return desc.settings.rays.enabled && raysSource && raysSource->hasScene();
}

bool FrameState::usesPlanar() const {
    return desc.settings.planar.enabled && planarSource && planarSource->hasMirrors();
}

bool FrameState::usesProbes() const {
    return desc.settings.probes.enabled && probesSource && probesSource->hasProbes();
}

void FrameState::makeTables(gpu::Frame& frame) {
    if (tablesMade && !frame.rehearsing())
        return;
    frame.pass(pipelines.dfg).write("dfg", dfg).dispatch(kDfgSize, kDfgSize);
    frame.clear(black, {});
    frame.clear(blackCube, {});
    frame.fill(noProbes, 0);
    if (pyramid.tiles)
        frame.fill(pyramid.tiles, 0);
    tablesMade = !frame.rehearsing();
}

/// The last frame's picture becomes the history, and this frame's takes the place of the one before.
void FrameState::turnHistory() {
    const bool wanted = wantsHistory(desc.settings);
    usesHistory = wanted && historyHeld;
    if (wanted) {
        std::swap(composite, history.color);
        std::swap(prepared.viewZ, history.viewZ);
        if (usesHistory) // the host may have drawn over it since
            history.color.states()[0] = {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT, 0, 0,
                                         VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    }
    historyHeld = wanted && !desc.settings.debug.outcome; // debug colours are no light
}

void FrameState::prepare(gpu::Frame& frame, const View& view) {
    const Settings& settings = desc.settings;
    shared::FrameConstants constants = makeFrameConstants(view, conventions, desc.width, desc.height);
    const bool sameProjection = ((constants.flags ^ lastFrame.flags) & shared::kInputOrthographic) == 0;
    usesHistory = usesHistory && sameProjection;
    const auto flag = [&](bool on, uint32_t bit) { constants.flags |= on ? bit : 0; };
    flag(static_cast<bool>(inputs.environment), shared::kInputEnvironment);
    flag(static_cast<bool>(inputs.fallbackSpecular), shared::kInputFallback);
    flag(static_cast<bool>(inputs.material), shared::kInputMaterial);
    flag(resolvesMaterial(), shared::kInputResolved);
    flag(static_cast<bool>(inputs.motion), shared::kInputMotion);
    flag(settings.gbuffer.depthFormat == DepthFormat::Half, shared::kInputHalfDepth);
    flag(usesHistory, shared::kInputHistory);
    const bool now = settings.screen.colorSource == ColorSource::Current; // the last frame's picture does not tell them
    flag(conventions.highlightsInAlpha && !settings.screen.highlights && now, shared::kInputHighlights);
    flag(historyGamma, shared::kHistoryGamma);
    flag(settings.input.colorIsGamma, shared::kInputGamma);
    flag(settings.output.colorIsGamma, shared::kOutputGamma);
    traced.eightBits = settings.screen.targetFormat == TargetFormat::Rgba8;
    flag(traced.eightBits, shared::kTraceTarget8);
    const bool raysAlone = usesRays() && !settings.screen.enabled; // their record is as large as the picture
    traced.width = raysAlone ? desc.width : tracedPixels(settings, desc.width);
    traced.height = raysAlone ? desc.height : tracedPixels(settings, desc.height);
    constants.traceSize = {traced.width, traced.height};
    constants.traceScale = constants.size / constants.traceSize;
    constants.motionScale = {conventions.motionScale[0], conventions.motionScale[1]};
    constants.viewToPrevView = glm::mat4(glm::dmat4(lastFrame.worldToView) * glm::dmat4(constants.viewToWorld));
    constants.prevViewToPixel = lastFrame.viewToPixel;
    constants.prevUvToView = lastFrame.uvToView;
    constants.environmentStrength = environmentStrength;
    constants.environmentMips = static_cast<float>(environmentMips);
    constants.worldToEnvironment = glm::rotate(glm::scale(glm::mat4(1), glm::vec3(1, environmentFlipY ? -1 : 1, 1)),
                                               -environmentRotation, glm::vec3(0, 1, 0));
    sameView = constants.worldToView == lastFrame.worldToView && constants.viewToPixel == lastFrame.viewToPixel;
    if (!frame.rehearsing()) {
        lastFrame = constants;
        historyGamma = settings.output.colorIsGamma;
    }
    frame.update(frameConstants, &constants, sizeof(constants));
    prepareSurface(frame, inputs.depth.desc().samples > 1);
    if (frame.rehearsing())
        prepareSurface(frame, true);
}

/// Else the host's image of it is as good.
bool FrameState::resolvesMaterial() const {
    return inputs.depth.desc().samples > 1 || conventions.material != MaterialKind::F0Roughness;
}

void FrameState::prepareSurface(gpu::Frame& frame, bool manySamples) {
    // What this kind of host does not have is not looked at: any image stands in that has as many samples.
    gpu::Image& material = inputs.material ? inputs.material : inputs.normal;
    gpu::Pass pass = frame.pass(manySamples ? pipelines.surfaceSamples : pipelines.surface);
    pass.read("frame", frameConstants)
        .read("depth", inputs.depth, kTexels)
        .read("normal", inputs.normal, kTexels)
        .read("material", material, kTexels)
        .read("baseColor", inputs.baseColor ? inputs.baseColor : material, kTexels)
        .write("viewZ", prepared.viewZ)
        .write("surface", prepared.surface)
        .write("resolvedMaterial", prepared.material);
    if (manySamples)
        pass.write("edge", prepared.edge);
    pass.dispatch(desc.width, desc.height);
}

void FrameState::prepareBackFaces(gpu::Frame& frame) {
    if (hasBackFaces || frame.rehearsing())
        frame.pass(pipelines.backFaces)
            .read("frame", frameConstants)
            .read("backDepth", inputs.backDepth, kTexels)
            .write("backViewZ", prepared.backViewZ)
            .dispatchIndirect(rays.list, offsetof(shared::RayListHeader, backFaceGroups));
    else if (!noBackFaces)
        frame.clear(prepared.backViewZ, {.float32 = {shared::kBackgroundZ}});
    noBackFaces = !hasBackFaces && !frame.rehearsing();
}

TraceInputs FrameState::traceInputs(Rays& list) {
    return {frameConstants,
            inputs,
            prepared,
            list,
            pyramid,
            hasBackFaces,
            usesHistory ? &history : nullptr,
            black,
            probesSource ? probesSource->probes() : nullptr,
            noProbes,
            nullptr};
}

void FrameState::classify(gpu::Frame& frame) {
    constexpr shared::RayListHeader kNoRays = {{shared::kRayGroupsX, 0, 1}, 0, {0, 0, 1}, {0, 0, 1}, {}};
    frame.update(rays.list, &kNoRays, sizeof(kNoRays));
    gpu::Pass pass = frame.pass(pipelines.classify);
    pass.read("frame", frameConstants)
        .read("viewZ", prepared.viewZ)
        .read("surface", prepared.surface)
        .readWrite("rays", rays.list);
    shared::TraceConstants constants = traceConstants(desc.settings, hasBackFaces);
    const uint32_t* local = pipelines.backFaces.localSize();
    constants.backFaceGroups = {(prepared.backViewZ.width() + local[0] - 1) / local[0],
                                (prepared.backViewZ.height() + local[1] - 1) / local[1]};
    writeTraced(pass, traced, false).push(constants).dispatch(traced.width, traced.height);
}

/// For the rays of the screen source, if there are any; for those of layers, which are not known yet, at any rate.
void FrameState::makePyramid(gpu::Frame& frame) {
    const shared::TraceConstants settings = traceConstants(desc.settings, hasBackFaces && desc.settings.screen.enabled);
    shared::PyramidConstants constants = {settings.thickness, settings.thicknessRelative, settings.flags,
                                          pyramid.levels};
    if (expectsLayers()) // cells tell when a ray is behind all that they hold: for whichever rays see more there
        constants.thicknessRelative = std::max(constants.thicknessRelative, desc.settings.refraction.hizDepthBias);
    gpu::Pass pass = frame.pass(pipelines.pyramid);
    pass.read("frame", frameConstants)
        .read("viewZ", prepared.viewZ)
        .read("backViewZ", prepared.backViewZ)
        .write("pyramid", pyramid.cells)
        .readWrite("tiles", pyramid.tiles)
        .push(constants);
    constexpr uint32_t kPixelsAThread = 4;
    if (expectsLayers())
        pass.dispatch((desc.width + kPixelsAThread - 1) / kPixelsAThread,
                      (desc.height + kPixelsAThread - 1) / kPixelsAThread);
    else
        pass.dispatchIndirect(rays.list, offsetof(shared::RayListHeader, pyramidGroups));
}

void FrameState::trace(gpu::Frame& frame) {
    const Technique& technique = techniqueFor(desc.settings.screen.march);
    const auto index = static_cast<size_t>(&technique - techniques().data());
    technique.record(frame, pipelines.trace[index], desc.settings, traceInputs(rays), traced);
    untraced = false;
}

void FrameState::denoise(gpu::Frame& frame) {
    recordDenoise(frame, pipelines.denoise, desc.settings, {traceInputs(rays), traced}, denoised);
}

/// Those that ask what others have left, in the user's order.
void FrameState::askLaterSources(gpu::Frame& frame) {
    for (const uint32_t source : sourceOrder(desc.settings)) {
        if (source == shared::kSourceRays && usesRays())
            traceScene(frame);
        if (source == shared::kSourcePlanar && usesPlanar())
            lookUpMirrors(frame);
        if (source == shared::kSourceProbes && usesProbes())
            lookUpProbes(frame);
    }
}

/// Bit s: source s.
uint32_t FrameState::takingPart() const {
    if (desc.settings.reflect.strength <= 0)
        return 0;
    const auto bit = [](bool on, uint32_t source) { return on ? 1u << source : 0u; };
    return bit(desc.settings.screen.enabled, shared::kSourceScreen) | bit(usesRays(), shared::kSourceRays) |
           bit(usesPlanar(), shared::kSourcePlanar) | bit(usesProbes(), shared::kSourceProbes) |
           bit(desc.settings.sky.enabled && inputs.environment, shared::kSourceSky);
}

EarlierAnswers FrameState::answersBefore(uint32_t source) {
    const uint32_t before = takingPart() & sourcesBefore(sourceOrder(desc.settings), source);
    const auto has = [&](uint32_t other) { return (before & (1u << other)) != 0; };
    return {before,
            has(shared::kSourceScreen) ? *denoised.answer : black,
            has(shared::kSourceRays) ? raysSource->answer() : black,
            has(shared::kSourceRays) ? raysSource->rayRecord() : traced.rayRecord,
            has(shared::kSourcePlanar) ? planarSource->answer() : black,
            has(shared::kSourceProbes) ? probesSource->answer() : black};
}

EarlierAnswers FrameState::noAnswersBefore() {
    return {0, black, black, traced.rayRecord, black, black};
}

void FrameState::traceScene(gpu::Frame& frame) {
    gpu::Image& environment = inputs.environment ? inputs.environment : blackCube;
    gpu::Image& diffuse = inputs.environmentDiffuse ? inputs.environmentDiffuse : blackCube;
    raysSource->record(frame, desc.settings,
                       {frameConstants, prepared, answersBefore(shared::kSourceRays), traced.rayRecord,
                        resolvesMaterial() ? prepared.material : inputs.material, inputs.litRadiance,
                        inputs.fallbackSpecular ? inputs.fallbackSpecular : black,
                        static_cast<bool>(inputs.environment), environment,
                        static_cast<bool>(inputs.environmentDiffuse), diffuse, dfg, sameView});
}

void FrameState::lookUpMirrors(gpu::Frame& frame) {
    planarSource->record(frame, desc.settings,
                         {frameConstants, lastFrame, prepared, answersBefore(shared::kSourcePlanar)});
}

void FrameState::lookUpProbes(gpu::Frame& frame) {
    probesSource->record(frame, desc.settings, {frameConstants, prepared, answersBefore(shared::kSourceProbes)});
}

/// How the pixels' rays ended: the screen's, or those through the scene where there are no others.
gpu::Image& FrameState::rayRecord() {
    return usesRays() && !desc.settings.screen.enabled ? raysSource->rayRecord() : traced.rayRecord;
}

/// While the screen source is off, its images say that no ray was traced.
void FrameState::forgetTrace(gpu::Frame& frame) {
    if (untraced && denoised.answer == &traced.target())
        return;
    denoised.answer = &traced.target();
    frame.clear(traced.target(), {});
    frame.clear(traced.rayRecord, {});
    untraced = !frame.rehearsing();
}

void FrameState::combine(gpu::Frame& frame) {
    combinePass(frame, pipelines.combine).dispatch(desc.width, desc.height);
}

gpu::Pass FrameState::combinePass(gpu::Frame& frame, const gpu::Pipeline& pipeline) {
    const shared::HierarchyConstants constants = {takingPart(), packOrder(sourceOrder(desc.settings))};
    gpu::Pass pass = frame.pass(pipeline);
    pass.read("frame", frameConstants)
        .read("viewZ", prepared.viewZ)
        .read("surface", prepared.surface)
        .read("radianceWeight", *denoised.answer)
        .read("raysAnswer", usesRays() ? raysSource->answer() : black)
        .read("raysRecord", usesRays() ? raysSource->rayRecord() : traced.rayRecord)
        .read("planarAnswer", usesPlanar() ? planarSource->answer() : black)
        .read("probesAnswer", usesProbes() ? probesSource->answer() : black)
        .read("environment", inputs.environment ? inputs.environment : blackCube)
        .write("reflected", reflected.reflected)
        .write("weights", reflected.weights)
        .push(constants);
    return pass;
}

void FrameState::compose(gpu::Frame& frame) {
    const Settings& settings = desc.settings;
    const shared::CompositeConstants constants = {static_cast<uint32_t>(settings.composite.model),
                                                  settings.reflect.fresnel,
                                                  settings.debug.outcome,
                                                  settings.reflect.strength,
                                                  settings.reflect.falloffExponent,
                                                  traceConstants(settings, hasBackFaces).maxSteps};
    frame.pass(pipelines.composite)
        .read("frame", frameConstants)
        .read("viewZ", prepared.viewZ)
        .read("surface", prepared.surface)
        .read("material", resolvesMaterial() ? prepared.material : inputs.material, kTexels)
        .read("edge", prepared.edge)
        .read("litRadiance", inputs.litRadiance, kTexels)
        .read("fallbackSpecular", inputs.fallbackSpecular ? inputs.fallbackSpecular : black, kTexels)
        .read("reflected", reflected.reflected)
        .read("rayRecord", rayRecord())
        .read("dfg", dfg)
        .write("composite", composite)
        .push(constants)
        .dispatch(desc.width, desc.height);
}

void FrameState::countOutcomes(gpu::Frame& frame) {
    frame.fill(statistics, 0);
    frame.pass(pipelines.statistics)
        .read("frame", frameConstants)
        .read("rayRecord", rayRecord())
        .readWrite("statistics", statistics)
        .dispatch(traced.width, traced.height);
    if (usesRays())
        raysSource->count(frame, statistics);
    frame.copyBuffer(statistics, statisticsReadback);
}

/// Makes what the last frame did not need, so that there is something to show.
void FrameState::bringUpToDate(gpu::Frame& frame) {
    if (upToDate)
        return;
    makeTables(frame);
    prepare(frame, lastView);
    forgetTrace(frame);
    askLaterSources(frame);
    combine(frame);
    upToDate = !frame.rehearsing();
}

void FrameState::recordView(gpu::Frame& frame, uint32_t which) {
    bringUpToDate(frame);
    const bool layers = recorded && expectsLayers();
    const shared::ViewConstants constants = {which, traceConstants(desc.settings, hasBackFaces).maxSteps};
    frame.pass(pipelines.view)
        .read("frame", frameConstants)
        .read("viewZ", prepared.viewZ)
        .read("surface", prepared.surface)
        .read("material", resolvesMaterial() ? prepared.material : inputs.material, kTexels)
        .read("radianceWeight", *denoised.answer)
        .read("rayRecord", rayRecord())
        .read("reflected", reflected.reflected)
        .read("weights", reflected.weights)
        .read("planarAnswer", usesPlanar() ? planarSource->answer() : black)
        .read("probesAnswer", usesProbes() ? probesSource->answer() : black)
        .read("refracted", layers ? refraction->refracted() : black)
        .read("refractionWeights", layers ? refraction->weights() : black)
        .write("view", viewImage)
        .push(constants)
        .dispatch(desc.width, desc.height);
}

void FrameState::recordInspection(gpu::Frame& frame, uint32_t x, uint32_t y) {
    inspect(frame, x, y, techniqueFor(desc.settings.screen.march));
}

void FrameState::inspect(gpu::Frame& frame, uint32_t x, uint32_t y, const Technique& technique) {
    bringUpToDate(frame);
    const shared::InspectConstants constants = {{x, y}};
    frame.fill(inspector->log, 0);
    frame.pass(inspector->pixel)
        .read("frame", frameConstants)
        .read("viewZ", prepared.viewZ)
        .read("surface", prepared.surface)
        .read("material", resolvesMaterial() ? prepared.material : inputs.material, kTexels)
        .read("rayRecord", rayRecord())
        .read("reflected", reflected.reflected)
        .read("composite", ranPasses || frame.rehearsing() ? composite : inputs.litRadiance, kTexels)
        .write("rays", inspector->rays.list)
        .write("rayLog", inspector->log)
        .push(constants)
        .dispatch(1);
    const auto index = static_cast<size_t>(&technique - techniques().data());
    TraceInputs oneRay = traceInputs(inspector->rays);
    oneRay.log = &inspector->log;
    technique.record(frame, inspector->trace[index], desc.settings, oneRay, traced);
    combinePass(frame, inspector->combine).readWrite("rayLog", inspector->log).dispatch(desc.width, desc.height);
    frame.copyBuffer(inspector->log, inspector->readback);
}

// ---------------------------------------------------------------- creation

Result<Pipelines> Pipelines::create(gpu::Context& context) {
    using gpu::Pipeline;
    GLINT_TRY(surface, Pipeline::compute(context, {"prepare/surface", 0, {}}));
    GLINT_TRY(surfaceSamples, Pipeline::compute(context, {"prepare/surface_samples", 0, {}}));
    GLINT_TRY(backFaces, Pipeline::compute(context, {"prepare/back_faces", 0, {}}));
    GLINT_TRY(dfg, Pipeline::compute(context, {"prepare/dfg", 0, {}}));
    GLINT_TRY(classify, Pipeline::compute(context, {"trace/classify", sizeof(shared::TraceConstants), {}}));
    GLINT_TRY(pyramid, Pipeline::compute(context, {"prepare/pyramid", sizeof(shared::PyramidConstants), {}}));
    std::vector<Pipeline> trace;
    for (const Technique& technique : techniques()) {
        GLINT_TRY(pipeline, Pipeline::compute(context, {technique.shader, sizeof(shared::TraceConstants), {}}));
        trace.push_back(std::move(pipeline));
    }
    GLINT_TRY(denoise, DenoisePipelines::create(context));
    GLINT_TRY(combine, Pipeline::compute(context, {"hierarchy/combine", sizeof(shared::HierarchyConstants), {}}));
    GLINT_TRY(composite, Pipeline::compute(context, {"composite/composite", sizeof(shared::CompositeConstants), {}}));
    GLINT_TRY(view, Pipeline::compute(context, {"composite/view", sizeof(shared::ViewConstants), {}}));
    GLINT_TRY(statistics, Pipeline::compute(context, {"composite/statistics", 0, {}}));
    return Pipelines{std::move(surface),  std::move(surfaceSamples), std::move(backFaces), std::move(dfg),
                     std::move(classify), std::move(pyramid),        std::move(trace),     std::move(denoise),
                     std::move(combine),  std::move(composite),      std::move(view),      std::move(statistics)};
}

Result<std::unique_ptr<FrameState>> FrameState::create(gpu::Context& context, const ReflectionsDesc& desc) {
    auto state = std::make_unique<FrameState>();
    state->context = &context;
    state->desc = desc;
    GLINT_TRY(pipelines, Pipelines::create(context));
    state->pipelines = std::move(pipelines);
    GLINT_CHECK(state->createImages());
    GLINT_CHECK(state->expectBackFaces(0, 0));
    GLINT_CHECK(state->expectSamples(1));
    GLINT_CHECK(state->createRays());
    if (desc.transparentLayers) {
        GLINT_TRY(refraction, Refraction::create(context, desc.width, desc.height, desc.views));
        state->refraction = std::move(refraction);
    }
    GLINT_CHECK(state->setSettings(desc.settings));
    if (desc.inspection) {
        GLINT_TRY(inspector, Inspector::create(context));
        state->inspector = std::make_unique<Inspector>(std::move(inspector));
    }
    GLINT_TRY(timers, gpu::Timers::create(context));
    state->timers = std::move(timers);
    GLINT_CHECK(state->rehearse());
    return state;
}

namespace {

struct WantedImage {
    gpu::Image* image;
    const char* name;
    VkFormat format;
    uint32_t width;
    uint32_t height;
    VkImageUsageFlags more; ///< besides being sampled and stored
    gpu::ImageShape shape = gpu::ImageShape::Flat;
};

constexpr VkImageUsageFlags kCleared = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
constexpr VkImageUsageFlags kComposite =
    VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT; ///< hosts blend over it

/// Nothing to do if it is there already.
Result<void> makeImage(gpu::Context& context, const WantedImage& wanted) {
    if (*wanted.image)
        return {};
    GLINT_TRY(image,
              gpu::Image::create(context, {wanted.name, wanted.format, wanted.width, wanted.height, 1,
                                           wanted.shape == gpu::ImageShape::Cube ? 6u : 1u, wanted.shape,
                                           VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | wanted.more}));
    *wanted.image = std::move(image);
    return {};
}

} // namespace

/// Nothing is ever taken away: frames in flight may still read it.
Result<void> FrameState::makeImagesFor(const Settings& settings) {
    const uint32_t w = desc.width;
    const uint32_t h = desc.height;
    if (settings.screen.targetFormat == TargetFormat::Rgba8)
        GLINT_CHECK(makeImage(
            *context, {&traced.radianceWeight8, "glint/radianceWeight8", VK_FORMAT_R8G8B8A8_UNORM, w, h, kCleared}));
    else
        GLINT_CHECK(makeImage(
            *context, {&traced.radianceWeight, "glint/radianceWeight", VK_FORMAT_R16G16B16A16_SFLOAT, w, h, kCleared}));
    if (settings.screen.colorSource == ColorSource::Previous) {
        GLINT_CHECK(makeImage(
            *context, {&history.color, "glint/previousComposite", VK_FORMAT_R16G16B16A16_SFLOAT, w, h, kComposite}));
        GLINT_CHECK(makeImage(*context, {&history.viewZ, "glint/previousViewZ", VK_FORMAT_R32_SFLOAT, w, h, 0}));
    }
    if (settings.rays.enabled && !raysSource) {
        GLINT_TRY(source, RaysSource::create(*context, w, h));
        GLINT_CHECK(source->setSettings(settings));
        raysSource = std::move(source);
        GLINT_CHECK(giveScene());
    } else if (raysSource) {
        GLINT_CHECK(raysSource->setSettings(settings));
    }
    return makeDenoiseImages(*context, settings, w, h, denoised);
}

void FrameState::restartAccumulation() {
    if (raysSource)
        raysSource->forgetFrames();
}

Result<void> FrameState::setRays(rays::Scene& scene, SurfaceTableState& surfaces) {
    rayScene = &scene;
    raySurfaces = &surfaces;
    shadeHits = {};
    return giveScene();
}

Result<void> FrameState::setRays(rays::Scene& scene, ShadeHits shade) {
    rayScene = &scene;
    raySurfaces = nullptr;
    shadeHits = std::move(shade);
    return giveScene();
}

/// Makes the pipeline of the host's scene as soon as both are there, and rehearses it.
Result<void> FrameState::giveScene() {
    if (!raysSource || !rayScene)
        return {};
    if (raySurfaces)
        GLINT_CHECK(raysSource->setScene(*rayScene, *raySurfaces));
    else
        GLINT_CHECK(raysSource->setScene(*rayScene, shadeHits));
    gpu::Frame frame = gpu::Frame::rehearsal(*context);
    raysSource->record(frame, desc.settings,
                       {frameConstants, prepared, noAnswersBefore(), traced.rayRecord, black, black, black, false,
                        blackCube, false, blackCube, dfg, false});
    return frame.firstError();
}

Result<void> FrameState::setPlanar(PlanarState& planar) {
    if (!planarSource) {
        GLINT_TRY(source, PlanarSource::create(*context, desc.width, desc.height));
        planarSource = std::move(source);
    }
    GLINT_CHECK(planarSource->setPlanar(planar));
    gpu::Frame frame = gpu::Frame::rehearsal(*context);
    planarSource->record(frame, desc.settings, {frameConstants, lastFrame, prepared, noAnswersBefore()});
    return frame.firstError();
}

Result<void> FrameState::setProbes(ProbesState& probes) {
    if (!probesSource) {
        GLINT_TRY(source, ProbesSource::create(*context, desc.width, desc.height));
        probesSource = std::move(source);
    }
    GLINT_CHECK(probesSource->setProbes(probes));
    gpu::Frame frame = gpu::Frame::rehearsal(*context);
    probesSource->record(frame, desc.settings, {frameConstants, prepared, noAnswersBefore()});
    if (refraction) {
        GLINT_CHECK(refraction->setProbes(probes));
        rehearseLayer(frame);
    }
    return frame.firstError();
}

Result<void> FrameState::createImages() {
    const uint32_t w = desc.width;
    const uint32_t h = desc.height;
    std::vector<WantedImage> images = {
        {&prepared.viewZ, "glint/viewZ", VK_FORMAT_R32_SFLOAT, w, h, 0},
        {&prepared.surface, "glint/surface", VK_FORMAT_R32G32_UINT, w, h, 0},
        {&prepared.material, "glint/material", VK_FORMAT_R16G16B16A16_SFLOAT, w, h, 0},
        {&traced.unused, "glint/unused", VK_FORMAT_R16G16B16A16_SFLOAT, 1, 1, 0},
        {&traced.unused8, "glint/unused8", VK_FORMAT_R8G8B8A8_UNORM, 1, 1, 0},
        {&traced.rayRecord, "glint/rayRecord", VK_FORMAT_R32G32_UINT, w, h, kCleared},
        {&reflected.reflected, "glint/reflected", VK_FORMAT_R16G16B16A16_SFLOAT, w, h, 0},
        {&reflected.weights, "glint/weights", VK_FORMAT_R32G32_UINT, w, h, 0},
        {&composite, "glint/composite", VK_FORMAT_R16G16B16A16_SFLOAT, w, h, kComposite},
        {&dfg, "glint/dfg", VK_FORMAT_R16G16_SFLOAT, kDfgSize, kDfgSize, 0},
        {&black, "glint/black", VK_FORMAT_R16G16B16A16_SFLOAT, 1, 1, kCleared},
        {&blackCube, "glint/blackCube", VK_FORMAT_R16G16B16A16_SFLOAT, 1, 1, kCleared, gpu::ImageShape::Cube},
    };
    if (desc.views)
        images.push_back({&viewImage, "glint/view", VK_FORMAT_R32G32B32A32_SFLOAT, w, h,
                          VK_IMAGE_USAGE_TRANSFER_SRC_BIT | kCleared});
    for (const WantedImage& wanted : images)
        GLINT_CHECK(makeImage(*context, wanted));

    GLINT_TRY(constants,
              gpu::Buffer::create(*context, {"glint/frame", sizeof(shared::FrameConstants),
                                             VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                             gpu::BufferHome::Device}));
    frameConstants = std::move(constants);
    GLINT_TRY(lists,
              gpu::Buffer::create(*context, {"glint/noProbes", sizeof(shared::ProbeRecord),
                                             VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                             gpu::BufferHome::Device}));
    noProbes = std::move(lists);
    if (!desc.statistics)
        return {};
    GLINT_TRY(counts,
              gpu::Buffer::create(*context, {"glint/statistics", sizeof(shared::RayStatistics),
                                             VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                                 VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                             gpu::BufferHome::Device}));
    statistics = std::move(counts);
    GLINT_TRY(readback, gpu::Buffer::create(*context, {"glint/statisticsReadback", sizeof(shared::RayStatistics),
                                                       VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::BufferHome::Readback}));
    statisticsReadback = std::move(readback);
    std::memset(statisticsReadback.mapped(), 0, statisticsReadback.size()); // nothing is counted yet
    return {};
}

Result<void> FrameState::createRays() {
    GLINT_TRY(list, gpu::Buffer::create(
                        *context, {"glint/rays", sizeof(shared::RayListHeader) + size_t{4} * desc.width * desc.height,
                                   VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                       VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT,
                                   gpu::BufferHome::Device}));
    rays.list = std::move(list);
    return {};
}

Result<void> FrameState::createPyramid() {
    const uint32_t longest = std::max(desc.width, desc.height);
    pyramid.levels = std::clamp(static_cast<uint32_t>(std::bit_width(longest - 1)), 1u, shared::kMaxPyramidLevels - 1);
    const auto half = [](uint32_t size, uint32_t times) { return (size + (1u << times) - 1) >> times; };
    // Level 1 beside the column of the others: lib/pyramid.glsl.
    GLINT_TRY(cells, gpu::Image::create(*context, {"glint/pyramid", VK_FORMAT_R32G32B32A32_UINT,
                                                   half(desc.width, 1) + half(desc.width, 2),
                                                   half(desc.height, 1) + pyramid.levels, 1, 1, gpu::ImageShape::Flat,
                                                   VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT}));
    const size_t tiles =
        size_t{half(desc.width, shared::kPyramidTileLevel)} * half(desc.height, shared::kPyramidTileLevel);
    const size_t above = tiles; // more than the level above has
    GLINT_TRY(tileCells,
              gpu::Buffer::create(*context, {"glint/pyramidTiles", 16 + 16 * (tiles + above),
                                             VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                             gpu::BufferHome::Device}));
    pyramid.cells = std::move(cells);
    pyramid.tiles = std::move(tileCells);
    tablesMade = false; // its counter starts at 0
    return {};
}

Result<void> FrameState::setSettings(const Settings& settings) {
    GLINT_CHECK(makeImagesFor(settings));
    const bool layers = refraction && settings.refraction.enabled;
    if ((layers || techniqueFor(settings.screen.march).usesPyramid) && !pyramid.cells)
        GLINT_CHECK(createPyramid());
    desc.settings = settings;
    return {};
}

Result<void> FrameState::expectBackFaces(uint32_t width, uint32_t height) {
    hasBackFaces = width > 0 && height > 0;
    if (prepared.backViewZ && !hasBackFaces)
        return {};
    width = std::max(width, 1u);
    height = std::max(height, 1u);
    if (prepared.backViewZ && prepared.backViewZ.width() == width && prepared.backViewZ.height() == height)
        return {};
    GLINT_TRY(image, gpu::Image::create(
                         *context, {"glint/backViewZ", VK_FORMAT_R32_SFLOAT, width, height, 1, 1, gpu::ImageShape::Flat,
                                    VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                        VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
    lastBackViewZ = std::move(prepared.backViewZ);
    prepared.backViewZ = std::move(image);
    noBackFaces = false;
    return {};
}

Result<void> FrameState::expectSamples(uint32_t samples) {
    const uint32_t width = samples > 1 ? desc.width : 1;
    const uint32_t height = samples > 1 ? desc.height : 1;
    if (prepared.edge && prepared.edge.width() >= width && prepared.edge.height() >= height)
        return {};
    GLINT_TRY(image, gpu::Image::create(*context, {"glint/edge", VK_FORMAT_R32G32B32A32_UINT, width, height, 1, 1,
                                                   gpu::ImageShape::Flat,
                                                   VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT}));
    lastEdge = std::move(prepared.edge);
    prepared.edge = std::move(image);
    return {};
}

void FrameState::rehearseLayer(gpu::Frame& frame) {
    LayerImages layer;
    recordLayer(frame, layer);
}

Result<void> FrameState::rehearse() {
    gpu::Frame frame = gpu::Frame::rehearsal(*context);
    makeTables(frame);
    prepare(frame, {});
    classify(frame);
    prepareBackFaces(frame);
    makePyramid(frame);
    for (size_t i = 0; i < techniques().size(); ++i)
        techniques()[i].record(frame, pipelines.trace[i], desc.settings, traceInputs(rays), traced);
    rehearseDenoise(frame, pipelines.denoise, desc.settings, {traceInputs(rays), traced}, denoised);
    combine(frame);
    compose(frame);
    if (desc.statistics)
        countOutcomes(frame);
    if (refraction) {
        refraction->begin(frame, composite);
        rehearseLayer(frame);
    }
    if (desc.views)
        recordView(frame, 0);
    for (size_t i = 0; inspector && i < techniques().size(); ++i)
        inspect(frame, 0, 0, techniques()[i]);
    return frame.firstError();
}

} // namespace glint::reflect
