#include "reflect/rays/rays.hpp"

#include "base/assert.hpp"
#include "reflect/denoise/denoises.hpp"
#include "reflect/trace/technique.hpp"
#include "shared/ray_hit.h"
#include "shared/surface_table.h"

#include <array>

namespace glint::reflect {
namespace {

using rays::Bounds;

/// What rays.accumulate has summed up.
constexpr HistoryImage kSum = {0, "glint/raysSum", VK_FORMAT_R32G32B32A32_SFLOAT};
constexpr HistoryImage kWeights = {1, "glint/raysWeights", VK_FORMAT_R32_SFLOAT};

/// World-space bounds of all instances that transmit light.
Bounds transparentBounds(const rays::Scene& scene, const SurfaceTableState& surfaces) {
    Bounds all;
    for (const uint32_t instance : surfaces.transparentInstances())
        if (instance < scene.instanceCount()) // a rehearsal's lists may differ
            all.add(scene.instanceBounds(instance));
    return all;
}

/// True if mirrors' paths go on from rough surfaces, and the denoiser averages what that brings.
bool wantsBranches(const Settings& settings) {
    return denoises(settings) && settings.rays.enabled && settings.rays.bounces > 1;
}

/// True if rough pixels send a ray to the environment, whose light the denoiser joins. Emissive surfaces are left to
/// the paths, as the screen's hits have their light already.
bool wantsSkyApart(const Settings& settings) {
    return denoises(settings) && settings.rays.enabled && settings.rays.sampleLights;
}

/// The most by which rays may differ that answer for the pixels between them; 0 where each pixel sends its own. The
/// denoiser and the truth of rays.accumulate average each pixel's own rays.
float interpolation(const Settings& settings) {
    return denoises(settings) || settings.rays.accumulate ? 0 : settings.rays.interpolate;
}

/// How many of a hit's lights share a shadow ray, where the denoiser averages.
uint32_t lightsTogether(const Settings& settings, uint32_t lights) {
    const auto shadowRays = static_cast<uint32_t>(settings.rays.shadowRays);
    return denoises(settings) ? std::max((lights + shadowRays - 1) / shadowRays, 1u) : 1;
}

} // namespace

static_assert(sizeof(RayHit) == sizeof(shared::RayHitRecord));

Result<std::unique_ptr<RaysSource>> RaysSource::create(StageContext& stages) {
    gpu::Context& context = stages.gpu;
    const uint32_t width = stages.width();
    const uint32_t height = stages.height();
    std::unique_ptr<RaysSource> source(new RaysSource(stages));
    GLINT_TRY(list, gpu::Pipeline::compute(context, {"rays/list", 0, {}}));
    GLINT_TRY(interpolate, gpu::Pipeline::compute(context, {"rays/interpolate", 0, {}}, gpu::Compile::Later));
    GLINT_TRY(count, gpu::Pipeline::compute(context, {"rays/statistics", 0, {}}));
    source->list_ = std::move(list);
    source->interpolate_ = std::move(interpolate);
    source->count_ = std::move(count);
    const auto makeImage = [&](const char* name, VkFormat format) {
        return gpu::Image::create(context, {name, format, width, height, 1, 1, gpu::ImageShape::Flat,
                                            VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT});
    };
    GLINT_TRY(radianceWeight, makeImage("glint/raysRadianceWeight", VK_FORMAT_R16G16B16A16_SFLOAT));
    GLINT_TRY(record, makeImage("glint/raysRecord", VK_FORMAT_R32G32B32A32_UINT));
    GLINT_CHECK(source->makeMirrored(false, false));
    GLINT_TRY(lister, RayLister::create(context, width, height));
    GLINT_TRY(rays, RayLister::makeList(context, "glint/raysList", width, height));
    source->radianceWeight_ = std::move(radianceWeight);
    source->record_ = std::move(record);
    source->lister_ = std::move(lister);
    source->rays_ = std::move(rays);
    return source;
}

Result<void> RaysSource::make(const Settings& settings) {
    GLINT_CHECK(makeMirrored(wantsBranches(settings), wantsSkyApart(settings)));
    GLINT_CHECK(makeSentinels());
    GLINT_CHECK(makeShading());
    if (interpolation(settings) > 0)
        GLINT_CHECK(interpolate_.compile());
    const uint32_t width = settings.rays.accumulate ? radianceWeight_.width() : 1;
    const uint32_t height = settings.rays.accumulate ? radianceWeight_.height() : 1;
    if (width == sumsWidth_ && height == sumsHeight_) {
        sums_.reset(HistoryReset::Settings);
        return {};
    }
    const std::array<StageImage, 2> images = {kSum.sized(width, height), kWeights.sized(width, height)};
    GLINT_CHECK(sums_.make(images, false));
    sumsWidth_ = width;
    sumsHeight_ = height;
    return {};
}

Result<void> RaysSource::makeMirrored(bool surfaces, bool skyApart) {
    const auto grow = [&](gpu::Image& image, const char* name, bool whole) {
        return growImage(stages_, image,
                         {name, VK_FORMAT_R32G32B32A32_UINT, whole ? radianceWeight_.width() : 1,
                          whole ? radianceWeight_.height() : 1});
    };
    GLINT_CHECK(grow(mirroredSurface_, "glint/mirroredSurface", surfaces));
    GLINT_CHECK(grow(mirroredLight_, "glint/mirroredLight", surfaces || skyApart));
    return {};
}

bool RaysSource::branches() const {
    return surfaces_ && wantsBranches(stages_.settings());
}

bool RaysSource::storesApart() const {
    return surfaces_ && (wantsBranches(stages_.settings()) || wantsSkyApart(stages_.settings()));
}

/// Creates the pipeline of sentinels once settings want it and there is a scene that lights hits.
Result<void> RaysSource::makeSentinels() {
    const Settings& settings = stages_.settings();
    const bool wanted = denoises(settings) && settings.denoise.antilag == Antilag::Gradient;
    if (!wanted || !surfaces_ || followSentinels_)
        return {};
    const bool query = scene_->backend() == RayBackend::Query;
    GLINT_TRY(follow, gpu::Pipeline::compute(stages_.gpu, {query ? "rays/sentinels_query" : "rays/sentinels_bvh", 0,
                                                           scene_->constants(), surfaces_->textureLayout()}));
    followSentinels_ = std::move(follow);
    return {};
}

Result<void> RaysSource::setScene(rays::Scene& scene, SurfaceTableState& surfaces) {
    const bool query = scene.backend() == RayBackend::Query;
    const auto makePaths = [&](std::string_view shader) {
        return gpu::Pipeline::compute(stages_.gpu, {shader, 0, scene.constants(), surfaces.textureLayout()},
                                      gpu::Compile::Later);
    };
    GLINT_TRY(reflect, makePaths(query ? "rays/reflect_query" : "rays/reflect_bvh"));
    GLINT_TRY(reflectLights, makePaths(query ? "rays/reflect_lights_query" : "rays/reflect_lights_bvh"));
    stages_.retired.keep(std::move(reflect_));
    stages_.retired.keep(std::move(followSentinels_));
    stages_.retired.keep(std::move(reflectLights_));
    reflect_ = std::move(reflect);
    reflectLights_ = std::move(reflectLights);
    if (scene_ != &scene || surfaces_ != &surfaces || instancesBefore_.size() != surfaces.instances().size())
        GLINT_CHECK(makeInstancesBefore(surfaces));
    scene_ = &scene;
    surfaces_ = &surfaces;
    shade_ = {};
    sums_.reset(HistoryReset::Asked);
    if (lights_)
        GLINT_CHECK(lights_->setScene(surfaces));
    GLINT_CHECK(makeShading());
    return makeSentinels();
}

Result<void> RaysSource::makeInstancesBefore(SurfaceTableState& surfaces) {
    GLINT_TRY(buffer,
              gpu::Buffer::create(stages_.gpu, {"glint/instancesBefore", surfaces.instances().size(),
                                                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                                gpu::BufferHome::Device}));
    stages_.retired.keep(std::move(instancesBefore_));
    instancesBefore_ = std::move(buffer);
    instancesBeforeCount_ = 0;
    return {};
}

/// Compiles the paths that the settings ask for, and creates the lights that they sample.
Result<void> RaysSource::makeShading() {
    if (!surfaces_)
        return {};
    if (!samplesLights())
        return reflect_.compile();
    if (!lights_) {
        GLINT_TRY(lights, LightTable::create(stages_));
        GLINT_CHECK(lights->setScene(*surfaces_));
        lights_ = std::move(lights);
    }
    return reflectLights_.compile();
}

void RaysSource::environmentChanged() {
    if (lights_)
        lights_->environmentChanged();
}

Result<void> RaysSource::setScene(rays::Scene& scene, ShadeHits shade) {
    const std::string_view shader = scene.backend() == RayBackend::Query ? "rays/hits_query" : "rays/hits_bvh";
    GLINT_TRY(traceHits, gpu::Pipeline::compute(stages_.gpu, {shader, 0, scene.constants()}));
    if (!hits_) {
        const size_t pixels = size_t{radianceWeight_.width()} * radianceWeight_.height();
        GLINT_TRY(hits,
                  gpu::Buffer::create(stages_.gpu, {"glint/rayHits", pixels * sizeof(shared::RayHitRecord),
                                                    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::BufferHome::Device}));
        hits_ = std::move(hits);
    }
    stages_.retired.keep(std::move(traceHits_));
    traceHits_ = std::move(traceHits);
    scene_ = &scene;
    surfaces_ = nullptr;
    shade_ = std::move(shade);
    sums_.reset(HistoryReset::Asked);
    return {};
}

shared::RaysConstants RaysSource::constants(const Inputs& host, uint32_t before) const {
    const Settings& settings = stages_.settings();
    const RaysSettings& rays = settings.rays;
    shared::RaysConstants constants = {};
    constants.samples = static_cast<uint32_t>(rays.samples);
    constants.bounces = surfaces_ ? static_cast<uint32_t>(rays.bounces) : 1; // the host shades only first hits
    constants.tMin = rays.tMin;
    constants.tMax = rays.tMax;
    constants.maxRoughness = rays.maxRoughness;
    constants.threshold = traceConstants(settings, false).threshold;
    constants.reuseRoughness = rays.reuseRoughness;
    constants.regularization = rays.regularization;
    constants.interpolate = surfaces_ ? interpolation(settings) : 0; // hosts shade the hits of one list
    constants.instancesBefore = followsHits() ? instancesBeforeCount_ : 0;
    constants.transparents = static_cast<uint32_t>(rays.transparents);
    constants.cullMask = static_cast<uint32_t>(rays.cullMask);
    constants.lightCount = surfaces_ ? surfaces_->lightCount() : 0;
    constants.lightsTogether = lightsTogether(settings, constants.lightCount);
    constants.before = before;
    const auto flag = [&](bool on, uint32_t bit) { constants.flags |= on ? bit : 0; };
    flag(rays.alphaTest, shared::kRaysAlphaTest);
    flag(rays.lobe == RayLobe::Cone, shared::kRaysCone);
    flag(rays.lobe == RayLobe::Mirror || rays.lobe == RayLobe::Cone ||
             (rays.lobe == RayLobe::MirrorIfOne && rays.samples == 1),
         shared::kRaysMirror);
    flag(host.environment && settings.sky.enabled, shared::kRaysEnvironment);
    flag(static_cast<bool>(host.environmentDiffuse), shared::kRaysEnvironmentDiffuse);
    flag(rays.accumulate, shared::kRaysAccumulate);
    flag(rays.environmentOcclusion, shared::kRaysEnvironmentOcclusion);
    flag(stages_.plan.previousEnds, shared::kRaysPreviousEnds);
    flag(branches(), shared::kRaysBranches);
    flag(samplesLights() && !denoises(settings), shared::kRaysSampleLights);
    // The denoiser uses a pixel's answer as the light along its one ray.
    flag(wantsSkyApart(settings) && surfaces_ && host.environment && settings.sky.enabled, shared::kRaysSampleSky);
    const bool afterScreen = (before & (1u << shared::kSourceScreen)) != 0;
    flag(rays.reuseLight && afterScreen, shared::kRaysReuseLight);
    const Bounds transparents = surfaces_ ? transparentBounds(*scene_, *surfaces_) : Bounds();
    flag(!transparents.empty(), shared::kRaysTransparentScene);
    flag(!transparents.empty() && rays.transparents > 0, shared::kRaysTransparents);
    constants.transparentsLow = transparents.low;
    constants.transparentsHigh = transparents.high;
    return constants;
}

void RaysSource::record(gpu::Frame& frame, const RaysInputs& inputs) {
    GLINT_ASSERT(frame.rehearsing() || !surfaces_ || scene_->instanceCount() == surfaces_->instanceCount(),
                 "the RayScene has {} instances, its surface table {}", scene_->instanceCount(),
                 surfaces_ ? surfaces_->instanceCount() : 0);
    if (!inputs.sameView && !frame.rehearsing())
        sums_.reset(HistoryReset::View);
    sums_.begin(frame, stages_.settings().rays.accumulate);
    lister_.begin(frame);
    gpu::Pass list = frame.pass(list_);
    list.read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("screenRecord", inputs.screenRecord)
        .read("rayRates", inputs.frame.rayRates, kTexels)
        .read("otherLobe", inputs.prepared.otherLobe)
        .write("raysRadianceWeight", radianceWeight_)
        .write("raysRecord", record_);
    lister_.bind(inputs.earlier.bind(list)).dispatch(stages_.extent.x, stages_.extent.y);
    lister_.list(frame, rays_, stages_.extent.x, stages_.extent.y, {});

    if (surfaces_)
        recordShaded(frame, inputs);
    else
        recordHits(frame, inputs);
    if (surfaces_ && interpolation(stages_.settings()) > 0)
        recordBetween(frame, inputs);
    sums_.end(frame);
}

/// Answers the pixels between those that sent a ray, and traces the rays of those that need their own.
void RaysSource::recordBetween(gpu::Frame& frame, const RaysInputs& inputs) {
    lister_.begin(frame);
    gpu::Pass between = frame.pass(interpolate_);
    between.read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .readWrite("raysRadianceWeight", radianceWeight_)
        .readWrite("raysRecord", record_);
    lister_.bind(between).dispatch(stages_.extent.x, stages_.extent.y);
    lister_.list(frame, rays_, stages_.extent.x, stages_.extent.y, {});
    recordPaths(frame, inputs, samplesLights());
}

/// True if the denoiser asks how what rays hit has moved.
bool RaysSource::followsHits() const {
    return surfaces_ && denoises(stages_.settings()) && stages_.settings().denoise.hitMotion;
}

void RaysSource::end(gpu::Frame& frame) {
    if (!surfaces_)
        return;
    const uint32_t count = surfaces_->instanceCount();
    if (followsHits() && count > 0)
        frame.copyBytes(surfaces_->instances(), 0, instancesBefore_, 0, count * sizeof(shared::SurfaceInstanceRecord));
    if (!frame.rehearsing())
        instancesBeforeCount_ = followsHits() ? count : 0;
}

/// Binds what a pass needs to light hits with the host's table.
gpu::Pass& RaysSource::bindShading(gpu::Pass& pass, const FrameInputs& inputs, const Prepared& prepared) {
    Inputs& host = inputs.host;
    const StandIns& standIns = inputs.standIns;
    pass.read("frame", inputs.constants)
        .read("viewZ", prepared.viewZ)
        .read("surface", prepared.surface)
        .read("rays", rays_.list)
        .read("environment", host.environment ? host.environment : standIns.blackCube)
        .read("environmentDiffuse", host.environmentDiffuse ? host.environmentDiffuse : standIns.blackCube)
        .read("dfg", standIns.dfg)
        .read("blueNoise", standIns.blueNoise);
    scene_->bind(pass);
    return surfaces_->bind(pass);
}

/// Traces rays and shades their hits with the host's table.
void RaysSource::recordShaded(gpu::Frame& frame, const RaysInputs& inputs) {
    if (lights_ && (samplesLights() || frame.rehearsing())) {
        lights_->record(frame, inputs.frame, *scene_);
        recordPaths(frame, inputs, true);
    }
    if (!samplesLights() || frame.rehearsing())
        recordPaths(frame, inputs, false);
}

void RaysSource::recordPaths(gpu::Frame& frame, const RaysInputs& inputs, bool sampleLights) {
    Inputs& host = inputs.frame.host;
    gpu::Image& black = inputs.frame.standIns.black;
    const std::optional<PreviousFrame>& previous = inputs.previous;
    const std::array<gpu::Image*, 3> previousImages = {previous ? &previous->color : &black,
                                                       previous ? &previous->viewZ : &black,
                                                       host.motion ? &host.motion : &black};
    gpu::Pass pass = frame.pass(sampleLights ? reflectLights_ : reflect_);
    bindShading(pass, inputs.frame, inputs.prepared)
        .read("screenRecord", inputs.screenRecord)
        .read("otherLobe", inputs.prepared.otherLobe)
        .read("material", inputs.prepared.material, kTexels)
        .read("instancesBefore", instancesBefore_)
        .read("metaBefore", inputs.frame.historyMeta, kTexels)
        .read("previousImages", previousImages, kTexels)
        .read("litRadiance", host.litRadiance, kTexels)
        .read("fallbackSpecular", host.fallbackSpecular ? host.fallbackSpecular : black, kTexels)
        .write("raysRadianceWeight", radianceWeight_, 0, true)
        .readWrite("raysRecord", record_)
        .write("mirroredSurface", mirroredSurface_)
        .write("mirroredLight", mirroredLight_)
        .readWrite("raysSum", sums_.now(kSum))
        .readWrite("raysWeights", sums_.now(kWeights));
    if (sampleLights)
        lights_->bind(pass);
    pass.dispatchIndirect(rays_.list, offsetof(shared::RayListHeader, rayGroups));
}

void RaysSource::recordSentinels(gpu::Frame& frame, const FrameInputs& inputs, const Prepared& prepared,
                                 const SentinelImages& images) {
    gpu::Pass pass = frame.pass(followSentinels_);
    bindShading(pass, inputs, prepared)
        .read("raysAnswer", radianceWeight_)
        .read("instancesBefore", instancesBefore_)
        .read("sentinelRayBefore", images.rayBefore)
        .read("sentinelPathBefore", images.pathBefore)
        .write("sentinelRay", images.ray)
        .write("sentinelPath", images.path)
        .write("change", images.change)
        .dispatch(images.change.width(), images.change.height(), 2);
}

void RaysSource::count(gpu::Frame& frame, const FrameInputs& inputs, gpu::Buffer& statistics) {
    frame.pass(count_)
        .read("frame", inputs.constants)
        .read("raysRecord", record_)
        .readWrite("statistics", statistics)
        .dispatch(stages_.extent.x, stages_.extent.y);
}

/// Traces rays; the host shades their hits into the answer.
void RaysSource::recordHits(gpu::Frame& frame, const RaysInputs& inputs) {
    gpu::Pass pass = frame.pass(traceHits_);
    pass.read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("rays", rays_.list)
        .read("otherLobe", inputs.prepared.otherLobe)
        .read("screenRecord", inputs.screenRecord)
        .read("blueNoise", inputs.frame.standIns.blueNoise)
        .write("raysRecord", record_, 0, true)
        .write("hits", hits_);
    scene_->bind(pass).dispatchIndirect(rays_.list, offsetof(shared::RayListHeader, rayGroups));
    if (frame.rehearsing())
        return;
    constexpr VkPipelineStageFlags2 kAnywhere = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    const gpu::Use read = {kAnywhere, VK_ACCESS_2_MEMORY_READ_BIT};
    frame.hand(rays_.list, read);
    frame.hand(hits_, read);
    frame.hand(radianceWeight_, {kAnywhere, VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                                 VK_IMAGE_LAYOUT_GENERAL, true});
    static_assert(offsetof(shared::RayListHeader, rayGroups) == 0 && offsetof(shared::RayListHeader, rayCount) == 12);
    RayHits given;
    given.arguments = rays_.list.handle();
    given.hits = hits_.handle();
    given.hitsSize = hits_.size();
    given.answer = {radianceWeight_.handle(), radianceWeight_.view(),   radianceWeight_.desc().format,
                    radianceWeight_.width(),  radianceWeight_.height(), VK_IMAGE_LAYOUT_GENERAL};
    frame.scope("rays/host", [&] { shade_(frame.commands(), given); });
}

} // namespace glint::reflect
