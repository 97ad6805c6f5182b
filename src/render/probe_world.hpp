// The probes of a job, on the GPU: from a file that fits its scene, or baked now.
#pragma once

#include "render/probe_baking.hpp"
#include "render/render_job.hpp"

#include <vector>

namespace glint::render {

/// Where `glint bake` puts a scene's probes, and where --probes auto looks for them: beside a scene's file, and for a
/// built-in scene in the current folder.
std::string probeFileFor(const std::string& scene);

class ProbeWorld {
public:
    /// As RenderJob::probes says. `renderer` bakes where there is nothing to read; its G-buffer's size changes then.
    /// Errors: of a file that was named, as readProbes and checkProbesFit; OutOfMemory, DeviceLost.
    static Result<ProbeWorld> create(gpu::Context& context, Context& library, Renderer& renderer,
                                     const JobInputs& inputs, const RenderJob& job);

    Probes& probes() { return probes_; }

private:
    explicit ProbeWorld(Probes&& probes) : probes_(std::move(probes)) {}
    std::vector<gpu::Image> cubes_;
    Probes probes_;
};

} // namespace glint::render
