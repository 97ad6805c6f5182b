// Reflections for a G-buffer that another renderer wrote to a file: from the files to images.
#pragma once

#include "lab/gbuffer_files/gbuffer_doctor.hpp"
#include "lab/job/job_inputs.hpp"
#include "lab/job/render_job.hpp"
#include "lab/sources/probe_file.hpp"

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace glint::gpu {
class Context;
}

namespace glint::render {

struct TraceJob {
    /// `scene` is the G-buffer's file, `camera` a camera file. Size, time, materials and planar mirrors have no
    /// meaning. `environment`: empty is none. `probes`: a file of glint bake, or empty.
    RenderJob picture;
    std::string color;        ///< file of the lit picture; empty: the G-buffer's file
    bool asksForRays = false; ///< the user named rays, of which a note says that a G-buffer has none
    std::string
        mapping; ///< a preset or a file (lab/gbuffer_files/gbuffer_mapping.hpp); empty: the preset that fits the file
};

/// What the files of a job contain, decoded.
struct TraceInputs {
    std::shared_ptr<JobInputs> frame; ///< size, camera, environment
    std::shared_ptr<const scene::GBufferPixels> pixels;
    std::shared_ptr<const ProbeSet> probes; ///< null: none
    scene::GBufferHealth health;            ///< what contradicts the mapping or the camera
};

/// Reads and checks every file; needs no device. `previous`: the camera of the frame before, which motion is relative
/// to; null: the first frame, whose motion is not read. Errors: those of the readers; InvalidInput if the files do not
/// fit each other.
Result<TraceInputs> loadTraceInputs(const TraceJob& job, const scene::Camera* previous = nullptr);

/// Takes a frame of a sequence: its number from 0, its inputs and what was rendered.
using TakeTraced = std::function<Result<void>(size_t frame, const TraceInputs& inputs, const RenderResult& result)>;

/// Renders the frames of a sequence one after the other with one history. Returns the last frame's result.
///
/// `jobs`   one per frame, at least one; they differ in their files alone. The first is rendered as often as its
///          `frames` says, the others once
/// `first`  inputs of the first
/// Errors: those of the device, the settings, later frames' files, and `take`; InvalidInput for frames of another size.
Result<RenderResult> runTraces(gpu::Context& context, std::span<const TraceJob> jobs, const TraceInputs& first,
                               const TakeTraced& take);
/// On a device of its own.
Result<RenderResult> runTraces(std::span<const TraceJob> jobs, const TraceInputs& first, const TakeTraced& take);

} // namespace glint::render
