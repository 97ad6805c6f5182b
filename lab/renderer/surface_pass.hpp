// Draws the opaque surfaces, with lighting, into the G-buffer.
#pragma once

#include "gpu/pass.hpp"
#include "lab/renderer/environment.hpp"
#include "lab/renderer/gbuffer.hpp"
#include "lab/renderer/gpu_scene.hpp"
#include "lab/renderer/ray_world.hpp"
#include "lab/renderer/view.hpp"

#include <array>

namespace glint::render {

/// Inputs of every lit surface, in all passes.
struct LightingInputs {
    gpu::Buffer& view;   ///< shared::RenderView
    gpu::Buffer& lights; ///< shared::Light
    Environment& environment;
    gpu::Image& dfg;
    gpu::Image& shadowAtlas;
    RayWorld* rayWorld; ///< replaces the atlas in pipelines created for ray-traced shadows
};

/// Returns the name of a lit surface's fragment shader for `name`, such as "render/surface": with shadow maps, or with
/// shadow rays of this back end.
std::string litShader(std::string_view name, const RayWorld* rayWorld);

/// Begins a pass with the scene and its lights bound, as lab/shaders/render/surface_bindings.glsl requires.
gpu::Pass surfacePass(gpu::Frame& frame, const gpu::Pipeline& pipeline, GpuScene& scene, const LightingInputs& inputs);

/// As surfacePass without lights: for shaders that output surface attributes and no lighting.
gpu::Pass geometryPass(gpu::Frame& frame, const gpu::Pipeline& pipeline, GpuScene& scene, gpu::Buffer& view);

/// Records the draw of one item.
void drawItem(gpu::Draws& draws, const GpuItem& item, uint32_t instance, VkCullModeFlags cull);

/// The topologies, in the order of scene::Topology.
constexpr std::array<VkPrimitiveTopology, 3> kTopologies = {
    VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, VK_PRIMITIVE_TOPOLOGY_LINE_LIST, VK_PRIMITIVE_TOPOLOGY_POINT_LIST};

/// The pipelines of one kind of pass over the opaque surfaces, by topology and surface class.
struct SurfacePipelines {
    std::array<gpu::Pipeline, 3> opaque; ///< by topology
    std::array<gpu::Pipeline, 3> masked;
    static Result<SurfacePipelines> create(gpu::Context& context, const GpuScene& scene, gpu::RasterDesc desc);
};

class SurfacePass {
public:
    /// `rayWorld`: null unless shadows are ray-traced.
    static Result<SurfacePass> create(gpu::Context& context, const GpuScene& scene, const GBufferOptions& options,
                                      const RayWorld* rayWorld);

    /// Clears the G-buffer and draws every opaque and masked item, the nearest first.
    void draw(gpu::Frame& frame, const View& view, GpuScene& scene, const LightingInputs& inputs, GBuffer& gbuffer);

private:
    template <class MakePass>
    void drawAll(gpu::Frame& frame, const GpuScene& scene, const SurfacePipelines& pipelines,
                 const MakePass& makePass) const;

    GBufferOptions options_;
    SurfacePipelines whole_;      ///< mode prepass: attributes and lighting in one pass
    SurfacePipelines geometry_;   ///< mode geometry, first pass: surface attributes
    SurfacePipelines shading_;    ///< mode geometry, second pass: lighting
    std::vector<uint32_t> order_; ///< item order of this frame; kept so that recording allocates nothing
};

} // namespace glint::render
