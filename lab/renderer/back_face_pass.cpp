#include "lab/renderer/back_face_pass.hpp"

#include "lab/renderer/frustum.hpp"
#include "lab/renderer/gbuffer.hpp"
#include "lab/renderer/surface_pass.hpp"

#include <algorithm>

namespace glint::render {

Result<BackFacePass> BackFacePass::create(gpu::Context& context, const GpuScene& scene) {
    BackFacePass result;
    gpu::RasterDesc desc;
    desc.vertexShader = "render/back_faces.vert";
    desc.pushSize = sizeof(shared::DrawConstants);
    desc.depthFormat = kDepthFormat;
    for (size_t topology = 0; topology < kTopologies.size(); ++topology) {
        desc.topology = kTopologies[topology];
        desc.fragmentShader = {};
        desc.tableLayout = VK_NULL_HANDLE;
        GLINT_TRY(solid, gpu::Pipeline::raster(context, desc));
        desc.fragmentShader = "render/back_faces_masked.frag";
        desc.tableLayout = scene.textures().layout();
        GLINT_TRY(masked, gpu::Pipeline::raster(context, desc));
        result.solid_[topology] = std::move(solid);
        result.masked_[topology] = std::move(masked);
    }
    return result;
}

void BackFacePass::draw(gpu::Frame& frame, const View& view, gpu::Buffer& viewBuffer, GpuScene& scene,
                        bool transparents, gpu::Image& backDepth) {
    const std::vector<GpuItem>& items = scene.items();
    const Frustum frustum(view.worldToClip);
    bool clear = true; // the first pass clears, even if it draws nothing
    const auto drawAll = [&](const gpu::Pipeline& pipeline, size_t topology, bool masked) {
        const auto belongs = [&](const GpuItem& item) {
            const bool solid = item.surface == SurfaceClass::Opaque;
            const bool drawn = transparents || item.surface != SurfaceClass::Transparent;
            return item.topology == static_cast<scene::Topology>(topology) && drawn && solid != masked;
        };
        if (!clear && !frame.rehearsing() && std::none_of(items.begin(), items.end(), belongs))
            return;
        gpu::Pass pass = frame.pass(pipeline);
        scene.bind(pass).read("view", viewBuffer).depth(backDepth, clear);
        if (masked)
            pass.read("materials", scene.materials()).table(scene.textures().set());
        pass.draw([&](gpu::Draws& draws) {
            for (uint32_t i = 0; i < items.size(); ++i)
                if (belongs(items[i]) && frustum.mayShow(items[i].boundsWS))
                    drawItem(draws, items[i], i, items[i].doubleSided ? VK_CULL_MODE_NONE : VK_CULL_MODE_FRONT_BIT);
        });
        clear = false;
    };
    for (size_t topology = 0; topology < kTopologies.size(); ++topology) {
        drawAll(solid_[topology], topology, false);
        drawAll(masked_[topology], topology, true);
    }
}

} // namespace glint::render
