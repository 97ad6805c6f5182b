// The floor of what an effect can cost on a device: one pass that reads the G-buffer's channels and writes a picture.
#pragma once

#include "gpu/pass.hpp"
#include "render/gbuffer.hpp"

namespace glint::measure {

class FloorPass {
public:
    static constexpr const char* kName = "measure/floor"; ///< of the pass, in pass times

    /// `context` must know gpu::shaders::render(). Errors: OutOfMemory, Unsupported.
    static Result<FloorPass> create(gpu::Context& context, uint32_t width, uint32_t height);
    /// Records nothing for a G-buffer with several samples a pixel, which no single read can stand for.
    void record(gpu::Frame& frame, render::GBuffer& gbuffer);

private:
    gpu::Pipeline pipeline_;
    gpu::Image result_;
};

} // namespace glint::measure
