#include "reflect/refraction/refraction.hpp"

#include "reflect/probes/probes_source.hpp"
#include "reflect/trace/technique.hpp"
#include "shared/frame_constants.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <bit>

namespace glint::reflect {
namespace {

static_assert(static_cast<uint32_t>(BodyShape::Straight) == shared::kRefractionStraight &&
              static_cast<uint32_t>(BodyShape::Thin) == shared::kRefractionThin);
static_assert(static_cast<uint32_t>(RefractionModel::Thin) == shared::kRefractionThin + 1);

} // namespace

shared::TraceConstants layerTraceConstants(const Settings& settings, uint32_t levels) {
    shared::TraceConstants constants = traceConstants(settings, false);
    const RefractionSettings& wanted = settings.refraction;
    constants.thickness = 0;
    constants.thicknessRelative = wanted.hizDepthBias;
    constants.maxSteps = static_cast<uint32_t>(wanted.hizMaxIterations);
    constants.selfCollisionSkip = 0;
    constants.minLevel = std::min(static_cast<uint32_t>(wanted.hizMinLevel), levels);
    constants.maxLevel = std::min(static_cast<uint32_t>(std::max(wanted.hizMinLevel, wanted.hizMaxLevel)), levels);
    constants.borderWidth = wanted.borderWidth;
    constants.flags |= shared::kTraceClipToFrustum;
    return constants;
}

shared::RefractionConstants refractionConstants(const Settings& settings, bool probes, bool environment) {
    const RefractionSettings& wanted = settings.refraction;
    shared::RefractionConstants constants = {};
    constants.ior = wanted.ior;
    constants.dispersion = wanted.dispersion;
    constants.thickness = wanted.thickness;
    constants.thicknessMultiplier = wanted.thicknessMultiplier;
    constants.absorptionDistance = wanted.absorptionDistance;
    const glm::vec3 color(wanted.transmittanceRed, wanted.transmittanceGreen, wanted.transmittanceBlue);
    constants.transmittance = {glm::packHalf2x16({color.r, color.g}), glm::packHalf2x16({color.b, 0.0f})};
    constants.innerReflections = static_cast<uint32_t>(wanted.innerReflections);
    constants.reflectionBorderWidth = settings.fade.borderWidth;
    const auto flag = [&](bool on, uint32_t bit) { constants.flags |= on ? bit : 0; };
    constants.flags = static_cast<uint32_t>(wanted.model);
    flag(wanted.projection == RefractionProjection::Proxy, shared::kLayerProxy);
    flag(wanted.reflections && settings.reflect.strength > 0, shared::kLayerReflects);
    flag(wanted.screen, shared::kLayerScreen);
    flag(probes && settings.probes.enabled, shared::kLayerProbes);
    flag(environment && settings.sky.enabled, shared::kLayerSky);
    constants.probeFlags = probeFlags(settings);
    return constants;
}

Result<std::unique_ptr<Refraction>> Refraction::create(StageContext& stages) {
    gpu::Context& context = stages.gpu;
    const uint32_t width = stages.width();
    const uint32_t height = stages.height();
    const bool views = stages.desc.views; // which show what layers wrote
    constexpr uint32_t kSampled = 19;     // in the largest pass
    VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    context.api().GetPhysicalDeviceProperties2(context.physicalDevice(), &properties);
    const VkPhysicalDeviceLimits& limits = properties.properties.limits;
    const uint32_t most = std::min(limits.maxPerStageDescriptorSamplers, limits.maxPerStageDescriptorSampledImages);
    if (most < kSampled)
        return makeError(ErrorCode::Unsupported,
                         "transparent layers read {} images in a pass, but {} allows {}: make these reflections "
                         "without ReflectionsDesc::transparentLayers",
                         kSampled, context.info().name, most);
    std::unique_ptr<Refraction> result(new Refraction(context));
    GLINT_TRY(alone, gpu::Pipeline::compute(context, {"refraction/layer", sizeof(uint32_t), {}}, gpu::Compile::Later));
    GLINT_TRY(edges, gpu::Pipeline::compute(context, {"refraction/layer_edges", 0, {}}));
    GLINT_TRY(depth, gpu::Pipeline::compute(context, {"refraction/layers_depth", 0, {}}));
    GLINT_TRY(mipChain, gpu::MipChain::create(context, 1));
    const auto makePicture = [&](const char* name) {
        const auto mips = static_cast<uint32_t>(std::bit_width(std::max(width, height)));
        return gpu::Image::create(context,
                                  {name, VK_FORMAT_R16G16B16A16_SFLOAT, width, height, mips, 1, gpu::ImageShape::Flat,
                                   VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT});
    };
    const auto makeStored = [&](const char* name, VkFormat format, bool whole) {
        return gpu::Image::create(
            context, {name, format, whole ? width : 1, whole ? height : 1, 1, 1, gpu::ImageShape::Flat,
                      VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    };
    GLINT_TRY(solid, makePicture("glint/solidPicture"));
    GLINT_TRY(behind, makePicture("glint/behind"));
    GLINT_TRY(layersZ, makeStored("glint/layersZ", VK_FORMAT_R32_SFLOAT, true));
    GLINT_TRY(refracted, makeStored("glint/refracted", VK_FORMAT_R16G16B16A16_SFLOAT, views));
    GLINT_TRY(weights, makeStored("glint/refractionWeights", VK_FORMAT_R16G16B16A16_SFLOAT, views));
    result->alone_ = std::move(alone);
    result->edges_ = std::move(edges);
    result->depth_ = std::move(depth);
    result->mips_ = std::move(mipChain);
    result->solid_ = std::move(solid);
    result->behind_ = std::move(behind);
    result->layersZ_ = std::move(layersZ);
    result->refracted_ = std::move(refracted);
    result->weights_ = std::move(weights);
    result->views_ = views;
    return result;
}

Result<void> Refraction::make(const Settings& settings) const {
    return settings.refraction.enabled ? (withProbes_ ? withProbes_ : alone_).compile() : Result<void>();
}

Result<void> Refraction::setProbes(ProbesState& probes, gpu::Retired& retired) {
    GLINT_TRY(pipeline,
              gpu::Pipeline::compute(context_, {"refraction/layer_probes", sizeof(uint32_t), {}, probes.cubesLayout()},
                                     gpu::Compile::Later));
    retired.keep(std::move(withProbes_));
    withProbes_ = std::move(pipeline);
    return {};
}

void Refraction::begin(gpu::Frame& frame, gpu::Image& composite) {
    frame.scope("refraction/solidPicture", [&] { mips_.makeFrom(frame, composite, solid_); });
    frame.clear(layersZ_, {.float32 = {shared::kBackgroundZ}});
    frame.clear(refracted_, {});
    frame.clear(weights_, {});
}

void Refraction::record(gpu::Frame& frame, LayerImages& layer, const LayerInputs& inputs, gpu::Image& composite) {
    frame.scope("refraction/picture", [&] { mips_.makeFrom(frame, composite, behind_); });
    Inputs& host = inputs.frame.host;
    const StandIns& standIns = inputs.frame.standIns;
    ProbesState* probes = withProbes_ ? inputs.probes : nullptr;
    const uint32_t images = (layer.fallbackSpecular ? shared::kLayerFallback : 0) |
                            (layer.objectCenter ? shared::kLayerCenters : 0) |
                            (layer.coverage ? shared::kLayerCoverage : 0) | (views_ ? shared::kLayerViews : 0);
    gpu::Pass pass = frame.pass(probes ? withProbes_ : alone_);
    pass.read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("pyramid", inputs.pyramid.cells)
        .read("layerDepth", layer.depth, kTexels)
        .read("layerNormal", layer.normal, kTexels)
        .read("layerMaterial", layer.material, kTexels)
        .read("layerRadiance", layer.radiance, kTexels)
        .read("layerFallback", layer.fallbackSpecular ? layer.fallbackSpecular : standIns.black, kTexels)
        .read("layerTransmittance", layer.transmittance, kTexels)
        .read("layerAbsorption", layer.absorption, kTexels)
        .read("layerBody", layer.body, kTexels)
        .read("layerCenter", layer.objectCenter ? layer.objectCenter : standIns.black, kTexels)
        .read("layerCoverage", layer.coverage ? layer.coverage : standIns.black, kTexels)
        .read("behind", behind_)
        .read("solid", solid_)
        .read("layersZ", layersZ_)
        .read("environment", host.environment ? host.environment : standIns.blackCube)
        .read("dfg", standIns.dfg)
        .write("composite", composite, 0, true)
        .write("refracted", refracted_, 0, true)
        .write("refractionWeights", weights_, 0, true);
    if (probes)
        probes->bind(pass);
    pass.push(images).dispatch(composite.width(), composite.height());
    if (layer.coverage || frame.rehearsing())
        frame.pass(edges_)
            .read("frame", inputs.frame.constants)
            .read("viewZ", inputs.prepared.viewZ)
            .read("layerDepth", layer.depth, kTexels)
            .read("layerCoverage", layer.coverage, kTexels)
            .read("behind", behind_, kTexels)
            .readWrite("composite", composite)
            .dispatch(composite.width(), composite.height());
    frame.pass(depth_)
        .read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("layerDepth", layer.depth, kTexels)
        .write("layersZ", layersZ_, 0, true)
        .dispatch(composite.width(), composite.height());
}

} // namespace glint::reflect
