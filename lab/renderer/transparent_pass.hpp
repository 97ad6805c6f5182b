// Draws blended and transmissive surfaces over a lit image.
#pragma once

#include "lab/renderer/surface_pass.hpp"

namespace glint::render {

class TransparentPass {
public:
    static Result<TransparentPass> create(gpu::Context& context, const GpuScene& scene, const GBufferOptions& options,
                                          const RayWorld* rayWorld);
    /// Creates the image with mips that transmissive surfaces fetch from; one texel if the scene has no such surface.
    /// Errors: OutOfMemory.
    static Result<gpu::Image> makeBehind(gpu::Context& context, const GpuScene& scene, uint32_t width, uint32_t height);

    /// Draws the farthest item first, by the centre of each item; tests depth and does not write it. Records nothing if
    /// the scene has no such surface. Transmissive surfaces fetch from the image as it was before this pass. With
    /// several samples per pixel, the G-buffer's multisampled litRadiance is the intermediate render target.
    void draw(gpu::Frame& frame, const View& view, GpuScene& scene, const LightingInputs& inputs, GBuffer& gbuffer,
              gpu::Image& behind, gpu::Image& hdr);

private:
    std::array<gpu::Pipeline, 3> pipelines_; ///< by topology
    gpu::Pipeline spread_;                   ///< only with several samples per pixel
    std::vector<uint32_t> order_;
};

} // namespace glint::render
