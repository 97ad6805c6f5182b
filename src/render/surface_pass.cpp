#include "render/surface_pass.hpp"

#include <algorithm>

namespace glint::render {

gpu::Pass surfacePass(gpu::Frame& frame, const gpu::Pipeline& pipeline, GpuScene& scene, const LightingInputs& inputs) {
    gpu::Pass pass = frame.pass(pipeline);
    pass.read("instances", scene.instances())
        .read("positions", scene.positions())
        .read("attributes", scene.attributes())
        .read("materials", scene.materials())
        .read("view", inputs.view)
        .read("lights", inputs.lights)
        .read("environmentRadiance", inputs.environment.radiance())
        .read("environmentDiffuse", inputs.environment.diffuse())
        .read("dfg", inputs.dfg)
        .read("shadowAtlas", inputs.shadowAtlas, gpu::SamplerKind::ShadowCompare)
        .table(scene.textures().set())
        .indices(scene.indices());
    return pass;
}

void drawItem(gpu::Draws& draws, const GpuItem& item, uint32_t instance, VkCullModeFlags cull) {
    draws.cull(cull, item.mirrored);
    draws.push(shared::DrawConstants{instance});
    draws.drawIndexed(item.indexCount, item.firstIndex, item.vertexOffset);
}

Result<SurfacePass> SurfacePass::create(gpu::Context& context, const GpuScene& scene) {
    SurfacePass result;
    gpu::RasterDesc desc;
    desc.vertexShader = "render/surface.vert";
    desc.fragmentShader = "render/surface.frag";
    desc.pushSize = sizeof(shared::DrawConstants);
    desc.colorFormats = GBuffer::colorFormats(context);
    desc.depthFormat = kDepthFormat;
    desc.tableLayout = scene.textures().layout();
    for (size_t topology = 0; topology < kTopologies.size(); ++topology) {
        desc.topology = kTopologies[topology];
        desc.constants = {{0, 0}};
        GLINT_TRY(opaque, gpu::Pipeline::raster(context, desc));
        desc.constants = {{0, 1}};
        GLINT_TRY(masked, gpu::Pipeline::raster(context, desc));
        result.opaque_[topology] = std::move(opaque);
        result.masked_[topology] = std::move(masked);
    }
    return result;
}

void SurfacePass::draw(gpu::Frame& frame, const View& view, GpuScene& scene, const LightingInputs& inputs,
                       GBuffer& gbuffer) {
    const std::vector<GpuItem>& items = scene.items();
    order_.resize(items.size());
    for (uint32_t i = 0; i < items.size(); ++i)
        order_[i] = i;
    // Nearest first: what is hidden then fails the depth test before it is lit. Ties keep the scene's order.
    std::stable_sort(order_.begin(), order_.end(), [&](uint32_t a, uint32_t b) {
        const auto viewZ = [&](uint32_t i) {
            return glm::dot(items[i].centerWS - view.positionWS(), view.forwardWS());
        };
        return viewZ(a) < viewZ(b);
    });

    bool clear = true; // the first pass does, though it may draw nothing
    const auto drawAll = [&](const gpu::Pipeline& pipeline, SurfaceClass surface, scene::Topology topology) {
        const auto belongs = [&](const GpuItem& item) { return item.surface == surface && item.topology == topology; };
        if (!clear && !frame.rehearsing() && std::none_of(items.begin(), items.end(), belongs))
            return;
        constexpr VkClearColorValue kZero = {};
        const VkClearColorValue* clearColor = clear ? &kZero : nullptr;
        surfacePass(frame, pipeline, scene, inputs)
            .color(gbuffer.normal, clearColor)
            .color(gbuffer.material, clearColor)
            .color(gbuffer.motion, clearColor)
            .color(gbuffer.litRadiance, clearColor)
            .color(gbuffer.fallbackSpecular, clearColor)
            .color(gbuffer.albedo, clearColor)
            .depth(gbuffer.deviceDepth, clear)
            .draw([&](gpu::Draws& draws) {
                for (const uint32_t i : order_)
                    if (belongs(items[i]))
                        drawItem(draws, items[i], i, items[i].doubleSided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
            });
        clear = false;
    };
    for (size_t topology = 0; topology < kTopologies.size(); ++topology) {
        drawAll(opaque_[topology], SurfaceClass::Opaque, static_cast<scene::Topology>(topology));
        drawAll(masked_[topology], SurfaceClass::Masked, static_cast<scene::Topology>(topology));
    }
}

} // namespace glint::render
