// The probes of a job on the GPU: read from a file that fits its scene, or baked.
#pragma once

#include "lab/job/render_job.hpp"
#include "lab/sources/probe_baking.hpp"
#include "lab/sources/probe_file.hpp"

#include <vector>

namespace glint::render {

/// Returns the path where `glint bake` stores a scene's probes and where --probes auto searches: beside the scene's
/// file, or in the current folder for a built-in scene.
std::string probeFileFor(const std::string& scene);

class ProbeWorld {
public:
    /// Loads the probes that RenderJob::probes names. If there is no file to read, `renderer` bakes them, and its
    /// G-buffer changes its size. Errors: for a named file as readProbes and checkProbesFit; OutOfMemory, DeviceLost.
    static Result<ProbeWorld> create(gpu::Context& context, Context& library, Renderer& renderer,
                                     const JobInputs& inputs, const RenderJob& job);

    /// Creates the probes of a set on the GPU. Errors: OutOfMemory, DeviceLost.
    static Result<ProbeWorld> upload(gpu::Context& context, Context& library, const ProbeSet& set);

    Probes& probes() { return probes_; }

private:
    explicit ProbeWorld(Probes&& probes) : probes_(std::move(probes)) {}
    std::vector<gpu::Image> cubes_;
    Probes probes_;
};

} // namespace glint::render
