// Reflections for a G-buffer that another renderer wrote to a file: from the files to images.
#pragma once

#include "render/job_inputs.hpp"
#include "render/probe_file.hpp"
#include "render/render_job.hpp"
#include "scene/gbuffer_doctor.hpp"

#include <memory>

namespace glint::gpu {
class Context;
}

namespace glint::render {

struct TraceJob {
    /// `scene` is the G-buffer's file, `camera` a camera file. Size, time, materials and planar mirrors have no
    /// meaning. `environment`: empty is none. `probes`: a file of glint bake, or empty.
    RenderJob picture;
    std::string color;   ///< file of the lit picture; empty: the G-buffer's file
    std::string mapping; ///< a preset or a file (scene/gbuffer_mapping.hpp); empty: the preset that fits the file
};

/// What the files of a job contain, decoded.
struct TraceInputs {
    std::shared_ptr<JobInputs> frame; ///< size, camera, environment
    std::shared_ptr<const scene::GBufferPixels> pixels;
    std::shared_ptr<const ProbeSet> probes; ///< null: none
    scene::GBufferHealth health;            ///< what contradicts the mapping or the camera
};

/// Reads and checks every file; needs no device. Errors: those of the readers; InvalidInput if the files do not fit
/// each other.
Result<TraceInputs> loadTraceInputs(const TraceJob& job);

/// Errors: those of the device and the settings.
Result<RenderResult> runTrace(gpu::Context& context, const TraceJob& job, const TraceInputs& inputs);
/// On a device of its own.
Result<RenderResult> runTrace(const TraceJob& job, const TraceInputs& inputs);

} // namespace glint::render
