// Draws the opaque surfaces: lit, and into the G-buffer.
#pragma once

#include "gpu/pass.hpp"
#include "render/environment.hpp"
#include "render/gbuffer.hpp"
#include "render/gpu_scene.hpp"
#include "render/ray_world.hpp"
#include "render/view.hpp"

#include <array>

namespace glint::render {

/// What every lit surface reads, whichever pass draws it.
struct LightingInputs {
    gpu::Buffer& view;   ///< shared::RenderView
    gpu::Buffer& lights; ///< shared::Light
    Environment& environment;
    gpu::Image& dfg;
    gpu::Image& shadowAtlas;
    RayWorld* rayWorld; ///< in the atlas's place, for pipelines that were made with rays for shadows
};

/// The name of a lit surface's fragment shader, "render/surface" say, for shadows by maps or by rays of this back end.
std::string litShader(std::string_view name, const RayWorld* rayWorld);

/// A pass with the scene and its light bound, as shaders/render/surface_bindings.glsl asks.
gpu::Pass surfacePass(gpu::Frame& frame, const gpu::Pipeline& pipeline, GpuScene& scene, const LightingInputs& inputs);

/// The same without light: shaders that ask what a surface is, not how it is lit.
gpu::Pass geometryPass(gpu::Frame& frame, const gpu::Pipeline& pipeline, GpuScene& scene, gpu::Buffer& view);

/// Records the draw of one item.
void drawItem(gpu::Draws& draws, const GpuItem& item, uint32_t instance, VkCullModeFlags cull);

/// The topologies, in the order of scene::Topology.
constexpr std::array<VkPrimitiveTopology, 3> kTopologies = {
    VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, VK_PRIMITIVE_TOPOLOGY_LINE_LIST, VK_PRIMITIVE_TOPOLOGY_POINT_LIST};

/// One kind of pass over the opaque surfaces: a pipeline for each topology and surface class.
struct SurfacePipelines {
    std::array<gpu::Pipeline, 3> opaque; ///< by topology
    std::array<gpu::Pipeline, 3> masked;
    static Result<SurfacePipelines> create(gpu::Context& context, const GpuScene& scene, gpu::RasterDesc desc);
};

class SurfacePass {
public:
    /// `rayWorld`: absent, unless shadows are by rays.
    static Result<SurfacePass> create(gpu::Context& context, const GpuScene& scene, const GBufferOptions& options,
                                      const RayWorld* rayWorld);

    /// Clears the G-buffer and draws every opaque and masked item, the nearest first.
    void draw(gpu::Frame& frame, const View& view, GpuScene& scene, const LightingInputs& inputs, GBuffer& gbuffer);

private:
    template <class MakePass>
    void drawAll(gpu::Frame& frame, const GpuScene& scene, const SurfacePipelines& pipelines,
                 const MakePass& makePass) const;

    GBufferOptions options_;
    SurfacePipelines whole_;      ///< mode prepass: everything at once
    SurfacePipelines geometry_;   ///< mode geometry: what surfaces are, ...
    SurfacePipelines shading_;    ///< ... then their light
    std::vector<uint32_t> order_; ///< of this frame's items; kept so that recording allocates nothing
};

} // namespace glint::render
