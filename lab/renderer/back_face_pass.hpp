// Draws the back faces of solid objects: the depth of the nearest surfaces that face away from the camera.
#pragma once

#include "gpu/pass.hpp"
#include "lab/renderer/gpu_scene.hpp"
#include "lab/renderer/view.hpp"

#include <array>

namespace glint::render {

class BackFacePass {
public:
    static Result<BackFacePass> create(gpu::Context& context, const GpuScene& scene);

    /// Clears `backDepth` and draws opaque and masked items, and with `transparents` also transparent ones.
    /// Double-sided surfaces, lines and points have no thickness: both of their sides are drawn. `viewBuffer` holds the
    /// shared::RenderView of `view`.
    void draw(gpu::Frame& frame, const View& view, gpu::Buffer& viewBuffer, GpuScene& scene, bool transparents,
              gpu::Image& backDepth);

private:
    std::array<gpu::Pipeline, 3> solid_; ///< by topology
    std::array<gpu::Pipeline, 3> masked_;
};

} // namespace glint::render
