// Draws blended and light-transmitting surfaces over a lit picture.
#pragma once

#include "render/surface_pass.hpp"

namespace glint::render {

class TransparentPass {
public:
    static Result<TransparentPass> create(gpu::Context& context, const GpuScene& scene, const GBufferOptions& options,
                                          const RayWorld* rayWorld);
    /// What surfaces that transmit light look through: an image with mips; one texel if nothing in the scene does.
    /// Errors: OutOfMemory.
    static Result<gpu::Image> makeBehind(gpu::Context& context, const GpuScene& scene, uint32_t width, uint32_t height);

    /// Draws the farthest first, by the centre of each item; tests depth, writes none. Nothing is recorded if the scene
    /// has no such surface. Surfaces that transmit light see the picture as it is before this pass. With several
    /// samples a pixel, the G-buffer's many samples of litRadiance are drawn to in between.
    void draw(gpu::Frame& frame, const View& view, GpuScene& scene, const LightingInputs& inputs, GBuffer& gbuffer,
              gpu::Image& behind, gpu::Image& hdr);

private:
    std::array<gpu::Pipeline, 3> pipelines_; ///< by topology
    gpu::Pipeline spread_;                   ///< with several samples a pixel only
    std::vector<uint32_t> order_;
};

} // namespace glint::render
