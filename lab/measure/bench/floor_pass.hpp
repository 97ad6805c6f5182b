// Measures the minimum cost of an effect on a device: one pass that reads the G-buffer's channels and writes an image.
#pragma once

#include "gpu/pass.hpp"
#include "lab/renderer/gbuffer.hpp"

namespace glint::measure {

class FloorPass {
public:
    static constexpr const char* kName = "measure/floor"; ///< name of the pass in pass times

    /// Requires that `context` has gpu::shaders::render() registered. Errors: OutOfMemory, Unsupported.
    static Result<FloorPass> create(gpu::Context& context, uint32_t width, uint32_t height);
    /// Records nothing for a multisampled G-buffer, whose cost a single read does not represent.
    void record(gpu::Frame& frame, render::GBuffer& gbuffer);

private:
    gpu::Pipeline pipeline_;
    gpu::Image result_;
};

} // namespace glint::measure
