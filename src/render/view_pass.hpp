// Makes a view's values visible on the GPU, as displayBytes (render/views.hpp) does it for files.
#pragma once

#include "gpu/pass.hpp"
#include "render/views.hpp"

namespace glint::render {

class ViewPass {
public:
    static Result<ViewPass> create(gpu::Context& context);
    /// `values`   any float or UNORM format; `target` RGBA8_UNORM with STORAGE usage, as large
    /// `kind`     any but Radiance, which the display pass shows
    void draw(gpu::Frame& frame, gpu::Image& values, ViewKind kind, gpu::Image& target);

private:
    gpu::Pipeline pipeline_;
};

} // namespace glint::render
