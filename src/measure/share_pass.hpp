// Makes a chosen share of a G-buffer's surfaces mirrors, for timing against the share of the picture that reflects.
#pragma once

#include "gpu/pass.hpp"
#include "render/gbuffer.hpp"

namespace glint::measure {

class SharePass {
public:
    /// `context` must know gpu::shaders::render(). Errors: OutOfMemory, Unsupported.
    static Result<SharePass> create(gpu::Context& context);
    /// Writes GBuffer::material: mirrors (F0 0.9, roughness 0) in tiles that are `share` ([0, 1]) of the surfaces'
    /// pixels, nothing that reflects elsewhere. The G-buffer must have one sample a pixel.
    void record(gpu::Frame& frame, render::GBuffer& gbuffer, float share);

private:
    gpu::Pipeline pipeline_;
};

} // namespace glint::measure
