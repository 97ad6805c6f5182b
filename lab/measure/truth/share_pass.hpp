// Turns a fraction of a G-buffer's surfaces into mirrors, to time an effect against the fraction of the image that
// reflects.
#pragma once

#include "gpu/pass.hpp"
#include "lab/renderer/gbuffer.hpp"

namespace glint::measure {

class SharePass {
public:
    /// Requires that `context` has gpu::shaders::render() registered. Errors: OutOfMemory, Unsupported.
    static Result<SharePass> create(gpu::Context& context);
    /// Writes GBuffer::material: mirrors (F0 0.9, roughness 0) in tiles that cover the fraction `share` ([0, 1]) of the
    /// surfaces' pixels; other pixels do not reflect. The G-buffer must have one sample per pixel.
    void record(gpu::Frame& frame, render::GBuffer& gbuffer, float share);

private:
    gpu::Pipeline pipeline_;
};

} // namespace glint::measure
