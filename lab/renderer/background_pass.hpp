// Draws the environment into pixels without a surface.
#pragma once

#include "gpu/pass.hpp"
#include "lab/renderer/environment.hpp"
#include "lab/renderer/gbuffer.hpp"

namespace glint::render {

class BackgroundPass {
public:
    static Result<BackgroundPass> create(gpu::Context& context, const GBufferOptions& options);
    /// `view` holds a shared::RenderView.
    void draw(gpu::Frame& frame, gpu::Buffer& view, Environment& environment, GBuffer& gbuffer);

private:
    gpu::Pipeline motion_;
    gpu::Pipeline radiance_;
};

} // namespace glint::render
