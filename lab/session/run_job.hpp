// Executes a RenderJob: draws its scene with our renderer and with reflections, and reads the images back.
#pragma once

#include "gpu/context.hpp"
#include "lab/session/reflection_session.hpp"

#include <functional>

namespace glint::render {

/// Opens a job for repeated use: its scene is read and uploaded once; settings, size, camera and time may change. The
/// caller handles RenderJob::frames, views, device and validate. Errors: those of the scene's readers, the device and
/// the settings.
Result<ReflectionSession> openJob(gpu::Context& context, const RenderJob& job);

/// Creates its own device. Errors: as openJob; with RenderJob::validate also the first message of the validation layer.
Result<RenderResult> runJob(const RenderJob& job);

/// Uses an existing device; the caller handles RenderJob::device and validate.
Result<RenderResult> runJob(gpu::Context& context, const RenderJob& job);

/// Uses a session whose scene, camera, sources, size, time and seed are the job's; the caller gives it the job's
/// settings (ReflectionSession::setSettings).
Result<RenderResult> runJob(ReflectionSession& session, const RenderJob& job);

/// Errors: Unsupported with the first message of the validation layer, if there is one.
Result<void> checkMessages(const gpu::Context& context);

// Parts of runJob, for jobs whose G-buffer comes from elsewhere.
SessionOptions sessionOptions(const RenderJob& job);
/// Renders the job's frames, which are numbered from `firstIndex` on, and reads its views. Errors: those of the views;
/// InvalidArgument for an inspected pixel outside the image.
Result<RenderResult> renderFrames(ReflectionSession& session, const RenderJob& job, uint32_t firstIndex = 0);
/// Calls `work` with a device of its own. Errors: as runJob.
Result<RenderResult> onOwnDevice(const RenderJob& job, const std::function<Result<RenderResult>(gpu::Context&)>& work);

} // namespace glint::render
