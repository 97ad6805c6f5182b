#include "lab/renderer/transparent_layers.hpp"

#include <algorithm>

namespace glint::render {
namespace {

/// Only the front of a body is drawn: light leaves at its back, which refraction computes.
VkCullModeFlags culled(const GpuItem& item) {
    return item.doubleSided && !item.isBody ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT;
}

/// `makePass(topology, first)`: returns a pass with its attachments; the first one clears them, even if it draws
/// nothing.
template <class MakePass>
void drawTransparent(gpu::Frame& frame, const GpuScene& scene, const MakePass& makePass) {
    const std::vector<GpuItem>& items = scene.items();
    bool first = true;
    for (size_t topology = 0; topology < kTopologies.size(); ++topology) {
        const auto belongs = [&](const GpuItem& item) {
            return item.surface == SurfaceClass::Transparent && item.topology == static_cast<scene::Topology>(topology);
        };
        if (!first && !frame.rehearsing() && std::none_of(items.begin(), items.end(), belongs))
            continue;
        gpu::Pass pass = makePass(topology, first);
        pass.draw([&](gpu::Draws& draws) {
            for (uint32_t i = 0; i < items.size(); ++i)
                if (belongs(items[i]))
                    drawItem(draws, items[i], i, culled(items[i]));
        });
        first = false;
    }
}

} // namespace

Result<TransparentLayers> TransparentLayers::create(gpu::Context& context, const GpuScene& scene,
                                                    const GBufferOptions& options, const RayWorld* rayWorld,
                                                    uint32_t width, uint32_t height, uint32_t most) {
    constexpr uint32_t kImages = 8;
    VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    context.api().GetPhysicalDeviceProperties2(context.physicalDevice(), &properties);
    if (properties.properties.limits.maxColorAttachments < kImages)
        return makeError(ErrorCode::Unsupported,
                         "{} draws into {} images at a time, layers of transparent surfaces need {}: set "
                         "refraction.enabled to false",
                         context.info().name, properties.properties.limits.maxColorAttachments, kImages);
    TransparentLayers result;
    const bool manySamples = options.mode == GBufferMode::Prepass && options.samples > 1;
    const VkFormat normalFormat = GBuffer::colorFormats(context)[0];
    const std::string lit = litShader("render/layer", rayWorld);
    for (size_t topology = 0; topology < kTopologies.size(); ++topology) {
        gpu::RasterDesc desc;
        desc.vertexShader = "render/surface.vert";
        desc.fragmentShader = manySamples ? "render/peel_samples.frag" : "render/peel.frag";
        desc.pushSize = sizeof(shared::DrawConstants);
        desc.depthFormat = kDepthFormat;
        desc.tableLayout = scene.textures().layout();
        desc.topology = kTopologies[topology];
        desc.constants = {{1, 0}};
        GLINT_TRY(first, gpu::Pipeline::raster(context, desc));
        desc.constants = {{1, 1}};
        GLINT_TRY(behind, gpu::Pipeline::raster(context, desc));
        desc.constants = {};
        desc.fragmentShader = lit;
        desc.colorFormats = {kRadianceFormat, kRadianceFormat, normalFormat,    kRadianceFormat,
                             kRadianceFormat, kRadianceFormat, kRadianceFormat, VK_FORMAT_R32G32B32A32_SFLOAT};
        desc.depthCompare = VK_COMPARE_OP_EQUAL;
        desc.depthWrite = false;
        GLINT_TRY(shaded, gpu::Pipeline::raster(context, desc));
        result.first_[topology] = std::move(first);
        result.behind_[topology] = std::move(behind);
        result.lit_[topology] = std::move(shaded);
    }
    const auto make = [&](gpu::Image& image, const char* name, VkFormat format,
                          VkImageUsageFlags attachment) -> Result<void> {
        GLINT_TRY(made, gpu::Image::create(context, {name, format, width, height, 1, 1, gpu::ImageShape::Flat,
                                                     attachment | VK_IMAGE_USAGE_SAMPLED_BIT}));
        image = std::move(made);
        return {};
    };
    constexpr VkImageUsageFlags kColor = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    LayerImages& images = result.images_;
    GLINT_CHECK(make(images.radiance, "layer/radiance", kRadianceFormat, kColor));
    GLINT_CHECK(make(images.fallbackSpecular, "layer/fallbackSpecular", kRadianceFormat, kColor));
    GLINT_CHECK(make(images.normal, "layer/normal", normalFormat, kColor));
    GLINT_CHECK(make(images.material, "layer/material", kRadianceFormat, kColor));
    GLINT_CHECK(make(images.transmittance, "layer/transmittance", kRadianceFormat, kColor));
    GLINT_CHECK(make(images.absorption, "layer/absorption", kRadianceFormat, kColor));
    GLINT_CHECK(make(images.body, "layer/body", kRadianceFormat, kColor));
    GLINT_CHECK(make(images.objectCenter, "layer/objectCenter", VK_FORMAT_R32G32B32A32_SFLOAT, kColor));
    result.depths_.resize(most);
    for (gpu::Image& depth : result.depths_)
        GLINT_CHECK(make(depth, "layer/depth", kDepthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT));
    if (options.samples > 1)
        GLINT_CHECK(result.createCoverage(context, scene, options.samples, width, height));
    return result;
}

Result<void> TransparentLayers::createCoverage(gpu::Context& context, const GpuScene& scene, uint32_t samples,
                                               uint32_t width, uint32_t height) {
    constexpr VkFormat kFormat = VK_FORMAT_R8G8_UNORM;
    gpu::RasterDesc desc;
    desc.vertexShader = "render/surface.vert";
    desc.fragmentShader = "render/layer_cover.frag";
    desc.pushSize = sizeof(shared::DrawConstants);
    desc.colorFormats = {kFormat};
    desc.depthFormat = kDepthFormat;
    desc.depthWrite = false;
    desc.blend = gpu::Blend::Premultiplied; // with alpha 0: adds
    desc.samples = samples;
    desc.tableLayout = scene.textures().layout();
    for (size_t topology = 0; topology < kTopologies.size(); ++topology) {
        desc.topology = kTopologies[topology];
        desc.constants = {{1, 0}};
        GLINT_TRY(first, gpu::Pipeline::raster(context, desc));
        desc.constants = {{1, 1}};
        GLINT_TRY(behind, gpu::Pipeline::raster(context, desc));
        coverFirst_[topology] = std::move(first);
        coverBehind_[topology] = std::move(behind);
    }
    gpu::ImageDesc image = {
        "layer/coverSamples", kFormat, width, height, 1, 1, gpu::ImageShape::Flat, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT};
    image.samples = samples;
    GLINT_TRY(many, gpu::Image::create(context, image));
    image.name = "layer/coverage";
    image.samples = 1;
    image.usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
    GLINT_TRY(mean, gpu::Image::create(context, image));
    coverSamples_ = std::move(many);
    coverage_ = std::move(mean);
    return {};
}

void TransparentLayers::cover(gpu::Frame& frame, GpuScene& scene, gpu::Buffer& view, GBuffer& gbuffer, uint32_t layer) {
    if (!coverage_)
        return;
    constexpr VkClearColorValue kZero = {};
    const auto& pipelines = layer == 0 ? coverFirst_ : coverBehind_;
    drawTransparent(frame, scene, [&](size_t topology, bool first) {
        gpu::Pass pass = geometryPass(frame, pipelines[topology], scene, view);
        pass.read("thisLayer", depths_[layer], gpu::SamplerKind::NearestClamp)
            .read("nearerLayer", layer == 0 ? images_.material : depths_[layer - 1], gpu::SamplerKind::NearestClamp)
            .color(coverSamples_, first ? &kZero : nullptr)
            .resolve(coverage_)
            .depth(gbuffer.shadedDepth(), false, false);
        return pass;
    });
}

void TransparentLayers::peel(gpu::Frame& frame, GpuScene& scene, gpu::Buffer& view, GBuffer& gbuffer) {
    for (uint32_t layer = 0; layer < count(); ++layer) {
        const auto& pipelines = layer == 0 ? first_ : behind_;
        gpu::Image& nearer = layer == 0 ? images_.material : depths_[layer - 1]; // the first layer does not read it
        drawTransparent(frame, scene, [&](size_t topology, bool first) {
            gpu::Pass pass = geometryPass(frame, pipelines[topology], scene, view);
            pass.read("solid", gbuffer.deviceDepth, gpu::SamplerKind::NearestClamp)
                .read("nearerLayer", nearer, gpu::SamplerKind::NearestClamp)
                .depth(depths_[layer], first);
            return pass;
        });
    }
}

LayerImages& TransparentLayers::draw(gpu::Frame& frame, GpuScene& scene, const LightingInputs& inputs, uint32_t layer) {
    constexpr VkClearColorValue kZero = {};
    drawTransparent(frame, scene, [&](size_t topology, bool first) {
        const VkClearColorValue* clear = first ? &kZero : nullptr;
        gpu::Pass pass = surfacePass(frame, lit_[topology], scene, inputs);
        pass.color(images_.radiance, clear)
            .color(images_.fallbackSpecular, clear)
            .color(images_.normal, clear)
            .color(images_.material, clear)
            .color(images_.transmittance, clear)
            .color(images_.absorption, clear)
            .color(images_.body, clear)
            .color(images_.objectCenter, clear)
            .depth(depths_[layer], false, false);
        return pass;
    });
    return images_;
}

} // namespace glint::render
