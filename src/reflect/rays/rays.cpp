#include "reflect/rays/rays.hpp"

#include "base/assert.hpp"
#include "reflect/rays/blue_noise.hpp"
#include "reflect/trace/technique.hpp"
#include "shared/ray_hit.h"

namespace glint::reflect {
namespace {

constexpr gpu::SamplerKind kTexels = gpu::SamplerKind::NearestClamp;

} // namespace

static_assert(sizeof(RayHit) == sizeof(shared::RayHitRecord));

Result<std::unique_ptr<RaysSource>> RaysSource::create(gpu::Context& context, uint32_t width, uint32_t height) {
    std::unique_ptr<RaysSource> source(new RaysSource(context));
    GLINT_TRY(list, gpu::Pipeline::compute(context, {"rays/list", sizeof(shared::RaysConstants), {}}));
    GLINT_TRY(count, gpu::Pipeline::compute(context, {"rays/statistics", 0, {}}));
    source->list_ = std::move(list);
    source->count_ = std::move(count);
    const auto makeImage = [&](const char* name, VkFormat format) {
        return gpu::Image::create(context, {name, format, width, height, 1, 1, gpu::ImageShape::Flat,
                                            VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT});
    };
    GLINT_TRY(radianceWeight, makeImage("glint/raysRadianceWeight", VK_FORMAT_R16G16B16A16_SFLOAT));
    GLINT_TRY(record, makeImage("glint/raysRecord", VK_FORMAT_R32G32B32A32_UINT));
    GLINT_TRY(rays, gpu::Buffer::create(context,
                                        {"glint/raysList", sizeof(shared::RayListHeader) + size_t{4} * width * height,
                                         VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                             VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT,
                                         gpu::BufferHome::Device}));
    GLINT_TRY(noise,
              gpu::Buffer::create(context, {"glint/blueNoise", blueNoiseMask().size() * sizeof(uint32_t),
                                            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                            gpu::BufferHome::Device}));
    source->radianceWeight_ = std::move(radianceWeight);
    source->record_ = std::move(record);
    source->rays_.list = std::move(rays);
    source->blueNoise_ = std::move(noise);
    return source;
}

Result<void> RaysSource::setSettings(const Settings& settings) {
    framesHeld_ = false;
    const uint32_t width = settings.rays.accumulate ? radianceWeight_.width() : 1;
    const uint32_t height = settings.rays.accumulate ? radianceWeight_.height() : 1;
    if (sum_ && sum_.width() == width && sum_.height() == height)
        return {};
    const auto makeImage = [&](const char* name, VkFormat format) {
        return gpu::Image::create(context_, {name, format, width, height, 1, 1, gpu::ImageShape::Flat,
                                             VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    };
    GLINT_TRY(sum, makeImage("glint/raysSum", VK_FORMAT_R32G32B32A32_SFLOAT));
    GLINT_TRY(weights, makeImage("glint/raysWeights", VK_FORMAT_R32_SFLOAT));
    sum_ = std::move(sum);
    weights_ = std::move(weights);
    return {};
}

Result<void> RaysSource::setScene(rays::Scene& scene, SurfaceTableState& surfaces) {
    const std::string_view shader = scene.backend() == RayBackend::Query ? "rays/reflect_query" : "rays/reflect_bvh";
    GLINT_TRY(reflect,
              gpu::Pipeline::compute(context_, {shader, sizeof(shared::RaysConstants), {}, surfaces.textureLayout()}));
    reflect_ = std::move(reflect);
    scene_ = &scene;
    surfaces_ = &surfaces;
    shade_ = {};
    framesHeld_ = false;
    return {};
}

Result<void> RaysSource::setScene(rays::Scene& scene, ShadeHits shade) {
    const std::string_view shader = scene.backend() == RayBackend::Query ? "rays/hits_query" : "rays/hits_bvh";
    GLINT_TRY(traceHits, gpu::Pipeline::compute(context_, {shader, sizeof(shared::RaysConstants), {}}));
    if (!hits_) {
        const size_t pixels = size_t{radianceWeight_.width()} * radianceWeight_.height();
        GLINT_TRY(hits, gpu::Buffer::create(context_, {"glint/rayHits", pixels * sizeof(shared::RayHitRecord),
                                                       VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::BufferHome::Device}));
        hits_ = std::move(hits);
    }
    traceHits_ = std::move(traceHits);
    scene_ = &scene;
    surfaces_ = nullptr;
    shade_ = std::move(shade);
    framesHeld_ = false;
    return {};
}

shared::RaysConstants RaysSource::constants(const Settings& settings, const RaysInputs& inputs) const {
    const RaysSettings& rays = settings.rays;
    shared::RaysConstants constants = {};
    constants.samples = static_cast<uint32_t>(rays.samples);
    constants.bounces = surfaces_ ? static_cast<uint32_t>(rays.bounces) : 1; // the host's shading takes no others
    constants.tMin = rays.tMin;
    constants.tMax = rays.tMax;
    constants.maxRoughness = rays.maxRoughness;
    constants.threshold = traceConstants(settings, false).threshold;
    constants.reuseRoughness = rays.reuseRoughness;
    constants.cullMask = static_cast<uint32_t>(rays.cullMask);
    constants.lightCount = surfaces_ ? surfaces_->lightCount() : 0;
    constants.before = inputs.earlier.before;
    const auto flag = [&](bool on, uint32_t bit) { constants.flags |= on ? bit : 0; };
    flag(rays.alphaTest, shared::kRaysAlphaTest);
    flag(rays.lobe == RayLobe::Mirror || (rays.lobe == RayLobe::MirrorIfOne && rays.samples == 1), shared::kRaysMirror);
    flag(inputs.hasEnvironment && settings.sky.enabled, shared::kRaysEnvironment);
    flag(inputs.hasEnvironmentDiffuse, shared::kRaysEnvironmentDiffuse);
    flag(rays.accumulate, shared::kRaysAccumulate);
    const bool afterScreen = (inputs.earlier.before & (1u << shared::kSourceScreen)) != 0;
    flag(rays.reuseLight && afterScreen, shared::kRaysReuseLight);
    return constants;
}

void RaysSource::record(gpu::Frame& frame, const Settings& settings, const RaysInputs& inputs) {
    GLINT_ASSERT(frame.rehearsing() || !surfaces_ || scene_->instanceCount() == surfaces_->instanceCount(),
                 "the RayScene has {} instances, its surface table {}", scene_->instanceCount(),
                 surfaces_ ? surfaces_->instanceCount() : 0);
    if (!noiseHeld_ && !frame.rehearsing()) {
        frame.update(blueNoise_, blueNoiseMask().data(), blueNoise_.size());
        noiseHeld_ = true;
    }
    if (settings.rays.accumulate && (!framesHeld_ || !inputs.sameView)) {
        frame.clear(sum_, {});
        frame.clear(weights_, {});
    }
    framesHeld_ = settings.rays.accumulate && !frame.rehearsing();
    const shared::RaysConstants constants = this->constants(settings, inputs);
    constexpr shared::RayListHeader kNoRays = {{shared::kRayGroupsX, 0, 1}, 0, {0, 0, 1}, {0, 0, 1}, {}};
    frame.update(rays_.list, &kNoRays, sizeof(kNoRays));
    gpu::Pass list = frame.pass(list_);
    list.read("frame", inputs.frameConstants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("screenRecord", inputs.screenRecord)
        .readWrite("rays", rays_.list)
        .write("raysRadianceWeight", radianceWeight_)
        .write("raysRecord", record_);
    inputs.earlier.bind(list);
    list.push(constants).dispatch(radianceWeight_.width(), radianceWeight_.height());

    if (!surfaces_) {
        recordHits(frame, inputs, constants);
        return;
    }
    gpu::Pass pass = frame.pass(reflect_);
    pass.read("frame", inputs.frameConstants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("rays", rays_.list)
        .read("screenRecord", inputs.screenRecord)
        .read("material", inputs.material, kTexels)
        .read("litRadiance", inputs.litRadiance, kTexels)
        .read("fallbackSpecular", inputs.fallbackSpecular, kTexels)
        .read("environment", inputs.environment)
        .read("environmentDiffuse", inputs.environmentDiffuse)
        .read("dfg", inputs.dfg)
        .read("blueNoise", blueNoise_)
        .write("raysRadianceWeight", radianceWeight_, 0, true)
        .write("raysRecord", record_, 0, true)
        .readWrite("raysSum", sum_)
        .readWrite("raysWeights", weights_);
    scene_->bind(pass);
    surfaces_->bind(pass).push(constants).dispatchIndirect(rays_.list, offsetof(shared::RayListHeader, rayGroups));
}

void RaysSource::count(gpu::Frame& frame, gpu::Buffer& statistics) {
    frame.pass(count_)
        .read("raysRecord", record_)
        .readWrite("statistics", statistics)
        .dispatch(record_.width(), record_.height());
}

/// Traces, lets the host shade, and takes its answer.
void RaysSource::recordHits(gpu::Frame& frame, const RaysInputs& inputs, const shared::RaysConstants& constants) {
    gpu::Pass pass = frame.pass(traceHits_);
    pass.read("frame", inputs.frameConstants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("rays", rays_.list)
        .read("screenRecord", inputs.screenRecord)
        .read("blueNoise", blueNoise_)
        .write("raysRecord", record_, 0, true)
        .write("hits", hits_);
    scene_->bind(pass).push(constants).dispatchIndirect(rays_.list, offsetof(shared::RayListHeader, rayGroups));
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
