// Turns scene-referred radiance into the picture for a screen.
#pragma once

#include "gpu/pass.hpp"
#include "render/render_settings.hpp"

namespace glint::render {

class DisplayPass {
public:
    static Result<DisplayPass> create(gpu::Context& context);
    /// Makes what these settings need for pictures of this size; before `draw` with display.antialias fxaa.
    /// Errors: OutOfMemory.
    Result<void> resize(gpu::Context& context, uint32_t width, uint32_t height, const DisplaySettings& settings);
    /// `ldr`: RGBA8_UNORM with STORAGE usage, as large as `hdr`; it gets sRGB-encoded colours and alpha 1.
    void draw(gpu::Frame& frame, gpu::Image& hdr, gpu::Image& ldr, const DisplaySettings& settings);

private:
    gpu::Pipeline tonemap_;
    gpu::Pipeline fxaa_;
    gpu::Image aliased_; ///< the picture before its edges are smoothed; absent unless asked for
};

} // namespace glint::render
