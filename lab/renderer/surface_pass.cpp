#include "lab/renderer/surface_pass.hpp"

#include "lab/renderer/frustum.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace glint::render {

gpu::Pass geometryPass(gpu::Frame& frame, const gpu::Pipeline& pipeline, GpuScene& scene, gpu::Buffer& view) {
    gpu::Pass pass = frame.pass(pipeline);
    scene.bind(pass).read("materials", scene.materials()).read("view", view).table(scene.textures().set());
    return pass;
}

gpu::Pass surfacePass(gpu::Frame& frame, const gpu::Pipeline& pipeline, GpuScene& scene, const LightingInputs& inputs) {
    gpu::Pass pass = geometryPass(frame, pipeline, scene, inputs.view);
    pass.read("lights", inputs.lights)
        .read("environmentRadiance", inputs.environment.radiance())
        .read("environmentDiffuse", inputs.environment.diffuse())
        .read("dfg", inputs.dfg);
    if (inputs.rayWorld)
        inputs.rayWorld->bindForShadows(pass);
    else
        pass.read("shadowAtlas", inputs.shadowAtlas, gpu::SamplerKind::ShadowCompare);
    return pass;
}

std::string litShader(std::string_view name, const RayWorld* rayWorld) {
    const char* suffix = !rayWorld ? "" : rayWorld->backend() == RayBackend::Query ? "_query" : "_bvh";
    return fmt::format("{}{}.frag", name, suffix);
}

void drawItem(gpu::Draws& draws, const GpuItem& item, uint32_t instance, VkCullModeFlags cull) {
    draws.cull(cull, item.mirrored);
    draws.push(shared::DrawConstants{instance});
    draws.drawIndexed(item.indexCount, item.firstIndex, item.vertexOffset);
}

Result<SurfacePipelines> SurfacePipelines::create(gpu::Context& context, const GpuScene& scene, gpu::RasterDesc desc) {
    SurfacePipelines result;
    desc.vertexShader = "render/surface.vert";
    desc.pushSize = sizeof(shared::DrawConstants);
    desc.depthFormat = kDepthFormat;
    desc.tableLayout = scene.textures().layout();
    for (size_t topology = 0; topology < kTopologies.size(); ++topology) {
        desc.topology = kTopologies[topology];
        desc.constants = {{0, 0}};
        GLINT_TRY(opaque, gpu::Pipeline::raster(context, desc));
        desc.constants = {{0, 1}};
        GLINT_TRY(masked, gpu::Pipeline::raster(context, desc));
        result.opaque[topology] = std::move(opaque);
        result.masked[topology] = std::move(masked);
    }
    return result;
}

Result<SurfacePass> SurfacePass::create(gpu::Context& context, const GpuScene& scene, const GBufferOptions& options,
                                        const RayWorld* rayWorld) {
    SurfacePass result;
    result.options_ = options;
    const std::vector<VkFormat> formats = GBuffer::colorFormats(context);
    const std::vector<VkFormat> lobes = options.lobes ? GBuffer::lobeFormats(context) : std::vector<VkFormat>();
    gpu::RasterDesc desc;
    if (options.mode == GBufferMode::Prepass) {
        const std::string surface = litShader(options.lobes ? "render/surface_lobes" : "render/surface", rayWorld);
        desc.fragmentShader = surface;
        desc.colorFormats = formats;
        desc.colorFormats.insert(desc.colorFormats.end(), lobes.begin(), lobes.end());
        desc.samples = options.samples;
        GLINT_TRY(whole, SurfacePipelines::create(context, scene, desc));
        result.whole_ = std::move(whole);
        return result;
    }
    desc.fragmentShader = options.lobes ? "render/geometry_lobes.frag" : "render/geometry.frag";
    desc.colorFormats = {formats.begin(), formats.begin() + 3};
    desc.colorFormats.insert(desc.colorFormats.end(), lobes.begin(), lobes.end());
    GLINT_TRY(geometry, SurfacePipelines::create(context, scene, desc));
    const std::string shading = litShader(options.lobes ? "render/shading_lobes" : "render/shading", rayWorld);
    desc.fragmentShader = shading;
    desc.colorFormats = {formats.begin() + 3, formats.end()};
    desc.samples = options.samples;
    if (options.samples == 1) { // the depth already exists: only visible surfaces are lit
        desc.depthCompare = VK_COMPARE_OP_EQUAL;
        desc.depthWrite = false;
    }
    GLINT_TRY(shadingPasses, SurfacePipelines::create(context, scene, desc));
    result.geometry_ = std::move(geometry);
    result.shading_ = std::move(shadingPasses);
    return result;
}

void SurfacePass::draw(gpu::Frame& frame, const View& view, GpuScene& scene, const LightingInputs& inputs,
                       GBuffer& gbuffer) {
    const std::vector<GpuItem>& items = scene.items();
    const Frustum frustum(view.worldToClip);
    order_.clear();
    for (uint32_t i = 0; i < items.size(); ++i)
        if (frustum.mayShow(items[i].boundsWS))
            order_.push_back(i);
    // Nearest first, so that hidden surfaces fail the depth test before lighting. Ties keep the scene's order.
    std::stable_sort(order_.begin(), order_.end(), [&](uint32_t a, uint32_t b) {
        const auto viewZ = [&](uint32_t i) {
            return glm::dot(items[i].boundsWS.center() - view.positionWS(), view.forwardWS());
        };
        return viewZ(a) < viewZ(b);
    });
    constexpr VkClearColorValue kZero = {};
    const auto addGeometry = [&](gpu::Pass& pass, const VkClearColorValue* clear) {
        pass.color(gbuffer.normal, clear)
            .color(gbuffer.material, clear)
            .color(drawn(gbuffer.multisampled.motion, gbuffer.motion), clear);
    };
    const auto addLobes = [&](gpu::Pass& pass, const VkClearColorValue* clear) {
        if (gbuffer.lobes)
            pass.color(gbuffer.lobes, clear).color(gbuffer.coatNormal, clear);
    };
    const auto addLight = [&](gpu::Pass& pass, const VkClearColorValue* clear) {
        pass.color(drawn(gbuffer.multisampled.litRadiance, gbuffer.litRadiance), clear)
            .color(drawn(gbuffer.multisampled.fallbackSpecular, gbuffer.fallbackSpecular), clear)
            .color(drawn(gbuffer.multisampled.albedo, gbuffer.albedo), clear);
    };

    if (options_.mode == GBufferMode::Prepass) {
        drawAll(frame, scene, whole_, [&](const gpu::Pipeline& pipeline, bool first) {
            gpu::Pass pass = surfacePass(frame, pipeline, scene, inputs);
            addGeometry(pass, first ? &kZero : nullptr);
            addLight(pass, first ? &kZero : nullptr);
            addLobes(pass, first ? &kZero : nullptr);
            return pass.depth(gbuffer.deviceDepth, first);
        });
        return;
    }
    drawAll(frame, scene, geometry_, [&](const gpu::Pipeline& pipeline, bool first) {
        gpu::Pass pass = geometryPass(frame, pipeline, scene, inputs.view);
        addGeometry(pass, first ? &kZero : nullptr);
        addLobes(pass, first ? &kZero : nullptr);
        return pass.depth(gbuffer.deviceDepth, first);
    });
    // With one sample per pixel the depth already exists, and only visible surfaces are lit.
    const bool ownDepth = bool(gbuffer.multisampled.depth);
    drawAll(frame, scene, shading_, [&](const gpu::Pipeline& pipeline, bool first) {
        gpu::Pass pass = surfacePass(frame, pipeline, scene, inputs);
        addLight(pass, first ? &kZero : nullptr);
        return pass.depth(gbuffer.shadedDepth(), first && ownDepth, ownDepth);
    });
}

/// `makePass(pipeline, first)`: returns a pass with its attachments; the first one clears them.
template <class MakePass>
void SurfacePass::drawAll(gpu::Frame& frame, const GpuScene& scene, const SurfacePipelines& pipelines,
                          const MakePass& makePass) const {
    const std::vector<GpuItem>& items = scene.items();
    bool first = true; // the first pass clears, even if it draws nothing
    const auto drawSome = [&](const gpu::Pipeline& pipeline, SurfaceClass surface, scene::Topology topology) {
        const auto belongs = [&](const GpuItem& item) { return item.surface == surface && item.topology == topology; };
        if (!first && !frame.rehearsing() && std::none_of(items.begin(), items.end(), belongs))
            return;
        makePass(pipeline, first).draw([&](gpu::Draws& draws) {
            for (const uint32_t i : order_)
                if (belongs(items[i]))
                    drawItem(draws, items[i], i, items[i].doubleSided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
        });
        first = false;
    };
    for (size_t topology = 0; topology < kTopologies.size(); ++topology) {
        drawSome(pipelines.opaque[topology], SurfaceClass::Opaque, static_cast<scene::Topology>(topology));
        drawSome(pipelines.masked[topology], SurfaceClass::Masked, static_cast<scene::Topology>(topology));
    }
}

} // namespace glint::render
