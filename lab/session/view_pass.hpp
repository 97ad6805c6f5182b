// Converts a view's values to visible colours on the GPU, as displayBytes (lab/session/views.hpp) does for files.
#pragma once

#include "gpu/pass.hpp"
#include "lab/session/views.hpp"

namespace glint::render {

class ViewPass {
public:
    static Result<ViewPass> create(gpu::Context& context);
    /// `values`   any float or UNORM format; `target`: RGBA8_UNORM with STORAGE usage, of the same size
    /// `kind`     any but Radiance, which the display pass shows
    void draw(gpu::Frame& frame, gpu::Image& values, ViewKind kind, gpu::Image& target);

private:
    gpu::Pipeline pipeline_;
};

} // namespace glint::render
