// Turns scene-referred radiance into the picture for a screen.
#pragma once

#include "gpu/pass.hpp"
#include "render/render_settings.hpp"

namespace glint::render {

class DisplayPass {
public:
    static Result<DisplayPass> create(gpu::Context& context);
    /// `ldr`: RGBA8_UNORM with STORAGE usage, as large as `hdr`; it gets sRGB-encoded colours and alpha 1.
    void draw(gpu::Frame& frame, gpu::Image& hdr, gpu::Image& ldr, const DisplaySettings& settings);

private:
    gpu::Pipeline pipeline_;
};

} // namespace glint::render
