#include "lab/renderer/transparent_pass.hpp"

#include "lab/renderer/frustum.hpp"

#include <algorithm>
#include <bit>

namespace glint::render {

Result<TransparentPass> TransparentPass::create(gpu::Context& context, const GpuScene& scene,
                                                const GBufferOptions& options, const RayWorld* rayWorld) {
    TransparentPass result;
    gpu::RasterDesc desc;
    desc.samples = options.samples;
    if (options.samples > 1) {
        desc.vertexShader = "render/fullscreen.vert";
        desc.fragmentShader = "render/spread.frag";
        desc.colorFormats = {kRadianceFormat};
        GLINT_TRY(spread, gpu::Pipeline::raster(context, desc));
        result.spread_ = std::move(spread);
    }
    desc.vertexShader = "render/surface.vert";
    const std::string transparent = litShader("render/transparent", rayWorld);
    desc.fragmentShader = transparent;
    desc.pushSize = sizeof(shared::DrawConstants);
    desc.colorFormats = {kRadianceFormat};
    desc.depthFormat = kDepthFormat;
    desc.depthWrite = false;
    desc.blend = gpu::Blend::Premultiplied;
    desc.tableLayout = scene.textures().layout();
    for (size_t topology = 0; topology < kTopologies.size(); ++topology) {
        desc.topology = kTopologies[topology];
        GLINT_TRY(pipeline, gpu::Pipeline::raster(context, desc));
        result.pipelines_[topology] = std::move(pipeline);
    }
    return result;
}

Result<gpu::Image> TransparentPass::makeBehind(gpu::Context& context, const GpuScene& scene, uint32_t width,
                                               uint32_t height) {
    if (!scene.transmitsLight())
        width = height = 1;
    const auto mips = static_cast<uint32_t>(std::bit_width(std::max(width, height)));
    return gpu::Image::create(
        context, {"render/behind", kRadianceFormat, width, height, mips, 1, gpu::ImageShape::Flat,
                  VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
}

void TransparentPass::draw(gpu::Frame& frame, const View& view, GpuScene& scene, const LightingInputs& inputs,
                           GBuffer& gbuffer, gpu::Image& behind, gpu::Image& hdr) {
    const std::vector<GpuItem>& items = scene.items();
    const Frustum frustum(view.worldToClip);
    order_.clear();
    for (uint32_t i = 0; i < items.size(); ++i)
        if (items[i].surface == SurfaceClass::Transparent && frustum.mayShow(items[i].boundsWS))
            order_.push_back(i);
    if (order_.empty() && !frame.rehearsing())
        return;
    std::stable_sort(order_.begin(), order_.end(), [&](uint32_t a, uint32_t b) {
        const auto viewZ = [&](uint32_t i) {
            return glm::dot(items[i].boundsWS.center() - view.positionWS(), view.forwardWS());
        };
        return viewZ(a) > viewZ(b);
    });
    if (scene.transmitsLight()) {
        frame.copy(hdr, behind);
        frame.makeMips(behind);
    }
    gpu::Image& target = drawn(gbuffer.multisampled.litRadiance, hdr);
    if (spread_)
        frame.pass(spread_)
            .read("radiance", hdr, gpu::SamplerKind::NearestClamp)
            .color(target)
            .draw([](gpu::Draws& draws) { draws.draw(3); });
    for (size_t topology = 0; topology < kTopologies.size(); ++topology) {
        const auto belongs = [&](uint32_t i) { return items[i].topology == static_cast<scene::Topology>(topology); };
        if (!frame.rehearsing() && std::none_of(order_.begin(), order_.end(), belongs))
            continue;
        gpu::Pass pass = surfacePass(frame, pipelines_[topology], scene, inputs);
        pass.read("behind", behind).color(target).depth(gbuffer.shadedDepth(), false, false);
        if (spread_)
            pass.resolve(hdr);
        pass.draw([&](gpu::Draws& draws) {
            for (const uint32_t i : order_) {
                if (!belongs(i))
                    continue;
                if (items[i].doubleSided) // the far side first
                    drawItem(draws, items[i], i, VK_CULL_MODE_FRONT_BIT);
                drawItem(draws, items[i], i, VK_CULL_MODE_BACK_BIT);
            }
        });
    }
}

} // namespace glint::render
