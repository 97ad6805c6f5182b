// Converts scene-referred radiance to the displayed image.
#pragma once

#include "gpu/pass.hpp"
#include "lab/renderer/render_settings.hpp"

namespace glint::render {

class DisplayPass {
public:
    static Result<DisplayPass> create(gpu::Context& context);
    /// Allocates what these settings need for images of this size. Call before `draw` with display.antialias fxaa.
    /// Errors: OutOfMemory.
    Result<void> resize(gpu::Context& context, uint32_t width, uint32_t height, const DisplaySettings& settings);
    /// `ldr`: RGBA8_UNORM with STORAGE usage, of the size of `hdr`; receives sRGB-encoded colours and alpha 1.
    void draw(gpu::Frame& frame, gpu::Image& hdr, gpu::Image& ldr, const DisplaySettings& settings);

private:
    gpu::Pipeline tonemap_;
    gpu::Pipeline fxaa_;
    gpu::Image aliased_; ///< the image before antialiasing; absent without fxaa
};

} // namespace glint::render
